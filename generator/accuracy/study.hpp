// What accuracy costs: runs of the generated step, the cheapest of them, and the choice by a
// target.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "accuracy/core.hpp"

namespace treedyn::accuracy {

/// What holds the state: a scalar, in a compensated step with what its sums lost.
enum class State { kFloat, kCompensated, kDouble };
inline constexpr State kStates[] = {State::kFloat, State::kCompensated, State::kDouble};

/// "float", "float compensated", "double".
const char* name_of(State state);

/// How firmware would step the scene.
struct Setting {
  State state = State::kFloat;
  std::string integrator;
  double step = 0;  ///< s
  bool operator==(const Setting&) const = default;
};

/// "float compensated rk4 0.01".
std::string text_of(const Setting& setting);

/// What came of a setting over the band of initial states.
struct Outcome {
  Setting setting;
  program::Cost step_cost;  ///< operations of a step in the phase in which the scene begins
  program::Cost worst_cost;
  /// Largest difference of a joint coordinate from the reference at the times of output, of each
  /// initial state, rad or m; not finite where the motion ended.
  std::vector<double> joint_errors;
  /// The same of the energy that is stored in motion, gravity, springs and contacts, J.
  std::vector<double> energy_errors;
  int status = 0;  ///< bits that `step` returned

  [[nodiscard]] bool failed() const;
  [[nodiscard]] double error() const;         ///< largest of joint_errors
  [[nodiscard]] double least() const;         ///< smallest
  [[nodiscard]] double energy_error() const;  ///< largest of energy_errors, J
  /// Cycles for a second of motion.
  [[nodiscard]] double cycles_per_second(const Core& core) const;
};

/// What errors are measured against.
struct Reference {
  std::string methods;          ///< the two that were compared
  double agreement = 0;         ///< largest difference of their joint coordinates, rad or m
  std::string check;            ///< what shares no text with them; empty: it did not get through
  double check_difference = 0;  ///< largest, from the first method
  double check_error = 0;       ///< of it, by its difference from itself at ten times its tolerance

  /// True if the check contradicts: it is off by more than ten times what both are known to.
  [[nodiscard]] bool refuted() const;
  /// What an error is not known to.
  [[nodiscard]] double uncertainty() const;
};

/// All runs of one scene.
struct Study {
  std::string scene;
  double duration = 0;         ///< s
  int states = 0;              ///< in the band, the scene's own first
  double spread = 0;           ///< of the band, part of each coordinate and speed
  bool speeds_only = false;    ///< loops have their place: coordinates stay
  std::optional<double> rate;  ///< of a controller, Hz; a whole number of steps a period
  Reference reference;
  std::vector<Outcome> outcomes;  ///< by scalar, integrator, falling step
};

/// Numbers of the outcomes than which none is both cheaper and more accurate, by rising cost.
std::vector<std::size_t> pareto(const Study& study, const Core& core);

/// True if an outcome is off by at most `target`, even if the uncertainty of the reference is added
/// to its error.
bool reaches(const Study& study, double target);

/// The outcome that reaches `target` for the fewest cycles; nothing if there is none.
std::optional<std::size_t> cheapest(const Study& study, const Core& core, double target);

/// The outcome of the smallest error. \pre there is one that did not fail
std::size_t most_accurate(const Study& study);

/// The order p of e = C h^p by least squares over the steps of one scalar and integrator whose
/// error lies between 100 times the smallest and 1e-3; nothing with fewer than two.
std::optional<double> fitted_order(const Study& study, State state, const std::string& integrator);

/// The smallest error of a scalar and the step at which it is reached; nothing where all failed.
struct Floor {
  double error = 0;
  Setting setting;
};
std::optional<Floor> floor_of(const Study& study, State state);

}  // namespace treedyn::accuracy
