#include "description/scene_effects.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "model/effects.hpp"
#include "model/force_laws.hpp"

namespace treedyn::description {

namespace {

using Of = SceneContext::Of;

Use use_of(const Fields& fields, const Text& text) {
  static const std::map<std::string, Use, std::less<>> words = {
      {"default", Use::kDefault}, {"on", Use::kOn}, {"off", Use::kOff}};
  const auto found = words.find(text.text);
  if (found == words.end()) {
    fields.fail(text.where,
                fmt::format("'{}' is no state of an effect; expected default, on or off",
                            shown(text.text)));
  }
  return found->second;
}

/// 0 without; at run time above zero, since zero is another law.
Real positive_at_run_time(const SceneFields& fields, std::string_view key) {
  const Real value = fields.amount_or(key, 0);
  return value.recipe() == 0 ? value : fields.positive(key);
}

}  // namespace

const std::vector<SceneEffects::Row>& SceneEffects::rows() {
  using E = SceneEffects;
  static const std::vector<Row> table = {
      {"viscous_friction", {"joint", "coefficient"}, &E::viscous_friction},
      {"coulomb_friction", {"joint", "force", "slip_speed"}, &E::coulomb_friction},
      {"stribeck_friction",
       {"joint", "force", "static_force", "stribeck_speed", "slip_speed"},
       &E::stribeck_friction},
      {"armature", {"joint", "inertia"}, &E::armature},
      {"joint_spring", {"joint", "stiffness", "damping", "rest"}, &E::joint_spring},
      {"point_spring",
       {"point", "anchor", "stiffness", "damping", "rest_length"},
       &E::point_spring},
      {"drive", {"joint", "torque", "kp", "kd", "target"}, &E::drive},
      {"locked_joint", {"name", "joint", "at", "acceleration"}, &E::locked_joint},
      {"force", {"point", "value"}, &E::force},
      {"moment", {"point", "value"}, &E::moment},
      {"point_constraint",
       {"name", "point", "along", "curve", "acceleration"},
       &E::point_constraint},
      {"orientation_constraint",
       {"name", "point", "along", "acceleration"},
       &E::orientation_constraint},
      {"joined_constraint", {"name", "point", "other", "along"}, &E::joined_constraint},
      {"ground_contact",
       {"point", "normal", "height", "stiffness", "exponent", "dissipation", "friction",
        "slip_speed", "law"},
       &E::ground_contact}};
  return table;
}

SceneEffects::SceneEffects(SceneContext& context, const SceneFields& root) : context_(context) {
  if (const Node* const use = root.find("use")) {
    read_use(*use);
  }
  scene().velocity_products = acts("velocity_products");
  const Node* const node = root.find("effects");
  if (node != nullptr) {
    Keys keys = {"gravity", "stabilisation"};
    for (const Row& row : rows()) {
      keys.push_back(row.effect);
    }
    const SceneFields effects = context_.fields(*node, "effects", keys);
    read_gravity(effects);
    for (const Node& entries : node->items) {  // constraints and points get the order of the file
      const auto row = std::ranges::find(rows(), entries.key.text, &Row::effect);
      if (row != rows().end()) {
        read_entries(*row, effects, entries);
      }
    }
    if (const Node* const stabilisation = effects.find("stabilisation")) {
      read_stabilisation(*stabilisation);
    }
  }
  if (!acts("stabilisation")) {
    scene().stepping.drift = model::Drift::kNone;
  }
  check_on(root, node);
}

void SceneEffects::read_use(const Node& node) {
  const SceneFields fields = context_.fields(node, "use", names_of(model::effects()));
  for (const Node& item : node.items) {
    use_[item.key.text] = use_of(fields, fields.scalar(item));
  }
}

bool SceneEffects::acts(std::string_view effect) const {
  const auto found = use_.find(effect);
  return found == use_.end() || found->second != Use::kOff;
}

/// An effect that is on has something to act with.
void SceneEffects::check_on(const SceneFields& root, const Node* effects) const {
  for (const auto& [effect, use] : use_) {
    const bool has_values = effect == "velocity_products" || effect == "impact" ||
                            effect == "stabilisation" || acting_.count(effect) > 0;
    if (use == Use::kOn && !has_values) {
      root.fail(
          find(root.get("use"), effect)->where,
          fmt::format("effect '{}' is on and {}; expected {}", effect,
                      effects == nullptr ? "there are no effects" : "nothing in 'effects' acts",
                      "an entry that is not off"));
    }
  }
}

void SceneEffects::read_gravity(const SceneFields& effects) {
  const Node* const node = effects.find("gravity");
  if (node == nullptr) {
    return;
  }
  const model::Vector3 value = effects.at_run_time().vector_of(*node);
  if (acts("gravity")) {
    scene().gravity = value;
    acting_.insert("gravity");
  }
}

void SceneEffects::read_stabilisation(const Node& node) {
  const SceneFields fields = context_.fields(node, "stabilisation", {"method", "rate"});
  const Text method = fields.text("method");
  const std::optional<model::Drift> drift = model::drift_of(method.text);
  if (!drift) {
    fields.fail(method.where,
                fmt::format("method '{}' is unknown; expected none, baumgarte or projection",
                            shown(method.text)));
  }
  scene().stepping.drift = *drift;
  if (fields.find("rate") != nullptr) {
    if (*drift != model::Drift::kBaumgarte) {
      fields.fail(fields.get("rate").key.where, "'rate' belongs to baumgarte; expected no rate");
    }
    scene().stepping.stabilisation = fields.positive("rate");
  }
}

bool SceneEffects::entry_acts(std::string_view effect, const SceneFields& fields) const {
  const std::optional<Text> text = fields.optional_text("use");
  const Use use = text ? use_of(fields, *text) : Use::kDefault;
  if (use == Use::kOn && !acts(effect)) {
    fields.fail(text->where, fmt::format("entry is on and effect '{}' is off; expected one of "
                                         "these, not both",
                                         effect));
  }
  return acts(effect) && use != Use::kOff;
}

/// One that is zero does nothing; what is known at run time only is never zero.
void SceneEffects::add(model::PointLaw law) {
  entry_is_nothing_ = !scene().declares_parameters &&
                      std::ranges::all_of(law.value, [](const auto& x) { return x.is_zero(); });
  scene().point_laws.push_back(std::move(law));
}

/// Entries that are off or do nothing are checked like others and then left out.
void SceneEffects::read_entries(const Row& row, const SceneFields& effects, const Node& node) {
  Keys keys = row.keys;
  keys.push_back("use");
  const std::vector<Node>& items = effects.sequence(node);
  for (std::size_t k = 0; k < items.size(); ++k) {
    const SceneFields fields =
        context_.fields(items[k], called(row.effect, items[k], k), keys).at_run_time();
    const bool used = entry_acts(row.effect, fields);
    const model::Scene before = scene();
    entry_is_off_ = !used;
    entry_is_nothing_ = false;
    (this->*row.read)(fields);
    if (used) {
      acting_.emplace(row.effect);
    }
    if (!used || entry_is_nothing_) {
      scene() = before;
    }
  }
}

void SceneEffects::viscous_friction(const SceneFields& fields) {
  const int joint = context_.joint(fields);
  add(model::viscous_friction(joint, fields.amount("coefficient")));
}

/// Without slip_speed it sticks; phases tell how it acts then, which does not change at run time.
void SceneEffects::coulomb_friction(const SceneFields& fields) {
  const int joint = context_.joint(fields);
  const Real slip_speed = positive_at_run_time(fields, "slip_speed");
  if (slip_speed == 0) {
    const Real force = fields.fixed().amount("force");
    entry_is_nothing_ = force == 0;
    scene().frictions.push_back({joint, force});
  } else {
    add(model::coulomb_friction(joint, fields.amount("force"), slip_speed));
  }
}

void SceneEffects::stribeck_friction(const SceneFields& fields) {
  const int joint = context_.joint(fields);
  const Real force = fields.amount("force");
  const Real static_force = fields.amount("static_force");
  const Real stribeck_speed = fields.positive("stribeck_speed");
  const Real slip_speed = fields.positive("slip_speed");
  if (static_force.plain() < force.plain()) {
    fields.fail(fields.get("static_force").where,
                fmt::format("'static_force' {} is below 'force' {}; expected at least as "
                            "much",
                            static_force.convert_to<double>(), force.convert_to<double>()));
  }
  add(model::stribeck_friction(joint, force, static_force, stribeck_speed, slip_speed));
}

void SceneEffects::armature(const SceneFields& fields) {
  const Real inertia = fields.amount("inertia");
  entry_is_nothing_ = inertia == 0 && !scene().declares_parameters;
  scene().armatures.push_back({context_.joint(fields), inertia});
}

void SceneEffects::joint_spring(const SceneFields& fields) {
  const int joint = context_.joint(fields);
  const Real stiffness = fields.amount("stiffness");
  const Real damping = fields.amount_or("damping", 0);
  add(model::joint_spring(joint, stiffness, damping, fields.number_or("rest", 0)));
}

void SceneEffects::point_spring(const SceneFields& fields) {
  const int point = context_.moving_point(fields);
  const model::Vector3 anchor = fields.vector("anchor");
  const Real stiffness = fields.amount("stiffness");
  const Real damping = fields.amount_or("damping", 0);
  add(model::point_spring(point, anchor, stiffness, damping, fields.amount_or("rest_length", 0)));
}

/// A torque, or kp (target - q) + kd (target' - qd), or their sum.
void SceneEffects::drive(const SceneFields& fields) {
  const int joint = context_.joint(fields);
  model::Expression torque;
  const Node* const given = fields.find("torque");
  const Node* const target = fields.find("target");
  if (given == nullptr && target == nullptr) {
    fields.fail(fields.where(), "has no torque and no target; expected at least one");
  }
  if (given != nullptr) {
    torque = context_.expression(fields, *given, Of::kState);
  }
  if (target != nullptr) {
    const auto motion = context_.motion(fields, *target);
    const model::Expression q(model::Variable{model::Quantity::kPosition, joint});
    const model::Expression qd(model::Variable{model::Quantity::kVelocity, joint});
    const model::Expression stiff = fields.amount("kp") * (motion[0] - q);
    const model::Expression damped = fields.amount_or("kd", 0) * (motion[1] - qd);
    torque = torque + stiff + damped;
  } else if (const Node* const gain =
                 fields.find("kp") != nullptr ? fields.find("kp") : fields.find("kd")) {
    fields.fail(gain->key.where,
                fmt::format("'{}' without a target; expected target too", gain->key.text));
  }
  add(model::drive(joint, torque));
}

model::VectorExpression SceneEffects::load(const SceneFields& fields) const {
  model::VectorExpression result;
  const std::vector<Node>& entries = fields.triple(fields.get("value"));
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = context_.expression(fields, entries[k], Of::kPoint);
  }
  return result;
}

void SceneEffects::force(const SceneFields& fields) {
  const int point = context_.moving_point(fields);
  add(model::point_force(point, load(fields)));
}

void SceneEffects::moment(const SceneFields& fields) {
  const int point = context_.moving_point(fields);
  add(model::moment(point, load(fields)));
}

void SceneEffects::ground_contact(const SceneFields& fields) {
  model::GroundContact contact;
  contact.point = context_.moving_point(fields);
  contact.plane = {
      fields.find("normal") == nullptr ? model::Vector3{0, 0, 1} : fields.direction("normal"),
      fields.number_or("height", 0)};
  if (const Node* const law = fields.find("law")) {
    for (const char* const other : {"stiffness", "exponent", "dissipation"}) {
      if (fields.find(other) != nullptr) {
        fields.fail(fields.get(other).key.where,
                    fmt::format("'{}' beside 'law'; expected one of them", other));
      }
    }
    contact.law = context_.expression(fields, *law, Of::kDepth);
  } else {
    contact.stiffness = fields.positive("stiffness");
    contact.exponent = fields.fixed().number_or("exponent", 1);
    contact.dissipation = fields.amount_or("dissipation", 0);
    if (contact.exponent < 1 || contact.exponent > 100) {  // whole powers are written as products
      fields.fail(fields.get("exponent").where, fmt::format("'exponent' is {}; expected 1 to 100",
                                                            contact.exponent.convert_to<double>()));
    }
  }
  contact.friction = fields.amount_or("friction", 0);
  contact.slip_speed = positive_at_run_time(fields, "slip_speed");
  if (contact.friction > 0 && contact.slip_speed == 0) {
    fields.fail(fields.get("friction").key.where,
                "friction without 'slip_speed'; expected a slip speed above 0");
  }
  if (fields.find("friction") == nullptr && fields.find("slip_speed") != nullptr) {
    fields.fail(fields.get("slip_speed").key.where,
                "'slip_speed' without 'friction'; expected a coefficient of friction too");
  }
  scene().contacts.push_back(std::move(contact));
}

}  // namespace treedyn::description
