// What a pass costs in accuracy: what the full benchmark (accuracy_main.cpp) shows of larger robots
// and more states, on one arm.
#include "benchmark/accuracy.hpp"

#include <gtest/gtest.h>

#include "description/read.hpp"

namespace treedyn::benchmark {
namespace {

constexpr double kLargestCost = 4;  ///< of a pass that is on by default

constexpr std::size_t kSums = 1;  ///< number of the formulation without them

/// At usual angles relative to the natural scale; elsewhere relative to what rounding of the inputs
/// makes of the result. Large angles are left out for `sums`: a sum is rounded to its own unit
/// before its sine is taken, which costs more there.
void expect_accurate(const Errors& with, const Errors& without, double unit, bool large,
                     const std::string& what) {
  const Errors cost = factors(with, without, unit);
  EXPECT_LE(cost.scaled[static_cast<std::size_t>(Region::kUsual)], kLargestCost) << what;
  EXPECT_LE(cost.conditioned[static_cast<std::size_t>(Region::kSingular)], kLargestCost) << what;
  if (large) {
    EXPECT_LE(cost.conditioned[static_cast<std::size_t>(Region::kLarge)], kLargestCost) << what;
  }
}

class Passes : public testing::TestWithParam<const char*> {};

/// States of a region: the largest error of 200 is up to a single one (bias force without any pass,
/// singular, float: 2.1 units of 200, 11 of 1000).
constexpr std::size_t kStates = 1000;

TEST_P(Passes, CostNoMoreThanAFactorOfFour) {
  const Subject arm{"puma560",
                    description::read_model(TREEDYN_SOURCE_DIR "/models/puma560.yaml", {}), kStates,
                    200};
  const std::vector<Accuracy> rows = accuracy(arm, GetParam(), formulations_by_pass());
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Accuracy& row = rows[k];
    const Accuracy& with = rows[row.formulation.with];
    const std::string& name = row.formulation.name;
    expect_accurate(with.in_double, row.in_double, 0x1p-53, k != kSums, name);
    expect_accurate(with.in_float, row.in_float, 0x1p-24, k != kSums, name + " in float");
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, Passes,
                         testing::Values("mass_matrix", "bias_force", "gravity_force",
                                         "inverse_dynamics", "forward_dynamics"),
                         [](const auto& function) { return std::string(function.param); });

}  // namespace
}  // namespace treedyn::benchmark
