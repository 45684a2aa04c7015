#include "verify/prove_scene.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "program/interpret.hpp"
#include "program/random.hpp"
#include "program/rank.hpp"
#include "simplify/constrained_inverse.hpp"
#include "simplify/scene_functions.hpp"
#include "verify/scene_equations.hpp"

namespace treedyn {

namespace {

using Values = std::vector<Real>;
using Matrix = std::vector<Values>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Real dot(const Values& a, const Values& b) {
  Real sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += a[k] * b[k];
  }
  return sum;
}

Real largest(const Values& values) {
  Real result = 0;
  for (const Real& x : values) {
    result = std::max(result, Real(abs(x)));
  }
  return result;
}

/// x of S x = b by Gaussian elimination with diagonal pivots; S positive semidefinite, components
/// behind the rank are zero: pivots of at most `least` of their own diagonal entry.
Values solved(Matrix s, Values b, const Real& least = Real("1e-25")) {
  const std::size_t n = b.size();
  std::vector<std::size_t> order;
  Values x(n);
  const auto free = [&](std::size_t i) {
    return std::find(order.begin(), order.end(), i) == order.end();
  };
  const Matrix whole = s;
  const auto share = [&](std::size_t i) {  // of its own diagonal entry
    return whole[i][i] > 0 ? Real(s[i][i] / whole[i][i]) : Real(0);
  };
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t p = n;
    for (std::size_t i = 0; i < n; ++i) {
      p = free(i) && (p == n || share(i) > share(p)) ? i : p;
    }
    if (!(share(p) > least)) {
      break;
    }
    order.push_back(p);
    for (std::size_t i = 0; i < n; ++i) {
      if (free(i)) {
        const Real factor = s[i][p] / s[p][p];
        for (std::size_t j = 0; j < n; ++j) {
          s[i][j] -= factor * s[p][j];
        }
        b[i] -= factor * b[p];
      }
    }
  }
  for (auto p = order.rbegin(); p != order.rend(); ++p) {
    Real sum = b[*p];
    for (std::size_t j = 0; j < n; ++j) {
      sum -= j == *p ? Real(0) : Real(s[*p][j] * x[j]);
    }
    x[*p] = sum / s[*p][*p];
  }
  return x;
}

/// x with K K x = K b: K x is as near to b as it can be.
Values least_squares(const Matrix& K, const Values& b) {
  Matrix square;
  Values right;
  for (const Values& row : K) {  // of the symmetric K
    square.emplace_back();
    std::transform(K.begin(), K.end(), std::back_inserter(square.back()),
                   [&](const Values& column) { return dot(row, column); });
    right.push_back(dot(row, b));
  }
  return solved(std::move(square), std::move(right));
}

/// Arrays by name, filled with pseudo-random numbers.
class State {
 public:
  State(const program::Signature& signature, program::Random& random) {
    for (const program::Array& array : signature.inputs) {
      names_.push_back(array.name);
      values_.emplace_back();
      std::generate_n(std::back_inserter(values_.back()), array.size,
                      [&] { return Real(2 * random.symmetric()); });
    }
  }
  Values& at(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    TREEDYN_EXPECT(found != names_.end());
    return values_[static_cast<std::size_t>(found - names_.begin())];
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }
  [[nodiscard]] Values evaluate(const program::Function& function) const {
    const std::vector<std::span<const Real>> spans(values_.begin(), values_.end());
    return program::interpret<Real>(function, spans);
  }

 private:
  std::vector<std::string> names_;
  std::vector<Values> values_;
};

void require_small(const std::string& name, const char* what, const Values& residual,
                   const Real& scale) {
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (!(abs(residual[k]) <= scale * Real("1e-30") + Real("1e-40"))) {
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

void prove_plain(const model::Scene& scene, const program::Function& function,
                 program::Random& random) {
  State state(function.signature, random);
  const Values ours = state.evaluate(function);
  const Values at_rest(state.at("q").size());
  const bool bias = state.has("qd");
  const SceneEquations equations(scene, state.at("q"), bias ? state.at("qd") : at_rest, 0);
  std::vector<int> all;
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    all.push_back(static_cast<int>(c));
  }
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

/// Finds the multipliers that K and b ask for. \return the values of all stages
Values solved_values(const program::Staged& staged, State& state) {
  if (!staged.solves.empty()) {
    const std::size_t r = index(staged.solves.front().rows);
    const Values first = state.evaluate(staged.function);
    const auto size = static_cast<std::ptrdiff_t>(r * (r + 1) / 2);
    const Values lower(first.begin(), first.begin() + size);
    const Values b(first.begin() + size, first.begin() + size + static_cast<std::ptrdiff_t>(r));
    const Matrix K = symmetric(lower, r);
    state.at(program::kMultiplierArray) =
        staged.solves.front().regular() ? solved(K, b, 0) : least_squares(K, b);
  }
  return state.evaluate(staged.function);
}

/// J A^-1 J^T, the lower half row by row.
Values inverse_weights(const SceneEquations& equations,
                       const std::vector<SceneEquations::Row>& rows) {
  Values K;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Values moved = solved(equations.inertia(), rows[k].J);
    for (std::size_t j = 0; j <= k; ++j) {
      K.push_back(dot(rows[j].J, moved));
    }
  }
  return K;
}

/// What is left of errors of the rows. Of deficient rows some errors no motion can reach:
/// J A^-1 J^T error = 0, as parts of the largest entry of this matrix.
Values reachable_error(const program::Staged& staged, const SceneEquations& equations,
                       const std::vector<SceneEquations::Row>& rows, Values error) {
  if (staged.solves.empty() || staged.solves.front().regular()) {
    return error;
  }
  Values reaction(equations.inertia().size());
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      reaction[i] += rows[k].J[i] * error[k];
    }
  }
  const Values moved = solved(equations.inertia(), reaction);
  const Values K = inverse_weights(equations, rows);
  const Real most = largest(K);
  // rows that depend on each other but for kDependent^2: the solution leaves out what is between
  const bool nearly =
      program::rank_of(K, static_cast<int>(rows.size())) > staged.solves.front().rank;
  const Real left_out = nearly ? Real(largest(error) * Real("1e-12")) : Real(0);
  for (std::size_t k = 0; k < rows.size() && most > 0; ++k) {
    const Real part = dot(rows[k].J, moved) / most;
    error[k] = abs(part) > left_out ? part : Real(0);
  }
  return error;
}

Real dot_of_sizes(const Values& a, const Values& b) {
  Real sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += abs(a[k] * b[k]);
  }
  return sum;
}

/// Of what is added up in A x + .. = J^T f and in J x, where x is made of parts that reactions f
/// cause: the largest.
Real largest_term(const SceneEquations& equations, const std::vector<SceneEquations::Row>& rows,
                  const Values& x, const Values& f) {
  Values parts;
  std::ranges::transform(x, std::back_inserter(parts), [](const Real& a) { return Real(abs(a)); });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Values caused = solved(equations.inertia(), rows[k].J);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i] += abs(caused[i] * f[k]);
    }
  }
  Real most = largest(parts);
  for (const Values& row : equations.inertia()) {
    most = std::max(most, dot_of_sizes(row, parts));
  }
  for (const SceneEquations::Row& row : rows) {
    most = std::max({most, dot_of_sizes(row.J, parts), Real(largest(row.J) * largest(f))});
  }
  return most;
}

/// A (qd_plus - qd_minus) = J^T P, J qd_plus = -e J qd_minus.
void prove_impact(const model::Scene& scene, const program::Staged& staged,
                  program::Random& random) {
  State state(staged.function.signature, random);
  const Values values = solved_values(staged, state);
  const std::size_t r = index(staged.solves.front().rows);
  const Values P(values.end() - static_cast<std::ptrdiff_t>(r), values.end());
  const Values& minus = state.at("qd_minus");
  const SceneEquations equations(scene, state.at("q"), Values(minus.size()), 0);
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  const Values plus(values.end() - static_cast<std::ptrdiff_t>(r + minus.size()),
                    values.end() - static_cast<std::ptrdiff_t>(r));
  Values motion;
  for (std::size_t i = 0; i < minus.size(); ++i) {
    Real sum = dot(equations.inertia()[i], plus) - dot(equations.inertia()[i], minus);
    for (std::size_t k = 0; k < r; ++k) {
      sum -= rows[k].J[i] * P[k];
    }
    motion.push_back(sum);
  }
  Values error;
  for (const SceneEquations::Row& row : rows) {
    error.push_back(dot(row.J, plus) + staged.restitution * dot(row.J, minus));
  }
  const Real scale =
      1000 * (1 + largest(plus) + largest(P) + largest_term(equations, rows, plus, P));
  require_small(staged.signature.name, "equation of motion", motion, scale);
  require_small(staged.signature.name, "row", reachable_error(staged, equations, rows, error),
                scale);
}

void prove_constrained(const model::Scene& scene, const program::Staged& staged,
                       program::Random& random) {
  State state(staged.function.signature, random);
  const std::string& name = staged.signature.name;
  const auto n = index(scene.tree.dof());
  const Values values = solved_values(staged, state);
  const std::size_t r = staged.solves.empty() ? 0 : index(staged.solves.front().rows);
  const auto contacts = static_cast<std::ptrdiff_t>(scene.contacts.size());
  const auto reactions = values.end() - contacts - static_cast<std::ptrdiff_t>(r);
  const Values qdd(reactions - static_cast<std::ptrdiff_t>(n), reactions);
  const Values lambda(reactions, values.end() - contacts);
  const Values& tau = state.at(state.has("tau") ? "tau" : program::kForceArray);

  const SceneEquations equations(scene, state.at("q"), state.at("qd"),
                                 state.has("t") ? state.at("t")[0] : Real(0),
                                 state.has("anchor") ? state.at("anchor") : Values());
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  const Values force = equations.force();
  Values motion;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum = dot(equations.inertia()[i], qdd) + equations.bias()[i] - tau[i] - force[i];
    for (std::size_t k = 0; k < r; ++k) {
      sum -= rows[k].J[i] * lambda[k];
    }
    motion.push_back(sum);
  }
  const Real scale = largest(equations.bias()) + largest(force) + largest(tau) + largest(qdd) +
                     largest(lambda) + largest_term(equations, rows, qdd, lambda);
  require_small(name, "equation of motion", motion, scale * 1000);
  Values error;
  for (const SceneEquations::Row& row : rows) {
    error.push_back(dot(row.J, qdd) + row.gamma - row.wanted);
  }
  error = reachable_error(staged, equations, rows, error);
  require_small(name, "row", error, scale * 1000);
}

/// A qdd + B + G = tau + J^T lambda and the scene's forces; regular rows leave the passive joints
/// without a drive.
void prove_inverse(const model::Scene& scene, const program::Staged& staged,
                   program::Random& random) {
  State state(staged.function.signature, random);
  const Values values = solved_values(staged, state);
  const SceneEquations equations(scene, state.at("q"), state.at("qd"),
                                 state.has("t") ? state.at("t")[0] : Real(0));
  const std::vector<SceneEquations::Row> rows = equations.rows(staged.constraints);
  const auto n = index(scene.tree.dof());
  const auto first =
      values.end() - static_cast<std::ptrdiff_t>(n + rows.size() + scene.contacts.size());
  const Values tau(first, first + static_cast<std::ptrdiff_t>(n));
  const Values lambda(first + static_cast<std::ptrdiff_t>(n),
                      first + static_cast<std::ptrdiff_t>(n + rows.size()));
  Values force = equations.force();
  for (std::size_t i = 0; i < n && !scene.contacts.empty(); ++i) {
    force[i] += state.at(program::kForceArray)[i];
  }
  Values motion;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum =
        dot(equations.inertia()[i], state.at("qdd")) + equations.bias()[i] - tau[i] - force[i];
    for (std::size_t k = 0; k < rows.size(); ++k) {
      sum -= rows[k].J[i] * lambda[k];
    }
    motion.push_back(sum);
  }
  const Real scale = 1000 * (largest(tau) + largest(lambda) + largest(equations.bias()));
  require_small(staged.signature.name, "equation of motion", motion, scale);
  if (staged.solves.front().regular()) {
    Values left;
    for (const int joint : simplify::passive_joints(scene)) {
      left.push_back(tau[index(joint)]);
    }
    require_small(staged.signature.name, "passive joint", left, scale);
  }
}

/// Joint forces of every contact at a depth, by the law's own words, against C f.
void prove_contacts(const model::Scene& scene, const program::Staged& staged,
                    program::Random& random) {
  for (std::size_t c = 0; c < staged.contacts.size(); ++c) {
    const program::Staged& press = staged.contacts[c];
    State state(press.function.signature, random);
    Real& depth = state.at(program::kDepthArray)[c];
    depth = abs(depth);
    if (state.has(program::kPowerArray)) {
      state.at(program::kPowerArray)[0] = pow(depth, press.power.exponent);
    }
    const SceneEquations equations(scene, state.at("q"), state.at("qd"), 0);
    const Real law = equations.contact_law(scene.contacts[c], depth);
    state.at(program::kNormalArray)[0] = std::max(law, Real(0));
    const Values force = equations.contact(scene.contacts[c], std::max(law, Real(0)));
    const Values ours = state.evaluate(press.function);
    Values residual = {ours[0] - law};
    for (std::size_t i = 0; i < force.size(); ++i) {
      residual.push_back(ours[i + 1] - state.at(program::kForceArray)[i] - force[i]);
    }
    require_small(press.signature.name, "force", residual, largest(ours) + largest(force));
  }
}

}  // namespace

void prove_scene(const model::Scene& scene, const Programs& programs) {
  program::Random random(7);
  for (const program::Function& function : programs.functions) {
    if (simplify::is_scene_function(function.signature.name)) {
      prove_plain(scene, function, random);
    }
  }
  for (const program::Staged& staged : programs.staged) {
    if (staged.signature.name.starts_with("constrained_dynamics")) {
      prove_constrained(scene, staged, random);
      prove_contacts(scene, staged, random);
    } else if (staged.signature.name.starts_with("constrained_inverse")) {
      prove_inverse(scene, staged, random);
    } else if (staged.signature.name.starts_with("impact")) {
      prove_impact(scene, staged, random);
    }
  }
}

}  // namespace treedyn
