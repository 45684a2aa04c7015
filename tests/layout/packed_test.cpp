// `--layout packed`: the values of the dense functions at the places that the header's tables name;
// `--trig late`: the same values.
#include "packed.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "dense.hpp"
#include "late.hpp"
#include "packed_limbs.hpp"

namespace {

constexpr int kN = packed::kDof;
constexpr int kNonzeros = packed::kMassMatrixNonzeros;
using Vector = std::array<double, kN>;
using Dense = std::array<double, kN * kN>;
using Packed = std::array<double, kNonzeros>;

Vector state(int k) {
  Vector q;
  for (int i = 0; i < kN; ++i) {
    q[static_cast<std::size_t>(i)] = 0.37 * (i + 1) * (k + 1) - 2.0 * k;
  }
  return q;
}

/// A from its stored values, zero elsewhere.
Dense unpacked(const Packed& values) {
  Dense a{};
  for (int k = 0; k < kNonzeros; ++k) {
    const int i = packed::kMassMatrixRow[k];
    const int j = packed::kMassMatrixColumn[k];
    a[static_cast<std::size_t>(i * kN + j)] = a[static_cast<std::size_t>(j * kN + i)] =
        values[static_cast<std::size_t>(k)];
  }
  return a;
}

TEST(Packed, StoresTheLowerTriangleRowByRow) {
  for (int k = 0; k < kNonzeros; ++k) {
    EXPECT_LE(packed::kMassMatrixColumn[k], packed::kMassMatrixRow[k]);
    if (k > 0) {
      const int before = packed::kMassMatrixRow[k - 1] * kN + packed::kMassMatrixColumn[k - 1];
      EXPECT_LT(before, packed::kMassMatrixRow[k] * kN + packed::kMassMatrixColumn[k]);
    }
  }
}

// EQUATIONS.md 7.1: links of different legs are not related; 135 of 171 entries remain, fewer by
// those that the base's own axes make zero.
TEST(Packed, LeavesOutWhatTheTreeMakesZero) {
  EXPECT_LE(kNonzeros, 135);
  EXPECT_GE(kNonzeros, 135 - 6);
}

// Also where two products cancel: the sliding z axis and the turning z axis of the base.
TEST(Packed, StoresNoZeros) {
  Packed values;
  packed::mass_matrix(state(1).data(), values.data());
  EXPECT_EQ(std::count(values.begin(), values.end(), 0.0), 0);
}

TEST(Packed, HoldsTheValuesOfTheDenseMatrix) {
  for (int k = 0; k < 20; ++k) {
    const Vector q = state(k);
    Dense expected;
    Packed values;
    dense::mass_matrix(q.data(), expected.data());
    packed::mass_matrix(q.data(), values.data());
    EXPECT_EQ(unpacked(values), expected) << "state " << k;
  }
}

TEST(Packed, AppliesToTheMatrixOfDynamicsTerms) {
  const Vector q = state(3);
  const Vector qd = state(5);
  Dense expected;
  Packed values;
  Vector b;
  Vector g;
  Vector expected_b;
  Vector expected_g;
  dense::dynamics_terms(q.data(), qd.data(), expected.data(), expected_b.data(), expected_g.data());
  packed::dynamics_terms(q.data(), qd.data(), values.data(), b.data(), g.data());
  EXPECT_EQ(unpacked(values), expected);
  EXPECT_EQ(b, expected_b);
  EXPECT_EQ(g, expected_g);
}

/// A matrix from stored values, zero elsewhere.
template <std::size_t kSize, std::size_t kStored>
std::array<double, kSize> unpacked(const double (&values)[kStored], const int (&row)[kStored],
                                   const int (&column)[kStored], bool mirrored) {
  constexpr int kColumns = kN;
  std::array<double, kSize> result{};
  for (std::size_t k = 0; k < kStored; ++k) {
    result[static_cast<std::size_t>(row[k] * kColumns + column[k])] = values[k];
    if (mirrored) {
      result[static_cast<std::size_t>(column[k] * kColumns + row[k])] = values[k];
    }
  }
  return result;
}

// The dense functions have the same statements, and store zeros as well.
TEST(Packed, HoldsMatricesOfUsers) {
  const Vector q = state(2);
  const Vector qd = state(4);
  Dense expected;
  double inertia[packed::kSlidingInertiaNonzeros];
  dense::sliding_inertia(q.data(), expected.data());
  packed::sliding_inertia(q.data(), inertia);
  EXPECT_EQ(
      unpacked<kN * kN>(inertia, packed::kSlidingInertiaRow, packed::kSlidingInertiaColumn, true),
      expected);
  EXPECT_LE(packed::kSlidingInertiaNonzeros, 135);
  double rate[packed::kMassMatrixRateNonzeros];
  dense::mass_matrix_rate(q.data(), qd.data(), expected.data());
  packed::mass_matrix_rate(q.data(), qd.data(), rate);
  EXPECT_EQ(
      unpacked<kN * kN>(rate, packed::kMassMatrixRateRow, packed::kMassMatrixRateColumn, true),
      expected);
  std::array<double, std::size_t{3} * kN * kN> all;
  double spins[packed::kSpinsNonzeros];
  dense::spins(q.data(), all.data());
  packed::spins(q.data(), spins);
  EXPECT_EQ(
      (unpacked<std::size_t{3} * kN * kN>(spins, packed::kSpinsRow, packed::kSpinsColumn, false)),
      all);
  EXPECT_LT(packed::kSpinsNonzeros, 3 * kN * kN / 3);
  std::array<double, std::size_t{3} * kN> sums;
  double same[packed::kSumsNonzeros];
  dense::sums(q.data(), sums.data());
  packed::sums(q.data(), same);
  EXPECT_EQ((unpacked<std::size_t{3} * kN>(same, packed::kSumsRow, packed::kSumsColumn, false)),
            sums);
  const auto zeros = std::count(sums.begin(), sums.end(), 0.0);
  EXPECT_EQ(packed::kSumsNonzeros, 3 * kN - zeros);
}

// `--trig late` moves statements and changes none.
TEST(LateTrigonometry, LeavesEveryBitOfTheResult) {
  for (int k = 0; k < 20; ++k) {
    const Vector q = state(k);
    Dense expected;
    Dense values;
    dense::mass_matrix(q.data(), expected.data());
    late::mass_matrix(q.data(), values.data());
    EXPECT_EQ(values, expected) << "state " << k;
  }
}

// Other code for the same values: 1143 operations on entries up to 100, each good to half a unit of
// 1e-16; the difference of both.
TEST(Packed, HoldsTheSameValuesIfLimbsShareCode) {
  const Vector q = state(7);
  Packed expected;
  Packed values;
  packed::mass_matrix(q.data(), expected.data());
  packed_limbs::mass_matrix(q.data(), values.data());
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NEAR(values[k], expected[k], 1143 * 100 * 1.2e-16 * 2);
  }
}

}  // namespace
