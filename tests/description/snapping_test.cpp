// Snapping, INTERFACE.md 2, and exact rotations, through the readers.
#include "description/snapping.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"

namespace treedyn::description {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

model::Tree with_rpy(const std::string& rpy, const char* snap = "1e-9") {
  return urdf(one_joint(fmt::format("<origin rpy=\"{}\"/>", rpy)), options(snap));
}

const Matrix3& rotation(const model::Tree& tree) { return tree.links.front().joint.rotation; }

model::Tree with_matrix(const std::string& matrix, const char* snap = "1e-9") {
  return yaml(
      one_link(fmt::format("type: revolute, axis: [0, 0, 1], rotation: {{matrix: [{}]}}", matrix)),
      options(snap));
}

model::Tree with_axis(const std::string& axis, const char* snap = "1e-9") {
  return yaml(one_link(fmt::format("type: revolute, axis: [{}]", axis)), options(snap));
}

const Vector3& axis(const model::Tree& tree) { return tree.links.front().joint.axis; }

void expect_orthonormal(const Matrix3& r) {
  EXPECT_LE(distance(r * transposed(r), identity()), Real("1e-48"));
  EXPECT_LE(abs(determinant(r) - 1), Real("1e-48"));
}

TEST(Snapping, MakesTheAnglesOfUr5Exact) {
  const model::Tree tree = with_rpy("0 1.57079632679 0");
  EXPECT_EQ(rotation(tree), (Matrix3{0, 0, 1, 0, 1, 0, -1, 0, 0}));
  ASSERT_THAT(tree.snaps, SizeIs(1));
  EXPECT_EQ(tree.snaps[0].what, "joint 'j': rpy[1]");
  EXPECT_EQ(tree.snaps[0].from, "1.57079632679");
  EXPECT_EQ(tree.snaps[0].to, "pi/2");
  EXPECT_NEAR(tree.snaps[0].change.convert_to<double>(), 4.8966e-12, 1e-15);
  EXPECT_EQ(tree.snaps[0].where.line, 4);
}

TEST(Snapping, KnowsEveryMultipleOfATwelfthOfPi) {
  const Real twelfth = pi() / 12;
  for (int k = -30; k <= 30; ++k) {
    const Real angle = k * twelfth + Real("3e-10");
    const model::Tree tree = with_rpy("0 0 " + angle.str(20, std::ios::fixed));
    const Matrix3& r = rotation(tree);
    ASSERT_THAT(tree.snaps, SizeIs(1)) << k;
    EXPECT_LE(abs(r[0] - cos(k * twelfth)), Real("1e-47")) << k;
    EXPECT_LE(abs(r[3] - sin(k * twelfth)), Real("1e-47")) << k;
    EXPECT_EQ(r[0] == 0, k % 12 == 6 || k % 12 == -6) << k;
    EXPECT_EQ(r[3] == 0, k % 12 == 0) << k;
  }
}

TEST(Snapping, NamesTheExactAngleShortly) {
  EXPECT_EQ(with_rpy("-3.14159265359 0 0").snaps.at(0).to, "-pi");
  EXPECT_EQ(with_rpy("2.61799387799 0 0").snaps.at(0).to, "5*pi/6");
  EXPECT_EQ(with_rpy("-0.785398163397 0 0").snaps.at(0).to, "-pi/4");
  EXPECT_EQ(with_rpy("1e-12 0 0").snaps.at(0).to, "0");
}

TEST(Snapping, LeavesWhatIsFartherThanItsTolerance) {
  const model::Tree tree = with_rpy("3.1415926518 0 0");
  EXPECT_THAT(tree.snaps, SizeIs(0));
  EXPECT_NEAR(rotation(tree)[7].convert_to<double>(), 1.79e-9, 1e-12);
  EXPECT_THAT(with_rpy("3.1415926518 0 0", "2e-9").snaps, SizeIs(1));
}

TEST(Snapping, SwitchedOffKeepsNumbersAsWritten) {
  const model::Tree tree = with_rpy("0 1.57079632679 0", "0");
  EXPECT_THAT(tree.snaps, SizeIs(0));
  EXPECT_LE(abs(rotation(tree)[0] - cos(Real("1.57079632679"))), Real("1e-48"));
  expect_orthonormal(rotation(tree));
}

TEST(Snapping, NeedsNoToleranceForExactExpressions) {
  const model::Tree tree = yaml(
      one_link("type: revolute, axis: [0, 0, 1], rotation: {rpy: [pi/2, 0, -pi/3]}"), options("0"));
  const Matrix3& r = rotation(tree);
  EXPECT_THAT(tree.snaps, SizeIs(0));
  EXPECT_EQ(r[0], Real(0.5));
  EXPECT_EQ(r[1], Real(0));
  EXPECT_EQ(r[4], Real(0));
  expect_orthonormal(r);
}

/// As CAD programs export them: a mounting that turns the frame, and a joint that turns it back.
TEST(Snapping, MakesRotationsExactThatFixedJointsCompose) {
  const std::string text =
      "name: m\nlinks:\n"
      "- {name: mount, father: ground, joint: {type: fixed, rotation: {rpy: [0, 0, 0.3]}}}\n"
      "- {name: a, father: mount, joint: {name: j, type: revolute, axis: [1, 0, 0], rotation: "
      "{rpy: [0, 0, 1.2707963267948966]}}, mass: 1}\n";
  const model::Tree tree = yaml(text);
  EXPECT_EQ(rotation(tree), (Matrix3{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  ASSERT_THAT(tree.snaps, SizeIs(4));  // entries 0, 1, 3, 4
  EXPECT_EQ(tree.snaps[0].what, "joint 'j': composed rotation[0]");
  EXPECT_EQ(tree.snaps[0].to, "0");
  EXPECT_EQ(tree.snaps[0].where.line, 4);
  EXPECT_NE(rotation(yaml(text, options("0")))[0], Real(0));
}

TEST(Rotation, AppliesRollThenPitchThenYaw) {
  // R = Rz(y) Ry(p) Rx(r), r = pi/2, y = pi/2: x -> y, y -> z, z -> x
  EXPECT_EQ(rotation(with_rpy("1.5707963267949 0 1.5707963267949")),
            (Matrix3{0, 0, 1, 1, 0, 0, 0, 1, 0}));
}

TEST(Matrix, SnapsEntriesNearExactValues) {
  const model::Tree tree = with_matrix("4.9e-12, -1, 0, 1, 4.9e-12, 0, 0, 0, 1");
  EXPECT_EQ(rotation(tree), (Matrix3{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  ASSERT_THAT(tree.snaps, SizeIs(2));
  EXPECT_EQ(tree.snaps[0].what, "joint 'j': matrix[0]");
  EXPECT_EQ(tree.snaps[0].to, "0");
}

TEST(Matrix, SnapsRootsToFullPrecision) {
  const model::Tree tree = with_matrix("0.8660254038, -0.5, 0, 0.5, 0.8660254038, 0, 0, 0, 1");
  EXPECT_LE(abs(rotation(tree)[0] - sqrt(Real(3)) / 2), Real("1e-48"));
  EXPECT_EQ(rotation(tree)[1], Real(-0.5));
  EXPECT_EQ(tree.snaps.at(0).to, "sqrt(3)/2");
  expect_orthonormal(rotation(tree));
}

TEST(Matrix, OfAGeneralAngleKeepsItsZerosAndIsOrthonormal) {
  // rotation by 1 rad about z, 17 digits
  const model::Tree tree = with_matrix(
      "0.54030230586813977, -0.84147098480789650, 1e-17, 0.84147098480789650, 0.54030230586813977, "
      "0, 0, 0, 1");
  const Matrix3& r = rotation(tree);
  EXPECT_EQ(r[2], Real(0));
  EXPECT_EQ(r[6], Real(0));
  EXPECT_EQ(r[8], Real(1));
  EXPECT_LE(abs(r[0] - cos(Real(1))), Real("1e-16"));
  expect_orthonormal(r);
}

TEST(Matrix, OfAGeneralRotationPassingByOneHalfIsNotPulledThere) {
  // about z by acos(1/2 + 3e-10); its sine is 1.7e-10 away from sqrt(3)/2
  const Real c = Real("0.5000000003");
  const Real s = sqrt(1 - c * c);
  const std::string entries =
      fmt::format("{0}, -{1}, 0, {1}, {0}, 0, 0, 0, 1", c.str(20), s.str(20));
  const model::Tree tree = with_matrix(entries, "4e-10");
  expect_orthonormal(rotation(tree));
  EXPECT_LE(abs(rotation(tree)[0] - Real(0.5)), Real("1e-47")) << "both are within 4e-10";
  const model::Tree kept = with_matrix(entries, "2e-10");  // holds for the sine alone
  EXPECT_LE(abs(rotation(kept)[0] - c), Real("1e-18"));
  EXPECT_THAT(kept.snaps, SizeIs(0));
}

TEST(Matrix, OfATinyAngleKeepsItsSine) {
  // cos(2e-5) is within 1e-9 of 1, sin(2e-5) is far from 0
  const Real angle = Real("2e-5");
  const Real c = cos(angle);
  const Real s = sin(angle);
  const model::Tree tree =
      with_matrix(fmt::format("{0}, -{1}, 0, {1}, {0}, 0, 0, 0, 1", c.str(25), s.str(25)));
  EXPECT_LE(abs(rotation(tree)[3] - s), Real("1e-20"));
  EXPECT_LE(abs(rotation(tree)[0] - c), Real("1e-20"));
}

TEST(Matrix, WithinABillionthOfARotationIsAccepted) {
  const model::Tree tree = with_matrix("1, 5e-10, 0, 0, 1, 0, 0, 0, 1", "0");
  expect_orthonormal(rotation(tree));
  EXPECT_THROW(with_matrix("1, 5e-9, 0, 0, 1, 0, 0, 0, 1", "0"), InputError);
  EXPECT_THROW(with_matrix("1, 0, 0, 0, 1, 0, 0, 0, -1"), InputError) << "a reflection";
  EXPECT_THROW(with_matrix("2, 0, 0, 0, 2, 0, 0, 0, 2"), InputError);
  EXPECT_THROW(with_matrix("0, 0, 0, 0, 0, 0, 0, 0, 0"), InputError);
}

TEST(Axis, IsNormalisedExactly) {
  EXPECT_EQ(axis(with_axis("0, 0, -7")), (Vector3{0, 0, -1}));
  EXPECT_EQ(axis(with_axis("0.7071, 0.7071, 0"))[0], sqrt(Real(2)) / 2);
  EXPECT_EQ(axis(with_axis("3, 0, 4")), (Vector3{Real(3) / 5, 0, Real(4) / 5}));
  EXPECT_EQ(axis(with_axis("1e-200, 0, 0")), (Vector3{1, 0, 0}));
}

TEST(Axis, SnapsToACoordinateAxis) {
  const model::Tree tree = with_axis("4.9e-12, 0, 1");
  EXPECT_EQ(axis(tree), (Vector3{0, 0, 1}));
  EXPECT_EQ(tree.snaps.at(0).what, "joint 'j': axis[0]");
  EXPECT_NE(axis(with_axis("4.9e-12, 0, 1", "0"))[0], Real(0));
}

TEST(Vet, NamesNearMissesWithoutTouchingThem) {
  const std::string path = testing::TempDir() + "near_miss.urdf";
  std::FILE* const file = std::fopen(path.c_str(), "w");
  const std::string text = one_joint("<origin rpy=\"0 1.5708 0\"/><axis xyz=\"0 0.00005 1\"/>");
  std::fwrite(text.data(), 1, text.size(), file);
  std::fclose(file);
  const Vetted vetted = vet_model(read_model_text(path), path, options());
  EXPECT_THAT(vetted.tree.snaps, SizeIs(0));
  ASSERT_GE(vetted.findings.size(), 2U);
  EXPECT_THAT(vetted.findings[0].message,
              HasSubstr("joint 'j': rpy[1] 1.5708 is 3.67e-06 away from pi/2; not changed"));
  EXPECT_THAT(vetted.findings[1].message,
              HasSubstr("joint 'j': axis[1] 0.00005 is 5e-05 away from 0; not changed"));
}

}  // namespace
}  // namespace treedyn::description
