// Structure of the resolved model: order, merging, bases, frames.
#include "description/resolve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<std::string> joint_names(const model::Tree& tree) {
  std::vector<std::string> names;
  for (const model::Link& link : tree.links) {
    names.push_back(link.joint.name);
  }
  return names;
}

std::vector<int> fathers(const model::Tree& tree) {
  std::vector<int> result;
  for (const model::Link& link : tree.links) {
    result.push_back(link.father);
  }
  return result;
}

/// A link of a tree description with mass 1.
std::string link(const std::string& name, const std::string& father, const std::string& joint) {
  return fmt::format("- {{name: {0}, father: {1}, mass: 1, joint: {{name: j_{0}, {2}}}}}\n", name,
                     father, joint);
}
const char* const kTurn = "type: revolute, axis: [0, 0, 1], offset: [1, 0, 0]";
const char* const kFix = "type: fixed, offset: [0, 2, 0], rotation: {rpy: [0, 0, pi/2]}";

TEST(Resolve, PutsFathersBeforeSonsAndKeepsTheOrderOtherwise) {
  const model::Tree tree =
      yaml("name: m\nlinks:\n" + link("c", "b", kTurn) + link("d", "ground", kTurn) +
           link("b", "a", kTurn) + link("a", "ground", kTurn));
  EXPECT_THAT(joint_names(tree), ElementsAre("j_d", "j_a", "j_b", "j_c"));
  EXPECT_THAT(fathers(tree), ElementsAre(-1, -1, 1, 2));
}

TEST(Resolve, TakesTheOrderOfAUrdfFromItsJoints) {
  const model::Tree tree =
      urdf(R"(<robot name="m"><link name="x"/><link name="y"/><link name="base"/><link name="z"/>
    <joint name="to_z" type="continuous"><parent link="base"/><child link="z"/></joint>
    <joint name="to_x" type="prismatic"><parent link="base"/><child link="x"/></joint>
    <joint name="to_y" type="revolute"><parent link="base"/><child link="y"/></joint></robot>)");
  EXPECT_THAT(joint_names(tree), ElementsAre("to_z", "to_x", "to_y"));
  EXPECT_EQ(tree.links[1].joint.type, model::JointType::kPrismatic);
  EXPECT_EQ(tree.links[0].joint.type, model::JointType::kRevolute);
  EXPECT_EQ(tree.links[0].joint.axis, (Vector3{1, 0, 0})) << "the default of URDF";
}

TEST(Resolve, MergesFixedJointsAndKeepsTheirFrames) {
  const model::Tree tree =
      yaml("name: m\nlinks:\n" + link("a", "ground", kTurn) + link("tool", "a", kFix) +
           link("tip", "tool", kFix) + link("b", "tool", kTurn));
  EXPECT_THAT(joint_names(tree), ElementsAre("j_a", "j_b"));
  EXPECT_EQ(tree.links[0].inertia.mass, Real(3));
  ASSERT_THAT(tree.frames, SizeIs(4));
  EXPECT_EQ(tree.frames[2].name, "tip");
  EXPECT_EQ(tree.frames[2].link, 0);
  EXPECT_EQ(tree.frames[2].origin, (Vector3{-2, 2, 0}));  // (0,2,0) + Rz(90)(0,2,0)
  EXPECT_EQ(tree.frames[2].rotation, (Matrix3{-1, 0, 0, 0, -1, 0, 0, 0, 1}));
  EXPECT_EQ(tree.links[1].father, 0);
  EXPECT_EQ(tree.links[1].joint.offset, (Vector3{0, 3, 0}));  // (0,2,0) + Rz(90)(1,0,0)
  EXPECT_EQ(tree.links[1].joint.rotation, (Matrix3{0, -1, 0, 1, 0, 0, 0, 0, 1}));
}

TEST(Resolve, DropsTheInertiaOfWhatIsFixedToTheGround) {
  const model::Tree tree =
      yaml("name: m\nlinks:\n" + link("table", "ground", kFix) + link("a", "table", kTurn));
  ASSERT_EQ(tree.size(), 1);
  EXPECT_EQ(tree.links[0].inertia.mass, Real(1));
  EXPECT_EQ(tree.links[0].father, model::kGround);
  EXPECT_EQ(tree.frames[0].link, model::kGround);
  EXPECT_EQ(tree.links[0].joint.offset, (Vector3{0, 3, 0}));
}

TEST(Resolve, PutsSixBaseJointsBeforeTheRoot) {
  const model::Tree tree = urdf(
      "<robot name=\"m\"><link name=\"trunk\"><inertial><mass value=\"7\"/><inertia ixx=\"1\" "
      "ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link><link name=\"leg\"/><joint name=\"hip\" "
      "type=\"revolute\">"
      "<parent link=\"trunk\"/><child link=\"leg\"/></joint></robot>",
      options("1e-9", Base::kAxes));
  EXPECT_THAT(joint_names(tree),
              ElementsAre("base_px", "base_py", "base_pz", "base_rz", "base_ry", "base_rx", "hip"));
  EXPECT_THAT(fathers(tree), ElementsAre(-1, 0, 1, 2, 3, 4, 5));
  EXPECT_EQ(tree.links[4].inertia.mass, Real(0));
  EXPECT_EQ(tree.links[5].inertia.mass, Real(7));
  EXPECT_EQ(tree.links[2].joint.type, model::JointType::kPrismatic);
  EXPECT_EQ(tree.links[3].joint.axis, (Vector3{0, 0, 1}));
  EXPECT_EQ(tree.links[5].joint.axis, (Vector3{1, 0, 0}));
  EXPECT_EQ(tree.frames[6].name, "trunk");
  EXPECT_EQ(tree.frames[6].link, 5);
}

TEST(Resolve, HangsEveryRootOnTheBaseJoints) {
  const model::Tree tree = yaml("name: m\nlinks:\n" + link("pelvis", "ground", kFix) +
                                    link("a", "pelvis", kTurn) + link("b", "ground", kTurn),
                                options("1e-9", Base::kAxes));
  EXPECT_THAT(fathers(tree), ElementsAre(-1, 0, 1, 2, 3, 4, 5, 5));
  EXPECT_EQ(tree.links[5].inertia.mass, Real(1));
  EXPECT_EQ(tree.links[5].inertia.com, (Vector3{0, 2, 0}));
}

TEST(Resolve, KeepsMasslessLinksInsideAChain) {
  const model::Tree tree = yaml(
      "name: m\nlinks:\n- {name: a, father: ground, joint: {type: revolute, axis: [1, 0, 0]}}\n" +
      link("b", "a", kTurn));
  EXPECT_EQ(tree.links[0].inertia.mass, Real(0));
  EXPECT_EQ(tree.links[0].joint.name, "a") << "a joint without a name is called like its link";
}

TEST(Resolve, KeepsLimits) {
  const model::Tree tree = yaml(
      one_link("type: revolute, axis: [0, 0, 1], limits: {lower: -pi/2, upper: .inf, effort: 5}"));
  const model::Limits& limits = tree.links[0].joint.limits;
  EXPECT_EQ(*limits.lower, -pi() / 2);
  EXPECT_FALSE(limits.upper.has_value());
  EXPECT_FALSE(limits.velocity.has_value());
  EXPECT_EQ(*limits.effort, Real(5));
}

TEST(Resolve, MakesIdentifiers) {
  const model::Tree tree = yaml(
      "name: 2R arm\nlinks:\n- {name: a, father: ground, joint: {name: \"joint 0.0\", type: "
      "revolute, axis: [1, 0, 0]}}\n");
  EXPECT_EQ(tree.identifier, "n2R_arm");
  EXPECT_EQ(tree.links[0].joint.name, "joint 0.0");
  EXPECT_EQ(tree.links[0].joint.identifier, "joint_0_0");
}

TEST(Resolve, DoesNotDependOnTheOrderOfLinksInAUrdf) {
  const std::string base = R"(<link name="base"/>)";
  const std::string a = R"(<link name="a"/>)";
  const std::string joint =
      R"(<joint name="j" type="revolute"><parent link="base"/><child link="a"/></joint>)";
  for (const std::string& body : {base + a + joint, joint + a + base, a + joint + base}) {
    const model::Tree tree = urdf("<robot name=\"m\">" + body + "</robot>");
    EXPECT_EQ(tree.links[0].name, "a");
  }
}

TEST(Resolve, MergesALongChainOfFixedJointsWithoutRecursion) {
  std::string text = "<robot name=\"m\"><link name=\"l0\"/>";
  constexpr int kCount = 20000;
  for (int k = 1; k <= kCount; ++k) {
    text += fmt::format(
        "<link name=\"l{0}\"/><joint name=\"j{0}\" type=\"{2}\"><parent link=\"l{1}\"/>"
        "<child link=\"l{0}\"/><origin xyz=\"1 0 0\"/></joint>",
        k, k - 1, k == kCount ? "revolute" : "fixed");
  }
  const model::Tree tree = urdf(text + "</robot>");
  ASSERT_EQ(tree.size(), 1);
  EXPECT_EQ(tree.links[0].joint.offset[0], Real(kCount));
}

}  // namespace
}  // namespace treedyn::description
