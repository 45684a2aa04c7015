// Compiled generated code against the generic engine at 50 digits, every committed model, both
// scalar types. The tolerance of every number is the running error bound of the code itself
// (support/measured.hpp), so it follows from the operations executed and the sizes of the operands.
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "engine/engine.hpp"
#include "support/cases.hpp"
#include "support/models.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

using support::Committed;
using support::CompiledModel;
using support::FunctionInfo;
using support::Manifest;
using support::Measurement;
using support::Sample;
using support::Variant;

constexpr std::size_t kStates = 200;

std::vector<Real> to_real(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// The same code twice: as it is, and with error bounds.
struct Code {
  CompiledModel plain;
  CompiledModel measured;
};

/// The same model in the generic engine, in 50 digits.
class Reference {
 public:
  explicit Reference(const Committed& model)
      : tree_(read(model)), engine_(tree_, tree_.points, gravity()) {}

  std::vector<Real> evaluate(const FunctionInfo& function, const Sample& sample) {
    std::vector<std::vector<Real>> inputs;
    for (const std::string& name : function.arguments) {
      inputs.push_back(to_real(sample.at(name)));
    }
    return engine_.evaluate(function.name, inputs);
  }

 private:
  static model::Tree read(const Committed& model) {
    description::ReadOptions options;
    options.base =
        model.manifest.base == "axes" ? description::Base::kAxes : description::Base::kFixed;
    return description::read_model(model.model.string(), options);
  }
  static model::Vector3 gravity() { return {Real(0), Real(0), Real("-9.81")}; }

  model::Tree tree_;
  engine::Engine<Real> engine_;
};

/// What the reference itself may lose: 50 digits less the growth over its operations, relative to
/// numbers of order 1 (a structural zero of the code may be 1e-50 there).
constexpr double kReference = 1e-40;

/// How far the outputs of one call are from the reference, in units of their bounds.
double ratio(const std::vector<double>& x, const std::vector<double>& bounds,
             const std::vector<Real>& expected) {
  double largest = x.size() == expected.size() ? 0 : HUGE_VAL;
  for (std::size_t k = 0; k < std::min(x.size(), expected.size()); ++k) {
    const double error = static_cast<double>(abs(Real(x[k]) - expected[k]));
    const double allowed = bounds[k] + kReference;
    largest = error <= allowed ? std::max(largest, error / allowed) : HUGE_VAL;
  }
  return largest;
}

/// The largest bound and the largest output of a function over all states of moderate angles.
struct Seen {
  double bound = 0;
  double scale = 0;
};

/// Compares one function in one state, and its operations with the manifest.
void expect_inside_bounds(const Code& code, const FunctionInfo& function, const Sample& sample,
                          const std::vector<Real>& expected, Seen& seen) {
  const auto inputs = support::arguments(sample, function.arguments);
  const std::vector<double> x = code.plain.call(function.name, inputs);
  const Measurement m = code.measured.measure(function.name, inputs);
  EXPECT_LE(ratio(x, m.bounds, expected), 1.0) << function.name;
  EXPECT_LE(ratio(m.values, m.bounds, expected), 1.0) << function.name << ", measured";
  EXPECT_EQ(m.operations, function.operations) << function.name;
  if (support::max_abs(sample.at("q")) < 4) {
    seen.bound = std::max(seen.bound, support::max_abs(m.bounds));
    seen.scale = std::max(seen.scale, support::max_abs(x));
  }
}

/// Bounds that prove something: at most 1000 roundings of the largest output. A solve loses the
/// condition of A beside that.
void expect_tight(const Manifest& manifest, const std::map<std::string, Seen>& seen) {
  const double unit = manifest.scalar == "float" ? 0x1p-24 : 0x1p-53;
  for (const auto& [function, largest] : seen) {
    if (function != "forward_dynamics") {
      EXPECT_LE(largest.bound, 1000 * unit * largest.scale + 1e-40) << function;
    }
  }
}

class GeneratedCode : public testing::TestWithParam<Committed> {};

void expect_equal_to_engine(const Committed& model, const Code& code,
                            std::size_t states = kStates) {
  Reference reference(model);
  const auto& manifest = code.plain.manifest();
  const auto dof = static_cast<std::size_t>(manifest.dof);
  std::map<std::string, Seen> seen;
  for (const Sample& sample : support::samples(dof, manifest.points.size(), states, 1)) {
    for (const FunctionInfo& function : manifest.functions) {
      expect_inside_bounds(code, function, sample, reference.evaluate(function, sample),
                           seen[function.name]);
    }
    if (testing::Test::HasFailure()) {
      return;  // one state says enough
    }
  }
  expect_tight(manifest, seen);
}

TEST_P(GeneratedCode, CommittedFunctionsEqualTheEngine) {
  const Committed& model = GetParam();
  expect_equal_to_engine(model, {CompiledModel(model.folder, model.stem),
                                 CompiledModel(model.folder, model.stem, Variant::kMeasured)});
}

TEST_P(GeneratedCode, AllFunctionsInDoubleEqualTheEngine) {
  expect_equal_to_engine(GetParam(),
                         {support::with_all_functions(GetParam(), "double", Variant::kPlain),
                          support::with_all_functions(GetParam(), "double", Variant::kMeasured)});
}

TEST_P(GeneratedCode, AllFunctionsInFloatEqualTheEngine) {
  expect_equal_to_engine(GetParam(),
                         {support::with_all_functions(GetParam(), "float", Variant::kPlain),
                          support::with_all_functions(GetParam(), "float", Variant::kMeasured)});
}

INSTANTIATE_TEST_SUITE_P(Models, GeneratedCode,
                         testing::ValuesIn(support::committed(TREEDYN_SOURCE_DIR)),
                         [](const auto& model) { return support::test_name(model.param); });

/// --share-limbs: model and scalar type.
using SharedCase = std::pair<Committed, const char*>;
class SharedLimbs : public testing::TestWithParam<SharedCase> {};

std::vector<SharedCase> shared_cases() {
  std::vector<SharedCase> result;
  for (const Committed& model : support::committed_models(TREEDYN_SOURCE_DIR)) {
    if (model.folder.filename() == "biped_axes") {
      result.emplace_back(model, "double");
    } else if (model.stem == "quadruped") {
      result.emplace_back(model, "double");
      result.emplace_back(model, "float");
      result.back().first.folder += "_axes";
      result.back().first.manifest.base = "axes";
    }
  }
  return result;
}

TEST_P(SharedLimbs, AllFunctionsEqualTheEngine) {
  constexpr std::size_t kFewStates = 12;
  const auto& [model, scalar] = GetParam();
  const std::vector<std::string> option = {"--share-limbs"};
  expect_equal_to_engine(model,
                         {support::with_all_functions(model, scalar, Variant::kPlain, option),
                          support::with_all_functions(model, scalar, Variant::kMeasured, option)},
                         kFewStates);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedLimbs, testing::ValuesIn(shared_cases()),
                         [](const auto& shared) { return support::test_name(shared.param.first); });

}  // namespace
}  // namespace treedyn
