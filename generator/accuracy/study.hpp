// What accuracy costs: runs of the generated step, the cheapest of them, and the choice by a
// target.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/core.hpp"
#include "program/stepper.hpp"

namespace treedyn::accuracy {

/// Largest differences from the reference at the times of comparison; of drift sizes of phi and of
/// J qd less what is led, as they are; of events differences of their times.
enum class Error { kJoints, kEnergy, kDrift, kAngle, kSpeed, kRate, kEvents, kPoints };

struct ErrorRow {
  Error error;
  std::string_view name;    ///< of `--error`
  std::string_view column;  ///< in CSV; in JSON the plural
  std::string_view head;    ///< of a column for the reader
  std::string_view text;    ///< what it is the largest of
};

inline constexpr std::array<ErrorRow, 8> kErrors = {{
    {Error::kJoints, "joints", "error", "error", "error of a joint, rad or m"},
    {Error::kEnergy, "energy", "energy_error", "energy, J", "error of the energy, J"},
    {Error::kDrift, "drift", "drift", "drift, m", "drift of a constraint, m"},
    {Error::kAngle, "drift_angle", "drift_angle", "drift, rad", "drift of a constraint, rad"},
    {Error::kSpeed, "drift_speed", "drift_speed", "drift, m/s", "speed off a constraint, m/s"},
    {Error::kRate, "drift_rate", "drift_rate", "drift, rad/s", "speed off a constraint, rad/s"},
    {Error::kEvents, "events", "event_error", "events, s", "error of the time of an event, s"},
    {Error::kPoints, "points", "point_error", "points, m", "error of a point, m"},
}};

constexpr const ErrorRow& row_of(Error error) { return kErrors[static_cast<std::size_t>(error)]; }

/// What holds the state: a scalar, in a compensated step with what its sums lost.
enum class State { kFloat, kCompensated, kDouble };
inline constexpr State kStates[] = {State::kFloat, State::kCompensated, State::kDouble};

/// "float", "float compensated", "double".
const char* name_of(State state);

/// What else may be chosen of the step: words of the options of the same names.
struct Variant {
  std::string sincos = "pair";
  std::string forward_dynamics = "cheapest";
  std::string stabilisation = "scene";  ///< as the scene says
  std::string cuts = "scene";
  std::string without = "nothing";  ///< the effect that is left out
  bool operator==(const Variant&) const = default;
};

/// " sincos=libm cuts=0": what is not as usual.
std::string text_of(const Variant& variant);

/// How firmware would step the scene.
struct Setting {
  State state = State::kFloat;
  std::string integrator;
  double step = 0;  ///< s
  Variant variant = {};
  bool operator==(const Setting&) const = default;
};

/// "float compensated rk4 0.01 cuts=0".
std::string text_of(const Setting& setting);
/// The integrator and the variant: steps of one method differ in their length alone.
std::string method_of(const Setting& setting);

/// What a step takes on a processor, bytes.
struct Size {
  long flash = 0;  ///< code and constants, what it calls of the compiler's libraries included
  long stack = 0;  ///< the deepest way of calls
};

/// Steps in one phase, the operations of one that repeats nothing, and of each repetition by its
/// number.
struct PhaseSteps {
  program::Cost cost;
  std::vector<program::Cost> repeated_costs = {};
  program::StepCount count = {};

  /// Of repetitions.
  [[nodiscard]] std::size_t kinds() const;
};

/// What came of a setting over the band of initial states.
struct Outcome {
  Setting setting;
  /// Of all motions.
  std::vector<PhaseSteps> phases;
  /// Of each initial state the largest along the motion; not finite where it ended, not there
  /// where the scene has nothing of the kind.
  std::map<Error, std::vector<double>> errors;
  int status = 0;                     ///< bits that `step` returned
  std::map<std::string, Size> sizes;  ///< by the names of cores, where they were asked for
  double time = 0;  ///< of this machine for a second of motion, s; 0: not measured

  [[nodiscard]] bool has(Error of) const { return errors.contains(of); }
  [[nodiscard]] bool failed() const;                            ///< the motion ended
  [[nodiscard]] double error(Error of = Error::kJoints) const;  ///< the largest of all states
  [[nodiscard]] double least(Error of = Error::kJoints) const;  ///< the smallest
  /// Below this 19 of 20 further initial states are expected: the upper end of a prediction
  /// interval by Student's t of the logarithms; no less than the largest. Of one state its own.
  [[nodiscard]] double expected(Error of = Error::kJoints) const;
  /// Operations of a step, the mean over the motions.
  [[nodiscard]] program::Cost step_cost() const;
  /// Cycles of a step in the dearest phase, if it repeats everything as often as any has.
  [[nodiscard]] double most_cycles(const Core& core) const;
  /// Cycles for a second of motion. \param contracted  of code compiled with contraction, whose
  /// bits and errors are others
  [[nodiscard]] double cycles_per_second(const Core& core, bool contracted = false) const;

 private:
  /// Over all steps.
  template <class Of>
  [[nodiscard]] double mean(Of of) const;
  [[nodiscard]] double cycles_of(const program::Cost& cost, const Core& core,
                                 bool contracted = false) const;
};

/// What errors are measured against.
struct Reference {
  std::string methods;                  ///< the two that were compared
  double agreement = 0;                 ///< largest difference of their joint coordinates, rad or m
  std::map<Error, double> differences;  ///< the same of all errors; of drift none is needed
  std::string check;            ///< what shares no text with them; empty: it did not get through
  double check_difference = 0;  ///< largest, from the first method
  double check_error = 0;       ///< of it, by its difference from itself at ten times its tolerance

  /// True if the check contradicts: it is off by more than ten times what both are known to.
  [[nodiscard]] bool refuted() const;
  /// What an error is not known to.
  [[nodiscard]] double uncertainty(Error of = Error::kJoints) const;
};

/// What a setting may take of a processor, bytes.
struct Limits {
  std::optional<long> flash;
  std::optional<long> stack;
};

/// The longest step of a method that amplifies nothing, the least at some times of the motion, s.
struct StepLimit {
  std::string integrator;
  double step = 0;
};

/// All runs of one scene.
struct Study {
  std::string scene;
  double duration = 0;           ///< s
  int states = 0;                ///< in the band, the scene's own first
  double spread = 0;             ///< of the band, part of each coordinate and speed
  int cuts = 0;                  ///< of the scene: shorter steps that look for an event
  bool speeds_only = false;      ///< loops have their place: coordinates stay
  std::optional<double> rate;    ///< of a controller, Hz; a whole number of steps a period
  Error error = Error::kJoints;  ///< of which targets, fronts, floors and pictures are
  Limits limits;
  std::vector<std::string> points;  ///< names of those that are compared
  Reference reference;
  std::vector<StepLimit> stability;  ///< of the methods that have one, contacts closed
  std::vector<Outcome> outcomes;     ///< by method, scalar, falling step
};

/// The errors that the scene has, in the order of kErrors.
std::vector<Error> errors_of(const Study& study);

/// Numbers of the outcomes than which none is both cheaper and more accurate, by rising cost.
std::vector<std::size_t> pareto(const Study& study, const Core& core);

/// Initial states (by number, the scene's own is 1) of whose errors some is over a hundred times
/// the median of all states, with the settings of which that is so.
struct Sensitive {
  int state = 0;
  std::size_t settings = 0;
  Setting worst;     ///< where it is most times the median
  double error = 0;  ///< there
  double median = 0;
};
std::vector<Sensitive> sensitive_states(const Study& study);

/// True if a step keeps the limits on a core.
bool fits(const Study& study, const Core& core, const Outcome& outcome);

/// The outcome that reaches `target` within the limits for the fewest cycles; nothing if there is
/// none.
std::optional<std::size_t> cheapest(const Study& study, const Core& core, double target);

/// The outcome of the smallest error within the limits; nothing if all failed or exceed them.
std::optional<std::size_t> most_accurate(const Study& study, const Core& core);

/// The order p of e = C h^p by least squares over steps of one scalar and method whose error lies
/// between 100 times the smallest and 1e-3: of these the shortest, as many as the order from one to
/// the next is the same within a quarter. Nothing with fewer than three.
std::optional<double> fitted_order(const Study& study, State state, const std::string& method);

/// The smallest error of a scalar and the step at which it is reached; nothing where all failed.
struct Floor {
  double error = 0;
  Setting setting;
  /// Shorter steps of this method gain nothing; else the smallest error is where the steps end.
  bool is_reached = false;
};
std::optional<Floor> floor_of(const Study& study, State state);

/// The smallest error of steps that take an event where they end (cuts=0); nothing where none does.
std::optional<Floor> event_floor(const Study& study);

}  // namespace treedyn::accuracy
