// Every committed model and every published robot: the generic engine against the recursive oracle
// at 50 digits; generated code against the oracle, MuJoCo and KDL.
#include "support/models.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include <gtest/gtest.h>

#include "description/read.hpp"
#include "engine/engine.hpp"
#include "engine/outputs.hpp"
#include "oracle/engines.hpp"
#include "oracle/from_tree.hpp"
#include "oracle/functions.hpp"
#include "support/cases.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

using oracle::largest;
using oracle::Problem;
using oracle::problem_of;
using support::Committed;
using support::Sample;

const model::Vector3 kGravity{Real(0), Real(0), Real("-9.81")};

model::Tree read(const std::filesystem::path& file, const std::string& base) {
  description::ReadOptions options;
  options.base = base == "axes" ? description::Base::kAxes : description::Base::kFixed;
  options.mimic = description::Mimic::kIndependent;
  return description::read_model(file.string(), options);
}

std::vector<Sample> samples_of(const model::Tree& tree, std::size_t count) {
  return support::samples(static_cast<std::size_t>(tree.dof()), tree.points.size(), count, 3);
}

template <class T>
std::vector<T> numbers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// One model file and what carries its root.
struct Robot {
  std::string name;
  std::filesystem::path file;
  std::string base;
};

std::vector<Robot> robots() {
  std::vector<Robot> result;
  for (const Committed& c : support::committed_models(TREEDYN_SOURCE_DIR)) {
    result.push_back({support::test_name(c), c.model, c.manifest.base});
  }
  const std::filesystem::path urdf = TREEDYN_SHARED_DATA "/robots/urdf";
  if (std::filesystem::is_directory(urdf)) {
    for (const auto& entry : std::filesystem::directory_iterator(urdf)) {
      std::string name = entry.path().stem().string();
      std::replace(name.begin(), name.end(), '-', '_');
      result.push_back({name, entry.path(), "fixed"});
      result.push_back({name + "_axes", entry.path(), "axes"});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Robot& a, const Robot& b) { return a.name < b.name; });
  return result;
}

class EveryRobot : public testing::TestWithParam<Robot> {};

using RealList = std::vector<Real>;

/// max|x - y|; for accelerations max|A (x - y)| / max|A|, as A may be nearly singular (a base at a
/// pitch of 90 degrees).
Real difference(const Problem<Real>& problem, const std::string& function, const RealList& q,
                RealList x, const RealList& y) {
  std::transform(x.begin(), x.end(), y.begin(), x.begin(), std::minus<>());
  if (function != "forward_dynamics") {
    return largest(x);
  }
  const RealList A = oracle::mass_matrix(problem.robot, q);
  RealList forces(x.size());
  for (std::size_t i = 0; i < A.size(); ++i) {
    forces[i / x.size()] += A[i] * x[i % x.size()];
  }
  return largest(forces) / largest(A);
}

/// Two algorithms in 50 digits: 1e-36 leaves 14 for the growth of rounding.
TEST_P(EveryRobot, EngineEqualsTheRecursiveOracle) {
  const model::Tree tree = read(GetParam().file, GetParam().base);
  const Problem<Real> problem = problem_of<Real>(tree, tree.points, kGravity);
  engine::Engine<Real> engine(tree, tree.points, kGravity);
  for (const Sample& sample : samples_of(tree, 8)) {
    for (const equations::Equation* function : engine::functions()) {
      const std::string name(function->name);
      std::vector<RealList> inputs;
      for (const equations::Argument& argument : function->inputs) {
        inputs.push_back(numbers<Real>(sample.at(std::string(argument.name))));
      }
      const RealList x = engine.evaluate(name, inputs);
      const RealList y = oracle::evaluate(problem, name, inputs);
      ASSERT_EQ(x.size(), y.size()) << name;
      ASSERT_LE(difference(problem, name, inputs[0], x, y), (1 + largest(y)) * Real("1e-36"))
          << name;
    }
  }
}

/// Rounding of two algorithms of double precision, each at most 100 N roundings of the largest
/// term.
double tolerance(std::size_t dof, double scale) {
  return 200 * static_cast<double>(dof) * 0x1p-53 * scale;
}

/// A and inverse dynamics of another engine against the oracle at 50 digits; angles of a few turns
/// (these engines reduce large angles in their own way).
void expect_agreement(const Problem<Real>& problem, const std::vector<Sample>& samples,
                      oracle::Engine& other) {
  const std::size_t n = problem.robot.size();
  const auto expect_near = [n](const std::vector<double>& x, const std::vector<Real>& y) {
    double scale = 0;
    double error = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      scale = std::max(scale, std::fabs(static_cast<double>(y[k])));
      error = std::max(error, std::fabs(static_cast<double>(Real(x.at(k)) - y[k])));
    }
    EXPECT_LE(error, tolerance(n, scale));
  };
  for (const Sample& sample : samples) {
    const auto& [q, qd, qdd] = std::tie(sample.at("q"), sample.at("qd"), sample.at("qdd"));
    if (support::max_abs(q) > 4) {
      continue;
    }
    expect_near(other.mass_matrix(q), oracle::evaluate(problem, "mass_matrix", {numbers<Real>(q)}));
    expect_near(other.inverse_dynamics(q, qd, qdd),
                oracle::evaluate(problem, "inverse_dynamics",
                                 {numbers<Real>(q), numbers<Real>(qd), numbers<Real>(qdd)}));
  }
}

TEST_P(EveryRobot, OracleEqualsKdl) {
  const model::Tree tree = read(GetParam().file, GetParam().base);
  const Problem<double> plain = problem_of<double>(tree, tree.points, kGravity);
  expect_agreement(problem_of<Real>(tree, tree.points, kGravity), samples_of(tree, 50),
                   *oracle::make_kdl(plain.robot, plain.gravity));
}

/// Robots that MuJoCo can represent (oracle/engines.hpp).
std::vector<Robot> robots_for_mujoco() {
  std::vector<Robot> result = robots();
  std::erase_if(result, [](const Robot& robot) {
    return !oracle::mujoco_reads(oracle::from_tree<double>(read(robot.file, robot.base)));
  });
  return result;
}

class RobotOfMujoco : public testing::TestWithParam<Robot> {};

TEST_P(RobotOfMujoco, OracleEqualsMujoco) {
  const model::Tree tree = read(GetParam().file, GetParam().base);
  const Problem<double> plain = problem_of<double>(tree, tree.points, kGravity);
  expect_agreement(problem_of<Real>(tree, tree.points, kGravity), samples_of(tree, 50),
                   *oracle::make_mujoco(plain.robot, plain.gravity));
}

class EveryModel : public testing::TestWithParam<Committed> {};

TEST_P(EveryModel, GeneratedCodeEqualsTheRecursiveOracle) {
  const Committed& model = GetParam();
  const support::CompiledModel code(model.folder, model.stem, support::Variant::kMeasured);
  const model::Tree tree = read(model.model, model.manifest.base);
  const Problem<Real> problem = problem_of<Real>(tree, tree.points, kGravity);
  for (const Sample& sample : samples_of(tree, 100)) {
    for (const support::FunctionInfo& function : model.manifest.functions) {
      std::vector<std::vector<Real>> inputs;
      for (const std::string& name : function.arguments) {
        inputs.push_back(numbers<Real>(sample.at(name)));
      }
      const auto y = oracle::evaluate(problem, function.name, inputs);
      const auto x = code.measure(function.name, support::arguments(sample, function.arguments));
      for (std::size_t k = 0; k < y.size(); ++k) {
        ASSERT_LE(abs(Real(x.values[k]) - y[k]), Real(x.bounds[k]) + Real("1e-40"))
            << function.name << " " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, EveryRobot, testing::ValuesIn(robots()),
                         [](const auto& robot) { return robot.param.name; });
INSTANTIATE_TEST_SUITE_P(Robots, RobotOfMujoco, testing::ValuesIn(robots_for_mujoco()),
                         [](const auto& robot) { return robot.param.name; });
INSTANTIATE_TEST_SUITE_P(Models, EveryModel,
                         testing::ValuesIn(support::committed(TREEDYN_SOURCE_DIR)),
                         [](const auto& model) { return support::test_name(model.param); });

}  // namespace
}  // namespace treedyn
