#include "verify/at_states.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/engine.hpp"
#include "engine/user_function.hpp"
#include "model/parameters.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"
#include "program/rounding.hpp"
#include "verify/solve.hpp"

namespace treedyn::verify {

namespace {

/// Larger robots get one state: the engine's block products grow as N^3.
constexpr int kLargestForTwoStates = 20;

/// A value of a program with the bound of its rounding.
using Number = program::Rounded<Real>;
using Numbers = std::vector<Number>;

/// Values that agree to so many digits are one to the passes, so a program may be off by that many
/// roundings of this size; of the 50 digits of the equations as many are lost where they cancel.
const Real& unit_of_programs() {
  static const Real value("1e-37");
  return value;
}

/// How large the terms of a mass matrix can be. Constants that cancel to less than 1e-40 of such
/// terms are zero to a program.
Real largest_inertia(const model::Tree& tree) {
  Real reach = 1;
  Real largest = 0;
  for (const model::Link& link : tree.links) {
    for (std::size_t k = 0; k < 3; ++k) {
      reach += abs(link.joint.offset[k]) + abs(link.inertia.com[k]);
      largest += abs(link.inertia.about_com[4 * k]);
    }
  }
  for (const model::Link& link : tree.links) {
    largest += link.inertia.mass * reach * reach;
  }
  return largest;
}

/// The same numbers on every machine, in [-2, 2).
class States {
 public:
  Real next() {
    return Real(static_cast<std::int64_t>(random_.next())) / Real(std::int64_t{1} << 62U);
  }

  std::vector<Values> inputs(const program::Signature& signature) {
    std::vector<Values> result;
    for (const program::Array& array : signature.inputs) {
      if (!array.type.empty()) {
        continue;  // what is made of parameters
      }
      result.emplace_back();
      std::generate_n(std::back_inserter(result.back()), array.size, [&] { return next(); });
    }
    return result;
  }

 private:
  program::Random random_{1};
};

/// \param derived  the elements of the argument behind `inputs`, if there is one
Numbers interpreted(const program::Function& function, const std::vector<Values>& inputs,
                    const Numbers& derived) {
  return program::outputs_of(
      function, program::node_values<Number>(
                    function.graph, function.outputs,
                    [&](int array, int element) {
                      const auto a = static_cast<std::size_t>(array);
                      const auto k = static_cast<std::size_t>(element);
                      TREEDYN_EXPECT(k < (a < inputs.size() ? inputs[a].size() : derived.size()));
                      return a < inputs.size() ? Number(inputs[a][k]) : derived[k];
                    },
                    [](program::Kind kind, const Number& a) {
                      return Number::function(kind, a, program::elementary(kind, a.value));
                    }));
}

/// \throws std::range_error if the difference is what cancellation makes of numbers that many
/// decades apart: no digit would be left in double
void compare(const std::string& name, const Numbers& ours, const Values& engines,
             const Real& largest_inertia) {
  const Real largest = verify::largest(engines);
  const Real tolerance = largest * Real("1e-35") + Real("1e-40");
  const Real no_digit = largest * Real("1e-17");
  const Real dropped = largest_inertia * (1 + largest);
  TREEDYN_EXPECT(ours.size() == engines.size());
  for (std::size_t k = 0; k < engines.size(); ++k) {
    const Real difference = abs(ours[k].value - engines[k]);
    if (difference <= tolerance) {
      continue;
    }
    if (!(difference <= unit_of_programs() * (Real(ours[k].error) + dropped))) {
      throw std::logic_error(fmt::format(
          "function '{}' differs from its block equation in element {}: {} instead of {}", name, k,
          ours[k].value.str(20), engines[k].str(20)));
    }
    if (!(difference <= no_digit)) {
      throw std::range_error(fmt::format(
          "masses, lengths and inertias cancel so that no digit of '{}' is left; expected numbers "
          "of fewer decades",
          name));
    }
  }
}

/// a b for row-major n x n matrices.
Numbers product(const Numbers& a, const Numbers& b, std::size_t n) {
  Numbers result(n * (b.size() / n));
  const std::size_t columns = b.size() / n;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < columns; ++j) {
        result[i * columns + j] = result[i * columns + j] + a[i * n + k] * b[k * columns + j];
      }
    }
  }
  return result;
}

/// L^T diag(d) L of the concatenated L and d.
Numbers multiplied_out(const Numbers& factors, std::size_t n) {
  Numbers transposed(n * n);
  Numbers scaled(n * n);
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

/// What all functions are held against.
struct Judge {
  std::vector<model::Point> points;
  model::Vector3 gravity;
  const UserEquations& equations;
  States states = {};
};

/// Y theta for the parameters theta of some links: first moments and tensors about their origins.
Numbers times_parameters(const Numbers& Y, const std::vector<model::Link>& links) {
  const std::size_t columns = 10 * links.size();
  Numbers tau(Y.size() / columns);
  for (std::size_t row = 0; row < tau.size(); ++row) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      const Real m = links[i].inertia.mass;
      const model::Vector3& c = links[i].inertia.com;
      const model::Matrix3& J = links[i].inertia.about_com;
      const Real square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
      const auto about_origin = [&](std::size_t a, std::size_t b) {
        return Real(J[3 * a + b] + m * ((a == b ? square : Real(0)) - c[a] * c[b]));
      };
      const std::array<Real, 10> theta = {m,
                                          m * c[0],
                                          m * c[1],
                                          m * c[2],
                                          about_origin(0, 0),
                                          about_origin(0, 1),
                                          about_origin(0, 2),
                                          about_origin(1, 1),
                                          about_origin(1, 2),
                                          about_origin(2, 2)};
      for (std::size_t k = 0; k < theta.size(); ++k) {
        tau[row] = tau[row] + Y[row * columns + 10 * i + k] * Number(theta[k]);
      }
    }
  }
  return tau;
}

/// A column that is wrong differs for random parameters.
void check_regressor(const Numbers& Y, const std::vector<Values>& inputs, const model::Tree& tree,
                     Judge& judge) {
  model::Tree drawn = tree;
  for (model::Link& link : drawn.links) {
    link.inertia.mass = judge.states.next();
    std::ranges::generate(link.inertia.com, [&] { return judge.states.next(); });
    const Real xy = judge.states.next();
    const Real xz = judge.states.next();
    const Real yz = judge.states.next();
    link.inertia.about_com = {judge.states.next(), xy, xz, xy, judge.states.next(), yz, xz, yz,
                              judge.states.next()};
  }
  engine::Engine<Real> engine(drawn, {}, judge.gravity);
  compare("inverse_dynamics_regressor", times_parameters(Y, drawn.links),
          engine.evaluate("inverse_dynamics", inputs), largest_inertia(tree));
}

/// Functions that have no equation of their own are held against the equations they stand for.
void check_function(const program::Function& function, engine::Engine<Real>& engine, Judge& judge,
                    const model::Tree& tree, const Numbers& derived) {
  const Real largest = largest_inertia(tree);
  const std::string& name = function.signature.name;
  const std::vector<Values> inputs = judge.states.inputs(function.signature);
  const Numbers ours = interpreted(function, inputs, derived);
  const auto n = static_cast<std::size_t>(engine.dof());
  const auto mass_matrix = [&] {
    return engine.evaluate("mass_matrix", {inputs[0]});
  };
  const auto times_inertia = [&](const Numbers& b) {
    const Values A = mass_matrix();
    Numbers numbers;
    for (const Real& value : A) {
      numbers.emplace_back(value);
    }
    return product(numbers, b, n);
  };
  if (name == "mass_matrix_factor") {
    compare(name, multiplied_out(ours, n), mass_matrix(), largest);
  } else if (name == "mass_matrix_solve") {
    compare(name, times_inertia(ours), inputs[1], largest);
  } else if (name == "mass_matrix_inverse") {
    compare(name, times_inertia(ours), identity(n), largest);
  } else if (name == "inverse_dynamics_regressor") {
    check_regressor(ours, inputs, tree, judge);
  } else if (name == "dynamics_terms") {
    Values expected = mass_matrix();
    for (const Values& term :
         {engine.evaluate("bias_force", inputs), engine.evaluate("gravity_force", {inputs[0]})}) {
      expected.insert(expected.end(), term.begin(), term.end());
    }
    compare(name, ours, expected, largest);
  } else {
    compare(name, ours, engine.evaluate(name, inputs), largest);
  }
}

/// The user's equation of that name; nullptr: one of ours.
const equations::UserEquation* find(const UserEquations& equations, const std::string& name) {
  const auto found =
      std::ranges::find_if(equations, [&](const auto* equation) { return equation->name == name; });
  return found == equations.end() ? nullptr : *found;
}

/// Every function at a state.
void check_at_state(Judge& judge, const model::Tree& tree,
                    const std::vector<const program::Function*>& functions,
                    const Numbers& derived) {
  engine::Engine<Real> engine(tree, judge.points, judge.gravity);
  const Real largest = largest_inertia(tree);
  for (const program::Function* const function : functions) {
    if (const equations::UserEquation* const of_user =
            find(judge.equations, function->signature.name)) {
      const std::vector<Values> inputs = judge.states.inputs(function->signature);
      engine::UserFunction<Real> expected(*of_user, tree, judge.points, judge.gravity);
      compare(function->signature.name, interpreted(*function, inputs, derived), expected(inputs),
              largest);
    } else {
      check_function(*function, engine, judge, tree, derived);
    }
  }
}

/// At run time as `update` and the functions compute it, with other numbers than the nominal ones.
void check_at_run_time(Judge& judge, const model::Tree& tree,
                       const std::vector<const program::Function*>& functions,
                       const program::Function& update) {
  enum class Draw { kNominal, kFirst, kSecond, kZero };
  const model::Vector3 gravity = judge.gravity;
  const auto places = model::points_with_parameters(tree, judge.points);
  for (const Draw draw : {Draw::kNominal, Draw::kFirst, Draw::kSecond, Draw::kZero}) {
    model::Tree changed = tree;
    Values values;
    for (const model::Parameter& parameter : tree.parameters) {
      const bool positive = parameter.quantity == model::ParameterKind::kMass;
      const Real random = judge.states.next();
      // gravity of a scene stands beside the tree: it is nominal
      const bool of_scene = parameter.quantity == model::ParameterKind::kScene;
      values.push_back(draw == Draw::kNominal || of_scene ? model::nominal(tree, gravity, parameter)
                       : draw == Draw::kZero              ? Real(0)
                       : positive                         ? abs(random)
                                                          : random);
      model::set(changed, judge.gravity, parameter, values.back());
    }
    for (const auto& [k, own] : places) {
      judge.points[k].at = changed.points[own].at;
    }
    std::vector<const program::Function*> checked = functions;
    if (draw == Draw::kZero) {
      std::erase_if(checked, [&](const program::Function* f) {
        return equations::divides_by_pivots(f->signature.name) ||
               find(judge.equations, f->signature.name) != nullptr;
      });
    }
    check_at_state(judge, changed, checked, interpreted(update, {values}, {}));
  }
}

}  // namespace

void check_at_states(const model::Tree& tree, const std::vector<model::Point>& points,
                     const model::Vector3& gravity, const UserEquations& equations,
                     const std::vector<program::Function>& functions,
                     const program::Function* update) {
  Judge judge{points, gravity, equations};
  std::vector<const program::Function*> fixed;
  std::vector<const program::Function*> at_run_time;
  for (const program::Function& function : functions) {
    const std::vector<program::Array>& inputs = function.signature.inputs;
    const bool takes_derived = !inputs.empty() && !inputs.back().type.empty();
    (takes_derived ? at_run_time : fixed).push_back(&function);
  }
  for (int count = tree.size() <= kLargestForTwoStates ? 2 : 1; count > 0; --count) {
    check_at_state(judge, tree, fixed, {});
  }
  if (!at_run_time.empty()) {
    check_at_run_time(judge, tree, at_run_time, *update);
  }
}

}  // namespace treedyn::verify
