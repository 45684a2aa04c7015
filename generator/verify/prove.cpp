#include "verify/prove.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/engine.hpp"
#include "engine/user.hpp"
#include "program/interpret.hpp"

namespace treedyn {

namespace {

/// Larger robots get one state: the engine's block products grow as N^3.
constexpr int kLargestForTwoStates = 20;

using Values = std::vector<Real>;

/// The same numbers on every machine (splitmix64), in (-2, 2).
class States {
 public:
  Real next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t x = state_;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    x ^= x >> 31U;
    return Real(static_cast<std::int64_t>(x)) / Real(std::int64_t{1} << 62U);
  }

  std::vector<Values> inputs(const program::Signature& signature) {
    std::vector<Values> result;
    for (const program::Array& array : signature.inputs) {
      result.emplace_back();
      std::generate_n(std::back_inserter(result.back()), array.size, [&] { return next(); });
    }
    return result;
  }

 private:
  std::uint64_t state_ = 1;
};

Values interpreted(const program::Function& function, const std::vector<Values>& inputs) {
  const std::vector<std::span<const Real>> spans(inputs.begin(), inputs.end());
  return program::interpret<Real>(function, spans);
}

void compare(const std::string& name, const Values& ours, const Values& engines) {
  Real largest = 0;
  for (const Real& value : engines) {
    largest = std::max(largest, Real(abs(value)));
  }
  const Real tolerance = largest * Real("1e-35") + Real("1e-40");
  for (std::size_t k = 0; k < engines.size(); ++k) {
    if (ours.size() != engines.size() || !(abs(ours[k] - engines[k]) <= tolerance)) {
      throw std::logic_error(fmt::format(
          "function '{}' differs from its block equation in element {}: {} instead of {}", name, k,
          ours.at(k).str(20), engines[k].str(20)));
    }
  }
}

/// a b for row-major n x n matrices.
Values product(const Values& a, const Values& b, std::size_t n) {
  Values result(n * (b.size() / n));
  const std::size_t columns = b.size() / n;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < columns; ++j) {
        result[i * columns + j] += a[i * n + k] * b[k * columns + j];
      }
    }
  }
  return result;
}

/// L^T diag(d) L of the concatenated L and d.
Values multiplied_out(const Values& factors, std::size_t n) {
  Values transposed(n * n);
  Values scaled(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      transposed[j * n + i] = factors[i * n + j];
      scaled[i * n + j] = factors[n * n + i] * factors[i * n + j];
    }
  }
  return product(transposed, scaled, n);
}

Values identity(std::size_t n) {
  Values result(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    result[i * n + i] = 1;
  }
  return result;
}

/// Functions that have no equation of their own are held against the equations they stand for.
void prove_function(const program::Function& function, engine::Engine<Real>& engine,
                    States& states) {
  const std::string& name = function.signature.name;
  const std::vector<Values> inputs = states.inputs(function.signature);
  const Values ours = interpreted(function, inputs);
  const auto n = static_cast<std::size_t>(engine.dof());
  const auto mass_matrix = [&] {
    return engine.evaluate("mass_matrix", {inputs[0]});
  };
  if (name == "mass_matrix_factor") {
    compare(name, multiplied_out(ours, n), mass_matrix());
  } else if (name == "mass_matrix_solve") {
    compare(name, product(mass_matrix(), ours, n), inputs[1]);
  } else if (name == "mass_matrix_inverse") {
    compare(name, product(mass_matrix(), ours, n), identity(n));
  } else if (name == "dynamics_terms") {
    Values expected = mass_matrix();
    for (const Values& term :
         {engine.evaluate("bias_force", inputs), engine.evaluate("gravity_force", {inputs[0]})}) {
      expected.insert(expected.end(), term.begin(), term.end());
    }
    compare(name, ours, expected);
  } else {
    compare(name, ours, engine.evaluate(name, inputs));
  }
}

/// The user's equation of that name; nullptr: one of ours.
const simplify::Derived* find(const simplify::DerivedFunctions& equations,
                              const std::string& name) {
  const auto found = std::find_if(equations.begin(), equations.end(), [&](const auto& function) {
    return function->equation.name == name;
  });
  return found == equations.end() ? nullptr : found->get();
}

}  // namespace

void prove_functions(const model::Tree& tree, const std::vector<model::Point>& points,
                     const model::Vector3& gravity, const simplify::DerivedFunctions& equations,
                     const std::vector<program::Function>& functions) {
  engine::Engine<Real> engine(tree, points, gravity);
  States states;
  for (int count = tree.size() <= kLargestForTwoStates ? 2 : 1; count > 0; --count) {
    for (const program::Function& function : functions) {
      if (const simplify::Derived* const of_user = find(equations, function.signature.name)) {
        const std::vector<Values> inputs = states.inputs(function.signature);
        engine::UserFunction<Real> expected(of_user->equation, tree, points, gravity);
        compare(function.signature.name, interpreted(function, inputs), expected(inputs));
      } else {
        prove_function(function, engine, states);
      }
    }
  }
}

}  // namespace treedyn
