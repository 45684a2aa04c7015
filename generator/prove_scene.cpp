#include "prove_scene.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/engine.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"

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
/// behind the rank are zero.
Values solved(Matrix s, Values b) {
  const std::size_t n = b.size();
  std::vector<std::size_t> order;
  Values x(n);
  const auto free = [&](std::size_t i) {
    return std::find(order.begin(), order.end(), i) == order.end();
  };
  Real first = 0;
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t p = n;
    for (std::size_t i = 0; i < n; ++i) {
      p = free(i) && (p == n || s[i][i] > s[p][p]) ? i : p;
    }
    first = step == 0 ? s[p][p] : first;
    if (!(s[p][p] > first * Real("1e-25"))) {
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

/// The equations of motion of a scene at one state, as the engine has them.
class Equations {
 public:
  Equations(const model::Scene& scene, const Values& q, const Values& qd)
      : scene_(scene), engine_(scene.tree, scene.points, scene.gravity), dof_(scene.tree.dof()) {
    const Values a = engine_.evaluate("mass_matrix", {q});
    for (int i = 0; i < dof_; ++i) {
      A.emplace_back(a.begin() + i * dof_, a.begin() + (i + 1) * dof_);
    }
    const Values rates = scene.velocity_products ? qd : Values(qd.size());
    bias = engine_.evaluate("inverse_dynamics", {q, rates, Values(qd.size())});
    if (!scene.points.empty()) {
      C_ = engine_.evaluate("force_jacobian_transpose", {q});
      H_ = engine_.evaluate("moment_jacobian_transpose", {q});
      gamma_f_ = engine_.evaluate("point_bias_acceleration", {q, rates});
      gamma_n_ = engine_.evaluate("angular_bias_acceleration", {q, rates});
    }
  }

  Matrix A;
  Values bias;  ///< B + G

  struct Row {
    Values J;
    Real gamma = 0;
    Real wanted = 0;
  };
  /// \param meaning  of the variables of a_des
  template <class Meaning>
  std::vector<Row> rows(const std::vector<int>& active, const Meaning& meaning) const {
    std::vector<Row> result;
    for (const int c : active) {
      const model::Constraint& constraint = scene_.constraints[index(c)];
      for (std::size_t k = 0; k < constraint.rows(); ++k) {
        result.push_back(row(constraint, k));
        result.back().wanted = wanted(constraint, k, meaning);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] Row row(const model::Constraint& c, std::size_t k) const {
    Row result{Values(index(dof_)), 0, 0};
    if (c.kind == model::ConstraintKind::kJoint) {
      result.J[index(c.joint)] = 1;
      return result;
    }
    const bool turning = c.kind == model::ConstraintKind::kOrientation;
    add(result, c.directions[k], turning ? H_ : C_, turning ? gamma_n_ : gamma_f_, c.point, 1);
    if (c.kind == model::ConstraintKind::kJoined) {
      add(result, c.directions[k], C_, gamma_f_, c.other, -1);
    }
    return result;
  }

  void add(Row& row, const model::Vector3& d, const Values& jacobian, const Values& gamma,
           int point, int sign) const {
    const std::size_t width = 3 * scene_.points.size();
    for (std::size_t n = 0; n < 3; ++n) {
      const std::size_t column = 3 * index(point) + n;
      for (std::size_t i = 0; i < row.J.size(); ++i) {
        row.J[i] += sign * d[n] * jacobian[i * width + column];
      }
      row.gamma += sign * d[n] * gamma[column];
    }
  }

  template <class Meaning>
  static Real wanted(const model::Constraint& c, std::size_t k, const Meaning& meaning) {
    const auto value = [&](const model::Expression& e) {
      return e.evaluate<Real>([](const Real& x) { return x; }, meaning);
    };
    if (!c.accelerations.empty()) {
      return value(c.accelerations[k]);
    }
    if (c.kind == model::ConstraintKind::kJoint) {
      return value(c.curve.acceleration[0]);
    }
    Real sum = 0;
    for (std::size_t n = 0; n < 3 && c.kind == model::ConstraintKind::kPoint; ++n) {
      sum += c.directions[k][n] * value(c.curve.acceleration[n]);
    }
    return sum;
  }

  const model::Scene& scene_;
  engine::Engine<Real> engine_;
  int dof_;
  Values C_, H_, gamma_f_, gamma_n_;
};

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
  Real variable(const model::Variable& v) {
    switch (v.quantity) {
      case model::Quantity::kTime:
        return at("t")[0];
      case model::Quantity::kPosition:
        return at("q")[index(v.index)];
      default:
        TREEDYN_EXPECT(v.quantity == model::Quantity::kVelocity);
        return at("qd")[index(v.index)];
    }
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
  const Equations equations(scene, state.at("q"), bias ? state.at("qd") : at_rest);
  std::vector<int> all;
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    all.push_back(static_cast<int>(c));
  }
  const auto rows = equations.rows(all, [](const model::Variable&) { return Real(0); });
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

void prove_constrained(const model::Scene& scene, const std::vector<int>& active,
                       const program::Staged& staged, program::Random& random) {
  State state(staged.function.signature, random);
  const std::string& name = staged.signature.name;
  const auto n = index(scene.tree.dof());
  std::size_t r = 0;
  if (!staged.solves.empty()) {
    r = index(staged.solves.front().rows);
    const Values first = state.evaluate(staged.function);
    const auto size = static_cast<std::ptrdiff_t>(r * (r + 1) / 2);
    const Values lower(first.begin(), first.begin() + size);
    const Values b(first.begin() + size, first.begin() + size + static_cast<std::ptrdiff_t>(r));
    state.at(program::kMultiplierArray) = least_squares(symmetric(lower, r), b);
  }
  const Values values = state.evaluate(staged.function);
  const Values qdd(values.end() - static_cast<std::ptrdiff_t>(n + r),
                   values.end() - static_cast<std::ptrdiff_t>(r));
  const Values lambda(values.end() - static_cast<std::ptrdiff_t>(r), values.end());

  const Equations equations(scene, state.at("q"), state.at("qd"));
  const auto rows =
      equations.rows(active, [&](const model::Variable& v) { return state.variable(v); });
  Values motion;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum = dot(equations.A[i], qdd) + equations.bias[i] - state.at("tau")[i];
    for (std::size_t k = 0; k < r; ++k) {
      sum -= rows[k].J[i] * lambda[k];
    }
    motion.push_back(sum);
  }
  const Real scale =
      largest(equations.bias) + largest(state.at("tau")) + largest(qdd) + largest(lambda);
  require_small(name, "equation of motion", motion, scale * 1000);
  Values error;
  for (const Equations::Row& row : rows) {
    error.push_back(dot(row.J, qdd) + row.gamma - row.wanted);
  }
  if (!staged.solves.empty() && !staged.solves.front().regular()) {
    Values reaction(n);  // J^T error moves nothing: J A^-1 J^T error = 0
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < r; ++k) {
        reaction[i] += rows[k].J[i] * error[k];
      }
    }
    const Values moved = solved(equations.A, reaction);
    for (std::size_t k = 0; k < r; ++k) {
      error[k] = dot(rows[k].J, moved);
    }
  }
  require_small(name, "row", error, scale * 1000);
}

}  // namespace

bool is_scene_function(const program::Signature& signature) {
  return signature.name.starts_with("reaction_");
}

void prove_scene(const model::Scene& scene, const Programs& programs) {
  program::Random random(7);
  for (const program::Function& function : programs.functions) {
    if (is_scene_function(function.signature)) {
      prove_plain(scene, function, random);
    }
  }
  for (const program::Staged& staged : programs.staged) {
    prove_constrained(scene, scene.phases[index(staged.phase)].active, staged, random);
  }
}

}  // namespace treedyn
