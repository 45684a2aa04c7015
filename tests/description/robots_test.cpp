// The reader against the bodies that Pinocchio made of published robots (robots/README.md).
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "description/read.hpp"

namespace treedyn::description {
namespace {

using Json = nlohmann::json;

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(TREEDYN_SHARED_DATA) / "robots";
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

Json read_json(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return Json::parse(stream);
}

model::Tree read_case(const std::filesystem::path& path, const Json& data) {
  ReadOptions options;
  options.base = data.at("base") == "fixed" ? Base::kFixed : Base::kAxes;
  options.mimic = Mimic::kIndependent;
  options.snap = 0;
  return read_model((path.parent_path() / data.at("urdf")).string(), options);
}

template <std::size_t size>
void expect_near(const std::array<Real, size>& x, const Json& expected, double scale,
                 const std::string& what) {
  for (std::size_t k = 0; k < size; ++k) {
    EXPECT_NEAR(x[k].template convert_to<double>(), expected.at(k).get<double>(), 1e-12 * scale)
        << what << " entry " << k;
  }
}

std::array<Real, 6> upper_half(const model::Matrix3& a) {
  return {a[0], a[1], a[2], a[4], a[5], a[8]};
}

const model::Link& link_of_joint(const model::Tree& tree, const std::string& joint) {
  for (const model::Link& link : tree.links) {
    if (link.joint.name == joint) {
      return link;
    }
  }
  throw std::runtime_error("no joint " + joint);
}

void expect_body(const model::Tree& tree, const Json& body, const Json& names) {
  const std::string name = body.at("joint");
  const model::Link& link = link_of_joint(tree, name);
  const int parent = body.at("parent");
  const std::string father = link.father == model::kGround
                                 ? ""
                                 : tree.links[static_cast<std::size_t>(link.father)].joint.name;
  EXPECT_EQ(father,
            parent < 0 ? "" : names.at(static_cast<std::size_t>(parent)).get<std::string>());
  EXPECT_EQ(link.joint.type == model::JointType::kRevolute, body.at("type") == "revolute");
  expect_near(link.joint.axis, body.at("axis"), 1, name + " axis");
  expect_near(link.joint.offset, body.at("placement_p"), 1, name + " offset");
  expect_near(link.joint.rotation, body.at("placement_R_rowmajor"), 1, name + " rotation");
  const double mass = body.at("mass");
  EXPECT_NEAR(link.inertia.mass.convert_to<double>(), mass, 1e-12 * mass) << name;
  if (mass > 0) {
    expect_near(link.inertia.com, body.at("com"), 1, name + " com");
  }
  expect_near(upper_half(link.inertia.about_com), body.at("inertia_at_com_xx_xy_xz_yy_yz_zz"), 1,
              name + " inertia");
}

const model::Frame& frame_called(const model::Tree& tree, const std::string& name) {
  for (const model::Frame& frame : tree.frames) {
    if (frame.name == name) {
      return frame;
    }
  }
  throw std::runtime_error("no frame " + name);
}

TEST(Robots, HaveTheBodiesThatPinocchioReads) {
  if (case_files().empty()) {
    GTEST_SKIP() << "no reference robots on this machine";
  }
  for (const auto& path : case_files()) {
    SCOPED_TRACE(path.filename().string());
    const Json data = read_json(path);
    const model::Tree tree = read_case(path, data);
    ASSERT_EQ(tree.size(), data.at("n").get<int>());
    EXPECT_EQ(tree.dof(), tree.size());
    for (const Json& body : data.at("bodies")) {
      if (body.at("index") != -1) {
        expect_body(tree, body, data.at("joint_names"));
      }
    }
  }
}

TEST(Robots, KeepMergedLinksAsFrames) {
  if (case_files().empty()) {
    GTEST_SKIP() << "no reference robots on this machine";
  }
  for (const auto& path : case_files()) {
    SCOPED_TRACE(path.filename().string());
    const Json data = read_json(path);
    const model::Tree tree = read_case(path, data);
    for (const Json& expected : data.at("frames")) {
      const std::string name = expected.at("name");
      const model::Frame& frame = frame_called(tree, name);
      const auto joint = data.at("joint_names").at(expected.at("parent_joint").get<std::size_t>());
      EXPECT_EQ(tree.links.at(static_cast<std::size_t>(frame.link)).joint.name, joint);
      expect_near(frame.origin, expected.at("placement_p"), 1, name + " origin");
      expect_near(frame.rotation, expected.at("placement_R_rowmajor"), 1, name + " rotation");
    }
  }
}

}  // namespace
}  // namespace treedyn::description
