// Expanded entries against the engine at random states.
#include "expansion/expansion.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/engine.hpp"
#include "equations/table.hpp"
#include "expansion/polynomial.hpp"
#include "support/random_tree.hpp"

namespace treedyn::expansion {
namespace {

/// Value and sum of magnitudes of a polynomial at numbers for the variables.
struct Value {
  double value = 0;
  double magnitude = 0;
};

Value value_of(const Polynomial& polynomial, const std::vector<double>& variables) {
  Value result;
  for (const auto& [monomial, coefficient] : polynomial) {
    double term = coefficient.to_double();
    for (const auto& [variable, exponent] : monomial) {
      term *= std::pow(variables[variable], exponent);
    }
    result.value += term;
    result.magnitude += std::abs(term);
  }
  return result;
}

class ExpandedRobot : public testing::Test {
 protected:
  ExpandedRobot() {
    support::Dice dice(6);
    tree_ = support::random_tree({{-1, 0, 0}, "RPR"}, dice);
    points_ = support::random_points(tree_, 2, dice);
    q_ = dice.numbers(3, 2);
    qd_ = dice.numbers(3, 2);
    qdd_ = dice.numbers(3, 2);
    f_ = dice.numbers(6, 2);
    n_ = dice.numbers(6, 2);
  }

  /// In the order of the ring: c, s | q per joint, rates, accelerations, f and n by turns.
  [[nodiscard]] std::vector<double> variables() const {
    std::vector<double> result = {std::cos(q_[0]), std::sin(q_[0]), q_[1], std::cos(q_[2]),
                                  std::sin(q_[2])};
    result.insert(result.end(), qd_.begin(), qd_.end());
    result.insert(result.end(), qdd_.begin(), qdd_.end());
    for (std::size_t i = 0; i < f_.size(); ++i) {
      result.push_back(f_[i]);
      result.push_back(n_[i]);
    }
    return result;
  }

  [[nodiscard]] std::vector<double> input(std::string_view name) const {
    return name == "q" ? q_ : name == "qd" ? qd_ : name == "qdd" ? qdd_ : name == "f" ? f_ : n_;
  }

  model::Tree tree_;
  std::vector<model::Point> points_;
  model::Vector3 gravity_{Real(0), Real(0), Real("-9.81")};
  std::vector<double> q_, qd_, qdd_, f_, n_;
};

TEST_F(ExpandedRobot, HasValuesOfTheEngine) {
  const Expansion expansion(tree_, points_, gravity_);
  engine::Engine<double> engine(tree_, points_, gravity_);
  for (const equations::Equation& equation : equations::table()) {
    std::vector<std::vector<double>> inputs;
    for (const equations::Argument& argument : equation.inputs) {
      inputs.push_back(input(argument.name));
    }
    const std::vector<double> expected = engine.evaluate(equation.name, inputs);
    const Entries entries = expansion.expand(*equation.expression);
    ASSERT_EQ(entries.values.size(), expected.size()) << equation.name;
    for (std::size_t n = 0; n < expected.size(); ++n) {
      const Value value = value_of(polynomial(expansion.ring(), entries.values[n]), variables());
      // Below 10^4 roundings of partial sums that the terms bound.
      const double tolerance = 1e4 * std::numeric_limits<double>::epsilon() * (value.magnitude + 1);
      EXPECT_NEAR(value.value, expected[n], tolerance) << equation.name << " " << n;
    }
  }
}

TEST_F(ExpandedRobot, HasVariablesOfJointsAndPoints) {
  const Expansion expansion(tree_, points_, gravity_);
  std::string names;
  for (const Ring::Variable& variable : expansion.ring().variables()) {
    names += variable.name + " ";
  }
  EXPECT_EQ(names,
            "c_j0 s_j0 q_j1 c_j2 s_j2 qd_j0 qd_j1 qd_j2 qdd_j0 qdd_j1 qdd_j2 "
            "f_p0_x n_p0_x f_p0_y n_p0_y f_p0_z n_p0_z f_p1_x n_p1_x f_p1_y n_p1_y f_p1_z n_p1_z ");
}

}  // namespace
}  // namespace treedyn::expansion
