// The constraints of a scene file.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/index.hpp"
#include "description/scene_effects.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {

using model::ConstraintKind;
using Of = SceneContext::Of;

void SceneEffects::refuse_second(const SceneFields& fields, const std::string& name) const {
  if (constraints_off_.count(name) > 0 || is_known(name, names_of(context_.scene().constraints))) {
    fields.fail(fields.where(), fmt::format("another constraint is called '{}'; expected different "
                                            "names",
                                            shown(name)));
  }
}

void SceneEffects::add(const SceneFields& fields, model::Constraint constraint) {
  if (fields.find("name") != nullptr) {
    static_cast<void>(fields.name("name", "constraint"));
  }
  refuse_second(fields, constraint.name);
  if (entry_is_off_) {
    constraints_off_.insert(constraint.name);
  }
  places_[constraint.name] = fields.where();
  scene().constraints.push_back(std::move(constraint));
}

namespace {

/// True if the positions that two rows along one axis hold differ, or one rests and one moves. What
/// rows along other directions hold are sums of components.
bool places_differ(const model::Constraint& a, std::size_t i, const model::Constraint& b) {
  std::vector<std::size_t> components;
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.kind == ConstraintKind::kJoint ? k == 0 : a.directions[i][k] != 0) {
      components.push_back(k);
    }
  }
  if (components.size() != 1) {
    return false;
  }
  const model::Expression& x = a.curve.position[components.front()];
  const model::Expression& y = b.curve.position[components.front()];
  const bool moves = x.uses(model::Quantity::kTime) || y.uses(model::Quantity::kTime);
  return a.pinned || b.pinned ? moves : !(x == y);
}

/// True if row i of `a` and row j of `b` hold the same direction and state different accelerations,
/// or positions.
bool differ(const model::Constraint& a, std::size_t i, const model::Constraint& b, std::size_t j) {
  const bool of_joint = a.kind == ConstraintKind::kJoint;
  const bool same = of_joint || a.directions[i] == b.directions[j];
  if (a.accelerations.empty() != b.accelerations.empty()) {
    return false;
  }
  if (!a.accelerations.empty()) {
    return same && !(a.accelerations[i] == b.accelerations[j]);
  }
  const bool led = of_joint || a.kind == ConstraintKind::kPoint;
  return led && (same || a.directions[i] == Real(-1) * b.directions[j]) && places_differ(a, i, b);
}

bool contradict(const model::Constraint& a, const model::Constraint& b) {
  if (a.kind != b.kind || a.joint != b.joint || a.point != b.point || a.other != b.other) {
    return false;
  }
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < b.rows(); ++j) {
      if (differ(a, i, b, j)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

void SceneEffects::refuse_contradictions(const SceneFields& root) const {
  const auto& constraints = context_.scene().constraints;
  for (const model::Phase& phase : context_.scene().phases) {
    for (auto b = phase.active.begin(); b != phase.active.end(); ++b) {
      const auto& second = constraints[to_index(*b)];
      const auto a = std::find_if(phase.active.begin(), b, [&](int c) {
        return contradict(constraints[to_index(c)], second);
      });
      if (a != b) {
        const auto& first = constraints[to_index(*a)];
        root.fail(places_.at(second.name),
                  fmt::format("constraint '{}' contradicts '{}' in phase '{}'; expected the same "
                              "motion, or one of them",
                              shown(second.name), shown(first.name), shown(phase.name)));
      }
      refuse_friction_at_rest(root, second);
    }
  }
}

/// Which of the two holds the joint nothing decides where it rests.
void SceneEffects::refuse_friction_at_rest(const SceneFields& root,
                                           const model::Constraint& constraint) const {
  if (constraint.kind == ConstraintKind::kJoint &&
      std::ranges::count(context_.scene().frictions, constraint.joint, &model::DryFriction::joint) >
          0) {
    root.fail(
        places_.at(constraint.name),
        fmt::format("constraint '{}' locks or leads a joint that dry friction without slip_speed "
                    "holds as well; expected a slip_speed, or one of them",
                    shown(constraint.name)));
  }
}

void SceneEffects::locked_joint(const SceneFields& fields) {
  model::Constraint constraint;
  constraint.kind = ConstraintKind::kJoint;
  constraint.joint = context_.joint(fields);
  constraint.name = fields.text_or("name", fields.text("joint").text);
  if (const Node* const at = fields.find("at")) {
    const auto motion = context_.motion(fields, *at);
    constraint.curve.position[0] = motion[0];
    constraint.curve.velocity[0] = motion[1];
    constraint.curve.acceleration[0] = motion[2];
  }
  read_accelerations(fields, constraint);
  constraint.pinned = fields.find("at") == nullptr && constraint.accelerations.empty();
  add(fields, std::move(constraint));
}

/// `along`: letters x, y, z or vectors; all three without it.
void SceneEffects::read_directions(const SceneFields& fields, model::Constraint& constraint) const {
  const std::array<model::Vector3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (fields.find("along") == nullptr) {
    constraint.directions.assign(axes.begin(), axes.end());
    return;
  }
  const std::vector<Node>& items = fields.list("along");
  if (items.empty()) {
    fields.fail(fields.get("along").where, "'along' is empty; expected at least one direction");
  }
  for (const Node& item : items) {
    const bool letter = item.kind == NodeKind::kScalar;
    const std::size_t axis = std::string_view("xyz").find(letter ? item.text : "?");
    if (letter && (item.text.size() != 1 || axis == std::string_view::npos)) {
      fields.fail(item.where, fmt::format("direction '{}' is unknown; expected x, y, z or a vector",
                                          shown(item.text)));
    }
    constraint.directions.push_back(letter ? axes[axis] : fields.fixed().direction_of(item));
  }
}

void SceneEffects::read_accelerations(const SceneFields& fields,
                                      model::Constraint& constraint) const {
  const Node* const node = fields.find("acceleration");
  if (node == nullptr) {
    return;
  }
  for (const char* const other : {"curve", "at"}) {
    if (fields.find(other) != nullptr) {
      fields.fail(node->key.where,
                  fmt::format("'acceleration' beside '{}'; expected one of them", other));
    }
  }
  const bool list = node->kind == NodeKind::kSequence;
  const std::size_t count = list ? node->items.size() : 1;
  if (count != constraint.rows()) {
    fields.fail(node->where, fmt::format("'acceleration' has {} entries; expected {}, one a "
                                         "direction",
                                         count, constraint.rows()));
  }
  for (std::size_t k = 0; k < count; ++k) {
    constraint.accelerations.push_back(
        context_.expression(fields, list ? node->items[k] : *node, Of::kState));
  }
}

void SceneEffects::point_constraint(const SceneFields& fields) {
  model::Constraint constraint;
  constraint.point = context_.moving_point(fields);
  constraint.name = fields.text_or("name", scene().points[to_index(constraint.point)].name);
  read_directions(fields, constraint);
  if (fields.find("curve") != nullptr) {
    const std::vector<Node>& entries = fields.triple(fields.get("curve"));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto motion = context_.motion(fields, entries[k]);
      constraint.curve.position[k] = motion[0];
      constraint.curve.velocity[k] = motion[1];
      constraint.curve.acceleration[k] = motion[2];
    }
  }
  read_accelerations(fields, constraint);
  constraint.pinned = fields.find("curve") == nullptr && constraint.accelerations.empty();
  add(fields, std::move(constraint));
}

void SceneEffects::orientation_constraint(const SceneFields& fields) {
  model::Constraint constraint;
  constraint.kind = ConstraintKind::kOrientation;
  constraint.point = context_.moving_point(fields);
  constraint.name =
      fields.text_or("name", scene().points[to_index(constraint.point)].name + "_orientation");
  read_directions(fields, constraint);
  read_accelerations(fields, constraint);
  add(fields, std::move(constraint));
}

namespace {

/// Two points of one link that no position brings together: in all directions, on the ground in
/// any.
bool keeps_apart(const model::Scene& scene, const model::Constraint& joined) {
  const model::Point& a = scene.points[to_index(joined.point)];
  const model::Point& b = scene.points[to_index(joined.other)];
  const model::Vector3 apart = a.at - b.at;
  const Real least("1e-9");
  if (a.link != b.link) {
    return false;
  }
  return a.link == model::kGround
             ? std::ranges::any_of(joined.directions,
                                   [&](const auto& d) { return abs(dot(d, apart)) > least; })
             : joined.rows() >= 3 && norm(apart) > least;
}

}  // namespace

void SceneEffects::joined_constraint(const SceneFields& fields) {
  model::Constraint constraint;
  constraint.kind = ConstraintKind::kJoined;
  constraint.point = context_.point(fields, "point");
  constraint.other = context_.point(fields, "other");
  if (constraint.point == constraint.other) {
    fields.fail(fields.get("other").where, "a point is joined to itself; expected two points");
  }
  read_directions(fields, constraint);
  if (keeps_apart(scene(), constraint)) {
    fields.fail(fields.get("other").where,
                fmt::format("'{}' and '{}' are fixed to one link, or to the ground, at different "
                            "places; expected points of two",
                            shown(fields.text("point").text), shown(fields.text("other").text)));
  }
  constraint.name = fields.text_or(
      "name", fmt::format("{}_{}", fields.text("point").text, fields.text("other").text));
  add(fields, std::move(constraint));
}

}  // namespace treedyn::description
