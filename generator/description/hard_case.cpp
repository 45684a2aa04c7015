#include "description/hard_case.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/transformed.hpp"
#include "description/hard_case_bodies.hpp"
#include "description/identifiers.hpp"
#include "description/read.hpp"
#include "description/resolve.hpp"
#include "description/scene_fields.hpp"
#include "model/force_laws.hpp"

namespace treedyn::description {

namespace {

/// c(t) = center + velocity t + A1 cos(omega t + phase) u + A2 sin(omega t + phase) v.
struct Harmonic {
  model::Vector3 center, velocity, u, v;
  Real A1, A2, omega, phase;
};

model::Curve curve_of(const Harmonic& h) {
  using model::Expression;
  const Expression t(model::Variable{model::Quantity::kTime, 0});
  const Expression angle = h.omega * t + h.phase;
  const Expression c = cos(angle);
  const Expression s = sin(angle);
  model::Curve result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Expression a = h.A1 * h.u[k];
    const Expression b = h.A2 * h.v[k];
    result.position[k] = h.center[k] + h.velocity[k] * t + a * c + b * s;
    result.velocity[k] = h.velocity[k] + h.omega * (b * c - a * s);
    result.acceleration[k] = -(h.omega * h.omega) * (a * c + b * s);
  }
  return result;
}

/// One case in the making.
class HardCase {
 public:
  HardCase(const std::string& file, const Node& root)
      : file_(file),
        root_(file, root, "scene file", {"schema", "id", "model", "scene", "expected", "verified"}),
        fields_(file, root_.get("scene"), "scene",
                {"gravity", "q0", "qd0", "tau", "t0", "duration", "joint_springs", "armatures",
                 "point_springs", "body_torques", "forces", "constraints", "redundant", "active",
                 "phases", "start_phase"}) {}

  model::Scene run() {
    scene_.name = root_.find("id") == nullptr ? "scene" : root_.name("id", "scene").text;
    scene_.tree = resolve(read_bodies(file_, root_.get("model"), scene_.name),
                          {.base = Base::kFixed, .mimic = Mimic::kIndependent, .snap = 0})
                      .tree;
    const std::size_t dof = scene_.tree.links.size();
    scene_.gravity = fields_.vector("gravity");
    scene_.q0 = fields_.numbers_of_joints("q0", dof);
    scene_.qd0 = fields_.numbers_of_joints("qd0", dof);
    scene_.tau = fields_.find("tau") == nullptr ? std::vector<Real>{}
                                                : fields_.numbers_of_joints("tau", dof);
    scene_.t0 = fields_.number_or("t0", 0);
    scene_.duration = fields_.amount_or("duration", 0);
    read_effects();
    read_all("constraint", "constraints", &HardCase::read_constraint);
    read_phases();
    return std::move(scene_);
  }

 private:
  void read_all(const char* kind, const char* key,
                void (HardCase::*read)(const Node&, const std::string&)) {
    const std::vector<Node>& items = fields_.list(key);
    for (std::size_t k = 0; k < items.size(); ++k) {
      (this->*read)(items[k], called(kind, items[k], k));
    }
  }

  void read_effects() {
    read_all("joint spring", "joint_springs", &HardCase::read_joint_spring);
    read_all("armature", "armatures", &HardCase::read_armature);
    read_all("point spring", "point_springs", &HardCase::read_point_spring);
    read_all("body torque", "body_torques", &HardCase::read_torque);
    read_all("force", "forces", &HardCase::read_force);
  }

  [[nodiscard]] int joint(const SceneFields& fields) const {
    return fields.integer("joint", 1, scene_.tree.size()) - 1;
  }

  /// The index of a point of a body; equal points exist once.
  int point(const SceneFields& fields, bool at_origin = false) {
    const int link = fields.integer("body", 1, scene_.tree.size()) - 1;
    const model::Vector3 at = at_origin ? model::Vector3{} : fields.vector("point");
    for (std::size_t k = 0; k < scene_.points.size(); ++k) {
      if (scene_.points[k].link == link && scene_.points[k].at == at) {
        return static_cast<int>(k);
      }
    }
    model::Point result;
    result.name = result.identifier = fmt::format("point_{}", scene_.points.size() + 1);
    result.link_name = scene_.tree.links[static_cast<std::size_t>(link)].name;
    result.link = link;
    result.at = at;
    scene_.points.push_back(std::move(result));
    return static_cast<int>(scene_.points.size()) - 1;
  }

  void read_joint_spring(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what, {"name", "joint", "k", "d", "q0"});
    const int at = joint(fields);
    const Real stiffness = fields.number("k");
    const Real damping = fields.number_or("d", 0);
    scene_.joint_laws.push_back(
        model::joint_spring(at, stiffness, damping, fields.number_or("q0", 0)));
  }

  void read_armature(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what, {"name", "joint", "inertia"});
    const model::Armature armature{joint(fields), fields.amount("inertia")};
    if (armature.inertia != 0) {
      scene_.armatures.push_back(armature);
    }
  }

  void read_point_spring(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what,
                             {"name", "body", "point", "anchor", "k", "d", "rest_length"});
    const int at = point(fields);
    const model::Vector3 anchor = fields.vector("anchor");
    const Real stiffness = fields.number("k");
    const Real damping = fields.number_or("d", 0);
    scene_.point_laws.push_back(
        model::point_spring(at, anchor, stiffness, damping, fields.amount_or("rest_length", 0)));
  }

  void read_torque(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what, {"name", "body", "torque"});
    const int at = point(fields, true);
    const model::Vector3 value = fields.vector("torque");
    scene_.point_laws.push_back(model::moment(at, {value[0], value[1], value[2]}));
  }

  void read_force(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what,
                             {"name", "type", "joint", "friction", "body", "point", "normal",
                              "height", "k", "n", "c", "mu", "vs"});
    const std::string type = fields.text("type").text;
    if (type == "joint_coulomb") {
      const model::DryFriction friction{joint(fields), fields.amount_or("friction", 0)};
      if (friction.force != 0) {
        scene_.frictions.push_back(friction);
      }
    } else if (type == "ground_point" || type == "ground_point_hc") {
      read_contact(fields, type == "ground_point_hc");
    } else {
      fields.fail(fields.get("type").where,
                  fmt::format("type '{}' is unknown; expected joint_coulomb, ground_point or "
                              "ground_point_hc",
                              shown(type)));
    }
  }

  void read_contact(const SceneFields& fields, bool tangential) {
    model::GroundContact contact;
    contact.point = point(fields);
    contact.plane = {fields.direction("normal"), fields.number_or("height", 0)};
    contact.stiffness = fields.number("k");
    contact.exponent = fields.number_or("n", 1);
    contact.dissipation = fields.number_or("c", 0);
    if (contact.exponent < 1) {
      fields.fail(fields.get("n").where, "exponent 'n' is below 1; expected 1 or more");
    }
    if (contact.exponent > 100) {
      fields.fail(fields.get("n").where, "exponent 'n' is above 100; expected 1 to 100");
    }
    if (tangential) {
      contact.friction = fields.amount_or("mu", 0);
      contact.slip_speed = fields.amount_or("vs", 0);
      if (contact.friction > 0 && contact.slip_speed == 0) {
        fields.fail(fields.where(), "friction without 'vs'; expected a slip speed above 0");
      }
    }
    scene_.contacts.push_back(std::move(contact));
  }

  [[nodiscard]] std::vector<model::Vector3> directions(const SceneFields& fields) const {
    std::vector<model::Vector3> result;
    for (const Node& item : fields.sequence(fields.get("dirs"))) {
      result.push_back(fields.vector_of(item));
      if (result.back() == model::Vector3{}) {
        fields.fail(item.where, "direction has zero length; expected a direction");
      }
    }
    if (result.empty()) {
      fields.fail(fields.get("dirs").where, "'dirs' is empty; expected at least one direction");
    }
    return result;
  }

  [[nodiscard]] model::Curve curve(const Node& node, const std::string& what) const {
    const SceneFields fields(file_, node, what + ": curve",
                             {"center", "velocity", "u", "v", "A1", "A2", "omega", "phase"});
    const Harmonic harmonic{fields.vector("center"),      fields.vector_or("velocity", {}),
                            fields.vector_or("u", {}),    fields.vector_or("v", {}),
                            fields.number_or("A1", 0),    fields.number_or("A2", 0),
                            fields.number_or("omega", 0), fields.number_or("phase", 0)};
    return curve_of(harmonic);
  }

  void read_constraint(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what, {"name", "type", "body", "point", "dirs", "curve"});
    model::Constraint constraint;
    constraint.name = fields.find("name") == nullptr
                          ? fmt::format("{}", scene_.constraints.size() + 1)
                          : fields.name("name", "constraint").text;
    const std::string type = fields.text("type").text;
    if (type != "point" && type != "orientation") {
      fields.fail(fields.get("type").where,
                  fmt::format("type '{}' is unknown; expected point or orientation", shown(type)));
    }
    const bool is_point = type == "point";
    constraint.kind =
        is_point ? model::ConstraintKind::kPoint : model::ConstraintKind::kOrientation;
    constraint.point = point(fields, !is_point);
    constraint.directions = directions(fields);
    if (is_point) {
      constraint.curve = curve(fields.get("curve"), what);
    }
    if (index_of(scene_.constraints, constraint.name)) {
      fields.fail(fields.where(), "another constraint has this name; expected different names");
    }
    scene_.constraints.push_back(std::move(constraint));
  }

  [[nodiscard]] int constraint(const SceneFields& fields, const Node& node) const {
    const std::string name = fields.scalar(node).text;
    if (const std::optional<int> found = index_of(scene_.constraints, name)) {
      return *found;
    }
    fields.fail(node.where, fmt::format("constraint '{}' is not defined; expected one of "
                                        "'constraints'",
                                        shown(name)));
  }

  [[nodiscard]] std::vector<int> constraints(const SceneFields& fields, const char* key) const {
    std::vector<int> result =
        transformed(fields.list(key), [&](const Node& item) { return constraint(fields, item); });
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  [[nodiscard]] int phase(const SceneFields& fields, const char* key) const {
    const std::string name = fields.text(key).text;
    if (const std::optional<int> found = index_of(scene_.phases, name)) {
      return *found;
    }
    fields.fail(fields.get(key).where,
                fmt::format("phase '{}' is not defined; expected one of 'phases'", shown(name)));
  }

  void read_phases() {
    const std::vector<Node>& nodes = fields_.list("phases");
    if (nodes.empty()) {
      read_lone_phase();
      return;
    }
    std::vector<Named> names;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const std::string what = called("phase", nodes[k], k);
      const SceneFields fields(file_, nodes[k], what, {"name", "active", "until"});
      const Text name = fields.name("name", "phase");
      names.push_back({name.text, to_identifier(name.text), name.where.in(file_)});
      scene_.phases.push_back({name.text, constraints(fields, "active"), {}});
    }
    check_identifiers(names, "phase");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const SceneFields fields(file_, nodes[k], called("phase", nodes[k], k),
                               {"name", "active", "until"});
      for (const Node& item : fields.list("until")) {
        scene_.phases[k].until.push_back(event(item, "event of " + called("phase", nodes[k], k)));
      }
    }
    scene_.start_phase = fields_.find("start_phase") == nullptr ? 0 : phase(fields_, "start_phase");
  }

  /// Without phases `active` names what acts; without it everything does.
  void read_lone_phase() {
    model::Phase all;
    for (std::size_t k = 0; k < scene_.constraints.size(); ++k) {
      all.active.push_back(static_cast<int>(k));
    }
    if (fields_.find("active") != nullptr) {
      all.active = constraints(fields_, "active");
    }
    scene_.phases.push_back(std::move(all));
  }

  model::Event event(const Node& node, const std::string& what) {
    const SceneFields fields(file_, node, what,
                             {"point", "normal", "height", "crossing", "not_before", "impact",
                              "pin_where_it_lands", "rest_below", "then"});
    if (fields.text_or("crossing", "falling") != "falling") {
      fields.fail(fields.get("crossing").where, "unknown crossing; expected falling");
    }
    model::Event result;
    result.point =
        point(SceneFields(file_, fields.get("point"), what + ": point", {"body", "point"}));
    result.plane = {fields.direction("normal"), fields.number_or("height", 0)};
    result.not_before = fields.amount_or("not_before", 0);
    if (const Node* const impact = fields.find("impact")) {
      result.impact = read_impact(*impact, what + ": impact", fields);
    }
    result.pins = constraints(fields, "pin_where_it_lands");
    result.then = phase(fields, "then");
    return result;
  }

  [[nodiscard]] model::Impact read_impact(const Node& node, const std::string& what,
                                          const SceneFields& event) const {
    const SceneFields fields(file_, node, what, {"constraints", "restitution", "rest_below"});
    model::Impact impact{constraints(fields, "constraints"), fields.amount_or("restitution", 0),
                         fields.amount_or("rest_below", event.amount_or("rest_below", 0))};
    if (impact.restitution > 1) {
      fields.fail(fields.get("restitution").where, "restitution is above 1; expected 0 to 1");
    }
    return impact;
  }

  const std::string& file_;
  SceneFields root_;
  SceneFields fields_;
  model::Scene scene_;
};

}  // namespace

bool is_hard_case(const Node& root) {
  return std::ranges::any_of(root.items, [](const Node& item) {
    return item.key.text == "schema" ||
           (item.key.text == "model" && item.kind == NodeKind::kMapping);
  });
}

model::Scene read_hard_case(const std::string& file, const Node& root) {
  return HardCase(file, root).run();
}

}  // namespace treedyn::description
