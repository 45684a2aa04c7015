#include "description/bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"

namespace treedyn::description {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

model::Tree with_inertia(const std::string& inertia) {
  return yaml(one_link("type: revolute, axis: [0, 0, 1]", "mass: 1\n  inertia: [" + inertia + "]"));
}
std::string error_of_inertia(const std::string& inertia) {
  return yaml_error(
      one_link("type: revolute, axis: [0, 0, 1]", "mass: 1\n  inertia: [" + inertia + "]"));
}

TEST(ResolveInertia, TakesSixEntriesAsASymmetricTensor) {
  EXPECT_EQ(with_inertia("4, 0.1, 0.2, 5, 0.3, 6").links[0].inertia.about_com,
            (Matrix3{4, Real(1) / 10, Real(2) / 10, Real(1) / 10, 5, Real(3) / 10, Real(2) / 10,
                     Real(3) / 10, 6}));
}

TEST(ResolveInertia, RefusesAnIndefiniteTensor) {
  EXPECT_THAT(error_of_inertia("1, 2, 0, 1, 0, 1"),
              HasSubstr("link 'a': inertia is indefinite, its principal moments are -1, 1, 3; "
                        "expected none below 0"));
  EXPECT_NE(error_of_inertia("0, 0.1, 0, 0, 0, 0"), "");
  EXPECT_NE(error_of_inertia("0.01, 0, 0, -0.002, 0, 0.01"), "");
  EXPECT_NE(error_of_inertia("1e-3, 0, 0, 1e-3, 0, -1e-5"), "");
}

/// An antenna on a base that stands: its joint needs no axis, and its inertia is in no equation.
TEST(ResolveInertia, WarnsOfAnIndefiniteTensorThatDoesNotMove) {
  const model::Tree tree = urdf(R"(<robot name="m">
<link name="base"/>
<link name="antenna"><inertial><mass value="0.1"/>
<inertia ixx="-3e-6" ixy="0" ixz="0" iyy="3e-6" iyz="0" izz="9e-6"/></inertial></link>
<link name="arm"><inertial><mass value="2"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="f" type="fixed"><parent link="base"/><child link="antenna"/><axis/></joint>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/></joint>
</robot>)");
  ASSERT_THAT(tree.warnings, SizeIs(1));
  EXPECT_THAT(tree.warnings[0].message,
              HasSubstr("link 'antenna': inertia is indefinite, its principal moments are -3e-06, "
                        "3e-06, 9e-06; the link does not move, so it is in no equation"));
}

TEST(ResolveInertia, AcceptsWhatTheRoundingOfItsDecimalsExplains) {
  EXPECT_EQ(error_of_inertia("0, 0, 0, 0, 0, 0"), "");
  EXPECT_EQ(error_of_inertia("0, 0, 0, 0, 0, -5e-20"), "");
  EXPECT_EQ(error_of_inertia("0, 5e-20, 0, 0, 0, 0"), "");
  EXPECT_EQ(error_of_inertia("0.01, 0.00707, 0, 0.00499, 0, 0.015"), "")
      << "determinant of the 2x2 block -8e-8";
}

TEST(ResolveInertia, WarnsOfAViolatedTriangleInequality) {
  const model::Tree tree = with_inertia("1, 0, 0, 2, 0, 4");
  ASSERT_THAT(tree.warnings, SizeIs(1));
  EXPECT_THAT(
      tree.warnings[0].message,
      HasSubstr(
          "link 'a': inertia violates the triangle inequality: of its principal moments 1, 2, 4"));
  EXPECT_THAT(with_inertia("1, 0, 0, 2, 0, 3").warnings, IsEmpty());
}

TEST(ResolveInertia, TurnsTheTensorOfAUrdfByItsOrigin) {
  const model::Tree tree = urdf(one_joint(
      "",
      "<inertial><origin xyz=\"1 2 3\" rpy=\"0 0 1.57079632679\"/><mass value=\"2\"/>"
      "<inertia ixx=\"1\" ixy=\"0.1\" ixz=\"0.2\" iyy=\"2\" iyz=\"0.3\" izz=\"2.5\"/></inertial>"));
  // R = Rz(90): x -> y, y -> -x
  const model::Inertia& inertia = tree.links[0].inertia;
  EXPECT_EQ(inertia.com, (Vector3{1, 2, 3}));
  EXPECT_EQ(inertia.about_com, (Matrix3{2, -Real(1) / 10, -Real(3) / 10, -Real(1) / 10, 1,
                                        Real(2) / 10, -Real(3) / 10, Real(2) / 10, 2.5}));
}

TEST(ResolveInertia, OfAMasslessLinkKeepsItsCentreOfMass) {
  const model::Tree tree =
      yaml(one_link("type: revolute, axis: [0, 0, 1]",
                    "mass: 0\n  com: [1, 2, 3]\n  inertia: [0, 0, 0, 0, 0, 1]"));
  EXPECT_EQ(tree.links[0].inertia.com, (Vector3{1, 2, 3}));  // its mass may be one of run time
  EXPECT_EQ(tree.links[0].inertia.about_com[8], Real(1));
}

TEST(Combined, PutsTwoBodiesTogetherAboutTheirCommonCentre) {
  // 1 kg at x = 0 and 3 kg at x = 4: centre at 3, moments 1*9 + 3*1 = 12
  const model::Inertia a{1, {0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
  const model::Inertia b{3, {4, 0, 0}, {}};
  const model::Inertia whole = combined({a, b});
  EXPECT_EQ(whole.mass, Real(4));
  EXPECT_EQ(whole.com, (Vector3{3, 0, 0}));
  EXPECT_EQ(whole.about_com, (Matrix3{1, 0, 0, 0, 13, 0, 0, 0, 13}));
}

TEST(Combined, LeavesNoRoundingWhereMomentsCancel) {
  const Real third = Real(1) / 3;
  const model::Inertia whole =
      combined({{third, {third, 0, 1}, {}}, {third, {-third, 0, 1}, {}}, {third, {0, 0, 1}, {}}});
  EXPECT_EQ(whole.com[0], Real(0));
  EXPECT_EQ(whole.about_com[1], Real(0));
  EXPECT_EQ(whole.about_com[2], Real(0));
}

TEST(Combined, OfNothingIsMassless) { EXPECT_EQ(combined({}).mass, Real(0)); }

TEST(Moved, TurnsAndShifts) {
  const Matrix3 z90 = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  const model::Inertia moved_body =
      moved({2, {1, 0, 0}, {1, 0, 0, 0, 2, 0, 0, 0, 3}}, z90, {10, 20, 30});
  EXPECT_EQ(moved_body.com, (Vector3{10, 21, 30}));
  EXPECT_EQ(moved_body.about_com, (Matrix3{2, 0, 0, 0, 1, 0, 0, 0, 3}));
}

}  // namespace
}  // namespace treedyn::description
