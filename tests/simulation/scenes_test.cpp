// Every scene of models/scenes runs, and shows a fact that is known without us.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "simulation/run_scene.hpp"

namespace treedyn::simulation {
namespace {

double range(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) {
    result = std::max(result, std::fabs(value));
  }
  return result;
}

/// Engine and program give the same terms; 1e-11 of their size covers the condition of a biped's A.
void expect_engine_agrees(const model::Scene& scene) {
  const auto program = program_dynamics(scene);
  const auto engine = engine_dynamics(scene);
  const Needs needs = needs_of(scene);
  const int points = static_cast<int>(scene.points.size());
  Terms a(scene.tree.dof(), points, needs);
  Terms b(scene.tree.dof(), points, needs);
  for (int trial = 1; trial <= 5; ++trial) {
    const Vector q = Vector::LinSpaced(scene.tree.dof(), -0.7, 0.3 * trial);
    const Vector qd = Vector::LinSpaced(scene.tree.dof(), 0.5, -0.2 * trial);
    program->evaluate(q, qd, a);
    engine->evaluate(q, qd, b);
    const VectorMap x(a.values().data(), static_cast<Eigen::Index>(a.values().size()));
    const VectorMap y(b.values().data(), static_cast<Eigen::Index>(b.values().size()));
    EXPECT_LE((x - y).cwiseAbs().maxCoeff(), 1e-11 * (1 + y.cwiseAbs().maxCoeff())) << scene.name;
  }
}

TEST(Scenes, HaveTheSameTermsByProgramAndEngine) {
  for (const char* const name :
       {"pendulum", "double_pendulum", "arm_circle", "compass_walk", "drop", "four_bar",
        "biped_double_support", "biped_flight", "biped_stepping"}) {
    expect_engine_agrees(committed(name));
  }
}

/// T = 4 sqrt(l/g) K(sin(A/2)) by the arithmetic-geometric mean: K(k) = pi/2 / agm(1, cos(A/2)).
TEST(PendulumScene, HasThePeriodOfTheEllipticIntegral) {
  Running run(committed("pendulum"));
  double a = 1;
  double b = std::cos(std::numbers::pi / 3);
  for (int k = 0; k < 6; ++k) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double period = 4 * std::sqrt(1 / 9.81) * std::numbers::pi / 2 / a;
  run.advance_to(period);
  EXPECT_NEAR(run.simulator.q()[0], 2 * std::numbers::pi / 3, 1e-8);
  run.advance_to(1.75 * period);  // three quarters: at the bottom again
  EXPECT_NEAR(run.simulator.q()[0], 0, 1e-8);
}

TEST(DoublePendulumScene, KeepsItsEnergyForItsFrictionIsOff) {
  Running run(committed("double_pendulum"));
  const Recording recording = run.record(0.1);
  EXPECT_LT(range(column(recording, "energy")), 1e-6 * 1000);  // of about 1000 J, ten seconds
  EXPECT_GT(largest(column(recording, "kinetic_energy")), 100);
}

/// The reactions do the work: their power is the rate of the energy.
TEST(ArmCircleScene, FeelsReactionsWhoseWorkIsTheEnergy) {
  Running run(committed("arm_circle"));
  const Recording recording = run.record(std::numbers::pi / 500);
  const std::vector<double> x = column(recording, "R[pen.x]");
  const std::vector<double> z = column(recording, "R[pen.z]");
  const std::vector<double> energy = column(recording, "energy");
  double work = 0;
  double worst = 0;
  for (std::size_t k = 0; k < energy.size(); ++k) {
    const auto power = [&](std::size_t n) {
      const double angle = 2 * recording.rows[n].t;
      return 0.5 * (-x[n] * std::sin(angle) + z[n] * std::cos(angle));  // R . c'
    };
    if (k > 0) {  // the trapezoidal rule: its error is h^2/12 of the power's change of slope
      work += (power(k) + power(k - 1)) / 2 * (recording.rows[k].t - recording.rows[k - 1].t);
    }
    worst = std::max(worst, std::fabs(energy[k] - energy[0] - work));
  }
  EXPECT_LT(worst, 1e-4 * range(energy));
  EXPECT_LT(largest(column(recording, "drift")), 1e-12);
}

TEST(CompassWalkScene, WalksAtLeastFortyStepsAndConvergesToACycle) {
  Running run(committed("compass_walk"));
  run.advance_to(30);
  const auto& events = run.simulator.events();
  ASSERT_GE(events.size(), 40U);
  const double last = events[39].time - events[38].time;
  EXPECT_NEAR(events[38].time - events[37].time, last, 1e-4 * last);
  EXPECT_NEAR(last, 0.734, 0.002);  // Goswami et al.: the period on 3 degrees is 0.734 s
  for (const EventRecord& event : events) {
    EXPECT_LT(event.qd_after.norm(), event.qd_before.norm() * 1.2);
  }
}

/// One bounce of Hunt and Crossley: v/c - ln(1 + c v)/c^2 is the same before and after, with
/// negative speed after. Gravity adds 9.81 m/s^2 in a contact of 1.5 ms, and the law changes by 7.4
/// for each m/s of the speed after: 0.11.
TEST(DropScene, ReboundsAsHuntAndCrossleySay) {
  Running run(committed("drop"));
  double before = 0;
  double after = 0;
  run.simulator.advance_to(0.6, [&] {
    const double speed = run.simulator.qd()[0];
    before = std::min(before, speed);
    after = std::max(after, speed);
    return true;
  });
  const double c = 0.3;
  const auto law = [c](double v) {
    return v / c - std::log(1 + c * v) / (c * c);
  };
  EXPECT_NEAR(-before, std::sqrt(2 * 9.81), 1e-2);
  EXPECT_NEAR(law(-before), law(-after), 0.11);
}

TEST(DropScene, ComesToRestInTheGround) {
  Running run(committed("drop"));
  const Recording recording = run.record(0.01);
  const std::vector<double> energy = column(recording, "energy");
  for (std::size_t k = 1; k < energy.size(); ++k) {
    EXPECT_LE(energy[k], energy[k - 1] + 1e-7);
  }
}

/// The crank turns; the loop stays closed; the coupler's end is on the circle of the rocker.
TEST(FourBarScene, TurnsItsCrankFullyAndStaysClosed) {
  Running run(committed("four_bar"));
  const Recording recording = run.record(0.01);
  EXPECT_LT(largest(column(recording, "drift")), 1e-13);
  EXPECT_GT(range(column(recording, "q[crank_joint]")), 2 * std::numbers::pi);
  EXPECT_LT(range(column(recording, "q[rocker_joint]")), std::numbers::pi);
  const std::vector<double> crank = column(recording, "q[crank_joint]");
  const std::vector<double> rocker = column(recording, "q[rocker_joint]");
  for (std::size_t k = 0; k < crank.size(); ++k) {
    const double x = 0.6 + 0.4 * std::cos(rocker[k]) - 0.2 * std::cos(crank[k]);
    const double z = 0.4 * std::sin(rocker[k]) - 0.2 * std::sin(crank[k]);
    EXPECT_NEAR(std::hypot(x, z), 0.5, 1e-12);
  }
}

double mass_of(const model::Scene& scene) {
  double mass = 0;
  for (const model::Link& link : scene.tree.links) {
    mass += static_cast<double>(link.inertia.mass);
  }
  return mass;
}

/// At rest the feet carry the weight, whatever the distribution among redundant rows is.
TEST(BipedDoubleSupportScene, CarriesItsWeightOnTwelveReactionsOfRankTen) {
  Running run(committed("biped_double_support"));
  const Recording recording = run.record(0.05);
  ASSERT_EQ(recording.stopped, "");
  double vertical = 0;
  for (const char* const name :
       {"R[left_heel.z]", "R[left_toe.z]", "R[right_heel.z]", "R[right_toe.z]"}) {
    vertical += column(recording, name).back();
  }
  EXPECT_NEAR(vertical, 9.81 * mass_of(run.scene), 0.5);
  EXPECT_EQ(run.simulator.solution().rank, 10);
  EXPECT_LT(run.simulator.solution().residual, 1e-9);
  EXPECT_LT(largest(column(recording, "drift")), 1e-12);
}

TEST(BipedFlightScene, FliesOnAParabolaWithItsEnergyAndMomentum) {
  Running run(committed("biped_flight"));
  Pose pose(run.scene.tree, run.scene.gravity);
  const double mass = mass_of(run.scene);
  const auto about_com = [&] {
    pose.update(run.simulator.q(), run.simulator.qd());
    Eigen::Vector3d com = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < pose.links().size(); ++k) {
      com += static_cast<double>(run.scene.tree.links[k].inertia.mass) / mass * pose.links()[k].r;
    }
    return Eigen::Vector3d(pose.angular_momentum() - com.cross(pose.linear_momentum()));
  };
  const Eigen::Vector3d spin = about_com();
  const Eigen::Vector3d momentum = pose.linear_momentum();
  const double energy = pose.kinetic_energy() + pose.potential_energy();
  run.advance_to(0.7);
  EXPECT_LT((about_com() - spin).norm(), 1e-6);
  EXPECT_LT((pose.linear_momentum() - momentum - Eigen::Vector3d(0, 0, -9.81 * 0.7 * mass)).norm(),
            1e-6);
  EXPECT_NEAR(pose.kinetic_energy() + pose.potential_energy(), energy, 1e-6);
}

TEST(BipedSteppingScene, ChangesItsFeetWithImpactsThatLoseEnergy) {
  Running run(committed("biped_stepping"));
  const Recording recording = run.record(0.02);
  ASSERT_EQ(recording.stopped, "");
  int landings = 0;
  Pose pose(run.scene.tree, run.scene.gravity);
  for (const EventRecord& event : recording.events) {
    if (event.impulse.size() == 0) {
      continue;
    }
    ++landings;
    pose.update(event.q, event.qd_before);
    const double before = pose.kinetic_energy();
    pose.update(event.q, event.qd_after);
    EXPECT_LE(pose.kinetic_energy(), before * (1 + 1e-9));
  }
  EXPECT_GE(landings, 5);
  EXPECT_LT(largest(column(recording, "drift")), 1e-12);
  const std::vector<double> height = column(recording, "q[base_pz]");
  EXPECT_LT(range(height), 0.1);  // it does not fall
}

/// hard_cases s12: the fixed point that its file states, after 100 steps.
TEST(SimplestWalker, WalksAHundredStepsOnItsLimitCycle) {
  const model::Scene scene = description::read_scene(std::string(TREEDYN_SOURCE_DIR) +
                                                     "/tests/data/hard_cases/"
                                                     "s12_simplest_walker.json");
  Settings settings;
  settings.tolerance = 1e-12;
  Running run(scene, &settings);
  run.simulator.advance_to(1000, [&] { return run.simulator.events().size() < 100; });
  const auto& events = run.simulator.events();
  ASSERT_EQ(events.size(), 100U);
  const EventRecord& last = events.back();
  EXPECT_NEAR(last.q[2], -0.20016107217, 1e-9);
  EXPECT_NEAR(last.qd_after[2], 0.19990606, 1e-8);  // as many digits as the file prints
  EXPECT_NEAR(last.qd_after[3], 0.18410059, 1e-8);
  EXPECT_NEAR(last.time - events[98].time, 3.88194000128, 1e-9);
  EXPECT_LT((last.qd_after.tail(2) - events[97].qd_after.tail(2)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((last.q.tail(2) - events[97].q.tail(2)).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace treedyn::simulation
