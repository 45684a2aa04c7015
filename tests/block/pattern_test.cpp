// Zero patterns of EQUATIONS.md 7.1.
#include "block/pattern.hpp"

#include <gtest/gtest.h>

#include "block/random_leaves.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"

namespace treedyn::block {
namespace {

using namespace equations;  // NOLINT(google-build-using-namespace): the symbols

// 0 - 1 - 2, 1 - 3, and a second root 4 with son 5; joint 1 is prismatic.
Index two_trees() { return {{-1, 0, 1, 1, -1, 4}, {true, false, true, true, true, true}, {}, {}}; }

bool is_ancestor(const Index& index, int j, int i) {  // j ≼ i
  while (i > j) {
    i = index.father[static_cast<std::size_t>(i)];
  }
  return i == j;
}

/// Some revolute (prismatic) joint j with k ≺ j ≼ i.
bool joint_between(const Index& index, int k, int i, bool revolute) {
  for (int j = k + 1; j <= i; ++j) {
    if (is_ancestor(index, k, j) && is_ancestor(index, j, i) &&
        index.revolute[static_cast<std::size_t>(j)] == revolute) {
      return true;
    }
  }
  return false;
}

template <class Rule>
void expect_pattern(const Expression& e, const Rule& rule) {
  support::Dice dice(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Index index = random_index(8, 0, dice);
    const Pattern blocks = pattern(e, index);
    for (int i = 0; i < blocks.rows(); ++i) {
      for (int j = 0; j < blocks.cols(); ++j) {
        EXPECT_EQ(blocks.find(i, j) >= 0, rule(index, i, j)) << i << "," << j;
      }
    }
  }
}

bool reaches(const Index& index, int i, int j) { return is_ancestor(index, j, i); }

TEST(Reachability, ListsAncestors) {
  EXPECT_EQ(to_text(reachability(two_trees())),
            "x.....\n"
            "xx....\n"
            "xxx...\n"
            "xx.x..\n"
            "....x.\n"
            "....xx\n");
}

TEST(Pattern, OfVectorsBetweenJointsAndLinksIsThatOfD) {
  expect_pattern(joint_to_com_vectors(), reaches);
  expect_pattern(velocity_jacobian(centres_of_mass()), reaches);
}

TEST(Pattern, OfWhatIsMultipliedByStrictDIsStrict) {
  expect_pattern(D - E,
                 [](const Index& index, int i, int j) { return i != j && reaches(index, i, j); });
}

TEST(Pattern, OfFirstTermOfBiasMatrixNeedsRevoluteJointBetween) {
  expect_pattern(
      skew_transpose(joint_to_com_vectors()) * skew_transpose(z_d * sigma * qd_d) * (D - E),
      [](const Index& index, int i, int k) { return joint_between(index, k, i, true); });
}

TEST(Pattern, OfSecondTermOfBiasMatrixNeedsPrismaticJointBetween) {
  expect_pattern(
      2 * D * skew_transpose(z_d * (E - sigma) * qd_d) * (D - E),
      [](const Index& index, int i, int k) { return joint_between(index, k, i, false); });
}

TEST(Pattern, OfMassMatrixJoinsRelatedLinksOnly) {
  expect_pattern(mass_matrix(), [](const Index& index, int i, int j) {
    return reaches(index, i, j) || reaches(index, j, i);
  });
}

// No fill-in: A = L^T Δ L has no more zeros than L^T Δ L, nor has L^-1 more blocks than L.
TEST(Pattern, OfFactorsAlongPathsIsThatOfTheMassMatrix) {
  const Expression L = leaf("L", Structure::kAlongPaths, {kLinks, kLinks});
  expect_pattern(transpose(L) * m_d * L, [](const Index& index, int i, int j) {
    return reaches(index, i, j) || reaches(index, j, i);
  });
  expect_pattern(L * L, reaches);
}

TEST(Pattern, OfAngularJacobianHasRevoluteColumnsOnly) {
  expect_pattern(angular_jacobian(), [](const Index& index, int i, int j) {
    return reaches(index, i, j) && index.revolute[static_cast<std::size_t>(j)];
  });
}

TEST(Pattern, OfMomentJacobianFollowsCarriersOfPoints) {
  Index index = two_trees();
  index.carrier = {2, -1, 5, 2};
  EXPECT_EQ(to_text(pattern(moment_jacobian_transpose(points()), index)),
            "x..x\n"
            "....\n"  // prismatic
            "x..x\n"
            "....\n"
            "..x.\n"
            "..x.\n");
}

TEST(Pattern, OfForceJacobianHasNoColumnForPointsOnGround) {
  Index index = two_trees();
  index.carrier = {-1, 3};
  EXPECT_EQ(to_text(pattern(force_jacobian_transpose(points()), index)),
            ".x\n.x\n..\n.x\n..\n..\n");
}

TEST(Pattern, FindsBlocksAndNothingElse) {
  const Pattern p(3, {{0, 2}, {}, {1}});
  EXPECT_EQ(p.find(0, 2), 1);
  EXPECT_EQ(p.find(0, 1), -1);
  EXPECT_EQ(p.find(2, 1), 2);
  EXPECT_EQ(transpose(p), Pattern(3, {{0}, {2}, {0}}));
  EXPECT_EQ(unite(p, diagonal(3)), Pattern(3, {{0, 2}, {1}, {1, 2}}));
  EXPECT_EQ(product(p, diagonal(3)), p);
}

// 18 joints: 6 of the floating base, two legs of 6 (EQUATIONS.md 7.1).
TEST(Pattern, OfBipedMassMatrixHas135PairsInLowerHalf) {
  Index index;
  for (int i = 0; i < 18; ++i) {
    index.father.push_back(i == 12 ? 5 : i - 1);
    index.revolute.push_back(i >= 3);
  }
  const Pattern A = pattern(mass_matrix(), index);
  EXPECT_EQ((A.blocks() + 18) / 2, 135);
}

}  // namespace
}  // namespace treedyn::block
