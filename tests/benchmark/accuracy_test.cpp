// No pass costs more than a factor of 4 in accuracy: what the full benchmark (accuracy_main.cpp)
// shows of larger robots and thousands of states, on one arm and a few hundred.
#include "benchmark/accuracy.hpp"

#include <gtest/gtest.h>

#include "description/read.hpp"

namespace treedyn::benchmark {
namespace {

constexpr double kLargestCost = 4;  ///< of a pass that is on by default

void expect_accurate(const Errors& all, const Errors& without, double unit,
                     const std::string& what) {
  const Errors cost = factors(all, without, unit);
  for (std::size_t k = 0; k < kRegions.size(); ++k) {
    EXPECT_LE(cost.conditioned[k], kLargestCost) << what << ", " << kRegions[k];
  }
}

class Passes : public testing::TestWithParam<const char*> {};

TEST_P(Passes, CostNoMoreThanAFactorOfFourInAccuracy) {
  const Subject arm{
      "puma560", description::read_model(TREEDYN_SOURCE_DIR "/models/puma560.yaml", {}), 200, 200};
  const std::vector<Accuracy> rows = accuracy(arm, GetParam(), formulations_by_pass());
  for (const Accuracy& row : rows) {
    expect_accurate(rows.front().in_double, row.in_double, 0x1p-53, row.formulation);
    expect_accurate(rows.front().in_float, row.in_float, 0x1p-24, row.formulation + " in float");
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, Passes,
                         testing::Values("mass_matrix", "bias_force", "inverse_dynamics",
                                         "forward_dynamics"),
                         [](const auto& function) { return std::string(function.param); });

}  // namespace
}  // namespace treedyn::benchmark
