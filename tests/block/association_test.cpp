#include "block/association.hpp"

#include <gtest/gtest.h>

namespace treedyn::block {
namespace {

std::vector<std::pair<int, int>> order_of(const std::vector<Factor>& factors) {
  std::vector<std::pair<int, int>> result;
  for (const Split& split : associate(factors)) {
    result.emplace_back(split.left, split.right);
  }
  return result;
}

using Order = std::vector<std::pair<int, int>>;

TEST(Associate, MultipliesColumnFromTheRight) {
  const Factor square{full(4, 4), 1, 1, false};
  const Factor column{full(4, 1), 1, 1, false};
  EXPECT_EQ(order_of({square, square, column}), (Order{{1, 2}, {0, 1}}));
}

TEST(Associate, MultipliesRowFromTheLeft) {
  const Factor square{full(4, 4), 1, 1, false};
  const Factor row{full(1, 4), 1, 1, false};
  EXPECT_EQ(order_of({row, square, square}), (Order{{0, 1}, {0, 2}}));
}

TEST(Associate, PrefersSmallBlocks) {
  const Factor row{diagonal(5), 1, 3, false};  // z^dT
  const Factor matrix{full(5, 5), 3, 3, false};
  EXPECT_EQ(order_of({row, matrix, matrix}), (Order{{0, 1}, {0, 2}}));
}

TEST(Associate, MultipliesNumbersOutBeforeTheSizeRuleBlowsThemUp) {
  const Factor row{full(4, 4), 1, 3, false};     // J_v^T
  const Factor column{full(4, 4), 3, 1, false};  // J_v
  const Factor vectors{full(4, 1), 3, 1, false};
  EXPECT_EQ(order_of({row, column, vectors}), (Order{{0, 1}, {0, 2}}));
}

TEST(Associate, LeavesSingleFactorAlone) {
  EXPECT_TRUE(order_of({{full(2, 2), 1, 1, false}}).empty());
}

}  // namespace
}  // namespace treedyn::block
