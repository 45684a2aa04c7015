#include "description/skeleton.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace treedyn::description {
namespace {

using testing::ElementsAre;

/// Links a, b, c, .. with the given fathers ("ground" or a link), all revolute.
RawTree tree_of(const std::vector<std::string>& fathers) {
  RawTree raw;
  raw.file = "m.yaml";
  raw.name.text = "m";
  for (std::size_t k = 0; k < fathers.size(); ++k) {
    const std::string name(1, static_cast<char>('a' + static_cast<int>(k)));
    raw.links.push_back({{name, {}}, std::nullopt, {}});
    RawJoint joint;
    joint.name.text = "j_" + name;
    joint.type.text = "revolute";
    joint.father.text = fathers[k];
    joint.son.text = name;
    raw.joints.push_back(joint);
  }
  return raw;
}

std::string error_of(const RawTree& raw) {
  try {
    resolve_skeleton(raw);
  } catch (const InputError& error) {
    return error.message();
  }
  return "";
}

TEST(ResolveSkeleton, OrdersLinksBreadthFirst) {
  const RawTree raw = tree_of({"b", "ground", "ground", "b", "a"});
  const Skeleton skeleton = resolve_skeleton(raw);
  EXPECT_THAT(skeleton.order, ElementsAre(1, 2, 0, 3, 4));
  EXPECT_THAT(skeleton.father, ElementsAre(1, -1, -1, 1, 0));
}

TEST(ResolveSkeleton, NamesTheLinksOfACycle) {
  EXPECT_EQ(error_of(tree_of({"ground", "d", "b", "c", "d"})),
            "fathers form the cycle 'b' -> 'd' -> 'c' -> 'b'; expected a tree on the ground");
  EXPECT_EQ(error_of(tree_of({"a"})),
            "fathers form the cycle 'a' -> 'a'; expected a tree on the ground");
}

TEST(ResolveSkeleton, FindsTheCycleAboveALink) {
  EXPECT_EQ(error_of(tree_of({"b", "c", "b"})),
            "fathers form the cycle 'b' -> 'c' -> 'b'; expected a tree on the ground");
}

TEST(ResolveSkeleton, AcceptsNamesInUnicodeAndRefusesBrokenOnes) {
  RawTree raw = tree_of({"ground"});
  for (const std::string& good : {std::string("\xc3\xbc"), std::string("\xe5\x85\xb3\xe8\x8a\x82"),
                                  std::string("\xf0\x9f\xa4\x96"), std::string("*/\"'\\")}) {
    raw.joints[0].name.text = good;
    EXPECT_EQ(error_of(raw), "") << good;
  }
  for (const std::string& bad :
       {std::string("\xc3"), std::string("\xc0\x80"), std::string("\xed\xa0\x80"),
        std::string("\xff"), std::string("\xf4\x90\x80\x80"), std::string("a\nb"),
        std::string("\x7f")}) {
    raw.joints[0].name.text = bad;
    EXPECT_NE(error_of(raw), "");
  }
}

TEST(MovingOrder, TakesTheFirstJointWhoseFatherIsPlaced) {
  const RawTree raw = tree_of({"e", "ground", "a", "ground", "d"});
  const Skeleton skeleton = resolve_skeleton(raw);
  EXPECT_THAT(moving_order(skeleton, skeleton.father), ElementsAre(1, 3, 4, 0, 2));
}

}  // namespace
}  // namespace treedyn::description
