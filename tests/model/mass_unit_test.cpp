// The unit of mass: one for ordinary robots, a power of two that brings others near one.
#include "model/mass_unit.hpp"

#include <gtest/gtest.h>

namespace treedyn::model {
namespace {

/// A link on a joint: mass m at (2, 0, 0), moment 1/2 m about each axis.
Link link_of(JointType type, const Real& mass) {
  Link link;
  link.joint.type = type;
  link.inertia.mass = mass;
  link.inertia.com = {2, 0, 0};
  for (std::size_t k = 0; k < 9; k += 4) {
    link.inertia.about_com[k] = mass / 2;
  }
  return link;
}

Real unit_of(std::vector<Link> links) {
  Tree tree;
  tree.links = std::move(links);
  return mass_unit(tree);
}

TEST(MassUnit, IsOneForRobotsOfOurSize) {
  EXPECT_EQ(unit_of({}), 1);
  EXPECT_EQ(unit_of({link_of(JointType::kRevolute, 0)}), 1);
  EXPECT_EQ(unit_of({link_of(JointType::kPrismatic, Real("1e-11"))}), 1);
  EXPECT_EQ(unit_of({link_of(JointType::kRevolute, Real("2e11"))}), 1);  // 9e11 kg m^2
}

TEST(MassUnit, BringsTheLargestResistanceNearOne) {
  for (const char* const mass : {"3e-20", "7e-13", "1e13", "5e25"}) {
    for (const JointType type : {JointType::kPrismatic, JointType::kRevolute}) {
      const Real m(mass);
      const Real resistance = type == JointType::kPrismatic ? m : Real(m * Real("4.5"));
      if (resistance > Real("1e-12") && resistance < Real("1e12")) {
        continue;
      }
      const Real unit = unit_of({link_of(type, m / 1000), link_of(type, m)});
      EXPECT_GE(resistance / unit, 1) << mass;
      EXPECT_LT(resistance / unit, 2) << mass;
      int exponent = 0;
      EXPECT_EQ(frexp(unit.digits(), &exponent), Digits("0.5")) << mass;  // no digit changes
    }
  }
}

TEST(MassUnit, DividesMassesAndMomentsOfInertiaAndNothingElse) {
  Tree tree;
  tree.links = {link_of(JointType::kRevolute, 24)};
  const Tree scaled = in_mass_unit(tree, 8);
  EXPECT_EQ(scaled.links[0].inertia.mass, 3);
  EXPECT_EQ(scaled.links[0].inertia.about_com[4], Real("1.5"));
  EXPECT_EQ(scaled.links[0].inertia.com[0], 2);
}

}  // namespace
}  // namespace treedyn::model
