// The arithmetic and the text of benchmark reports on figures that are known.
#include "benchmark/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/clock.hpp"

namespace treedyn::benchmark {
namespace {

using testing::HasSubstr;
using testing::Not;

Cell cell(const std::string& contestant, double least, std::optional<double> instructions) {
  return {"arm", 6, "mass_matrix", contestant, 1e-16, least, least + 1, instructions};
}

const std::vector<Cell> kCells{cell("treedyn, libm", 50, 400), cell("treedyn, default", 25, 300),
                               cell("block form", 40, 9000), cell("KDL", 1000, 7000),
                               cell("MuJoCo", 500, 5000)};

TEST(Median, IsTheMiddleOrTheMeanOfBothMiddleValues) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

TEST(Measure, CallsEveryFunctionAndReturnsNoMedianBelowTheLeast) {
  std::vector<int> calls(2);
  const auto count = [&calls](std::size_t k) {
    return [&calls, k](Turn turn) {
      calls[k] += turn.calls;
    };
  };
  const auto times = measure({count(0), count(1)}, 3);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_GT(calls[k], 3);
    EXPECT_LE(times[k].least, times[k].median);
  }
}

TEST(Markdown, ComparesGeneratedCodeWithTheFastestEngineAndNotWithTheBlockForm) {
  const std::string text = markdown(kCells);
  EXPECT_THAT(text, HasSubstr("| arm (6 joints) | mass_matrix | 50 (51) | 25 (26) | 40 (41) | "
                              "1000 (1001) | 500 (501) | 10.0, 20.0 |"));
  EXPECT_THAT(text, HasSubstr("| 400 | 300 | 9000 | 7000 | 5000 |"));
}

TEST(Markdown, LeavesCellsEmptyThatAnEngineCannotExpress) {
  std::vector<Cell> cells = kCells;
  cells.push_back(cells.front());
  cells.back().function = "bias_force";
  EXPECT_THAT(markdown(cells), HasSubstr("bias_force | 50 (51) | | | | |"));
}

TEST(Markdown, HasNoTableOfInstructionsThatWereNotCounted) {
  EXPECT_THAT(markdown({cell("KDL", 1, {})}), Not(HasSubstr("instructions")));
}

TEST(Csv, HasOneLineACell) {
  EXPECT_THAT(csv(kCells), HasSubstr("arm,6,mass_matrix,\"KDL\",1.0e-16,1000.0,1001.0,7000\n"));
}

TEST(Svg, LabelsBarsWithTheRatioToTheFirstContestant) {
  const std::string text = svg(kCells);
  EXPECT_THAT(text, HasSubstr(">20<"));
  EXPECT_THAT(text, HasSubstr(">0.50<"));
}

}  // namespace
}  // namespace treedyn::benchmark
