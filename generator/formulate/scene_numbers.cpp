#include "formulate/scene_numbers.hpp"

#include <algorithm>

namespace treedyn::formulate {

namespace {

using What = SceneNumber;

constexpr Dimension kNone = {0, 0, 0};
constexpr Dimension kLength = {0, 1, 0};
constexpr Dimension kSpeed = {0, 1, -1};

/// Of a number of a joint.
struct JointDimension {
  Dimension slides;
  Dimension turns;
};
constexpr JointDimension kForce = {{1, 1, -2}, {1, 2, -2}};
constexpr JointDimension kStiffness = {{1, 0, -2}, {1, 2, -2}};
constexpr JointDimension kDamping = {{1, 0, -1}, {1, 2, -1}};
constexpr JointDimension kInertia = {{1, 0, 0}, {1, 2, 0}};
constexpr JointDimension kPlace = {{0, 1, 0}, {0, 0, 0}};
constexpr JointDimension kRate = {{0, 1, -1}, {0, 0, -1}};

/// Shows the numbers of one scene, or of an event without its scene.
class Visit {
 public:
  Visit(const model::Scene* scene, const SeeNumbers& see) : scene_(scene), see_(see) {}

  void scene(model::Scene& s) const;
  void event(model::Event& e) const;

 private:
  void number(Real& x, What what, int link, const Dimension& dimension) const {
    see_({&x, 1}, {what, link, dimension});
  }
  void expression(model::Expression& e, What what, int link) const {
    e.change_constants([&](Real& x) { see_({&x, 1}, {what, link}); });
  }
  void vector(model::VectorExpression& v, What what, int link) const {
    std::ranges::for_each(v, [&](model::Expression& e) { expression(e, what, link); });
  }
  void plane(model::Plane& p, What normal, What height, int link) const {
    see_(p.normal, {normal, link, kNone, NumberForm::kAxis});
    number(p.height, height, link, kLength);
  }
  void of_joint(Real& x, What what, int joint, const JointDimension& dimension) const {
    const int link = link_of_joint(joint);
    const model::JointType type = scene_->tree.links[static_cast<std::size_t>(link)].joint.type;
    number(x, what, link, type == model::JointType::kRevolute ? dimension.turns : dimension.slides);
  }
  [[nodiscard]] int link_of_joint(int joint) const {
    return scene_->tree.coordinates[static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] int link_of_point(int point) const {
    return scene_->points[static_cast<std::size_t>(point)].link;
  }
  [[nodiscard]] int link_of(const model::Constraint& c) const {
    return c.kind == model::ConstraintKind::kJoint ? link_of_joint(c.joint)
                                                   : link_of_point(c.point);
  }
  [[nodiscard]] int link_of(const model::Event& e) const;
  void constraint(model::Constraint& c) const;
  void contact(model::GroundContact& c) const;
  void springs(model::Scene& s) const;
  void frictions(model::Scene& s) const;

  const model::Scene* scene_;
  const SeeNumbers& see_;
};

void Visit::constraint(model::Constraint& c) const {
  const int link = link_of(c);
  for (model::Vector3& direction : c.directions) {
    see_(direction, {What::kDirection, link, kNone, NumberForm::kAxis});
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
    see_(*c.loop, {What::kStart, link, kNone, NumberForm::kRotation});
    return;
  }
  for (Real& x : *c.loop) {
    number(x, What::kStart, link, kLength);
  }
}

void Visit::springs(model::Scene& s) const {
  for (model::JointSpring& spring : s.joint_springs) {
    of_joint(spring.stiffness, What::kStiffness, spring.joint, kStiffness);
    of_joint(spring.damping, What::kDamping, spring.joint, kDamping);
    of_joint(spring.rest, What::kRest, spring.joint, kPlace);
  }
  for (model::PointSpring& spring : s.point_springs) {
    const int link = link_of_point(spring.point);
    for (Real& x : spring.anchor) {
      number(x, What::kAnchor, link, kLength);
    }
    number(spring.stiffness, What::kStiffness, link, kStiffness.slides);
    number(spring.damping, What::kDamping, link, kDamping.slides);
    number(spring.rest_length, What::kRest, link, kLength);
  }
}

/// The unit of the stiffness follows from a whole exponent.
void Visit::contact(model::GroundContact& c) const {
  const int link = link_of_point(c.point);
  const bool whole = c.exponent == floor(c.exponent);
  const int length = whole ? 1 - static_cast<int>(c.exponent) : 0;
  plane(c.plane, What::kGroundNormal, What::kGroundHeight, link);
  number(c.stiffness, What::kGroundStiffness, link, {1, length, -2, whole});
  number(c.dissipation, What::kDissipation, link, {0, -1, 1});
  number(c.friction, What::kFriction, link, kNone);
  number(c.slip_speed, What::kSlipSpeed, link, kSpeed);
  if (c.law) {
    expression(*c.law, What::kLaw, link);
  }
}

void Visit::frictions(model::Scene& s) const {
  for (model::ViscousFriction& f : s.viscous_frictions) {
    of_joint(f.coefficient, What::kViscousFriction, f.joint, kDamping);
  }
  for (model::JointFriction& f : s.frictions) {
    of_joint(f.force, What::kDryFriction, f.joint, kForce);
    of_joint(f.slip_speed, What::kSlipSpeed, f.joint, kRate);
  }
  for (model::StribeckFriction& f : s.stribeck_frictions) {
    of_joint(f.force, What::kDryFriction, f.joint, kForce);
    of_joint(f.static_force, What::kStaticFriction, f.joint, kForce);
    of_joint(f.stribeck_speed, What::kStribeckSpeed, f.joint, kRate);
    of_joint(f.slip_speed, What::kSlipSpeed, f.joint, kRate);
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
      return link_of(scene_->constraints[static_cast<std::size_t>(e.constraint)]);
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
      number(x, What::kEventNormal, link, kNone);
    }
    see_({&e.plane.height, 1}, {What::kDryFriction, link});
  } else {
    plane(e.plane, What::kEventNormal, What::kEventHeight, link);
  }
  expression(e.value, What::kEvent, link);
  if (e.impact) {
    number(e.impact->restitution, What::kRestitution, link, kNone);
  }
}

void Visit::scene(model::Scene& s) const {
  std::ranges::for_each(s.constraints, [&](model::Constraint& c) { constraint(c); });
  springs(s);
  for (model::PointLoad& load : s.torques) {
    vector(load.value, What::kLoad, link_of_point(load.point));
  }
  for (model::PointLoad& load : s.forces) {
    vector(load.value, What::kLoad, link_of_point(load.point));
  }
  std::ranges::for_each(s.contacts, [&](model::GroundContact& c) { contact(c); });
  frictions(s);
  for (model::Armature& armature : s.armatures) {
    of_joint(armature.inertia, What::kArmature, armature.joint, kInertia);
  }
  for (model::Motor& motor : s.motors) {
    expression(motor.torque, What::kDrive, link_of_joint(motor.joint));
  }
  for (std::size_t k = 0; k < s.tau.size(); ++k) {
    of_joint(s.tau[k], What::kJointForce, static_cast<int>(k), kForce);
  }
  for (model::Phase& phase : s.phases) {
    std::ranges::for_each(phase.until, [&](model::Event& e) { event(e); });
    for (model::JointForce& own : phase.forces) {
      of_joint(own.force, What::kDryFriction, own.joint, kForce);
    }
  }
  number(s.stepping.stabilisation, What::kStabilisation, model::kGround, {0, 0, -1});
}

}  // namespace

void each_number(model::Scene& scene, const SeeNumbers& see) { Visit(&scene, see).scene(scene); }

void each_number(model::Event& event, const SeeNumbers& see) { Visit(nullptr, see).event(event); }

int group_of(SceneNumber what) {
  return static_cast<int>(what <= kLastOfExpressions ? What::kDrive : what);
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
