#include "description/mimic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"

namespace treedyn::description {
namespace {

using testing::ElementsAre;

/// Joints j0, j1, .. from one base; `mimics` are the elements inside of each.
std::string hand(const std::vector<std::string>& mimics) {
  std::string text = "<robot name=\"hand\"><link name=\"palm\"/>\n";
  for (std::size_t k = 0; k < mimics.size(); ++k) {
    text += fmt::format(
        "<link name=\"l{0}\"/><joint name=\"j{0}\" type=\"revolute\"><parent link=\"palm\"/>"
        "<child link=\"l{0}\"/>{1}</joint>\n",
        k, mimics[k]);
  }
  return text + "</robot>";
}

void expect_drive(const model::Drive& drive, int coordinate, double multiplier, double offset) {
  EXPECT_EQ(drive.coordinate, coordinate);
  EXPECT_EQ(drive.multiplier, Real(multiplier));
  EXPECT_EQ(drive.offset, Real(offset));
}

TEST(Mimic, MakesTheLeaderTheCoordinate) {
  const model::Tree tree =
      urdf(hand({R"(<mimic joint="j2" multiplier="-0.5" offset="0.25"/>)", "", ""}));
  EXPECT_EQ(tree.dof(), 2);
  EXPECT_THAT(tree.coordinates, ElementsAre(1, 2));
  expect_drive(tree.drives[0], 1, -0.5, 0.25);
  expect_drive(tree.drives[1], 0, 1, 0);
  expect_drive(tree.drives[2], 1, 1, 0);
}

TEST(Mimic, FollowsChainsToTheIndependentJoint) {
  // q0 = 2 q1 + 1, q1 = 3 q2 - 4: q0 = 6 q2 - 7
  const model::Tree tree = urdf(hand({R"(<mimic joint="j1" multiplier="2" offset="1"/>)",
                                      R"(<mimic joint="j2" multiplier="3" offset="-4"/>)", ""}));
  EXPECT_EQ(tree.dof(), 1);
  expect_drive(tree.drives[0], 0, 6, -7);
  expect_drive(tree.drives[1], 0, 3, -4);
}

TEST(Mimic, HasMultiplierOneAndOffsetZeroByDefault) {
  expect_drive(urdf(hand({"", R"(<mimic joint="j0"/>)"})).drives[1], 0, 1, 0);
}

TEST(Mimic, StaysIndependentOnRequest) {
  const model::Tree tree = urdf(hand({R"(<mimic joint="j1" multiplier="2"/>)", ""}),
                                options("1e-9", Base::kFixed, Mimic::kIndependent));
  EXPECT_THAT(tree.coordinates, ElementsAre(0, 1));
  expect_drive(tree.drives[0], 0, 1, 0);
}

TEST(Mimic, CountsBehindTheBaseJoints) {
  const model::Tree tree =
      urdf(hand({R"(<mimic joint="j1" multiplier="2"/>)", ""}), options("1e-9", Base::kAxes));
  EXPECT_THAT(tree.coordinates, ElementsAre(0, 1, 2, 3, 4, 5, 7));
  expect_drive(tree.drives[6], 6, 2, 0);
}

}  // namespace
}  // namespace treedyn::description
