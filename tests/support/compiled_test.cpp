// The helpers themselves: what they report of code that is known.
#include "support/compiled.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "common/real.hpp"
#include "support/cases.hpp"
#include "support/process.hpp"

namespace treedyn::support {
namespace {

using testing::ElementsAre;

constexpr const char* kHeader = R"(#pragma once
namespace sample {
using Scalar = double;
void f(const Scalar x[2], Scalar y[3]) noexcept;
}  // namespace sample
)";

constexpr const char* kSource = R"(#include "sample.hpp"
#include <cmath>
namespace sample {
using std::sin;
void f(const Scalar x[2], Scalar y[3]) noexcept {
  const Scalar s = sin(x[0]);
  y[0] = 0.1 * s + x[1];
  y[1] = -s / x[1];
}
}  // namespace sample
)";

constexpr const char* kManifest = R"({"model": {"file": "sample.yaml"},
 "options": {"scalar": "double", "base": "fixed"}, "dof": 2,
 "joints": [{"name": "a"}, {"name": "b"}], "points": [],
 "functions": [{"name": "f", "inputs": [{"name": "x", "size": 2}], "outputs": [{"name": "y", "size": 3}],
   "operations": {"add": 1, "mul": 1, "div": 1, "sqrt": 0, "sin": 1, "cos": 0}}]})";

/// The sample above; f leaves its third output unwritten.
CompiledModel sample(Variant variant) {
  const TemporaryFolder folder;
  write_file(folder.path() / "sample.hpp", kHeader);
  write_file(folder.path() / "sample.cpp", kSource);
  write_file(folder.path() / "sample.json", kManifest);
  return {folder.path(), "sample", variant};
}

TEST(CompiledModel, CallsTheFunctionAndLeavesUnwrittenOutputsNaN) {
  const std::vector<double> y = sample(Variant::kPlain).call("f", {{2.0, 4.0}});
  EXPECT_EQ(y[0], 0.1 * std::sin(2.0) + 4.0);
  EXPECT_EQ(y[1], -std::sin(2.0) / 4.0);
  EXPECT_TRUE(std::isnan(y[2]));
}

TEST(CompiledModel, CountsTheOperationsOfOneCall) {
  const CompiledModel model = sample(Variant::kMeasured);
  const auto expected = model.manifest().function("f").operations;
  EXPECT_EQ(model.measure("f", {{2.0, 4.0}}).operations, expected);
  EXPECT_EQ(model.measure("f", {{3.0, 5.0}}).operations, expected);
}

TEST(CompiledModel, BoundsTheRoundingErrorOfEveryOutput) {
  const CompiledModel model = sample(Variant::kMeasured);
  for (int k = 1; k <= 1000; ++k) {
    const double a = 0.37 * k;
    const double b = -0.011 * k;
    const Measurement y = model.measure("f", {{a, b}});
    const Real s = sin(Real(a));
    EXPECT_LE(abs(Real(y.values[0]) - (Real("0.1") * s + Real(b))), Real(y.bounds[0]));
    EXPECT_LE(abs(Real(y.values[1]) + s / Real(b)), Real(y.bounds[1]));
    EXPECT_LE(y.bounds[0], 6 * 1.2e-16 * (0.1 + std::fabs(b)));
  }
}

TEST(CompiledModel, ReportsWhatTheCompilerSays) {
  const TemporaryFolder folder;
  write_file(folder.path() / "sample.hpp", kHeader);
  write_file(folder.path() / "sample.cpp", "no C++");
  write_file(folder.path() / "sample.json", kManifest);
  EXPECT_THROW(CompiledModel(folder.path(), "sample"), std::runtime_error);
}

TEST(Run, ReturnsStatusOutputAndErrors) {
  const Outcome outcome = run({"sh", "-c", "read x; echo out $x; echo err >&2; exit 3"}, "hello\n");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.out, "out hello\n");
  EXPECT_EQ(outcome.err, "err\n");
}

TEST(ErrorOf, IsRelativeToTheLargestNumberAndAbsoluteBelowTheFloor) {
  const Tolerance tolerance{1e-12, 1e-12, 1e-9};
  EXPECT_EQ(error_of({1.0, 5.0}, {1.0, 4.0}, tolerance), 0.25);
  EXPECT_EQ(error_of({0.5}, {0.0}, tolerance), 0.5);
}

TEST(ErrorOf, IsInfiniteForNaNAndForDifferentSizes) {
  EXPECT_TRUE(std::isinf(error_of({NAN, 1.0}, {1.0, 1.0}, {})));
  EXPECT_TRUE(std::isinf(error_of({1.0}, {1.0, 1.0}, {})));
}

TEST(Report, FailsForNaNAndWithoutAnyComparison) {
  Report report;
  EXPECT_FALSE(report.passed());
  report.compare("code", "A", {1.0}, {1.0}, {});
  EXPECT_TRUE(report.passed());
  report.compare("code", "A", {NAN}, {1.0}, {});
  EXPECT_FALSE(report.passed());
}

TEST(RunCases, FailsForAFolderWithoutCases) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_cases({folder.path().string()}, [](const auto&, const auto&, Report&) {}), 1);
}

TEST(Flat, KeepsTheOrderOfNestedLists) {
  EXPECT_THAT(flat(Json::parse("[[1, 2], [3, [4]]]")), ElementsAre(1, 2, 3, 4));
}

}  // namespace
}  // namespace treedyn::support
