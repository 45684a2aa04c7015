// Proven error bounds of robots: never exceeded by random states and by the ends of the ranges,
// compared with the block equations in long double, and not much larger than the largest error.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "accuracy/bound_search.hpp"
#include "description/read.hpp"
#include "emit/literal.hpp"
#include "engine/engine.hpp"
#include "formulate/formulate.hpp"
#include "program/ones.hpp"
#include "support/states.hpp"

namespace treedyn::accuracy {
namespace {

const model::Vector3 kGravity{0, 0, Real("-9.81")};
/// Of one function of one robot; the ratios were measured over a million of them, too.
constexpr int kStates = 1500;
constexpr int kCuts = 250;

/// Six joints with the lengths, masses and limits of a UR5.
constexpr const char* kUr5 = R"(
name: ur5_like
links:
  - {name: shoulder, father: ground, mass: 3.7, com: [0, -0.02561, 0.00193],
     inertia: [0.0149, 0, 0, 0.0149, 0, 0.0104],
     joint: {name: pan, type: revolute, axis: [0, 0, 1], offset: [0, 0, 0.089159],
             limits: {lower: -6.28, upper: 6.28, velocity: 3.15, effort: 150}}}
  - {name: upper_arm, father: shoulder, mass: 8.393, com: [0.2125, 0, 0.11336],
     inertia: [0.0151, 0, 0, 0.1338, 0, 0.1338],
     joint: {name: lift, type: revolute, axis: [0, 0, 1], rotation: {rpy: [pi/2, 0, 0]},
             limits: {lower: -6.28, upper: 6.28, velocity: 3.15, effort: 150}}}
  - {name: forearm, father: upper_arm, mass: 2.33, com: [0.15, 0, 0.0265],
     inertia: [0.004, 0, 0, 0.0312, 0, 0.0312],
     joint: {name: elbow, type: revolute, axis: [0, 0, 1], offset: [-0.425, 0, 0],
             limits: {lower: -3.14, upper: 3.14, velocity: 3.15, effort: 150}}}
  - {name: wrist_1, father: forearm, mass: 1.219, com: [0, -0.0018, 0.01634],
     inertia: [0.0025, 0, 0, 0.0025, 0, 0.0012],
     joint: {name: wrist_1, type: revolute, axis: [0, 0, 1], offset: [-0.39225, 0, 0.10915],
             limits: {lower: -6.28, upper: 6.28, velocity: 3.2, effort: 28}}}
  - {name: wrist_2, father: wrist_1, mass: 1.219, com: [0, 0.0018, 0.01634],
     inertia: [0.0025, 0, 0, 0.0025, 0, 0.0012],
     joint: {name: wrist_2, type: revolute, axis: [0, 0, 1], offset: [0, -0.09465, 0],
             rotation: {rpy: [pi/2, 0, 0]},
             limits: {lower: -6.28, upper: 6.28, velocity: 3.2, effort: 28}}}
  - {name: wrist_3, father: wrist_2, mass: 0.1879, com: [0, 0, -0.001159],
     inertia: [0.0001, 0, 0, 0.0001, 0, 0.0001],
     joint: {name: wrist_3, type: revolute, axis: [0, 0, 1], offset: [0, 0.0823, 0],
             rotation: {rpy: [-pi/2, 0, 0]},
             limits: {lower: -6.28, upper: 6.28, velocity: 3.2, effort: 28}}}
points:
  - {name: tool, link: wrist_3, at: [0.01, 0.02, 0.1]}
)";

model::Tree robot(const std::string& name) {
  model::Tree tree = name == "ur5_like" ? description::parse_model(kUr5, "ur5_like.yaml", {})
                                        : description::read_model(
                                              TREEDYN_SOURCE_DIR "/models/" + name + ".yaml", {});
  if (tree.points.empty()) {
    const int last = tree.size() - 1;
    tree.points.push_back(
        {"tool", "tool", tree.links.back().name, last, {Real("0.1"), Real("-0.05"), Real("0.2")}});
  }
  return tree;
}

program::Function made(const model::Tree& tree, const std::string& name) {
  formulate::Options options;
  options.gravity = kGravity;
  options.points = tree.points;
  options.effort = 0;
  return formulate::formulated(tree, name, options);
}

/// Numbers of T, one of four at an end of its range, in the centre or at a right angle.
template <class T>
std::vector<std::vector<T>> random_inputs(const program::Signature& signature, const Box& box,
                                          support::Random& uniform) {
  std::vector<std::vector<T>> result;
  auto range = box.begin();
  for (const program::Array& array : signature.inputs) {
    result.emplace_back();
    for (int i = 0; i < array.size; ++i, ++range) {
      const double special = uniform(0, 32);
      const double x = special < 2   ? range->low
                       : special < 4 ? range->high
                       : special < 6 ? range->middle()
                       : special < 8 ? std::min(1.5707963267948966, range->high)
                                     : uniform(range->low, range->high);
      auto value = static_cast<T>(x);
      while (static_cast<double>(value) > range->high) {
        value = std::nextafter(value, -std::numeric_limits<T>::infinity());
      }
      while (static_cast<double>(value) < range->low) {
        value = std::nextafter(value, std::numeric_limits<T>::infinity());
      }
      result.back().push_back(value);
    }
  }
  return result;
}

template <class To, class From>
std::vector<std::vector<To>> converted(const std::vector<std::vector<From>>& from) {
  std::vector<std::vector<To>> result;
  for (const std::vector<From>& array : from) {
    result.emplace_back(array.begin(), array.end());
  }
  return result;
}

/// All of a function of a robot.
struct Case {
  model::Tree tree;
  std::string function;
  engine::Engine<long double> engine;

  Case(model::Tree the_tree, std::string name)
      : tree(std::move(the_tree)), function(std::move(name)), engine(tree, tree.points, kGravity) {}

  /// Of the outputs, everything at the larger end of its range.
  [[nodiscard]] std::vector<double> scales(const program::Signature& signature, const Box& box) {
    std::vector<std::vector<long double>> inputs;
    auto range = box.begin();
    for (const program::Array& array : signature.inputs) {
      inputs.emplace_back();
      for (int i = 0; i < array.size; ++i, ++range) {
        inputs.back().push_back(std::max(std::abs(range->low), std::abs(range->high)));
      }
    }
    return engine.scales(function, inputs);
  }
};

/// Bound over the largest error, both as parts of the scales.
template <class T>
double expect_never_exceeded(Case& of, emit::Scalar scalar) {
  const program::Function function = made(of.tree, of.function);
  const program::Function in_scalar = program::without_ones(
      function, [&](const Real& value) { return emit::rounds_to_one(value, scalar); });
  const Box box = States(of.tree).ranges(function.signature);
  const std::vector<double> scales = of.scales(function.signature, box);
  const BoundsOver bounds =
      bounds_over(function, {scalar, emit::Sincos::kPair}, {box, scales, kCuts});
  EXPECT_EQ(bounds.obstacle, "");
  support::Random uniform(1);
  double largest = 0;
  for (int k = 0; k < kStates; ++k) {
    const auto inputs = random_inputs<T>(function.signature, box, uniform);
    const std::vector<T> values =
        executed<T>(in_scalar, converted<double>(inputs), emit::Sincos::kPair);
    const std::vector<long double> exact =
        of.engine.evaluate(of.function, converted<long double>(inputs));
    for (std::size_t n = 0; n < values.size(); ++n) {
      const auto error =
          static_cast<double>(std::abs(static_cast<long double>(values[n]) - exact[n]));
      EXPECT_LE(error, bounds.outputs[n] + 0x1p-58 * scales[n])  // that of long double: 2^-64
          << of.function << ' ' << n;
      largest = std::max(largest, error == 0 ? 0 : error / scales[n]);
    }
  }
  return bounds.largest / largest;
}

class RobotBounds : public testing::TestWithParam<const char*> {
 protected:
  static void expect(const std::vector<const char*>& functions, double times) {
    for (const char* function : functions) {
      Case of(robot(GetParam()), function);
      const double in_float = expect_never_exceeded<float>(of, emit::Scalar::kFloat);
      const double in_double = expect_never_exceeded<double>(of, emit::Scalar::kDouble);
      EXPECT_LE(in_float, times) << function;
      EXPECT_LE(in_double, times) << function;
      EXPECT_GE(in_float, 1) << function;
      EXPECT_GE(in_double, 1) << function;
      std::printf("%s %s: float %.3g, double %.3g times the largest error\n", GetParam(), function,
                  in_float, in_double);
    }
  }
};

TEST_P(RobotBounds, OfPositionsAreWithinAHundredTimesTheLargestError) {
  expect({"mass_matrix", "gravity_force", "point_positions", "force_jacobian_transpose",
          "moment_jacobian_transpose"},
         100);
}

TEST_P(RobotBounds, OfSpeedsAreWithinAThousandTimesTheLargestError) {
  expect({"bias_force", "inverse_dynamics"}, 1000);
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotBounds,
                         testing::Values("puma560", "ur5_like", "panda", "biped", "quadruped"));

}  // namespace
}  // namespace treedyn::accuracy
