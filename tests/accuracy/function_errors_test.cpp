// Errors of functions: the bits of compiled code, errors and scales known by hand, planted
// mistakes.
#include "accuracy/function_errors.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "emit/literal.hpp"
#include "formulate/formulate.hpp"
#include "program/ones.hpp"
#include "support/compiled.hpp"
#include "support/random_tree.hpp"

namespace treedyn::accuracy {
namespace {

const std::string kModels = TREEDYN_SOURCE_DIR "/models/";
const model::Vector3 kGravity{0, 0, Real("-9.81")};

model::Tree read(const std::string& name) { return description::read_model(kModels + name, {}); }

/// As `generate --effort 0` has it.
program::Function made(const model::Tree& tree, const std::string& name,
                       const model::Vector3& gravity = kGravity) {
  formulate::Options options;
  options.gravity = gravity;
  options.points = tree.points;
  options.effort = 0;
  return formulate::formulated(tree, name, options);
}

Truth truth(const model::Tree& tree, const std::string& name, int states) {
  engine::Reference reference(tree, tree.points, kGravity);
  return truth_of(formulate::signature(name, tree.dof(), static_cast<int>(tree.points.size())),
                  States(tree), states,
                  [&](const Inputs& inputs) { return reference(name, inputs); });
}

template <class T>
void expect_bits_of_compiled_code(const char* scalar_name, emit::Scalar scalar) {
  const model::Tree tree = read("puma560.yaml");
  const std::string names = "mass_matrix,bias_force,forward_dynamics,mass_matrix_inverse";
  const support::CompiledModel code = support::generate_and_compile(
      kModels + "puma560.yaml",
      {"--effort", "0", "--scalar", scalar_name, "--functions", names, "-q"});
  const States states(tree);
  for (const char* name :
       {"mass_matrix", "bias_force", "forward_dynamics", "mass_matrix_inverse"}) {
    const program::Function function = program::without_ones(
        made(tree, name),
        [scalar](const Real& value) { return emit::rounds_to_one(value, scalar); });
    for (int k = 0; k < 20; ++k) {
      const Inputs inputs = states(function.signature, k);
      const std::vector<T> ours = executed<T>(function, inputs, emit::Sincos::kPair);
      EXPECT_EQ(std::vector<double>(ours.begin(), ours.end()), code.call(name, inputs))
          << name << " in state " << k;
    }
  }
}

TEST(Executed, HasTheBitsOfCompiledCodeInFloat) {
  expect_bits_of_compiled_code<float>("float", emit::Scalar::kFloat);
}

TEST(Executed, HasTheBitsOfCompiledCodeInDouble) {
  expect_bits_of_compiled_code<double>("double", emit::Scalar::kDouble);
}

TEST(Executed, HasTheBitsOfLimbsThatShareCode) {
  const support::CompiledModel code = support::generate_and_compile(
      kModels + "quadruped.yaml",
      {"--effort", "0", "--share-limbs", "--functions", "inverse_dynamics", "-q"});
  const model::Tree tree = read("quadruped.yaml");
  formulate::Options options;
  options.gravity = kGravity;
  options.effort = 0;
  options.share_limbs = true;
  const program::Function function = formulate::formulated(tree, "inverse_dynamics", options);
  ASSERT_NE(function.limb_code, nullptr);
  const Inputs inputs = States(tree)(function.signature, 0);
  EXPECT_EQ(executed<double>(function, inputs, emit::Sincos::kPair),
            code.call("inverse_dynamics", inputs));
}

/// y = a + b.
program::Function sum() {
  program::Function function;
  function.signature = {"sum", "", "", {{"x", 2, ""}}, {{"y", 1, ""}}};
  function.outputs = {function.graph.add(function.graph.input(0, 0), function.graph.input(0, 1))};
  return function;
}

TEST(Measured, AgreesWithErrorsByHand) {
  Truth exact;
  exact.inputs = {{{1, 0x1p-26}}, {{1, 0x1p-25}}};
  exact.exact = {{{Real(1) + ldexp(Real(1), -26)}, {4}}, {{Real(1) + ldexp(Real(1), -25)}, {4}}};
  const Measured in_float = measured(sum(), {emit::Scalar::kFloat, {}}, exact);
  EXPECT_EQ(in_float.errors.scaled.error, 0x1p-27);  // 2^-25 of 4
  EXPECT_EQ(in_float.errors.ulps.error, 0.25);       // beside 1 floats are 2^-23 apart
  EXPECT_EQ(in_float.errors.ulps.output, "y[0]");
  EXPECT_EQ(in_float.errors.ulps.state, 1);
  EXPECT_EQ(in_float.cost.add, 1);
  const Measured in_double = measured(sum(), {emit::Scalar::kDouble, {}}, exact);
  EXPECT_EQ(in_double.errors.scaled.error, 0);
  EXPECT_EQ(in_double.errors.scaled.output, "");
}

TEST(Measured, CallsWhatIsNoNumberInfinitelyWrong) {
  Truth exact;
  exact.inputs = {{{std::nan(""), 1}}};
  exact.exact = {{{1}, {1}}};
  EXPECT_TRUE(std::isinf(measured(sum(), {}, exact).errors.scaled.error));
}

/// Beside an exact zero, and one that 50 digits leave, units in the last place mean nothing.
TEST(Measured, LeavesUnitsOfZerosOut) {
  Truth exact;
  exact.inputs = {{{1, -1}}};
  exact.exact = {{{Real("1e-45")}, {1}}};
  const Errors errors = measured(sum(), {}, exact).errors;
  EXPECT_EQ(errors.ulps.error, 0);
  EXPECT_LT(errors.scaled.error, 1e-40);
}

/// m = 50 kg, l = 1 m, J_yy = J_zz = 10 kg m^2, centres of mass in the middle.
TEST(Scales, AreSumsOfMagnitudesByHand) {
  const model::Tree tree = read("two_link.yaml");
  engine::Reference reference(tree, tree.points, kGravity);
  for (const double angle : {0.0, 1.0, std::numbers::pi / 2}) {
    const std::vector<double> G = reference("gravity_force", {{angle, 0.5}}).scales;
    EXPECT_NEAR(G[1], 50 * 9.81 * 0.5, 1e-9);
    EXPECT_NEAR(G[0], 50 * 9.81 * (0.5 + 1 + 0.5), 1e-9);
    const std::vector<double> A = reference("mass_matrix", {{angle, 0.5}}).scales;
    EXPECT_NEAR(A[3], 50 * 0.25 + std::sqrt(200), 1e-9);
  }
}

TEST(Scales, AreNoSmallerThanTheValues) {
  support::Dice dice(3);
  for (int trial = 0; trial < 6; ++trial) {
    const model::Tree tree = support::random_tree(support::random_shape(5, dice), dice);
    const std::vector<model::Point> points = support::random_points(tree, 2, dice);
    engine::Reference reference(tree, points, kGravity);
    for (const std::string& name : formulate::function_names()) {
      Inputs inputs;
      for (const program::Array& array : formulate::signature(name, 5, 2).inputs) {
        inputs.push_back(dice.numbers(static_cast<std::size_t>(array.size), 2));
      }
      const engine::Exact exact = reference(name, inputs);
      ASSERT_EQ(exact.values.size(), exact.scales.size()) << name;
      for (std::size_t k = 0; k < exact.values.size(); ++k) {
        EXPECT_LE(std::abs(static_cast<double>(exact.values[k])),
                  exact.scales[k] * (1 + 1e-12) + 1e-30)
            << name << ' ' << k;
      }
    }
  }
}

/// Of every function of an arm some roundings of the scale, whatever the state.
TEST(Measured, FindsAnArmAccurateToAFewUnits) {
  const model::Tree tree = read("puma560.yaml");
  for (const char* name : {"mass_matrix", "bias_force", "gravity_force", "forward_dynamics"}) {
    const Measured in_double = measured(made(tree, name), {}, truth(tree, name, 40));
    EXPECT_LT(in_double.errors.scaled.error, 16 * 0x1p-53) << name;
    EXPECT_GT(in_double.errors.scaled.error, 0x1p-56) << name;
  }
}

/// Gravity two units in the last place too large, and with the wrong sign.
TEST(Measured, SeesPlantedMistakes) {
  const model::Tree tree = read("puma560.yaml");
  const Truth exact = truth(tree, "gravity_force", 40);
  const auto error = [&](const Real& g) {
    const model::Vector3 gravity{0, 0, g};
    return measured(made(tree, "gravity_force", gravity), {}, exact).errors.scaled.error;
  };
  const double right = error(Real("-9.81"));
  const double off = error(Real("-9.81") * (1 + 8 * ldexp(Real(1), -52)));
  EXPECT_GT(off, right + 2 * 0x1p-52);
  EXPECT_LT(off, right + 9 * 0x1p-52);
  EXPECT_GT(error(Real("9.81")), 0.5);
}

model::Tree limited() {
  return description::parse_model(R"(
name: limited
links:
  - {name: a, father: ground, mass: 1,
     joint: {name: j, type: revolute, axis: [0, 0, 1],
             limits: {lower: 0.1, upper: 0.3, velocity: 2, effort: 0}}}
  - {name: b, father: a, mass: 1, joint: {name: k, type: prismatic, axis: [0, 0, 1]}}
)",
                                  "limited.yaml", {});
}

TEST(States, StayInsideTheLimits) {
  const States states(limited());
  const program::Signature signature = formulate::signature("forward_dynamics", 2, 0);
  double widest = 0;
  for (int k = 0; k < 500; ++k) {
    const Inputs inputs = states(signature, k);
    EXPECT_GE(inputs[0][0], 0.1);
    EXPECT_LE(inputs[0][0], 0.3);
    EXPECT_LE(std::abs(inputs[1][0]), 2);
    EXPECT_LE(std::abs(inputs[2][0]), 1);
    EXPECT_LE(std::abs(inputs[0][1]), 1);
    widest = std::max(widest, std::abs(inputs[1][0]));
    EXPECT_EQ(inputs[0][0], static_cast<double>(static_cast<float>(inputs[0][0])));
    EXPECT_EQ(inputs, states(signature, k));
  }
  EXPECT_GT(widest, 1.9);
  EXPECT_NE(states(signature, 0), states(signature, 1));
}

TEST(States, NameWhatABoundAssumes) {
  const States states(limited());
  const program::Signature B = formulate::signature("bias_force", 2, 0);
  EXPECT_EQ(states.assumed(B, {{0, 2}, {0}}), "");
  EXPECT_EQ(states.assumed(B, {{0, 1, 2, 3}, {1}}), "q of k, qd of k");
  const program::Signature tau = formulate::signature("inverse_dynamics", 2, 0);
  EXPECT_EQ(states.assumed(tau, {{4}, {4}}), "qdd");
  const States free(read("two_link.yaml"));
  EXPECT_EQ(free.assumed(B, {{0, 1}, {}}), "");  // angles, of which sines and cosines are taken
  EXPECT_EQ(free.assumed(B, {{0, 1, 2, 3}, {1, 2}}), "q of elbow, qd of any joint");
  const std::vector<Interval> ranges = states.ranges(B);
  ASSERT_EQ(ranges.size(), 4U);
  EXPECT_NEAR(ranges[0].low, 0.1, 1e-15);
  EXPECT_TRUE(ranges[0].contains(0.3));
  EXPECT_TRUE(ranges[2].contains(-2) && ranges[3].contains(1));
}

/// Over all ranges where that can be proven, else in one state. Sums of angles are rounded.
TEST(Bounded, IsProvenOrSaysWhyNot) {
  const model::Tree tree = read("puma560.yaml");
  const auto bound_of = [&](const std::string& name) {
    const Truth exact = truth(tree, name, 40);
    const program::Function function = made(tree, name);
    const Measured in_double = measured(function, {}, exact);
    const Bound bound = bounded(function, {}, exact, in_double);
    EXPECT_GE(bound.error, bound.sampled) << name;
    EXPECT_LE(bound.error, 400 * bound.sampled) << name;
    if (name != "bias_force") {  // the scale is the same in every state, or that of this one
      EXPECT_NEAR(bound.sampled, in_double.errors.scaled.error, 1e-12 * bound.sampled) << name;
    }
    return bound;
  };
  const Bound A = bound_of("mass_matrix");
  EXPECT_EQ(A.assumed, "q of joint2, joint3");
  EXPECT_EQ(A.obstacle, "");
  EXPECT_EQ(bound_of("bias_force").assumed, "qd of any joint");
  const Bound qdd = bound_of("forward_dynamics");
  EXPECT_EQ(qdd.assumed, "");
  EXPECT_EQ(qdd.obstacle, "a divisor may be zero");
}

TEST(States, NameMissingLimits) {
  EXPECT_EQ(States(limited()).missing(),
            "the model states no limits of position for k (taken: -pi to pi rad, -1 to 1 m), of "
            "speed for k (taken: -1 to 1 rad/s or m/s), of effort for any joint (taken: -1 to 1 N "
            "m or N)");
}

/// As exporters of URDF write it, and with the limits exchanged.
TEST(States, TakeLimitsThatLeaveNoRangeForNone) {
  const model::Tree tree = description::parse_model(R"(
name: placeholders
links:
  - {name: a, father: ground, mass: 1,
     joint: {name: j, type: revolute, axis: [0, 0, 1], limits: {lower: 0, upper: 0}}}
  - {name: b, father: a, mass: 1,
     joint: {name: k, type: prismatic, axis: [0, 0, 1], limits: {lower: 0.2, upper: 0.2}}}
  - {name: c, father: b, mass: 1,
     joint: {name: l, type: revolute, axis: [0, 0, 1], limits: {lower: 1, upper: -1}}}
  - {name: d, father: c, mass: 1,
     joint: {name: m, type: revolute, axis: [0, 0, 1], limits: {lower: -1, upper: 0}}}
)",
                                                    "placeholders.yaml", {});
  const States states(tree);
  EXPECT_THAT(states.missing(), testing::StartsWith("the model states no limits of position for j, "
                                                    "k, l (taken: -pi to pi rad, -1 to 1 m), of"));
  const program::Signature G = formulate::signature("gravity_force", 4, 0);
  EXPECT_EQ(states.assumed(G, {{0, 1, 2, 3}, {0, 1, 2, 3}}), "q of j, k, l");
  const std::vector<Interval> ranges = states.ranges(G);
  const std::vector<std::pair<double, double>> expected = {{-std::numbers::pi, std::numbers::pi},
                                                           {-1, 1},
                                                           {-std::numbers::pi, std::numbers::pi},
                                                           {-1, 0}};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(ranges[k].low, expected[k].first, 1e-15) << k;
    EXPECT_NEAR(ranges[k].high, expected[k].second, 1e-15) << k;
  }
  std::vector<double> widest(4, 0);
  for (int number = 0; number < 200; ++number) {
    const Inputs inputs = states(G, number);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_TRUE(ranges[k].contains(inputs[0][k])) << k;
      widest[k] = std::max(widest[k], std::abs(inputs[0][k]));
    }
  }
  EXPECT_GT(widest[0], 3);
  EXPECT_GT(widest[1], 0.9);
  EXPECT_GT(widest[2], 3);
}

}  // namespace
}  // namespace treedyn::accuracy
