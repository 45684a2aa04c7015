// What numbers are made of, and what has cancelled.
#include "common/provenance.hpp"

#include <gtest/gtest.h>

namespace treedyn {
namespace {

Origin com_of(int link) { return {link, ModelPart::kCom, 0}; }
Origin mass_of(int link) { return {link, ModelPart::kMass, 0}; }

/// A mass, a length of two links that are alike, opposite in them, and an inertia of which two
/// entries are equal.
class ProvenanceTest : public testing::Test {
 protected:
  ProvenanceTest() {
    constexpr Dimension kKilograms = {1, 0, 0};
    constexpr Dimension kMetres = {0, 1, 0};
    constexpr Dimension kInertias = {1, 2, 0};
    begin_provenance({{mass_, {{mass_of(0)}, kKilograms}},
                      {length_, {{com_of(0)}, kMetres}},
                      {-length_, {{com_of(1)}, kMetres}},
                      {other_, {{com_of(2)}, kMetres}},
                      {inertia_, {{{0, ModelPart::kInertia, 0}}, kInertias}},
                      {inertia_, {{{0, ModelPart::kInertia, 3}}, kInertias}}},
                     {0, 0, 2});
  }
  static std::vector<Origin> origins(const Real& number) {
    const std::optional<Provenance> known = provenance_of(number);
    return known ? known->origins : std::vector<Origin>();
  }

  const Real mass_ = Real::seen_as(2, Digits("1.234567"));
  const Real length_ = Real::seen_as(3, Digits("2.345678"));
  const Real other_ = Real::seen_as(5, Digits("0.456789"));
  const Real inertia_ = Real::seen_as(7, Digits("0.678912"));
};

TEST_F(ProvenanceTest, HasAllThatANumberIsMadeOf) {
  const Real moment = mass_ * other_;
  EXPECT_EQ(origins(moment), (std::vector<Origin>{mass_of(0), com_of(2)}));
  EXPECT_EQ(provenance_of(moment)->dimension, (Dimension{1, 1, 0}));
  EXPECT_EQ(origins(-moment), origins(moment));
  EXPECT_EQ(origins(sqrt(other_)), std::vector<Origin>{com_of(2)});
  EXPECT_EQ(origins(cos(other_)), std::vector<Origin>{com_of(2)});
}

TEST_F(ProvenanceTest, IsNotKnownOfNumbersOfTheEquations) {
  EXPECT_FALSE(provenance_of(Real(2)));
  EXPECT_FALSE(provenance_of(other_ / other_));
}

TEST_F(ProvenanceTest, LeavesOutWhatHasCancelledSeveralOperationsLater) {
  const Real one = mass_ * other_ + length_;
  const Real two = one * one - mass_ * mass_ * other_ * other_;
  const Real rest = two - 2 * (mass_ * (length_ * other_));  // length^2
  EXPECT_EQ(origins(rest), (std::vector<Origin>{com_of(0), com_of(1)}));
  EXPECT_EQ(origins(sqrt(rest)), origins(rest));
}

TEST_F(ProvenanceTest, HasAnglesThatAnAdditionTheoremLeaves) {
  const Real angle = mass_ * other_;
  const Real sum = sin(angle) * cos(length_) + cos(angle) * sin(length_);
  EXPECT_EQ(origins(sum), (std::vector<Origin>{mass_of(0), com_of(0), com_of(1), com_of(2)}));
  const Real square = sin(angle) * sin(angle) + cos(angle) * cos(angle);
  EXPECT_EQ(origins(square * length_), (std::vector<Origin>{com_of(0), com_of(1)}));
}

TEST_F(ProvenanceTest, KeepsEqualNumbersOfOneLinkOfWhichOnlyTheDifferenceHasVanished) {
  const Real rest = mass_ + (other_ + inertia_) - inertia_;
  EXPECT_EQ(origins(rest).size(), 4U);
  const Real without = mass_ + (other_ + length_) - length_;
  EXPECT_EQ(origins(without), (std::vector<Origin>{mass_of(0), com_of(2)}));
}

}  // namespace
}  // namespace treedyn
