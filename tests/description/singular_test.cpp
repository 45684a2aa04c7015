// Joints without inertia, and what vet says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"

namespace treedyn::description {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The names in quotes before the colon of a message: "a b".
std::string joints_of(const std::string& message) {
  const std::string list = message.substr(0, message.find(':'));
  std::string names;
  for (std::size_t at = list.find('\''); at != std::string::npos; at = list.find('\'', at)) {
    const std::size_t end = list.find('\'', at + 1);
    names += (names.empty() ? "" : " ") + list.substr(at + 1, end - at - 1);
    at = end + 1;
  }
  return names;
}

/// The joints of every movement without inertia in a chain; every entry is "joint fields | link
/// fields".
std::vector<std::string> singular_joints(const std::vector<std::string>& links) {
  std::string text = "name: m\nlinks:\n";
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::size_t bar = links[k].find('|');
    text += fmt::format("- {{name: l{}, father: {}, joint: {{name: j{}, {}}}{}}}\n", k,
                        k == 0 ? "ground" : fmt::format("l{}", k - 1), k, links[k].substr(0, bar),
                        links[k].substr(bar + 1));
  }
  std::vector<std::string> names;
  for (const Warning& warning : joints_without_inertia(yaml(text))) {
    names.push_back(joints_of(warning.message));
  }
  return names;
}

const char* const kTurnZ = "type: revolute, axis: [0, 0, 1], offset: [1, 0.5, 0.25]";
const char* const kTurnX = "type: revolute, axis: [1, 0, 0], offset: [1, 0.5, 0.25]";
const char* const kSlideZ = "type: prismatic, axis: [0, 0, 1]";

std::string joint(const char* what, const char* body) { return fmt::format("{}|{}", what, body); }

TEST(JointsWithoutInertia, AreNoneInAnOrdinaryArm) {
  EXPECT_THAT(singular_joints({joint(kTurnZ, ", mass: 1, com: [1, 0, 0]"),
                               joint(kTurnX, ", mass: 1, com: [0, 1, 0]")}),
              IsEmpty());
}

TEST(JointsWithoutInertia, IncludeAMasslessLeaf) {
  EXPECT_THAT(singular_joints({joint(kTurnZ, ", mass: 1, com: [1, 0, 0]"), joint(kTurnX, "")}),
              ElementsAre("j1"));
}

TEST(JointsWithoutInertia, IncludeAPointMassOnTheAxis) {
  EXPECT_THAT(singular_joints({joint(kTurnZ, ", mass: 1, com: [0, 0, 2]")}), ElementsAre("j0"));
  EXPECT_THAT(singular_joints(
                  {joint("type: revolute, axis: [1, 2, 3]", ", mass: 1, com: [0.1, 0.2, 0.3]")}),
              ElementsAre("j0"));
}

TEST(JointsWithoutInertia, NameBothOfTwoParallelJointsWithNothingBetweenThem) {
  EXPECT_THAT(
      singular_joints({joint("type: revolute, axis: [0, 0, 1]", ""),
                       joint("type: revolute, axis: [0, 0, 1]", ", mass: 1, com: [1, 0, 0]")}),
      ElementsAre("j0 j1"));
}

/// Two particles turn about the line through them, whatever carries the first: the joint between
/// them takes no part.
TEST(JointsWithoutInertia, AreThoseOfTheMovementAndNoOthers) {
  const std::string rod =
      "name: rod\nlinks:\n"
      "- {name: body, father: ground, joint: {type: fixed}, mass: 2, com: [0, 0, 0.3]}\n"
      "- {name: tip, father: body, joint: {name: spin, type: revolute, axis: [0, 1, 0]}, mass: 2, "
      "com: [0.2, 0, 0]}\n";
  const auto found = joints_without_inertia(yaml(rod, options("0", Base::kAxes)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].message,
            "joints 'base_px', 'base_py', 'base_pz', 'base_rz', 'base_ry', 'base_rx': they can "
            "move together without moving any inertia; forward dynamics has no solution");
  EXPECT_THAT(joints_without_inertia(yaml(rod)), IsEmpty());
}

TEST(JointsWithoutInertia, AreNoneWhereArmaturesAct) {
  const model::Tree tree = yaml(one_link("type: revolute, axis: [0, 0, 1]", "mass: 0"));
  EXPECT_THAT(joints_without_inertia(tree, {Real("1e-9")}), IsEmpty());
  EXPECT_EQ(joints_without_inertia(tree, {0}).size(), 1U);
}

TEST(JointsWithoutInertia, SpareMasslessLinksThatCarryABody) {
  EXPECT_THAT(
      singular_joints({joint(kSlideZ, ""), joint(kTurnX, ""),
                       joint(kTurnZ, ", mass: 1, com: [1, 2, 3], inertia: [1, 0, 0, 2, 0, 2.5]")}),
      IsEmpty());
}

TEST(JointsWithoutInertia, SpareAPrismaticJointWithAnyMass) {
  EXPECT_THAT(singular_joints({joint(kSlideZ, ", mass: 1e-9")}), IsEmpty());
  EXPECT_THAT(singular_joints({joint(kSlideZ, ", mass: 0, inertia: [1, 0, 0, 1, 0, 1]")}),
              ElementsAre("j0"));
}

TEST(JointsWithoutInertia, SpareMasslessFollowersOfAMimicWhoseLeaderMovesAMass) {
  const auto hand = [](const char* mass) {
    return fmt::format(
        "<robot name=\"hand\"><link name=\"palm\"/><link name=\"finger\"><inertial><origin xyz=\"1 "
        "0 0\"/><mass value=\"{}\"/>"
        "<inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" "
        "izz=\"0\"/></inertial></link><link name=\"tip\"/>"
        "<joint name=\"j\" type=\"revolute\"><parent link=\"palm\"/><child link=\"finger\"/><axis "
        "xyz=\"0 0 1\"/></joint>"
        "<joint name=\"k\" type=\"revolute\"><parent link=\"palm\"/><child link=\"tip\"/><axis "
        "xyz=\"0 0 1\"/>"
        "<mimic joint=\"j\" multiplier=\"-2\"/></joint></robot>",
        mass);
  };
  EXPECT_THAT(joints_without_inertia(urdf(hand("1"))), IsEmpty());
  EXPECT_EQ(joints_without_inertia(urdf(hand("0"))).size(), 1U) << "of one coordinate";
  EXPECT_EQ(joints_without_inertia(urdf(hand("1"), options("0", Base::kFixed, Mimic::kIndependent)))
                .size(),
            1U);
}

TEST(JointsWithoutInertia, SayAboutOrAlong) {
  const auto turn =
      joints_without_inertia(yaml(one_link("type: revolute, axis: [0, 0, 1]", "mass: 0")));
  ASSERT_EQ(turn.size(), 1U);
  EXPECT_EQ(
      turn[0].message,
      "joint 'j': what it moves has no inertia about its axis; forward dynamics has no solution");
  EXPECT_EQ(turn[0].where.line, 5);
  const auto slide =
      joints_without_inertia(yaml(one_link("type: prismatic, axis: [0, 0, 1]", "mass: 0")));
  EXPECT_EQ(
      slide.at(0).message,
      "joint 'j': what it moves has no inertia along its axis; forward dynamics has no solution");
}

}  // namespace
}  // namespace treedyn::description
