// Robots as exporters write them: axes that are nearly aligned, by tilts that are no rounding. What
// the generator makes of them is held to the rounding of the equations as they stand.
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "engine/engine.hpp"
#include "formulate/functions.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"
#include "support/measured.hpp"
#include "verify/at_states.hpp"

namespace treedyn {
namespace {

using program::Random;
using RealList = std::vector<Real>;

constexpr const char* kFunctions[] = {"mass_matrix", "bias_force", "gravity_force",
                                      "inverse_dynamics", "forward_dynamics"};
const model::Vector3 kGravity{Real(0), Real(0), Real("-9.81")};

template <std::size_t n>
const char* one_of(const std::array<const char*, n>& words, Random& random) {
  return words[static_cast<std::size_t>(random.below(static_cast<int>(n)))];
}

/// Right angles, written with few digits, and tilts of 1e-16 to 1e-4.
std::string angle(Random& random) {
  static const std::array kAngles = {"0",
                                     "0",
                                     "1.5707963",
                                     "-1.5707963",
                                     "1.5707963267948966",
                                     "3.14159",
                                     "3.141592653",
                                     "-1.57079632",
                                     "3e-9",
                                     "-7e-9",
                                     "1e-8",
                                     "-3e-8",
                                     "2.98023e-08",
                                     "-4.37114e-08",
                                     "-1.2246467991473532e-16",
                                     "1.22465e-16",
                                     "1e-6",
                                     "0.0001",
                                     "1.5707963367948966",
                                     "0.7853981633974483"};
  return one_of(kAngles, random);
}

std::string axis(Random& random) {
  static const std::array kAxes = {"0 0 1",    "0 0 -1",      "1 0 0",     "0 1 0",
                                   "0 -1 0",   "1e-06 -1 0",  "5e-08 1 0", "0 0 -0.99999995",
                                   "1 0 1e-8", "0 -0.9999 0", "-3e-9 0 1"};
  return one_of(kAxes, random);
}

std::string length(Random& random) {
  static const std::array kLengths = {
      "0", "0", "0.1", "-0.2", "0.333", "0.0335", "-0.449219134762132"};
  return one_of(kLengths, random);
}

std::string link(const std::string& name, Random& random) {
  const auto number = [&](double middle, double spread) {
    return fmt::format("{:.4f}", middle + spread * random.symmetric());
  };
  return fmt::format(
      "<link name=\"{}\"><inertial><origin xyz=\"{} {} {}\"/><mass value=\"{}\"/><inertia "
      "ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/></inertial></link>\n",
      name, number(0, 0.2), number(0, 0.2), number(0, 0.2), number(3, 2.5), number(0.15, 0.03),
      number(0, 0.02), number(0, 0.02), number(0.15, 0.03), number(0, 0.02), number(0.15, 0.03));
}

std::string joint(int i, Random& random, const std::string& limb = {}) {
  const int father = random.below(4) > 0 ? i - 1 : random.below(i + 1) - 1;
  return fmt::format(
      "<joint name=\"{10}j{0}\" type=\"{1}\"><origin xyz=\"{2} {3} {4}\" rpy=\"{5} {6} {7}\"/>"
      "<parent link=\"{8}\"/><child link=\"{10}l{0}\"/><axis xyz=\"{9}\"/>"
      "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n",
      i, random.below(3) > 0 ? "revolute" : "prismatic", length(random), length(random),
      length(random), angle(random), angle(random), angle(random),
      father < 0 ? "base" : fmt::format("{}l{}", limb, father), axis(random), limb);
}

std::string robot(int joints, bool is_free, Random& random) {
  std::string text = "<robot name=\"near\">";
  text += is_free ? link("base", random) : "<link name=\"base\"/>\n";
  for (int i = 0; i < joints; ++i) {
    text += link(fmt::format("l{}", i), random) + joint(i, random);
  }
  return text + "</robot>\n";
}

/// A base with two limbs that differ in their names only.
std::string robot_with_limbs(int joints, bool is_free, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  std::string text = "<robot name=\"near\">";
  text += is_free ? link("base", random) : "<link name=\"base\"/>\n";
  for (const std::string limb : {"left_", "right_"}) {
    Random same(static_cast<std::uint64_t>(seed) + 1);
    for (int i = 0; i < joints; ++i) {
      text += link(fmt::format("{}l{}", limb, i), same) + joint(i, same, limb);
    }
  }
  return text + "</robot>\n";
}

}  // namespace

namespace program {

template <>
support::Measured<float> from_real(const Real& value) {
  return {static_cast<float>(value)};
}
template <>
support::Measured<double> from_real(const Real& value) {
  return {static_cast<double>(value)};
}

}  // namespace program

namespace {

template <class Scalar>
std::vector<Scalar> evaluated(const program::Function& function,
                              const std::vector<std::vector<float>>& inputs) {
  std::vector<std::vector<Scalar>> converted;
  std::vector<std::span<const Scalar>> spans;
  for (const auto& input : inputs) {
    spans.emplace_back(converted.emplace_back(input.begin(), input.end()));
  }
  return program::interpret<Scalar>(function, spans);
}

/// The formulation without any pass, whose error bounds are the measure.
program::Function plain(const model::Tree& tree, const std::string& name,
                        formulate::Options options) {
  options.share_limbs = false;
  formulate::Variant variant = formulate::plain_variant(tree);
  for (const formulate::PassInfo& info : formulate::passes()) {
    if (info.pass != formulate::Pass::kSums) {
      formulate::switch_off({info.pass}, variant);
    }
  }
  program::Function function = formulate::build(tree, formulate::recipe_of(name), options, variant);
  function.signature = formulate::signature(name, tree.dof(), 0);
  return function;
}

/// |answer - exact| is at most so many times what rounding may do to the plain formulation.
/// (Lengths and masses are of order 1, and 40 digits of the reference remain where it cancels.)
constexpr double kMostAmplification = 8;

template <class T>
void expect_accurate(const program::Function& function, const program::Function& before,
                     const std::vector<std::vector<float>>& inputs, const RealList& exact) {
  const std::vector<T> answers = evaluated<T>(function, inputs);
  const auto bounds = evaluated<support::Measured<T>>(before, inputs);
  double largest = 0;
  for (const Real& value : exact) {
    largest = std::max(largest, std::abs(static_cast<double>(value)));
  }
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double error = std::abs(static_cast<double>(Real(answers[k]) - exact[k]));
    EXPECT_TRUE(error <= kMostAmplification * bounds[k].bound() + 1e-40 * (1 + largest))
        << function.signature.name << "[" << k << "]: " << answers[k] << " instead of "
        << static_cast<double>(exact[k]) << ", bound " << bounds[k].bound();
  }
}

void expect_accurate(const model::Tree& tree, const formulate::Options& options, Random& random) {
  engine::Engine<Real> engine(tree, {}, options.gravity);
  for (const char* name : kFunctions) {
    const program::Function function = formulate::formulated(tree, name, options);
    const program::Function before = plain(tree, name, options);
    EXPECT_LE(function.rounding.amplification, 4) << name;
    EXPECT_NO_THROW(verify::check_at_states(tree, options.points, options.gravity, {}, {function}));
    for (int state = 0; state < 2; ++state) {
      std::vector<std::vector<float>> inputs;
      for (const program::Array& array : function.signature.inputs) {
        auto& values = inputs.emplace_back(static_cast<std::size_t>(array.size));
        std::ranges::generate(values, [&] { return static_cast<float>(3 * random.symmetric()); });
      }
      std::vector<RealList> exact;
      for (const auto& values : inputs) {
        exact.emplace_back(values.begin(), values.end());
      }
      const RealList expected = engine.evaluate(name, exact);
      expect_accurate<double>(function, before, inputs, expected);
      expect_accurate<float>(function, before, inputs, expected);
    }
  }
}

formulate::Options options_number(int k, int joints) {
  formulate::Options options;
  options.gravity = kGravity;
  options.effort = k % 25 == 7 && joints < 4 ? formulate::Options{}.effort : k % 10 == 3 ? 20 : 0;
  const auto& passes = formulate::passes();
  const auto left_out = static_cast<std::size_t>(k) % (2 * passes.size());  // every other: none
  if (left_out < passes.size()) {
    options.without = {passes[left_out].pass};
  }
  options.forward_dynamics = k % 4 == 1   ? formulate::ForwardDynamics::kArticulated
                             : k % 4 == 2 ? formulate::ForwardDynamics::kFactor
                                          : formulate::ForwardDynamics::kCheapest;
  return options;
}

class NearAligned : public testing::TestWithParam<int> {};

TEST_P(NearAligned, RobotsKeepTheAccuracyOfTheEquations) {
  constexpr int kRobots = 30;
  for (int k = GetParam() * kRobots; k < (GetParam() + 1) * kRobots; ++k) {
    Random random(static_cast<std::uint64_t>(k) + 1);
    const int joints = k % 10 == 0 ? 5 : 2 + random.below(3);
    const bool is_free = k % 7 == 5;
    const std::string text = robot(joints, is_free, random);
    SCOPED_TRACE(fmt::format("robot {}\n{}", k, text));
    description::ReadOptions read;
    read.snap = k % 3 == 0 ? Real(0) : read.snap;
    read.base = is_free ? description::Base::kAxes : read.base;
    expect_accurate(description::parse_model(text, "near.urdf", read), options_number(k, joints),
                    random);
  }
}

/// Of limbs that share their code.
TEST(NearAlignedLimbs, KeepTheAccuracyOfTheEquations) {
  int shared = 0;
  for (int k = 0; k < 30; ++k) {
    const bool is_free = k % 3 == 2;
    const std::string text = robot_with_limbs(2, is_free, 1000 + 10 * k);
    SCOPED_TRACE(fmt::format("robot {}\n{}", k, text));
    description::ReadOptions read;
    read.snap = k % 2 == 0 ? Real(0) : read.snap;
    read.base = is_free ? description::Base::kAxes : read.base;
    const model::Tree tree = description::parse_model(text, "near.urdf", read);
    formulate::Options options = options_number(k, 4);
    options.share_limbs = true;
    shared += formulate::formulated(tree, "inverse_dynamics", options).limb_code != nullptr ? 1 : 0;
    Random random(static_cast<std::uint64_t>(k) + 1);
    expect_accurate(tree, options, random);
  }
  EXPECT_GT(shared, 15);
}

INSTANTIATE_TEST_SUITE_P(Random, NearAligned, testing::Range(0, 10));

TEST(ModelsThatWereWrong, KeepTheAccuracyOfTheEquations) {
  for (const auto& entry :
       std::filesystem::directory_iterator(TREEDYN_SOURCE_DIR "/tests/data/near_aligned")) {
    for (const char* snap : {"1e-9", "0"}) {
      SCOPED_TRACE(fmt::format("{} --snap {}", entry.path().string(), snap));
      description::ReadOptions read;
      read.snap = Real(snap);
      formulate::Options options;
      options.gravity = kGravity;
      options.effort = 0;
      Random random(1);
      const model::Tree tree = description::read_model(entry.path().string(), read);
      expect_accurate(tree, options, random);
      options.without = {formulate::Pass::kSearch};
      expect_accurate(tree, options, random);
      options.points.emplace_back().link = tree.size() - 1;
      const auto rotations = formulate::formulated(tree, "point_rotations", options);
      EXPECT_NO_THROW(
          verify::check_at_states(tree, options.points, options.gravity, {}, {rotations}));
    }
  }
}

}  // namespace
}  // namespace treedyn
