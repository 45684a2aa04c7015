// Baumgarte's correction in generated functions, against the position of the hand by trigonometry.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {
namespace {

const char* const kBaumgarte = "  stabilisation: {method: baumgarte, rate: 20}\n";

/// x and z of the hand: both links are 1 m long, angles from the x axis upwards.
struct Hand {
  double x, z;
};

Hand hand_at(const Vector& q) {
  return {std::cos(q[0]) + std::cos(q[0] + q[1]), std::sin(q[0]) + std::sin(q[0] + q[1])};
}

Hand hand_velocity(const Vector& q, const Vector& qd) {
  const double w = qd[0] + qd[1];
  return {-std::sin(q[0]) * qd[0] - std::sin(q[0] + q[1]) * w,
          std::cos(q[0]) * qd[0] + std::cos(q[0] + q[1]) * w};
}

/// The hand's acceleration for joint accelerations.
Hand hand_acceleration(const Vector& q, const Vector& qd, const Vector& qdd) {
  const double w = qd[0] + qd[1];
  const Hand along = hand_velocity(q, qdd);
  return {along.x - std::cos(q[0]) * qd[0] * qd[0] - std::cos(q[0] + q[1]) * w * w,
          along.z - std::sin(q[0]) * qd[0] * qd[0] - std::sin(q[0] + q[1]) * w * w};
}

/// Some hundred roundings of numbers up to 1e3.
constexpr double kRounding = 1e-10;

TEST(Baumgarte, PullsTheHandBackToWhereItBegan) {
  const ArmScene scene(std::string(kHeld).append(kBaumgarte));
  const Hand p = hand_at(kq);
  const Hand v = hand_velocity(kq, kqd);
  const Vector anchor = {p.x - 0.02, 99, p.z + 0.03};  // y is no row
  const Vector qdd = scene.code().call("constrained_dynamics", {kq, kqd, ktau, anchor});
  const Hand a = hand_acceleration(kq, kqd, qdd);
  EXPECT_NEAR(a.x, -2 * 20 * v.x - 20 * 20 * 0.02, kRounding);
  EXPECT_NEAR(a.z, -2 * 20 * v.z + 20 * 20 * 0.03, kRounding);
}

TEST(Baumgarte, FollowsACurveWithoutAnAnchor) {
  const ArmScene scene(
      "  point_constraint:\n    - {name: lead, point: hand, along: [x], curve: [1 + t/2, 0, 0]}\n"
      "  stabilisation: {method: baumgarte, rate: 10}\n");
  const double t = 0.3;
  const Vector qdd = scene.code().call("constrained_dynamics", {kq, kqd, ktau, {t}});
  const double off = hand_at(kq).x - (1 + t / 2);
  const double rate = hand_velocity(kq, kqd).x - 0.5;
  EXPECT_NEAR(hand_acceleration(kq, kqd, qdd).x, -2 * 10 * rate - 10 * 10 * off, kRounding);
}

TEST(Baumgarte, KeepsAJointWhereItIsTold) {
  const std::string rate = "  stabilisation: {method: baumgarte, rate: 10}\n";
  const ArmScene at("  locked_joint:\n    - {joint: elbow, at: 0.1*t}\n" + rate);
  EXPECT_NEAR(at.code().call("constrained_dynamics", {kq, kqd, ktau, {2}}).at(1),
              -2 * 10 * (kqd[1] - 0.1) - 10 * 10 * (kq[1] - 0.2), kRounding);
  const ArmScene here("  locked_joint:\n    - {joint: elbow}\n" + rate);
  EXPECT_NEAR(here.code().call("constrained_dynamics", {kq, kqd, ktau, {-0.8}}).at(1),
              -2 * 10 * kqd[1] - 10 * 10 * (kq[1] + 0.8), kRounding);
}

TEST(Baumgarte, TurnsALinkBack) {
  const ArmScene scene(
      "  orientation_constraint:\n    - {name: level, point: hand, along: [y]}\n"
      "  stabilisation: {method: baumgarte, rate: 10}\n");
  const double angle = 0.05;  // about z of the joint, which is -y of the base
  const double was = kq[0] + kq[1] - angle;
  const double c = std::cos(was);
  const double s = std::sin(was);
  const Vector before = {c, 0, -s, 0, 1, 0, s, 0, c};  // about -y
  const Vector qdd = scene.code().call("constrained_dynamics", {kq, kqd, ktau, before});
  EXPECT_NEAR(qdd.at(0) + qdd.at(1), -2 * 10 * (kqd[0] + kqd[1]) - 10 * 10 * std::sin(angle),
              kRounding);
}

TEST(Baumgarte, StatedAccelerationsAreNotCorrected) {
  const char* const stated =
      "  point_constraint:\n    - {name: fall, point: hand, along: [z], acceleration: [-1]}\n";
  EXPECT_EQ(ArmScene(std::string(stated).append(kBaumgarte)).source(), ArmScene(stated).source());
}

TEST(Baumgarte, LeavesNoTraceUnlessNamed) {  // E1
  const std::string with = std::string(kHeld).append(kBaumgarte);
  EXPECT_EQ(ArmScene(with, "use: {stabilisation: off}\n").source(), ArmScene(kHeld).source());
  EXPECT_EQ(ArmScene(kHeld).source().find("anchor"), std::string::npos);
}

TEST(Baumgarte, HasAPrice) {  // E2
  const ArmScene with(std::string(kHeld).append(kBaumgarte));
  const ArmScene without(kHeld);
  bool found = false;
  const Json info = with.info();
  for (const Json& price : info.at("prices")) {
    if (price.at("effect") == "stabilisation" && price.at("function") == "constrained_dynamics") {
      found = true;
      EXPECT_EQ(operations_of(price.at("with")), with.operations("constrained_dynamics"));
      EXPECT_EQ(operations_of(price.at("without")), without.operations("constrained_dynamics"));
    }
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace treedyn::support
