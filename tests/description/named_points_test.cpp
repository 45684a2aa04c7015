#include "description/named_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/text_models.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const char* const kLeg = R"(name: leg
links:
- {name: table, father: ground, joint: {type: fixed, offset: [0, 0, 5]}}
- {name: shank, father: table, mass: 1, joint: {name: knee, type: revolute, axis: [0, 1, 0]}}
- {name: "ns:foot", father: shank, joint: {type: fixed, offset: [0, 0, -1], rotation: {rpy: [0, 0, pi/2]}}}
points:
- {name: heel, link: "ns:foot", at: [0.5, 0, 0]}
- {name: ankle, link: "ns:foot"}
)";

std::vector<std::string> names(const std::vector<model::Point>& points) {
  std::vector<std::string> result;
  for (const model::Point& point : points) {
    result.push_back(point.name);
  }
  return result;
}

std::string error_of(const std::string& list) {
  try {
    resolve_points(yaml(kLeg), list);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NamedPoints, StandInTheFrameOfTheCarryingLink) {
  const model::Tree tree = yaml(kLeg);
  ASSERT_THAT(tree.points, SizeIs(2));
  EXPECT_EQ(tree.points[0].link, 0);
  EXPECT_EQ(tree.points[0].link_name, "ns:foot");
  EXPECT_EQ(tree.points[0].at, (Vector3{0, 0.5, -1}));
  EXPECT_EQ(tree.points[1].at, (Vector3{0, 0, -1}));
}

TEST(ResolvePoints, TakesNamedPointsLinksAndCoordinates) {
  const model::Tree tree = yaml(kLeg);
  const auto points =
      resolve_points(tree, "heel,shank,tip=shank:0.25,-1,2e-1,toe=ns:foot,x=ns:foot:1,0,0,table");
  EXPECT_THAT(names(points), ElementsAre("heel", "shank", "tip", "toe", "x", "table"));
  EXPECT_EQ(points[2].at, (Vector3{Real(1) / 4, -1, Real(2) / 10}));
  EXPECT_EQ(points[3].at, (Vector3{0, 0, -1}));
  EXPECT_EQ(points[4].at, (Vector3{0, 1, -1}));
  EXPECT_EQ(points[5].link, model::kGround);
  EXPECT_EQ(points[5].at, (Vector3{0, 0, 5}));
}

TEST(ResolvePoints, AllAreTheMovingLinksInJointOrder) {
  EXPECT_THAT(names(resolve_points(yaml(kLeg), "all")), ElementsAre("shank"));
  EXPECT_THAT(
      names(resolve_points(yaml(kLeg, options("0", Base::kAxes)), "all")),
      ElementsAre("base_px", "base_py", "base_pz", "base_rz", "base_ry", "base_rx", "shank"));
}

TEST(ResolvePoints, OfAnEmptyListAreNone) {
  EXPECT_THAT(resolve_points(yaml(kLeg), ""), IsEmpty());
}

TEST(NamedPoints, MayStandOnTheGround) {
  const std::string text = std::string(kLeg) + "- {name: wall, link: ground, at: [1, 2, 3]}\n";
  const model::Point wall = yaml(text).points.back();
  EXPECT_EQ(wall.link, model::kGround);
  EXPECT_THAT(wall.at, ElementsAre(Real(1), Real(2), Real(3)));
  const std::vector<model::Point> points =
      resolve_points(yaml(kLeg), "a=ground,b=ground:0,0,1,ground");
  EXPECT_EQ(points[0].link, model::kGround);
  EXPECT_EQ(points[1].link, model::kGround);
  EXPECT_EQ(points[1].at[2], 1);
  EXPECT_EQ(points[2].name, "ground");
  EXPECT_EQ(points[2].link, model::kGround);
}

TEST(ResolvePoints, NameTheMistake) {
  EXPECT_EQ(error_of("knee"),
            "--points: 'knee' is neither a point nor a link of the model; expected one of ankle, "
            "heel, ns:foot, shank, table");
  EXPECT_EQ(error_of("a=b"),
            "--points: point 'a': link 'b' is unknown; expected one of ns:foot, shank, table");
  EXPECT_EQ(error_of("a=b:1,2,3"),
            "--points: point 'a': link 'b' is unknown; expected one of ns:foot, shank, table");
  EXPECT_EQ(error_of("hell"),
            "--points: 'hell' is neither a point nor a link of the model (did you mean 'heel'?); "
            "expected one of ankle, heel, ns:foot, shank, table");
  EXPECT_EQ(error_of("a=shnk"),
            "--points: point 'a': link 'shnk' is unknown (did you mean 'shank'?); expected one of "
            "ns:foot, shank, table");
  EXPECT_EQ(error_of("a=shank:1,2"), "--points: point 'a' has 2 numbers; expected 3");
  EXPECT_EQ(error_of("a=shank:1"), "--points: point 'a' has 1 number; expected 3");
  EXPECT_EQ(error_of("a=shank:1,2,x"),
            "--points: point 'a': 'x' is not a number; expected a decimal such as 0.25 or -1.5e-3");
  EXPECT_EQ(error_of("heel,,shank"),
            "--points: empty name; expected name, name=link or name=link:x,y,z");
  EXPECT_EQ(error_of("heel,"), "--points: empty name; expected name, name=link or name=link:x,y,z");
  EXPECT_EQ(error_of("=shank"),
            "--points: empty name; expected name, name=link or name=link:x,y,z");
  EXPECT_EQ(error_of("heel,heel"),
            "--points: point 'heel' is defined twice; expected different names");
  EXPECT_EQ(error_of("a.b=shank,a-b=shank"),
            "--points: points 'a.b' and 'a-b' both become the identifier 'a_b'; expected names "
            "that differ in letters or digits");
}

}  // namespace
}  // namespace treedyn::description
