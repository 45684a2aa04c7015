#include "formulate/scene_formulator.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "formulate/constrained.hpp"
#include "formulate/constrained_inverse.hpp"
#include "formulate/contacts.hpp"
#include "formulate/scene_system.hpp"
#include "formulate/search.hpp"
#include "model/mass_unit.hpp"
#include "model/scene_facts.hpp"
#include "program/rank.hpp"

namespace treedyn::formulate {

namespace {

constexpr const char* kForceUnit = "N m|N";
constexpr const char* kAcceleration = "rad/s^2|m/s^2";

Seen scene_with_stand_ins(const model::Scene& scene, Options options) {
  options.gravity = scene.gravity;
  options.points = scene.points;
  options.scene = &scene;
  return with_stand_ins(scene.tree, options);
}

/// Of a function of the family that the table of a scene's functions calls so.
program::Signature signature_of(std::string_view family, std::string name,
                                std::vector<program::Array> inputs,
                                std::vector<program::Array> outputs) {
  const equations::SceneFunctionInfo& info = equations::scene_function_info(family);
  return {std::move(name), info.equation, info.what, std::move(inputs), std::move(outputs)};
}

program::Signature signature_of(const char* name, std::vector<program::Array> inputs,
                                std::vector<program::Array> outputs) {
  return signature_of(name, name, std::move(inputs), std::move(outputs));
}

}  // namespace

SceneFormulator::SceneFormulator(const model::Scene& scene, const Options& options)
    : seen_(scene_with_stand_ins(scene, options)),
      scene_(*seen_.scene),
      tree_(model::in_mass_unit(scene_.tree, model::mass_unit(scene.tree))),
      options_(seen_.options),
      dof_(scene.tree.dof()),
      positions_(scene) {
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    all_.push_back(static_cast<int>(c));
  }
}

int SceneFormulator::rows() const { return rows_of(scene_, all_); }

program::Array SceneFormulator::q() const { return {"q", dof_, "rad|m"}; }

program::Array SceneFormulator::qd() const { return {"qd", dof_, "rad/s|m/s"}; }

program::Array SceneFormulator::anchor() const {
  return {"anchor", anchor_offset(scene_, static_cast<int>(scene_.constraints.size())), "m|1|rad"};
}

Inputs SceneFormulator::places() const {
  return {.q = 0, .qd = scene_.velocity_products ? 1 : -1, .tau = 2};
}

program::Function SceneFormulator::plain(const program::Signature& signature,
                                         std::vector<Expr> (*build)(const Task& task)) const {
  const Recipe recipe{places(), {}, build};
  program::Function function = cheapest_by_structure(scene_.tree, recipe, options_);
  function.signature = signature;
  return function;
}

program::Function SceneFormulator::jacobian() const {
  program::Signature signature =
      signature_of("reaction_jacobian_transpose", {q()}, {{"J", dof_ * rows(), "m|1"}});
  signature.rows = row_names(scene_, all_);
  return plain(signature, build_reaction_jacobian);
}

program::Function SceneFormulator::bias() const {
  program::Signature signature =
      signature_of("reaction_bias_acceleration", {q(), qd()}, {{"gamma", rows(), "m/s^2|rad/s^2"}});
  signature.rows = row_names(scene_, all_);
  return plain(signature, build_reaction_bias);
}

void SceneFormulator::add_forces(const PhaseState& state, program::Staged& staged) {
  for (const model::JointForce& own : state.forces) {
    staged.forces.emplace_back(own.joint, own.force.plain());
  }
}

/// An input that is there from the beginning.
void SceneFormulator::add_input(const program::Array& input, program::Staged& staged) {
  staged.signature.inputs.push_back(input);
  staged.function.signature.inputs.push_back(input);
  staged.levels.push_back(0);
}

/// What is said of constraints with a place of their own.
void SceneFormulator::add_places(const std::vector<int>& active, program::Staged& staged) const {
  for (const int c : active) {
    if (has_place(scene_, c)) {
      staged.anchors.push_back(
          fmt::format("{} is drawn to where the initial state of the scene has it",
                      scene_.constraints[to_index(c)].name));
    }
  }
}

program::RowSolve SceneFormulator::solve_of(const program::Function& function, int rows,
                                            const std::vector<int>& constraints,
                                            const std::vector<int>& joints) const {
  program::OrdinaryRows ordinary = positions_.ordinary(constraints, joints);
  if (!joints.empty()) {
    ordinary.lengths.clear();  // K has a row for each of the joints
  }
  program::RowSolve solve = program::solve_of(function, rows, ordinary);
  solve.passes = step_method(scene_) && std::ranges::any_of(constraints, [&](int constraint) {
                   return is_stabilised(scene_, constraint);
                 });
  solve.tolerance = scene_.rank_tolerance.convert_to<double>();
  if (std::ranges::any_of(constraints, [&](int constraint) {
        return scene_.constraints[to_index(constraint)].kind == model::ConstraintKind::kJoined;
      })) {
    solve.elsewhere = solve.rank;  // no other position counts: loops are open there
  }
  return solve;
}

/// Equations that are solved between the parts of a function: they go out, the solution comes in.
void SceneFormulator::add_rows(int rows, program::Signature& inner) {
  inner.inputs.push_back({program::kMultiplierArray, rows, ""});
  inner.outputs.insert(inner.outputs.begin(), {{program::kMatrixArray, rows * (rows + 1) / 2, ""},
                                               {program::kRightArray, rows, ""}});
}

/// Contacts press on what follows.
void SceneFormulator::add_contacts(program::Staged& staged) const {
  staged.gates.push_back(program::Gate::kPress);
  for (std::size_t k = 0; k < scene_.contacts.size(); ++k) {
    staged.contacts.push_back(contact_press(k));
  }
}

void SceneFormulator::add_depths(program::Signature& inner) const {
  if (!scene_.contacts.empty()) {
    inner.outputs.push_back({program::kDepthArray, static_cast<int>(scene_.contacts.size()), "m"});
  }
}

program::Staged SceneFormulator::constrained_dynamics(const PhaseState& state) const {
  Options options = options_;
  options.active = state.active;
  options.phase_forces = state.forces;
  const bool free = rows_of(scene_, options.active) == 0 && can_be_articulated(scene_);
  const Recipe recipe{places(),
                      {.regrouping = true,
                       .moment_form = true,
                       .tensor_form = true,
                       .trunk = true,
                       .articulated = free,
                       .fixed_length = true},
                      build_constrained_dynamics};
  const SceneArrays arrays = constrained_arrays(scene_, options.active);
  const int r = rows_of(scene_, options.active);
  program::Staged staged;
  staged.function = cheapest_by_structure(tree_, recipe, options);
  const program::Array tau = {"tau", dof_, kForceUnit};
  const program::Array qdd = {"qdd", dof_, kAcceleration};
  staged.signature = signature_of("constrained_dynamics", "constrained_dynamics" + state.ending,
                                  {q(), qd(), tau}, {qdd});
  if (r == 0) {
    staged.signature.equation = "(8)";
    staged.signature.brief =
        "Joint accelerations; tau comes on top of the scene's own joint forces.";
  }
  program::Signature& inner = staged.function.signature;
  inner = staged.signature;
  staged.levels = {0, 0, 0};
  if (!scene_.contacts.empty()) {
    inner.inputs.back().name = program::kForceArray;
    staged.levels.back() = 1;
    add_contacts(staged);
  }
  if (r > 0) {
    staged.signature.outputs.push_back({"lambda", r, "N|N m"});
    inner.outputs = staged.signature.outputs;
    add_rows(r, inner);
    staged.gates.push_back(program::Gate::kSolve);
    staged.levels.push_back(static_cast<int>(staged.gates.size()));
  }
  add_depths(inner);
  if (arrays.t >= 0) {
    add_input({"t", 1, "s"}, staged);
  }
  if (arrays.anchor >= 0) {
    add_input(anchor(), staged);
    staged.anchors = anchor_names(scene_);
  }
  add_places(options.active, staged);
  if (r > 0) {
    staged.solves.push_back(solve_of(staged.function, r, options.active));
  }
  staged.signature.rows = row_names(scene_, options.active);
  staged.constraints = options.active;
  add_forces(state, staged);
  return staged;
}

/// Reactions that stand for drives, and the equations that they are found by.
void SceneFormulator::add_least_reactions(const std::vector<int>& active,
                                          program::Staged& staged) const {
  program::Signature& inner = staged.function.signature;
  staged.signature.outputs.push_back({"lambda", rows_of(scene_, active), "N|N m"});
  inner.outputs = staged.signature.outputs;
  add_rows(static_cast<int>(passive_joints(scene_).size()), inner);
  staged.gates.push_back(program::Gate::kSolve);
  staged.levels.push_back(static_cast<int>(staged.gates.size()));
  staged.signature.rows = row_names(scene_, active);
  staged.constraints = active;
}

program::Staged SceneFormulator::inverse_dynamics(const PhaseState& state) const {
  Options options = options_;
  options.active = state.active;
  options.phase_forces = state.forces;
  Inputs where = places();
  const InverseArrays arrays = inverse_arrays(scene_, state.active);
  where.qdd = arrays.qdd;
  where.tau = -1;
  const Recipe recipe{where,
                      {.regrouping = true, .moment_form = true, .fixed_length = true},
                      build_constrained_inverse};
  program::Staged staged;
  staged.function = cheapest_by_structure(scene_.tree, recipe, options);
  const program::Array qdd = {"qdd", dof_, kAcceleration};
  const program::Array tau = {"tau", dof_, kForceUnit};
  staged.signature =
      signature_of("constrained_inverse_dynamics", "constrained_inverse_dynamics" + state.ending,
                   {q(), qd(), qdd}, {tau});
  program::Signature& inner = staged.function.signature;
  inner = staged.signature;
  staged.levels = {0, 0, 0};
  if (!scene_.contacts.empty()) {
    add_contacts(staged);
  }
  if (arrays.scene.mu >= 0) {
    add_least_reactions(options.active, staged);
  } else {
    staged.signature.equation = "(8)";
    staged.signature.brief = "Joint forces, on top of the scene's own, that make a motion.";
  }
  if (!scene_.contacts.empty()) {
    inner.inputs.push_back({program::kForceArray, dof_, kForceUnit});
    staged.levels.push_back(1);
  }
  add_depths(inner);
  if (arrays.scene.t >= 0) {
    add_input({"t", 1, "s"}, staged);
  }
  const std::vector<int> passive = joints_without_drive(scene_, options.active);
  if (!passive.empty()) {
    staged.solves = {
        solve_of(staged.function, static_cast<int>(passive.size()), options.active, passive)};
  }
  add_forces(state, staged);
  return staged;
}

program::Staged SceneFormulator::impact(const ImpactName& impact) const {
  Options options = options_;
  options.active = impact.constraints;
  options.restitution = impact.restitution;
  options.held = impact.held;
  const Recipe recipe{
      {.q = 0},
      {.regrouping = true, .tensor_form = true, .trunk = true, .fixed_length = true},
      build_impact};
  const int r = rows_of(scene_, impact.constraints);
  program::Staged staged;
  staged.function = cheapest_by_structure(tree_, recipe, options);
  const program::Array minus = {"qd_minus", dof_, "rad/s|m/s"};
  const program::Array plus = {"qd_plus", dof_, "rad/s|m/s"};
  const program::Array P = {"P", r, "N s|N m s"};
  staged.signature = signature_of("impact", impact.name, {q(), minus}, {plus, P});
  staged.function.signature = staged.signature;
  add_rows(r, staged.function.signature);
  staged.levels = {0, 0, 1};
  staged.gates = {program::Gate::kSolve};
  staged.solves = {solve_of(staged.function, r, impact.constraints)};
  for (const int c : impact.constraints) {
    const bool held = std::ranges::binary_search(impact.held, c);
    for (const std::string& row : row_names(scene_, {c})) {
      staged.signature.rows.push_back(row + (held ? ", led through it" : ""));
    }
  }
  staged.constraints = impact.constraints;
  staged.restitution = impact.restitution.plain();
  staged.held = impact.held;
  return staged;
}

/// Where the law needs it, d^n in front of the last gate, which is number `gate`.
void SceneFormulator::add_power(std::size_t contact, std::size_t gate,
                                program::Staged& staged) const {
  if (!needs_power(scene_.contacts[contact])) {
    return;
  }
  const bool of_all = staged.gates.front() == program::Gate::kClamp;  // depths of all contacts
  staged.power = {of_all ? static_cast<int>(contact) : 0, scene_.contacts[contact].exponent};
  staged.gates.insert(staged.gates.begin() + static_cast<std::ptrdiff_t>(gate),
                      program::Gate::kPower);
  for (int& level : staged.levels) {
    level += level > static_cast<int>(gate) ? 1 : 0;
  }
  staged.function.signature.inputs.push_back({program::kPowerArray, 1, ""});
  staged.levels.push_back(static_cast<int>(gate) + 1);
}

program::Staged SceneFormulator::contact_press(std::size_t contact) const {
  const Recipe recipe{{.q = 0, .qd = 1}, {}, [contact](const Task& task) {
                        return build_contact_press(task, contact);
                      }};
  program::Staged staged;
  staged.function = cheapest_by_structure(scene_.tree, recipe, options_);
  const int count = static_cast<int>(scene_.contacts.size());
  const program::Array depth = {program::kDepthArray, count, "m"};
  const program::Array force = {program::kForceArray, dof_, kForceUnit};
  staged.signature = {
      contact_name(scene_, contact, "press"), "(8)", "", {q(), qd(), depth}, {force}};
  staged.function.signature = {staged.signature.name,
                               "",
                               "",
                               {q(), qd(), depth, {program::kNormalArray, 1, "N"}, force},
                               {{program::kLawArray, 1, "N"}, force}};
  staged.levels = {0, 0, 0, 1, 0};
  staged.gates = {program::Gate::kClamp};
  add_power(contact, 0, staged);
  return staged;
}

program::Staged SceneFormulator::contact_force(std::size_t contact) const {
  const Recipe recipe{{.q = 0, .qd = 1}, {}, [contact](const Task& task) {
                        return build_contact_force(task, contact);
                      }};
  program::Staged staged;
  staged.function = cheapest_by_structure(scene_.tree, recipe, options_);
  const program::Array depth = {program::kDepthArray, 1, "m"};
  const program::Array f = {"f", 3, "N"};
  staged.signature = signature_of("contact_force", contact_name(scene_, contact, "contact_force"),
                                  {q(), qd()}, {f});
  staged.function.signature = {staged.signature.name,
                               "",
                               "",
                               {q(), qd(), depth, {program::kNormalArray, 1, "N"}},
                               {depth, {program::kLawArray, 1, "N"}, f}};
  staged.levels = {0, 0, 1, 2};
  staged.gates = {program::Gate::kReturn, program::Gate::kClamp};
  add_power(contact, 1, staged);
  return staged;
}

}  // namespace treedyn::formulate
