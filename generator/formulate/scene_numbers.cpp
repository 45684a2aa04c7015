#include "formulate/scene_numbers.hpp"

#include <algorithm>
#include <optional>

#include "common/index.hpp"

namespace treedyn::formulate {

namespace {

using What = model::SceneNumber;

/// Shows the numbers of one scene, or of an event without its scene.
class Visit {
 public:
  Visit(const model::Scene* scene, const SeeNumbers& see) : scene_(scene), see_(see) {}

  void scene(model::Scene& s) const;
  void event(model::Event& e) const;

 private:
  void number(Real& x, What what, int link) const {
    see_({&x, 1}, {what, link, model::row_of(what).dimension});
  }
  void expression(model::Expression& e, What what, int link) const {
    e.change_constants([&](Real& x, std::optional<What>) { number(x, what, link); });
  }
  void law(model::JointLaw& law) const;
  void law(model::PointLaw& law) const;
  void vector(model::VectorExpression& v, What what, int link) const {
    std::ranges::for_each(v, [&](model::Expression& e) { expression(e, what, link); });
  }
  void plane(model::Plane& p, What normal, What height, int link) const {
    see_(p.normal, {normal, link, model::kNoUnit, NumberForm::kAxis});
    number(p.height, height, link);
  }
  void of_joint(Real& x, What what, int joint) const {
    const int link = link_of_joint(joint);
    const model::JointType type = scene_->tree.links[to_index(link)].joint.type;
    const model::SceneNumberRow& row = model::row_of(what);
    see_({&x, 1}, {what, link, type == model::JointType::kRevolute ? row.turns : row.dimension});
  }
  [[nodiscard]] int link_of_joint(int joint) const {
    return scene_->tree.coordinates[to_index(joint)];
  }
  [[nodiscard]] int link_of_point(int point) const { return scene_->points[to_index(point)].link; }
  [[nodiscard]] int link_of(const model::Constraint& c) const {
    return c.kind == model::ConstraintKind::kJoint ? link_of_joint(c.joint)
                                                   : link_of_point(c.point);
  }
  [[nodiscard]] int link_of(const model::Event& e) const;
  void constraint(model::Constraint& c) const;
  void contact(model::GroundContact& c) const;

  const model::Scene* scene_;
  const SeeNumbers& see_;
};

void Visit::constraint(model::Constraint& c) const {
  const int link = link_of(c);
  for (model::Vector3& direction : c.directions) {
    see_(direction, {What::kDirection, link, model::kNoUnit, NumberForm::kAxis});
  }
  for (model::VectorExpression* const v :
       {&c.curve.position, &c.curve.velocity, &c.curve.acceleration}) {
    vector(*v, What::kCurve, link);
  }
  for (model::Expression& e : c.accelerations) {
    expression(e, What::kCurve, link);
  }
  if (!c.loop) {
    return;
  }
  if (c.loop->size() == std::tuple_size_v<model::Matrix3>) {
    see_(*c.loop, {What::kStart, link, model::kNoUnit, NumberForm::kRotation});
    return;
  }
  for (Real& x : *c.loop) {
    number(x, What::kStart, link);
  }
}

/// Constants are those of the scene in a drive and those of the effect in other laws. The energy is
/// in no function.
void Visit::law(model::JointLaw& law) const {
  if (law.effect == "drive") {
    expression(law.force, What::kDrive, link_of_joint(law.joint));
    return;
  }
  law.force.change_constants([&](Real& x, std::optional<What> what) {
    if (what) {
      of_joint(x, *what, law.joint);
    }
  });
}

void Visit::law(model::PointLaw& law) const {
  const int link = link_of_point(law.point);
  for (model::Expression& component : law.value) {
    component.change_constants(
        [&](Real& x, std::optional<What> what) { number(x, what.value_or(What::kLoad), link); });
  }
}

/// The unit of the stiffness follows from a whole exponent.
void Visit::contact(model::GroundContact& c) const {
  const int link = link_of_point(c.point);
  const bool whole = c.exponent == floor(c.exponent);
  const int length = whole ? 1 - static_cast<int>(c.exponent) : 0;
  plane(c.plane, What::kGroundNormal, What::kGroundHeight, link);
  see_({&c.stiffness, 1}, {What::kGroundStiffness, link, {1, length, -2, whole}});
  number(c.dissipation, What::kDissipation, link);
  number(c.friction, What::kFriction, link);
  number(c.slip_speed, What::kSlipSpeed, link);
  if (c.law) {
    expression(*c.law, What::kLaw, link);
  }
}

int Visit::link_of(const model::Event& e) const {
  if (scene_ == nullptr) {
    return model::kGround;
  }
  switch (e.kind) {
    case model::EventKind::kHeight:
      return link_of_point(e.point);
    case model::EventKind::kReaction:
      return link_of(scene_->constraints[to_index(e.constraint)]);
    case model::EventKind::kTime:
    case model::EventKind::kExpression:
      break;
  }
  return model::kGround;
}

/// What reactions are multiplied with is no unit vector, and a force is their height.
void Visit::event(model::Event& e) const {
  const int link = link_of(e);
  if (e.kind == model::EventKind::kReaction) {
    for (Real& x : e.plane.normal) {
      number(x, What::kEventNormal, link);
    }
    see_({&e.plane.height, 1}, {What::kDryFriction, link, model::kAnyUnit});
  } else {
    plane(e.plane, What::kEventNormal, What::kEventHeight, link);
  }
  expression(e.value, What::kEvent, link);
  if (e.impact) {
    number(e.impact->restitution, What::kRestitution, link);
  }
}

void Visit::scene(model::Scene& s) const {
  std::ranges::for_each(s.constraints, [&](model::Constraint& c) { constraint(c); });
  std::ranges::for_each(s.joint_laws, [&](model::JointLaw& joint_law) { law(joint_law); });
  std::ranges::for_each(s.point_laws, [&](model::PointLaw& point_law) { law(point_law); });
  std::ranges::for_each(s.contacts, [&](model::GroundContact& c) { contact(c); });
  for (model::DryFriction& friction : s.frictions) {
    of_joint(friction.force, What::kDryFriction, friction.joint);
  }
  for (model::Armature& armature : s.armatures) {
    of_joint(armature.inertia, What::kArmature, armature.joint);
  }
  for (std::size_t k = 0; k < s.tau.size(); ++k) {
    of_joint(s.tau[k], What::kJointForce, static_cast<int>(k));
  }
  for (model::Phase& phase : s.phases) {
    std::ranges::for_each(phase.until, [&](model::Event& e) { event(e); });
    for (model::JointForce& own : phase.forces) {
      of_joint(own.force, What::kDryFriction, own.joint);
    }
  }
  number(s.stepping.stabilisation, What::kStabilisation, model::kGround);
}

}  // namespace

void each_number(model::Scene& scene, const SeeNumbers& see) { Visit(&scene, see).scene(scene); }

void each_number(model::Event& event, const SeeNumbers& see) { Visit(nullptr, see).event(event); }

int group_of(model::SceneNumber what) {
  return static_cast<int>(what <= model::kLastOfExpressions ? What::kDrive : what);
}

void see(std::span<Real> numbers, NumberForm form, StandInNumbers& all) {
  const auto take = [&](const auto& seen) {
    std::ranges::copy(seen, numbers.begin());
  };
  const auto given = [&](auto array) {
    std::ranges::copy(numbers, array.begin());
    return array;
  };
  switch (form) {
    case NumberForm::kNumber:
      numbers.front() = all.number(StandIn::kScene, numbers.front());
      break;
    case NumberForm::kAxis:
      take(all.axis(given(model::Vector3{})));
      break;
    case NumberForm::kRotation:
      take(all.rotation(given(model::Matrix3{})));
      break;
  }
}

}  // namespace treedyn::formulate
