// The effects of a scene file.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "description/scene_context.hpp"

namespace treedyn::description {

enum class Use { kDefault, kOn, kOff };

/// What `use:` and the entries of `effects:` say, as effects of the scene.
class SceneEffects {
 public:
  /// Reads both. \throws InputError for unknown effects and contradictions.
  SceneEffects(SceneContext& context, const SceneFields& root);

  /// False if `use:` switches the effect off.
  [[nodiscard]] bool acts(std::string_view effect) const;
  /// True for the name of a constraint that is switched off.
  [[nodiscard]] bool is_off(const std::string& constraint) const {
    return constraints_off_.count(constraint) > 0;
  }
  /// \throws InputError if two rows that act in one phase want different motions of one thing, or a
  /// lock and dry friction hold one joint.
  void refuse_contradictions(const SceneFields& root) const;

 private:
  using Reader = void (SceneEffects::*)(const SceneFields& fields);
  struct Row {
    std::string_view effect;
    Keys keys;
    Reader read;
  };
  static const std::vector<Row>& rows();

  void read_use(const Node& node);
  void read_entries(const Row& row, const SceneFields& effects, const Node& node);
  void read_gravity(const SceneFields& effects);
  void read_stabilisation(const Node& node);
  void check_on(const SceneFields& root, const Node* effects) const;
  [[nodiscard]] bool entry_acts(std::string_view effect, const SceneFields& fields) const;

  void viscous_friction(const SceneFields& fields);
  void coulomb_friction(const SceneFields& fields);
  void stribeck_friction(const SceneFields& fields);
  void armature(const SceneFields& fields);
  void joint_spring(const SceneFields& fields);
  void point_spring(const SceneFields& fields);
  void drive(const SceneFields& fields);
  void locked_joint(const SceneFields& fields);
  void force(const SceneFields& fields);
  void moment(const SceneFields& fields);
  void point_constraint(const SceneFields& fields);
  void orientation_constraint(const SceneFields& fields);
  void joined_constraint(const SceneFields& fields);
  void ground_contact(const SceneFields& fields);

  [[nodiscard]] model::VectorExpression load(const SceneFields& fields) const;
  void read_directions(const SceneFields& fields, model::Constraint& constraint) const;
  void read_accelerations(const SceneFields& fields, model::Constraint& constraint) const;
  void add(model::JointLaw law) { scene().joint_laws.push_back(std::move(law)); }
  void add(model::PointLaw law);
  void add(const SceneFields& fields, model::Constraint constraint);
  void refuse_friction_at_rest(const SceneFields& root, const model::Constraint& constraint) const;
  void refuse_second(const SceneFields& fields, const std::string& name) const;
  model::Scene& scene() { return context_.scene(); }

  SceneContext& context_;
  std::map<std::string, Use, std::less<>> use_;
  std::set<std::string, std::less<>> acting_;  ///< entries of an effect that are not off
  std::set<std::string, std::less<>> constraints_off_;
  std::map<std::string, Place, std::less<>> places_;  ///< of the entries of constraints
  bool entry_is_off_ = false;
  bool entry_is_nothing_ = false;  ///< its numbers are zero
};

}  // namespace treedyn::description
