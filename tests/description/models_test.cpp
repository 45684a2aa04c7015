// Our own models: what each promises in its first lines.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::filesystem::path folder() { return std::filesystem::path(TREEDYN_SOURCE_DIR) / "models"; }

model::Tree read(const std::string& name, Base base = Base::kFixed) {
  return read_model((folder() / (name + ".yaml")).string(), options("1e-9", base));
}

TEST(Models, AreReadWithBothBasesAndSayWhyTheyAreThere) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    ++count;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    EXPECT_THAT(text.str(), HasSubstr("# Why: ")) << entry.path();
    EXPECT_THAT(text.str(), HasSubstr("# Source: ")) << entry.path();
    const std::string name = entry.path().stem().string();
    EXPECT_EQ(read(name).name, name);
    EXPECT_EQ(read(name, Base::kAxes).dof(), read(name).dof() + 6);
    EXPECT_THAT(read(name).snaps, IsEmpty()) << "our own angles are exact";
    EXPECT_THAT(joints_without_inertia(read(name)), IsEmpty()) << name;
  }
  EXPECT_GE(count, 7);
}

TEST(Models, HaveTheExpectedNumberOfJoints) {
  const std::map<std::string, int> joints = {{"two_link", 2},  {"polar", 2}, {"compass_walker", 4},
                                             {"puma560", 6},   {"panda", 7}, {"biped", 12},
                                             {"quadruped", 12}};
  for (const auto& [name, count] : joints) {
    EXPECT_EQ(read(name).dof(), count) << name;
  }
}

TEST(Puma560, HasTheFiguresOfArmstrongKhatibAndBurdick) {
  const model::Tree tree = read("puma560");
  const double mass[] = {0, 17.4, 4.8, 0.82, 0.34, 0.09};
  const double a[] = {0, 0, 0.4318, -0.0203, 0, 0};
  const double d[] = {0, 0.2435, -0.0934, 0.4331, 0, 0};
  const double izz[] = {0.35, 0.539, 0.066, 1.3e-3, 0.4e-3, 0.04e-3};
  for (std::size_t k = 0; k < 6; ++k) {
    const model::Joint& joint = tree.links[k].joint;
    // modified Denavit-Hartenberg: offset = (a, 0, 0) + Rx(alpha) (0, 0, d)
    const Vector3 expected = Vector3{Real(a[k]), 0, 0} + joint.rotation * Vector3{0, 0, Real(d[k])};
    EXPECT_LE(norm(joint.offset - expected), Real(1e-16)) << k;
    EXPECT_NEAR(tree.links[k].inertia.mass.convert_to<double>(), mass[k], 1e-15) << k;
    EXPECT_NEAR(tree.links[k].inertia.about_com[8].convert_to<double>(), izz[k], 1e-15) << k;
    EXPECT_EQ(joint.axis, (Vector3{0, 0, 1}));
  }
  EXPECT_EQ(tree.links[1].joint.rotation,
            (Matrix3{1, 0, 0, 0, 0, 1, 0, -1, 0}));  // alpha = -90 degrees
  EXPECT_EQ(tree.links[3].joint.rotation,
            (Matrix3{1, 0, 0, 0, 0, -1, 0, 1, 0}));  // alpha = +90 degrees
}

TEST(Biped, IsGeneralInEveryMovingLink) {
  const model::Tree tree = read("biped");
  for (const model::Link& link : tree.links) {
    const Vector3 moments = eigenvalues(link.inertia.about_com);
    EXPECT_GT(link.inertia.mass, Real(0)) << link.name;
    EXPECT_GT(moments[0], Real(0)) << link.name;
    EXPECT_GT(moments[1] - moments[0], Real(0.01) * moments[2]) << link.name;
    EXPECT_GT(moments[2] - moments[1], Real(0.01) * moments[2]) << link.name;
    for (const Real& entry : link.inertia.com) {
      EXPECT_NE(entry, Real(0)) << link.name;
    }
  }
}

TEST(Biped, WeighsWhatItsSubjectWeighs) {
  Real mass = 0;
  for (const model::Link& link : read("biped", Base::kAxes).links) {
    mass += link.inertia.mass;
  }
  EXPECT_NEAR(mass.convert_to<double>(), 1.002 * 80.5, 1e-12)
      << "the published fractions sum to 100.2 %";
}

TEST(Biped, StandsOnItsFootPoints) {
  const model::Tree tree = read("biped", Base::kAxes);
  std::vector<std::string> names;
  for (const model::Point& point : tree.points) {
    names.push_back(point.name);
  }
  EXPECT_THAT(names, ElementsAre("left_heel", "left_toe", "right_heel", "right_toe"));
  EXPECT_EQ(tree.points[0].link_name, "left_foot");
  EXPECT_EQ(tree.links[static_cast<std::size_t>(tree.points[2].link)].name, "right_foot");
}

TEST(Biped, IsMirroredFromLeftToRight) {
  const model::Tree tree = read("biped");
  for (std::size_t k = 0; k < 6; ++k) {
    const model::Link& left = tree.links[k];
    const model::Link& right = tree.links[k + 6];
    EXPECT_EQ(left.joint.offset[1], -right.joint.offset[1]) << left.name;
    EXPECT_EQ(left.inertia.com[1], -right.inertia.com[1]) << left.name;
    EXPECT_EQ(left.inertia.about_com[1], -right.inertia.about_com[1]) << left.name;
    EXPECT_EQ(left.inertia.about_com[5], -right.inertia.about_com[5]) << left.name;
    EXPECT_EQ(left.inertia.about_com[2], right.inertia.about_com[2]) << left.name;
  }
}

}  // namespace
}  // namespace treedyn::description
