// From a tree to the functions of INTERFACE.md 3: equations (2)-(11), simplified by the sparsity of
// D.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "formulate/pass_switches.hpp"
#include "model/scene.hpp"
#include "program/function.hpp"

namespace treedyn::formulate {

/// How forward dynamics solves, and its names, in their order.
enum class ForwardDynamics { kCheapest, kFactor, kArticulated };
inline constexpr std::array<std::string_view, 3> kForwardDynamics = {"cheapest", "factor",
                                                                     "articulated"};
/// \pre one of the names
inline ForwardDynamics forward_dynamics_of(std::string_view name) {
  return static_cast<ForwardDynamics>(std::ranges::find(kForwardDynamics, name) -
                                      kForwardDynamics.begin());
}

struct Options {
  model::Vector3 gravity{};          ///< m/s^2, base frame
  std::vector<model::Point> points;  ///< in the order of the generated arrays
  int effort = 2000;                 ///< moves of the variant search per function; 0: none
  ForwardDynamics forward_dynamics = ForwardDynamics::kCheapest;
  std::vector<Pass> without;            ///< passes that are switched off
  const model::Scene* scene = nullptr;  ///< of scene functions
  std::vector<int> active = {};         ///< of scene functions: the constraints that act, ascending
  std::vector<model::JointForce> phase_forces = {};  ///< of scene functions: those of the phase
  Real restitution = 0;                              ///< of impacts
  std::vector<int> held = {};  ///< of impacts: the active constraints that are led through it
  std::vector<model::Event> events = {};  ///< of functions of events: which
  bool share_limbs = false;               ///< equal limbs share code, see program/limb_code.hpp
  bool metres = false;                    ///< no other unit of length

  [[nodiscard]] bool has(Pass pass) const {
    return std::ranges::find(without, pass) == without.end();
  }
};

/// The functions that can be generated, in the order of INTERFACE.md 3.
const std::vector<std::string>& function_names();

/// Name, equation, arguments and units of a function, before any expression is built.
/// \pre `name` is one of function_names().
program::Signature signature(const std::string& name, int dof, int points);

/// The cheapest formulation found; deterministic.
/// \pre `name` is one of function_names().
program::Function formulated(const model::Tree& tree, const std::string& name,
                             const Options& options);

struct Derived;
/// The same of an equation of a user; its signature has the name alone.
program::Function formulated(const model::Tree& tree,
                             const std::shared_ptr<const Derived>& function,
                             const Options& options);

}  // namespace treedyn::formulate
