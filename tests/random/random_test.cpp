// Random trees through the whole pipeline: reader, formulation, program, against the engine and the
// recursive oracle, all at 50 digits; and a few of them through the compiler.

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "description/read.hpp"
#include "engine/engine.hpp"
#include "engine/outputs.hpp"
#include "formulate/formulate.hpp"
#include "oracle/from_tree.hpp"
#include "oracle/functions.hpp"
#include "program/interpret.hpp"
#include "random/random_description.hpp"
#include "rapidcheck/gtest.h"  // needs gtest/gtest.h before it
#include "support/compiled.hpp"
#include "support/process.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

/// The same trees on every run; RC_PARAMS of the environment overrides it.
const int kConfigured = setenv("RC_PARAMS", "seed=2011 max_success=40", 0);

using RealList = std::vector<Real>;
using RealInputs = std::vector<RealList>;

const model::Vector3 kGravity{Real(1), Real(-2), Real("-9.81")};

/// Lengths and masses are of order 1, so errors are relative to 1. `Real` has 50 digits, and a
/// cancellation below 1e-40 of its terms counts as zero (common/real.hpp); 1e4 is room for the
/// growth of rounding over the operations of 8 links.
const Real kTolerance("1e-36");

Real largest_difference(const RealList& x, const RealList& y) {
  RC_ASSERT(x.size() == y.size());
  Real error = 0;
  Real scale = 1;
  for (std::size_t k = 0; k < x.size(); ++k) {
    error = std::max(error, Real(abs(x[k] - y[k])));
    scale = std::max(scale, Real(abs(y[k])));
  }
  return error / scale;
}

/// Everything that computes the functions of one random tree.
struct Trio {
  explicit Trio(const model::Tree& the_tree)
      : tree(the_tree),
        engine(tree, tree.points, kGravity),
        problem(oracle::problem_of<Real>(tree, tree.points, kGravity)) {}
  const model::Tree& tree;
  engine::Engine<Real> engine;
  oracle::Problem<Real> problem;
};

RealInputs inputs_of(const program::Signature& signature, const support::Sample& sample) {
  RealInputs result;
  for (const program::Array& array : signature.inputs) {
    const std::vector<double>& values = sample.at(array.name);
    result.emplace_back(values.begin(), values.end());
  }
  return result;
}

/// A is far enough from singular for 36 digits of a solution to remain: the pivots of its
/// elimination are not tiny. (Massless links may make joints move nothing.)
bool solvable(const oracle::Problem<Real>& problem, const support::Sample& sample) {
  const RealList q(sample.at("q").begin(), sample.at("q").end());
  RealList A = oracle::mass_matrix(problem.robot, q);
  const std::size_t n = q.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (A[k * n + k] < Real("1e-3")) {
      return false;
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = A[i * n + k] / A[k * n + k];
      for (std::size_t j = k; j < n; ++j) {
        A[i * n + j] -= factor * A[k * n + j];
      }
    }
  }
  return true;
}

void expect_agreement(Trio& trio, const program::Function& function,
                      const support::Sample& sample) {
  const RealInputs inputs = inputs_of(function.signature, sample);
  const std::vector<std::span<const Real>> spans(inputs.begin(), inputs.end());
  const std::string& name = function.signature.name;
  const RealList program = program::interpret<Real>(function, spans);
  const RealList oracle = oracle::evaluate(trio.problem, name, inputs);
  RC_LOG() << name << '\n';
  RC_ASSERT(largest_difference(program, oracle) <= kTolerance);
  if (std::ranges::count(engine::functions(), name, &equations::Equation::name) > 0) {
    RC_ASSERT(largest_difference(trio.engine.evaluate(name, inputs), oracle) <= kTolerance);
  }
}

model::Tree read(const nlohmann::json& description) {
  description::ReadOptions options;
  return description::parse_model(description.dump(), "random.yaml", options);
}

RC_GTEST_PROP(RandomTree, ProgramAndEngineAndOracleAgree, ()) {
  const nlohmann::json description = random::description(8);
  RC_LOG() << description.dump(1) << '\n';
  const model::Tree tree = read(description);
  Trio trio(tree);
  formulate::Options options;
  options.gravity = kGravity;
  options.points = tree.points;
  options.effort = *rc::gen::element(0, 0, 20);
  const auto samples = support::samples(static_cast<std::size_t>(tree.dof()), tree.points.size(), 9,
                                        *rc::gen::arbitrary<std::uint64_t>());
  for (const std::string& name : formulate::function_names()) {
    const bool solves = name == "forward_dynamics" || name.starts_with("mass_matrix_");
    if (solves && !std::all_of(samples.begin(), samples.end(), [&](const support::Sample& sample) {
          return solvable(trio.problem, sample);
        })) {
      continue;
    }
    const program::Function function = formulate::formulated(tree, name, options);
    for (const std::size_t k : {0U, 1U, 3U, 4U, 6U, 7U, 8U}) {
      expect_agreement(trio, function, samples[k]);
    }
  }
}

RC_GTEST_PROP(RandomTree, CompiledCodeStaysInsideItsErrorBounds, ()) {
  const nlohmann::json description = random::description(5);
  RC_LOG() << description.dump(1) << '\n';
  const model::Tree tree = read(description);
  const support::TemporaryFolder folder;
  support::write_file(folder.path() / "random.yaml", description.dump());
  const support::CompiledModel code = support::generate_and_compile(
      folder.path() / "random.yaml",
      {"--effort", "0", "--gravity", "1,-2,-9.81", "--scalar", *rc::gen::element("double", "float"),
       "--functions", "mass_matrix,bias_force,inverse_dynamics,force_jacobian_transpose"},
      support::Variant::kMeasured);
  engine::Engine<Real> engine(tree, tree.points, kGravity);
  for (const support::Sample& sample :
       support::samples(static_cast<std::size_t>(tree.dof()), tree.points.size(), 20, 1)) {
    for (const support::FunctionInfo& function : code.manifest().functions) {
      RealInputs inputs;
      for (const std::string& name : function.arguments) {
        inputs.emplace_back(sample.at(name).begin(), sample.at(name).end());
      }
      const RealList expected = engine.evaluate(function.name, inputs);
      const support::Measurement m =
          code.measure(function.name, support::arguments(sample, function.arguments));
      RC_ASSERT(m.operations == function.operations);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        RC_ASSERT(abs(Real(m.values[k]) - expected[k]) <= Real(m.bounds[k]) + kTolerance);
      }
    }
  }
}

}  // namespace
}  // namespace treedyn
