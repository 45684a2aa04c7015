#include "verify/scene_at_states.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "model/scene_facts.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"
#include "program/rank.hpp"
#include "program/row_rank.hpp"
#include "verify/scene_equations.hpp"
#include "verify/solve.hpp"

namespace treedyn::verify {

namespace {

/// What arguments are filled with.
struct StateSource {
  program::Random random = program::Random(7);
  const Values& derived;  ///< of run-time parameters
};

/// Arrays by name, filled with pseudo-random numbers.
class State {
 public:
  State(const program::Signature& signature, StateSource& source) {
    for (const program::Array& array : signature.inputs) {
      names_.push_back(array.name);
      values_.emplace_back();
      if (!array.type.empty()) {
        values_.back() = source.derived;
        continue;
      }
      std::generate_n(std::back_inserter(values_.back()), array.size,
                      [&] { return Real(2 * source.random.symmetric()); });
    }
  }
  Values& at(const std::string& name) {
    const auto found = std::ranges::find(names_, name);
    TREEDYN_EXPECT(found != names_.end());
    return values_[static_cast<std::size_t>(found - names_.begin())];
  }
  /// Nearer to where the scene starts: this part of the way is left.
  void approach(const model::Scene& scene, double part) {
    const auto move = [&](const char* name, const Values& to) {
      for (std::size_t k = 0; has(name) && k < to.size(); ++k) {
        at(name)[k] = to[k] + part * at(name)[k];
      }
    };
    move("q", scene.q0);
    move("qd", scene.qd0);
    if (has("t")) {
      at("t")[0] = scene.t0 + part * abs(at("t")[0]);
    }
    if (has(program::kDepthArray)) {
      std::ranges::for_each(at(program::kDepthArray), [part](Real& depth) { depth *= part; });
    }
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::ranges::find(names_, name) != names_.end();
  }
  [[nodiscard]] Values evaluate(const program::Function& function) const {
    const std::vector<std::span<const Real>> spans(values_.begin(), values_.end());
    return program::interpret<Real>(function, spans);
  }

 private:
  std::vector<std::string> names_;
  std::vector<Values> values_;
};

bool is_finite(const Values& values) {
  return std::ranges::all_of(values, [](const Real& x) { return isfinite(x); });
}

/// Expressions of a scene need not have values everywhere. At a pseudo-random state, or at one
/// nearer to where the scene starts.
/// \param judged  State -> true, or false where the equations have no value
/// \throws std::domain_error if they have none at the start
template <class Judged>
void at_some_state(const model::Scene& scene, const program::Signature& signature,
                   StateSource& source, Judged judged) {
  for (const double part : {1.0, 0.5, 0.5, 0.5, 0.5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.0}) {
    State state(signature, source);
    if (part < 1) {
      state.approach(scene, part);
    }
    if (judged(state)) {
      return;
    }
  }
  std::vector<double> start;
  for (const std::vector<Real>& part : {scene.q0, scene.qd0}) {
    std::ranges::transform(part, std::back_inserter(start),
                           [](const Real& x) { return static_cast<double>(x); });
  }
  const std::string lost = model::without_value(scene, static_cast<double>(scene.t0), start);
  throw std::domain_error(fmt::format(
      "function '{}': {} has no value where the scene starts, at t = {} s; expected one "
      "that is finite there",
      signature.name, lost.empty() ? "an expression of the scene" : lost,
      static_cast<double>(scene.t0)));
}

/// \param sizes  of what is added up to it, the largest sum
/// \param least  by the smallest pivots on the way errors may have grown
void require_small(const std::string& name, const char* what, const Values& residual,
                   const Real& sizes, const Real& least = 1) {
  // values of 37 equal digits are one to the passes; some hundred meet in a sum
  const Real tolerance = sizes * Real("1e-34") / least + Real("1e-40");
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (!(abs(residual[k]) <= tolerance)) {
      throw std::logic_error(
          fmt::format("function '{}' differs from its equations: {} {} is off by {}", name, what, k,
                      residual[k].str(5)));
    }
  }
}

/// The lower half of a symmetric matrix, row by row, as rows.
Matrix symmetric(const Values& lower, std::size_t n) {
  Matrix result(n, Values(n));
  for (std::size_t i = 0, place = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      result[i][j] = result[j][i] = lower[place++];
    }
  }
  return result;
}

void check_plain(const model::Scene& scene, const program::Function& function,
                 StateSource& source) {
  State state(function.signature, source);
  const Values ours = state.evaluate(function);
  const Values at_rest(state.at("q").size());
  const bool bias = state.has("qd");
  const SceneEquations equations(scene, state.at("q"), bias ? state.at("qd") : at_rest, 0);
  std::vector<int> all(scene.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<SceneEquations::Row> rows = equations.rows(all);
  Values residual;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t i = 0; !bias && i < rows[r].J.size(); ++i) {
      residual.push_back(ours[i * rows.size() + r] - rows[r].J[i]);
    }
    if (bias) {
      residual.push_back(ours[r] - rows[r].gamma);
    }
  }
  require_small(function.signature.name, "element", residual, largest(ours));
}

/// Values of all stages.
struct StageValues {
  Values values;
  Real least = 1;              ///< the smallest pivot of K
  std::vector<bool> left_out;  ///< rows that joints move by the last digits of lengths alone
};

/// Leaves out rows whose diagonal entry of K is below 1e-30 of their size, 15 decades below what
/// the code takes for rounding: their entries of J have no 34 digits.
std::vector<bool> leave_out(const program::RowSolve& solve, Matrix& K, Values& b) {
  std::vector<bool> result(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    result[k] = K[k][k] <= Real("1e-30") * Real(solve.sizes[k]);
    for (std::size_t i = 0; result[k] && i < b.size(); ++i) {
      K[i][k] = K[k][i] = b[k] = 0;
    }
  }
  return result;
}

/// The values of all stages with the multipliers that K and b ask for.
StageValues solved_values(const program::Staged& staged, State& state) {
  StageValues result;
  if (!staged.solves.empty()) {
    const program::RowSolve& solve = staged.solves.front();
    const std::size_t r = to_index(solve.rows);
    const Values first = state.evaluate(staged.function);
    const auto size = static_cast<std::ptrdiff_t>(r * (r + 1) / 2);
    const Values lower(first.begin(), first.begin() + size);
    Values b(first.begin() + size, first.begin() + size + static_cast<std::ptrdiff_t>(r));
    Matrix K = symmetric(lower, r);
    result.left_out = leave_out(solve, K, b);
    Solution solution = solve.regular() ? solved(K, b, 0) : least_squares(K, b);
    state.at(program::kMultiplierArray) = std::move(solution.x);
    result.least = solution.least;
  }
  result.values = state.evaluate(staged.function);
  return result;
}

/// What is left of A x = right + J^T y, and the largest sum of the sizes of its terms.
struct Residual {
  Values left;
  Real sizes = 0;

  void add(std::size_t i, const Real& term) {
    left[i] += term;
    sum_[i] += abs(term);
    sizes = std::max(sizes, sum_[i]);
  }
  explicit Residual(std::size_t count) : left(count), sum_(count) {}

 private:
  Values sum_;
};

Residual motion_of(const SceneEquations& equations, const std::vector<SceneEquations::Row>& rows,
                   const Values& x, const Values& y) {
  Residual result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      result.add(i, equations.inertia()[i][j] * x[j]);
    }
    for (std::size_t k = 0; k < y.size(); ++k) {
      result.add(i, -rows[k].J[i] * y[k]);
    }
  }
  return result;
}

/// The smallest pivot of A.
Real least_pivot(const SceneEquations& equations) {
  return solved(equations.inertia(), Values(equations.inertia().size())).least;
}

/// J A^-1 J^T, the lower half row by row.
Values inverse_weights(const SceneEquations& equations,
                       const std::vector<SceneEquations::Row>& rows) {
  Values K;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Values moved = solved(equations.inertia(), rows[k].J).x;
    for (std::size_t j = 0; j <= k; ++j) {
      K.push_back(dot(rows[j].J, moved));
    }
  }
  return K;
}

Real trace_of_inverse(const SceneEquations& equations) {
  const std::size_t n = equations.inertia().size();
  Real trace = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Values unit(n);
    unit[i] = 1;
    trace += solved(equations.inertia(), unit).x[i];
  }
  return trace;
}

/// The largest part of an error, of J A^-1 J^T relative to its largest entry, that rows which
/// depend on each other but for kDependent leave: for such a combination e of them |J^T e| is at
/// most r kDependent |e| of the longest row, and e^T K e at most |J^T e|^2 times the trace of A^-1.
Real dependent_part(const SceneEquations& equations, const std::vector<SceneEquations::Row>& rows,
                    const Real& most) {
  Real longest = 0;
  for (const SceneEquations::Row& row : rows) {
    longest = std::max(longest, dot(row.J, row.J));
  }
  const Real part = Real(program::kDependent) * static_cast<int>(rows.size());
  return part * part * longest * trace_of_inverse(equations) / most;
}

/// The largest acceleration of a row by errors of this size in the equation of motion:
/// |J A^-1 e| <= sqrt(tr(J A^-1 J^T) tr(A^-1)) |e|.
Real acceleration_by(const SceneEquations& equations, const std::vector<SceneEquations::Row>& rows,
                     const Real& size) {
  Real trace = 0;
  for (const SceneEquations::Row& row : rows) {
    trace += dot(row.J, solved(equations.inertia(), row.J).x);
  }
  const auto n = static_cast<int>(equations.inertia().size());
  return sqrt(n * trace * trace_of_inverse(equations)) * size;
}

/// What rows are beside: their terms and, where accelerations are small for the forces that make
/// them, those by the rounding of the equation of motion, which no pivot of the rows enlarges.
/// \param of_motion  the sizes of its terms
Real sizes_of_rows(const SceneEquations& equations, const std::vector<SceneEquations::Row>& rows,
                   const Residual& error, const Real& of_motion, const Real& least) {
  const bool suffices = largest(error.left) <= error.sizes * Real("1e-34");
  return suffices ? error.sizes
                  : Real(error.sizes + least * acceleration_by(equations, rows, of_motion));
}

/// What is left of errors of the rows. Of deficient rows some errors no motion can reach:
/// J A^-1 J^T error = 0, as parts of the largest entry of this matrix.
Values reachable_error(const program::Staged& staged, const SceneEquations& equations,
                       const std::vector<SceneEquations::Row>& rows, Values error,
                       const std::vector<bool>& left_out_rows) {
  for (std::size_t k = 0; k < left_out_rows.size(); ++k) {
    error[k] = left_out_rows[k] ? Real(0) : error[k];
  }
  if (staged.solves.empty() || staged.solves.front().regular()) {
    return error;
  }
  Values reaction(equations.inertia().size());
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      reaction[i] += rows[k].J[i] * error[k];
    }
  }
  const Values moved = solved(equations.inertia(), reaction).x;
  const Values K = inverse_weights(equations, rows);
  const Real most = largest(K);
  if (most <= Real("1e-60")) {  // no motion reaches any row
    return Values(rows.size());
  }
  // rows that depend on each other nearly: the solution leaves out what is between
  const bool nearly =
      program::rank_of(K, static_cast<int>(rows.size())) > staged.solves.front().rank;
  const Real left_out =
      nearly ? Real(largest(error) * dependent_part(equations, rows, most)) : Real(0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Real part = dot(rows[k].J, moved) / most;
    error[k] = abs(part) > left_out ? part : Real(0);
  }
  return error;
}

/// e of every row of an impact, -1 where it is led through it.
Values shares_of_speed(const model::Scene& scene, const program::Staged& staged) {
  Values result;
  for (const int c : staged.constraints) {
    const bool held = std::ranges::binary_search(staged.held, c);
    result.insert(result.end(), scene.constraints[to_index(c)].rows(),
                  held ? Real(-1) : staged.restitution);
  }
  return result;
}

void check_impact(const model::Scene& scene, const program::Staged& staged, StateSource& source) {
  State state(staged.function.signature, source);
  const auto [values, least, left_out] = solved_values(staged, state);
  const std::size_t r = to_index(staged.solves.front().rows);
  const Values P(values.end() - static_cast<std::ptrdiff_t>(r), values.end());
  const Values& minus = state.at("qd_minus");
  const SceneEquations equations(scene, state.at("q"), Values(minus.size()), 0);
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  const Values plus(values.end() - static_cast<std::ptrdiff_t>(r + minus.size()),
                    values.end() - static_cast<std::ptrdiff_t>(r));
  Residual motion = motion_of(equations, rows, plus, P);
  for (std::size_t i = 0; i < minus.size(); ++i) {
    for (std::size_t j = 0; j < minus.size(); ++j) {
      motion.add(i, -equations.inertia()[i][j] * minus[j]);
    }
  }
  const Values of_before = shares_of_speed(scene, staged);
  Residual error(r);
  for (std::size_t k = 0; k < r; ++k) {
    for (std::size_t i = 0; i < minus.size(); ++i) {
      error.add(k, rows[k].J[i] * plus[i]);
      error.add(k, of_before[k] * rows[k].J[i] * minus[i]);
    }
  }
  const Real of_inertia = least_pivot(equations);
  const std::string& name = staged.signature.name;
  require_small(name, "equation of motion", motion.left, motion.sizes, of_inertia);
  require_small(name, "row", reachable_error(staged, equations, rows, error.left, left_out),
                sizes_of_rows(equations, rows, error, motion.sizes, least), of_inertia * least);
}

/// What rows want.
bool is_finite(const std::vector<SceneEquations::Row>& rows) {
  return std::ranges::all_of(rows,
                             [](const SceneEquations::Row& row) { return isfinite(row.wanted); });
}

/// Of the scene, and of the phase.
Values forces_of(const program::Staged& staged, const SceneEquations& equations) {
  Values force = equations.force();
  for (const auto& [joint, own] : staged.forces) {
    force[to_index(joint)] += own;
  }
  return force;
}

/// B + G - tau - force.
void add_forces(const SceneEquations& equations, const Values& tau, const Values& force,
                Residual& motion) {
  for (std::size_t i = 0; i < motion.left.size(); ++i) {
    for (const Real& term : {equations.bias()[i], Real(-tau[i]), Real(-force[i])}) {
      motion.add(i, term);
    }
  }
}

/// False where the scene has no value.
bool check_constrained(const model::Scene& scene, const program::Staged& staged, State& state) {
  const SceneEquations equations(scene, state.at("q"), state.at("qd"),
                                 state.has("t") ? state.at("t")[0] : Real(0),
                                 state.has("anchor") ? state.at("anchor") : Values());
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  const Values force = forces_of(staged, equations);
  if (!is_finite(force) || !is_finite(rows)) {
    return false;
  }
  const std::string& name = staged.signature.name;
  const auto n = to_index(scene.tree.dof());
  const auto [values, least, left_out] = solved_values(staged, state);
  const std::size_t r = staged.solves.empty() ? 0 : to_index(staged.solves.front().rows);
  const auto contacts = static_cast<std::ptrdiff_t>(scene.contacts.size());
  const auto reactions = values.end() - contacts - static_cast<std::ptrdiff_t>(r);
  const Values qdd(reactions - static_cast<std::ptrdiff_t>(n), reactions);
  const Values lambda(reactions, values.end() - contacts);
  const Values& tau = state.at(state.has("tau") ? "tau" : program::kForceArray);
  Residual motion = motion_of(equations, rows, qdd, lambda);
  add_forces(equations, tau, force, motion);
  Residual error(r);
  for (std::size_t k = 0; k < r; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      error.add(k, rows[k].J[i] * qdd[i]);
    }
    error.add(k, rows[k].gamma);
    error.add(k, -rows[k].wanted);
  }
  const Real of_inertia = least_pivot(equations);
  require_small(name, "equation of motion", motion.left, motion.sizes, of_inertia);
  require_small(name, "row", reachable_error(staged, equations, rows, error.left, left_out),
                sizes_of_rows(equations, rows, error, motion.sizes, least), of_inertia * least);
  return true;
}

/// A qdd + B + G = tau + J^T lambda and the scene's forces; regular rows leave the passive joints
/// without a drive. False where the scene has no value.
bool check_inverse(const model::Scene& scene, const program::Staged& staged, State& state) {
  const SceneEquations equations(scene, state.at("q"), state.at("qd"),
                                 state.has("t") ? state.at("t")[0] : Real(0));
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  Values force = forces_of(staged, equations);
  if (!is_finite(force) || !is_finite(rows)) {
    return false;
  }
  const auto [values, least, left_out] = solved_values(staged, state);
  const auto n = to_index(scene.tree.dof());
  const auto first =
      values.end() - static_cast<std::ptrdiff_t>(n + rows.size() + scene.contacts.size());
  const Values tau(first, first + static_cast<std::ptrdiff_t>(n));
  const Values lambda(first + static_cast<std::ptrdiff_t>(n),
                      first + static_cast<std::ptrdiff_t>(n + rows.size()));
  for (std::size_t i = 0; i < n && !scene.contacts.empty(); ++i) {
    force[i] += state.at(program::kForceArray)[i];
  }
  Residual motion = motion_of(equations, rows, state.at("qdd"), lambda);
  add_forces(equations, tau, force, motion);
  require_small(staged.signature.name, "equation of motion", motion.left, motion.sizes);
  if (!staged.solves.empty() && staged.solves.front().regular()) {
    Values left;
    for (const int joint : model::passive_joints(scene)) {
      left.push_back(tau[to_index(joint)]);
    }
    require_small(staged.signature.name, "passive joint", left, motion.sizes, least);
  }
  return true;
}

/// Joint forces of a contact at a depth, by the law's own words, against C f. False where the law
/// has no value.
bool check_contact(const model::Scene& scene, const program::Staged& press, std::size_t contact,
                   State& state) {
  Real& depth = state.at(program::kDepthArray)[contact];
  depth = abs(depth);
  if (state.has(program::kPowerArray)) {
    state.at(program::kPowerArray)[0] = pow(depth, press.power.exponent);
  }
  const SceneEquations equations(scene, state.at("q"), state.at("qd"), 0);
  const Real law = equations.contact_law(scene.contacts[contact], depth);
  if (!isfinite(law)) {
    return false;
  }
  state.at(program::kNormalArray)[0] = std::max(law, Real(0));
  const Values force = equations.contact(scene.contacts[contact], std::max(law, Real(0)));
  const Values ours = state.evaluate(press.function);
  Values residual = {ours[0] - law};
  for (std::size_t i = 0; i < force.size(); ++i) {
    residual.push_back(ours[i + 1] - state.at(program::kForceArray)[i] - force[i]);
  }
  require_small(press.signature.name, "force", residual, largest(ours) + largest(force));
  return true;
}

void check_contacts(const model::Scene& scene, const program::Staged& staged, StateSource& source) {
  for (std::size_t c = 0; c < staged.contacts.size(); ++c) {
    const program::Staged& press = staged.contacts[c];
    at_some_state(scene, press.function.signature, source,
                  [&](State& state) { return check_contact(scene, press, c, state); });
  }
}

}  // namespace

void check_scene_at_states(const model::Scene& scene, const program::Programs& programs,
                           const std::vector<Real>& derived) {
  StateSource source{.derived = derived};
  for (const program::Function& function : programs.functions) {
    if (equations::is_scene_function(function.signature.name)) {
      check_plain(scene, function, source);
    }
  }
  for (const program::Staged& staged : programs.staged) {
    if (staged.signature.name.starts_with("constrained_dynamics")) {
      at_some_state(scene, staged.function.signature, source,
                    [&](State& state) { return check_constrained(scene, staged, state); });
      check_contacts(scene, staged, source);
    } else if (staged.signature.name.starts_with("constrained_inverse")) {
      at_some_state(scene, staged.function.signature, source,
                    [&](State& state) { return check_inverse(scene, staged, state); });
    } else if (staged.signature.name.starts_with("impact")) {
      check_impact(scene, staged, source);
    }
  }
}

}  // namespace treedyn::verify
