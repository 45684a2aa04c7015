// A step of a scene with phases: events, impacts and what begins behind them.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {
namespace {

/// The walker of models/scenes/compass_walk.yaml with other steps.
std::string walk(const std::string& stepping, const std::string& effect = {}) {
  std::string text =
      read_file(std::string(TREEDYN_SOURCE_DIR) + "/models/scenes/compass_walk.yaml");
  const auto replace = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  replace("../compass_walker.yaml",
          std::string(TREEDYN_SOURCE_DIR) + "/models/compass_walker.yaml");
  replace("stepping: {output_step: 0.01}", "stepping: {" + stepping + "}");
  replace("effects:\n", "effects:\n" + effect);
  return text;
}

/// Two legs of 1 m with 5 kg at half their length and 10 kg at the hip; x, z, left, right.
class Walker {
 public:
  using Vec = Eigen::Vector4d;

  struct State {
    Vec q, qd;
    int stance = 0;    ///< 0: left
    double since = 0;  ///< the phase began, s
  };

  /// J of a point at distance l below the hip along a leg: x - l sin, z - l cos.
  static Eigen::Matrix<double, 2, 4> jacobian(const Vec& q, int leg, double l) {
    Eigen::Matrix<double, 2, 4> J = Eigen::Matrix<double, 2, 4>::Zero();
    J(0, 0) = J(1, 1) = 1;
    J(0, 2 + leg) = -l * std::cos(q[2 + leg]);
    J(1, 2 + leg) = l * std::sin(q[2 + leg]);
    return J;
  }

  /// d/dt(J) qd of this point.
  static Eigen::Vector2d bias(const Vec& q, const Vec& qd, int leg, double l) {
    const double w2 = qd[2 + leg] * qd[2 + leg];
    return {l * std::sin(q[2 + leg]) * w2, l * std::cos(q[2 + leg]) * w2};
  }

  static Eigen::Matrix4d inertia(const Vec& q) {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    A(0, 0) = A(1, 1) = 10;
    for (const int leg : {0, 1}) {
      const auto J = jacobian(q, leg, 0.5);
      A += 5 * J.transpose() * J;
    }
    return A;
  }

  /// A qdd = forces + J^T lambda, J qdd = right. \return the first four
  static Vec solve(const Eigen::Matrix4d& A, const Eigen::Matrix<double, 2, 4>& J, const Vec& force,
                   const Eigen::Vector2d& right) {
    Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Zero();
    M.topLeftCorner<4, 4>() = A;
    M.topRightCorner<4, 2>() = -J.transpose();
    M.bottomLeftCorner<2, 4>() = J;
    Eigen::Matrix<double, 6, 1> b;
    b << force, right;
    return M.fullPivLu().solve(b).head<4>();
  }

  static Vec acceleration(const Vec& q, const Vec& qd, int stance) {
    const double slope = std::acos(-1.0) / 60;
    const Eigen::Vector2d g(9.81 * std::sin(slope), -9.81 * std::cos(slope));
    Vec force = 10 * Vec(g[0], g[1], 0, 0);
    for (const int leg : {0, 1}) {
      force += 5 * jacobian(q, leg, 0.5).transpose() * (g - bias(q, qd, leg, 0.5));
    }
    return solve(inertia(q), jacobian(q, stance, 1), force, -bias(q, qd, stance, 1));
  }

  static double height(const Vec& q, int leg) { return q[1] - std::cos(q[2 + leg]); }

  /// Runge-Kutta of order 4.
  static State integrated(const State& s, double h) {
    const auto a = [&](const Vec& q, const Vec& qd) {
      return acceleration(q, qd, s.stance);
    };
    const Vec a1 = a(s.q, s.qd);
    const Vec v2 = s.qd + h / 2 * a1;
    const Vec a2 = a(s.q + h / 2 * s.qd, v2);
    const Vec v3 = s.qd + h / 2 * a2;
    const Vec a3 = a(s.q + h / 2 * v2, v3);
    const Vec v4 = s.qd + h * a3;
    const Vec a4 = a(s.q + h * v3, v4);
    return {s.q + h / 6 * (s.qd + 2 * v2 + 2 * v3 + v4), s.qd + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4),
            s.stance, s.since + h};
  }

  /// A step with the touch-down of the swing foot where it happens, by bisection, from 0.4 s on,
  /// plastic.
  static State step(const State& s, double h) {
    const int swing = 1 - s.stance;
    const State end = integrated(s, h);
    double low = std::max(0.0, 0.4 - s.since);
    if (!(low < h) || height(end.q, swing) >= 0 || height(integrated(s, low).q, swing) < 0) {
      return end;
    }
    double high = h;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (height(integrated(s, middle).q, swing) < 0 ? high : low) = middle;
    }
    State touch = integrated(s, high);
    const Eigen::Matrix4d A = inertia(touch.q);
    touch.qd = solve(A, jacobian(touch.q, swing, 1), A * touch.qd, Eigen::Vector2d::Zero());
    touch.stance = swing;
    touch.since = 0;
    return integrated(touch, h - high);
  }

  static State start() {
    State s;
    s.q << 0, std::cos(0.2714), -0.2714, 0.2714;
    s.qd << 1.0918 * std::cos(0.2714), 1.0918 * std::sin(0.2714), 1.0918, 0.3772;
    return s;
  }
};

Vector vector_of(const Walker::Vec& x) { return {x.data(), x.data() + 4}; }

/// The state of the walker's step.
struct Steps {
  Vector q, qd;
  Vector phase = {0};
  Vector steps = {0};
  Vector begun = {0};

  explicit Steps(const Walker::State& s)
      : q(vector_of(s.q)), qd(vector_of(s.qd)), phase{static_cast<double>(s.stance)} {}
  void advance(const SceneCode& scene) {
    const Vector next = scene.code().call("step", {q, qd, {0, 0, 0, 0}, phase, steps, begun});
    q.assign(next.begin(), next.begin() + 4);
    qd.assign(next.begin() + 4, next.begin() + 8);
    phase = {next.at(10)};
    steps = {next.at(11)};
    begun = {next.at(12)};
  }
};

TEST(PhaseStep, WalksLikeATextbooksEquations) {
  const SceneCode scene(walk("integrator: rk4, step: 1e-3"));
  Steps ours(Walker::start());
  Walker::State theirs = Walker::start();
  int changes = 0;
  for (int k = 0; k < 2000; ++k) {
    const double before = ours.phase[0];
    ours.advance(scene);
    changes += ours.phase[0] == before ? 0 : 1;
    theirs = Walker::step(theirs, 1e-3);
    ASSERT_EQ(ours.phase[0], theirs.stance) << "step " << k;
    ASSERT_NEAR(std::min(ours.begun[0] + ours.steps[0] * 1e-3, 0.401),
                std::min(theirs.since, 0.401), 1e-8)
        << "step " << k;
    // a few roundings in each of 2000 steps, and events that are taken up to 2e-10 steps late and
    // change speeds by 20/s, that errors of a walker do not multiply by more than 100
    ASSERT_LE((Walker::Vec(ours.q.data()) - theirs.q).norm(), 1e-9) << "step " << k;
    ASSERT_LE((Walker::Vec(ours.qd.data()) - theirs.qd).norm(), 1e-8) << "step " << k;
  }
  EXPECT_EQ(changes, 2);
}

/// Columns of the last row that `treedyn simulate --engine` writes for the walker, without drift.
Vector simulated(const std::string& integrator, const std::string& step,
                 const std::string& duration) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.yaml").string();
  write_file(file, walk("integrator: " + integrator));
  const Outcome outcome = run({TREEDYN_EXECUTABLE, "simulate", file, "--engine", "--drift", "none",
                               "--step", step, "--duration", duration});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::string row = outcome.out.substr(0, outcome.out.size() - 1);
  row = row.substr(row.rfind('\n') + 1);
  Vector values;
  for (std::size_t at = row.find(',', row.find(',') + 1); at != std::string::npos;
       at = row.find(',', at + 1)) {  // behind t and phase
    values.push_back(std::stod(row.substr(at + 1)));
  }
  return values;
}

/// q and qd after some steps.
Vector stepped(const SceneCode& scene, int count) {
  Steps steps(Walker::start());
  for (int k = 0; k < count; ++k) {
    steps.advance(scene);
  }
  Vector result = steps.q;
  result.insert(result.end(), steps.qd.begin(), steps.qd.end());
  return result;
}

double largest_difference(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, std::abs(a[k] - b.at(k)));
  }
  return largest;
}

struct Method {
  const char* name;
  double tolerance;
};

class Methods : public testing::TestWithParam<Method> {};

TEST_P(Methods, StepLikeTheSimulatorUpToAnEvent) {
  const std::string name = GetParam().name;
  const SceneCode scene(walk("step: 1e-3, integrator: " + name));
  EXPECT_LE(largest_difference(stepped(scene, 500), simulated(name, "1e-3", "0.5")),
            GetParam().tolerance);
}

// Some roundings in each of 500 steps, and the simulator meets the times of its table, roundings of
// h apart; Newton's iteration ends at a change of 1e-13 of a state of size 2, twice a step.
INSTANTIATE_TEST_SUITE_P(PhaseStep, Methods,
                         testing::Values(Method{"semi-implicit-euler", 1e-11}, Method{"rk4", 1e-11},
                                         Method{"dopri5-fixed", 1e-11}, Method{"sdirk2", 2e-10}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Largest error after 1.8 s and two events, against events that the simulator locates.
double error_behind_events(const std::string& stepping, double h, const Vector& exact) {
  const SceneCode scene(walk(fmt::format("{}, step: {}", stepping, h)));
  return largest_difference(stepped(scene, static_cast<int>(std::lround(1.8 / h))), exact);
}

TEST(PhaseStep, KeepsItsOrderBehindEvents) {
  const Vector exact = simulated("rk4", "1e-4", "1.8");
  // the method's own error, about 2e-7; events at the ends of steps leave 0.1
  const double coarse = error_behind_events("integrator: rk4", 0.02, exact);
  EXPECT_LE(coarse, 1e-5);
  const double fine = error_behind_events("integrator: rk4", 0.005, exact);
  EXPECT_GE(std::log2(coarse / fine) / 2, 3.5);
  EXPECT_LE(error_behind_events("integrator: dopri5-fixed, cuts: 4", 0.01, exact), 5e-8);
}

TEST(PhaseStep, WithTheIndexOfNoPhaseGivesNoNumber) {
  const SceneCode scene(walk("integrator: rk4, step: 1e-3"), Variant::kMeasured);
  const Walker::State s = Walker::start();
  for (const double phase : {-1.0, 2.0, 7.0}) {
    const Measurement step = scene.code().measure(
        "step", {vector_of(s.q), vector_of(s.qd), {0, 0, 0, 0}, {phase}, {0}, {0}});
    EXPECT_EQ(step.status & 16, 16) << phase;  // not_a_number
    EXPECT_TRUE(std::isnan(step.values.at(4))) << phase;
    EXPECT_EQ(step.values.at(10), phase);
  }
}

TEST(PhaseStep, WithoutCutsTakesEventsAtTheEndOfTheStep) {
  const SceneCode scene(walk("integrator: rk4, step: 1e-3, cuts: 0"));
  // two events, each up to h late; speeds change by up to 20/s around them and errors grow tenfold
  const Walker::State s = Walker::start();
  Vector q = vector_of(s.q);
  Vector qd = vector_of(s.qd);
  Vector phase = {0};
  Vector steps = {0};
  for (int k = 0; k < 1800; ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0, 0, 0, 0}, phase, steps});
    q.assign(next.begin(), next.begin() + 4);
    qd.assign(next.begin() + 4, next.begin() + 8);
    if (next.at(10) !=
        phase[0]) {  // the foot is below the ground, by no more than its way of a step
      const double height = q[1] - std::cos(q[3 - static_cast<std::size_t>(phase[0])]);
      EXPECT_LT(height, 0);
      EXPECT_GT(height, -3e-3);
    }
    phase = {next.at(10)};
    steps = {next.at(11)};
  }
  q.insert(q.end(), qd.begin(), qd.end());
  EXPECT_LE(largest_difference(q, simulated("rk4", "1e-3", "1.8")), 2 * 20 * 10 * 1e-3);
}

TEST(PhaseStep, OperationsOfTheManifestAreThoseExecutedInEveryPhase) {  // E2, E6
  const SceneCode scene(walk("integrator: rk4, step: 1e-3"), Variant::kMeasured);
  const Walker::State s = Walker::start();
  const Json entry = scene.manifest("step");
  const Vector q = {s.q[0], s.q[1] + 0.1, s.q[2],
                    s.q[3]};  // above the ground: no guard is negative
  for (const std::size_t phase : {0U, 1U}) {
    const Measurement step = scene.code().measure(
        "step", {q, vector_of(s.qd), {0, 0, 0, 0}, {static_cast<double>(phase)}, {0}, {0}});
    EXPECT_EQ(step.operations, operations_of(entry.at("phases").at(phase).at("operations")));
  }
  EXPECT_EQ(operations_of(entry.at("phases").at(0).at("operations")), scene.operations("step"));
}

TEST(PhaseStep, AnEventCostsNoMoreThanTheWorstCase) {  // E2
  const SceneCode scene(walk("integrator: rk4, step: 1e-3"), Variant::kMeasured);
  Walker::State s = Walker::start();
  int count = 0;
  for (Walker::State next = s; next.stance == s.stance; next = Walker::step(s, 1e-3), ++count) {
    s = next;
  }
  const Measurement step = scene.code().measure(
      "step",
      {vector_of(s.q), vector_of(s.qd), {0, 0, 0, 0}, {0}, {std::min(count - 1.0, 401.0)}, {0}});
  EXPECT_EQ(step.values.at(10), 1);
  const Operations worst = operations_of(scene.manifest("step").at("worst_case"));
  for (std::size_t n = 0; n < worst.size(); ++n) {
    EXPECT_LE(step.operations[n], worst[n]);
  }
  EXPECT_GT(total(step.operations), total(scene.operations("step")));
}

TEST(PhaseStep, RenewsTheAnchorOfTheFootThatLands) {
  const SceneCode scene(walk("integrator: semi-implicit-euler, step: 1e-3",
                             "  stabilisation: {method: baumgarte}\n"));
  Walker::State s = Walker::start();
  Vector q = vector_of(s.q);
  Vector qd = vector_of(s.qd);
  Vector anchor = {q[0] - std::sin(q[2]), 0, q[1] - std::cos(q[2]), 0, 0, 0};
  Vector phase = {0};
  Vector steps = {0};
  Vector begun = {0};
  const Vector first = anchor;
  while (phase[0] == 0) {
    EXPECT_EQ(anchor, first);
    const Vector next =
        scene.code().call("step", {q, qd, {0, 0, 0, 0}, anchor, phase, steps, begun});
    q.assign(next.begin(), next.begin() + 4);
    qd.assign(next.begin() + 4, next.begin() + 8);
    anchor.assign(next.begin() + 10, next.begin() + 16);
    phase = {next.at(16)};
    steps = {next.at(17)};
    begun = {next.at(18)};
    ASSERT_LE(std::abs(q[1]), 2);
  }
  EXPECT_NEAR(anchor.at(5), 0, 1e-12);  // on the ground, where it landed
  // the rest of the step leaves the foot there: h^2 times the accelerations of the joints
  EXPECT_NEAR(anchor.at(3), q[0] - std::sin(q[3]), 2e-5);
  EXPECT_NEAR(anchor.at(5), q[1] - std::cos(q[3]), 2e-5);
  EXPECT_EQ(Vector(anchor.begin(), anchor.begin() + 3), Vector(first.begin(), first.begin() + 3));
  EXPECT_EQ(steps.at(0), 0);
  EXPECT_GT(begun.at(0), 0);
  EXPECT_LT(begun.at(0), 1e-3);
}

TEST(PhaseStep, IsRefusedWhereAnImpactStrikesAMovingConstraint) {
  const TemporaryFolder folder;
  std::string moving = walk("integrator: rk4, step: 1e-3");
  const std::string held = "along: [x, z]}";
  moving.replace(moving.find(held), held.size(), "along: [x, z], curve: [0.1*t, 0, 0]}");
  write_file(folder.path() / "scene.yaml", moving);
  std::vector<std::string> command = {
      TREEDYN_EXECUTABLE,    "generate", "--scene", (folder.path() / "scene.yaml").string(), "-o",
      folder.path().string()};
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("is led along a curve"), std::string::npos) << outcome.err;
  command.insert(command.end(), {"--functions", "reaction_jacobian_transpose"});
  EXPECT_EQ(run(command).status, 0);
}

/// An impact that names what is led by an acceleration stops it.
TEST(PhaseStep, AnImpactStrikesTheLedJointThatItNames) {
  const SceneCode scene(fmt::format(
      "scene: stop\nmodel: {}\neffects:\n  locked_joint: [{{joint: x, acceleration: 0}}]\nphases:\n"
      "  - name: go\n    active: [x]\n    until: [{{time: 1, impact: {{constraints: [x], "
      "restitution: 0.25}}, then: go}}]\ninitial: {{qd: {{x: 2}}}}\nduration: 2\n",
      model_path("cart_and_ball")));
  const Vector result = scene.code().call("impact", {{0, 0}, {2, -5}});
  EXPECT_EQ(result, (Vector{-0.5, -5, -2 * 2.5}));  // 2 kg move with the cart
}

/// A cart goes on at 2 m/s while its ball is thrown back by a slope.
TEST(PhaseStep, AnImpactLeavesALedJointItsSpeed) {
  for (const std::string lead : {"acceleration: 0", "at: 2*t"}) {
    SCOPED_TRACE(lead);
    const SceneCode scene(
        fmt::format("scene: led\nmodel: {}\npoints: [{{name: tip, link: ball, at: [0, 0, 0]}}]\n"
                    "effects:\n  locked_joint: [{{joint: x, {}}}]\n"
                    "  point_constraint: [{{name: slope, point: tip, along: [[3, 0, 4]]}}]\n"
                    "phases:\n  - name: fall\n    active: [x]\n    until: [{{touch_down: {{point: "
                    "tip, normal: [3, 0, 4]}}, impact: {{constraints: [slope], restitution: 0.5}}, "
                    "then: fall}}]\ninitial: {{q: {{height: 1}}, qd: {{x: 2}}}}\nduration: 1\n",
                    model_path("cart_and_ball"), lead));
    EXPECT_EQ(scene.manifest("impact").at("rows").at(0), "x: force of the joint, led through it");
    const Vector result = scene.code().call("impact", {{0, 0}, {2, -5}});
    const double rebound = (-0.5 * (3 * 2 - 4 * 5) - 3 * 2) / 4;
    const double push = (rebound + 5) / 0.8;
    EXPECT_DOUBLE_EQ(result.at(0), 2);
    EXPECT_NEAR(result.at(1), rebound, 1e-14);
    EXPECT_NEAR(result.at(2), -0.6 * push, 1e-14);
    EXPECT_NEAR(result.at(3), push, 1e-14);
  }
}

TEST(PhaseStep, AnAdaptiveIntegratorHasNone) {
  const TemporaryFolder folder;
  write_file(folder.path() / "scene.yaml", walk("integrator: fehlberg78"));
  const Outcome outcome =
      run({TREEDYN_EXECUTABLE, "generate", "--scene", (folder.path() / "scene.yaml").string(),
           "--functions", "step", "-o", folder.path().string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("integrator 'fehlberg78' is not for generated code"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace treedyn::support
