// One step of a scene's integrator within one phase.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {
namespace {

TEST(Step, IsThatOfTheScenesIntegrator) {
  const ArmScene euler(kHeld, "stepping: {integrator: semi-implicit-euler, step: 1e-3}\n",
                       Variant::kMeasured);
  const Measurement step = euler.code().measure("step", {kq, kqd, ktau});
  EXPECT_EQ(step.operations, euler.operations("step"));
  const Vector expected = stepped(euler, kq);
  for (std::size_t i = 0; i < kq.size(); ++i) {
    EXPECT_EQ(step.values.at(i), expected.at(2 * i + 1));
    EXPECT_EQ(step.values.at(kq.size() + i), expected.at(2 * i));
  }
  EXPECT_FALSE(has(ArmScene(kHeld).source(), "step"));  // an adaptive integrator
}

/// q and qd after a second of steps.
Vector after_a_second(const std::string& integrator, double h) {
  const ArmScene scene("  drive:\n    - {joint: elbow, torque: 9*sin(3*t)}\n",
                       fmt::format("stepping: {{integrator: {}, step: {}}}\n", integrator, h));
  Vector q = kq;
  Vector qd = kqd;
  for (int k = 0; k < std::lround(1 / h); ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0, 0}, {k * h}});
    q.assign(next.begin(), next.begin() + 2);
    qd.assign(next.begin() + 2, next.end());
  }
  q.insert(q.end(), qd.begin(), qd.end());
  return q;
}

double distance(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  }
  return std::sqrt(sum);
}

TEST(Step, HasTheOrderOfItsMethod) {
  const Vector fine = after_a_second("rk4", 0.0005);
  const double rk4 =
      distance(after_a_second("rk4", 0.005), fine) / distance(after_a_second("rk4", 0.0025), fine);
  EXPECT_NEAR(std::log2(rk4), 4, 0.3);
  const double euler = distance(after_a_second("semi-implicit-euler", 0.002), fine) /
                       distance(after_a_second("semi-implicit-euler", 0.001), fine);
  EXPECT_NEAR(std::log2(euler), 1, 0.3);
  const Vector finest = after_a_second("dopri5-fixed", 0.002);
  const double dopri5 = distance(after_a_second("dopri5-fixed", 0.02), finest) /
                        distance(after_a_second("dopri5-fixed", 0.01), finest);
  EXPECT_NEAR(std::log2(dopri5), 5, 0.5);
  const double sdirk2 = distance(after_a_second("sdirk2", 0.01), fine) /
                        distance(after_a_second("sdirk2", 0.005), fine);
  EXPECT_NEAR(std::log2(sdirk2), 2, 0.3);
}

/// Of sdirk2 with three Newton steps a stage and one Jacobian: a scene without rows needs no more.
TEST(Step, CostsWhatItsManifestSays) {
  for (const std::string stepping :
       {"rk4, step: 1e-3", "dopri5-fixed, step: 1e-3", "sdirk2, step: 4e-3"}) {
    const std::string rows = stepping.starts_with("sdirk2") ? "" : kHeld;
    const ArmScene scene(rows + "  drive:\n    - {joint: elbow, torque: 9*t}\n",
                         "stepping: {integrator: " + stepping + "}\n", Variant::kMeasured);
    const Measurement step = scene.code().measure("step", {kq, kqd, ktau, {0.3}});
    EXPECT_EQ(step.operations, scene.operations("step")) << stepping;
    const Operations worst = operations_of(scene.manifest("step").at("worst_case"));
    for (std::size_t n = 0; n < worst.size(); ++n) {
      EXPECT_LE(step.operations[n], worst[n]) << stepping;
    }
  }
}

TEST(Step, CostsOneOfTwoLevels) {  // E4: the contact's price while it presses, and nothing else
  const char* const stepping = "stepping: {integrator: semi-implicit-euler, step: 1e-2}\n";
  const ArmScene ground(kGround, stepping, Variant::kMeasured);
  const Operations open = ground.operations("step");
  const Operations press = operations_of(ground.manifest("constrained_dynamics").at("press"));
  Vector q = {0.3, 0.3};
  Vector qd = {0, 0};
  int flights = 0;
  int contacts = 0;
  for (int k = 0; k < 200; ++k) {
    const Measurement step = ground.code().measure("step", {q, qd, {0, 0}});
    const bool touches = std::sin(q[0]) + std::sin(q[0] + q[1]) < 0;
    for (std::size_t n = 0; n < open.size(); ++n) {
      ASSERT_EQ(step.operations[n], open[n] + (touches ? press[n] : 0)) << "step " << k;
    }
    (touches ? contacts : flights) += 1;
    q.assign(step.values.begin(), step.values.begin() + 2);
    qd.assign(step.values.begin() + 2, step.values.end());
  }
  EXPECT_GT(flights, 20);
  EXPECT_GT(contacts, 20);
  // flight is the scene without contact and the depth of the hand
  const ArmScene free("", stepping);
  EXPECT_LE(total(open) - total(free.operations("step")), 8);
}

}  // namespace
}  // namespace treedyn::support
