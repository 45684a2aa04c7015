// Which rows count as dependent: neither masses nor units nor the drift of a step decide it.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"
#include "scenes/loop_oracle.hpp"

namespace treedyn::support {
namespace {

std::string scene(const std::string& model, const std::string& rest) {
  return fmt::format("scene: rank\nmodel: {}\n{}duration: 1\n", model_path(model), rest);
}

const std::string kTwoScales = scene("two_scales",
                                     "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint:\n"
                                     "    - {point: tip, along: [z]}\n"
                                     "    - {point: press, along: [z]}\n");
const std::string kArm = scene("arm",
                               "effects:\n  gravity: [0, 0, -9.81]\n  locked_joint:\n"
                               "    - {joint: slew}\n    - {joint: boom}\n    - {joint: tool}\n");
const std::string kCrane = scene("crane",
                                 "effects:\n  locked_joint:\n"
                                 "    - {joint: slew, acceleration: -0.3*sin(t)}\n"
                                 "    - {joint: pan}\n");

const std::string kTurntable =
    scene("turntable",
          "points:\n  - {name: ce, link: coupler, at: [0.5, 0, 0]}\n"
          "  - {name: re, link: rocker, at: [0.4, 0, 0]}\n"
          "  - {name: hand, link: a2, at: [0.05, 0, 0.02]}\n"
          "effects:\n  gravity: [0, 0, -9.81]\n"
          "  joined_constraint: [{name: loop, point: ce, other: re}]\n"
          "  point_constraint: [{name: place, point: hand, along: [x, y, z]}]\n"
          "  orientation_constraint: [{name: turn, point: hand}]\n"
          "initial: {q: {j_table: 0.3999999999999415, j_crank: 1.669334733522869, j_coupler: "
          "-1.3187123918215478, j_rocker: 1.955452649925002, j_a0: 0.3, j_a1: 0.3, j_a2: 0.3}}\n");

Measurement called(const SceneCode& code, const CompiledModel::Inputs& inputs) {
  return code.code().measure("constrained_dynamics", inputs);
}

class InScalar : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] SceneCode code(const std::string& text) const {
    return SceneCode(text, Variant::kPlain, {"--scalar", GetParam()});
  }
  /// Some roundings.
  [[nodiscard]] double rounding() const { return GetParam() == "float" ? 1e-5 : 1e-14; }
};

TEST_P(InScalar, ATipBesideAPressIsHeld) {
  const Measurement held = called(code(kTwoScales), {{0.1, 0.2}, {0, 0}, {0, 0}});
  EXPECT_EQ(held.status, 0);
  EXPECT_NEAR(held.values[0], 0, 9.81 * rounding());
  EXPECT_NEAR(held.values[1], 0, 9.81 * rounding());
  EXPECT_NEAR(held.values[2], 0.002 * 9.81, 0.02 * rounding());
  EXPECT_NEAR(held.values[3], 800 * 9.81, 7848 * rounding());
}

/// Cars of 1 kg that are locked on a waggon of 1 kg, all along one line.
std::string waggon(const std::string& model, int count) {
  const char* const link =
      "  - {{name: {}, father: {}, mass: 1, joint: {{name: {}, type: prismatic, axis: [1, 0, "
      "0]}}}}\n";
  std::string links =
      "name: waggon\nlinks:\n" + fmt::format(fmt::runtime(link), "waggon", "ground", "x");
  std::string locks = fmt::format("scene: waggon\nmodel: {}\neffects:\n  locked_joint:\n", model);
  for (int k = 0; k < count; ++k) {
    links +=
        fmt::format(fmt::runtime(link), fmt::format("car{}", k), "waggon", fmt::format("x{}", k));
    locks += fmt::format("    - {{joint: x{}}}\n", k);
  }
  write_file(model, links);
  return locks + "duration: 1\n";
}

// An elimination of so many rows is split into functions. All move as one mass, and a car's lock
// gives it what its own force lacks; K = 1 + 1 1^T has the condition 1 + count.
TEST_P(InScalar, ThirtyRowsAreHeld) {
  constexpr int kCount = 30;
  const TemporaryFolder folder;
  const SceneCode held = code(waggon(folder.path() / "waggon.yaml", kCount));
  EXPECT_NE(held.source().find("solve_regular_30_part_2("), std::string::npos);
  Vector tau = {40};
  for (int k = 0; k < kCount; ++k) {
    tau.push_back(k % 7 - 3);
  }
  const Measurement at = called(held, {Vector(kCount + 1), Vector(kCount + 1), tau});
  EXPECT_EQ(at.status, 0);
  const double acceleration = tau[0] / (kCount + 1);
  const double bound = 40 * (1 + kCount) * rounding();
  EXPECT_NEAR(at.values[0], acceleration, bound);
  for (std::size_t k = 1; k <= kCount; ++k) {
    EXPECT_NEAR(at.values[k], 0, bound);
    EXPECT_NEAR(at.values[kCount + k], acceleration - tau[k], bound);
  }
}

/// The Puma whose hand is held in six rows. \param beginning  its initial position
SceneCode held_puma(const std::string& beginning, const std::string& scalar) {
  return SceneCode(
      fmt::format("scene: held\nmodel: {}/models/puma560.yaml\npoints:\n"
                  "  - {{name: hand, link: link6, at: [0, 0, 0.1]}}\n"
                  "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{{point: hand}}]\n"
                  "  orientation_constraint: [{{point: hand}}]\n{}duration: 1\n",
                  TREEDYN_SOURCE_DIR, beginning),
      Variant::kPlain,
      {"--scalar", scalar, "--functions",
       "constrained_dynamics,reaction_jacobian_transpose,mass_matrix,gravity_force"});
}

/// K x = b of the six rows at rest.
struct Six {
  Eigen::MatrixXd K;
  Eigen::VectorXd b;
};

Six six_of(const CompiledModel& code, const Vector& q) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Vector a = code.call("mass_matrix", {q});
  const Vector j = code.call("reaction_jacobian_transpose", {q});
  const Vector g = code.call("gravity_force", {q});
  const Eigen::MatrixXd A = Eigen::Map<const Rows>(a.data(), 6, 6);
  const Eigen::MatrixXd J_T = Eigen::Map<const Rows>(j.data(), 6, 6);
  const Eigen::LDLT<Eigen::MatrixXd> of_A(A);
  return {J_T.transpose() * of_A.solve(J_T),
          J_T.transpose() * of_A.solve(Eigen::Map<const Eigen::VectorXd>(g.data(), 6))};
}

/// The least eigenvalue of K with ones on its diagonal: no pivot is a smaller part of its K_kk.
double least_part(const Eigen::MatrixXd& K) {
  const Eigen::VectorXd scale = K.diagonal().cwiseSqrt().cwiseInverse();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * K * scale.asDiagonal())
      .eigenvalues()[0];
}

// The wrist is straight: pivots behind small ones are rounding, and none of them may pass for one.
TEST(Rank, OfASingularPositionIsToldAndReactionsAreTheLeast) {
  const SceneCode held =
      held_puma("initial: {q: {joint2: 0.4, joint3: -0.7, joint4: 0.3, joint5: 0.9}}\n", "double");
  EXPECT_EQ(held.manifest("constrained_dynamics").at("rank"), 6);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  for (int n = 0; n < 300; ++n) {
    Vector q(6);
    std::ranges::generate(q, [&] { return angle(random); });
    q[4] = 0;
    const Measurement at = called(held, {q, Vector(6), Vector(6)});
    EXPECT_EQ(at.status, kRankLost) << n;
    const Six rows = six_of(held.code(), q);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_K(rows.K);
    const Eigen::MatrixXd V = of_K.eigenvectors().rightCols(5);
    const Eigen::VectorXd values = of_K.eigenvalues().tail(5);
    const Eigen::VectorXd least = V * (V.transpose() * rows.b).cwiseQuotient(values);
    const Eigen::Map<const Eigen::VectorXd> lambda(at.values.data() + 6, 6);
    EXPECT_LT((lambda - least).norm(), 1e-13 * values[4] / values[0] * least.norm()) << n;
  }
}

// At zeros the wrist is straight and stays so: what the rows are elsewhere is not what they are on
// the motions from there.
TEST_P(InScalar, PositionsOffTheMotionsOfASingularBeginningAreTold) {
  const SceneCode held = held_puma("", GetParam());
  EXPECT_EQ(held.manifest("constrained_dynamics").at("rank"), 5);
  EXPECT_NE(held.header().find("have 6,"), std::string::npos);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  int told = 0;
  for (int n = 0; n < 300; ++n) {
    Vector q(6);
    std::ranges::generate(q, [&] { return angle(random); });
    if (GetParam() == "float") {
      std::ranges::transform(q, q.begin(), [](double x) { return static_cast<float>(x); });
    }
    if (least_part(six_of(held.code(), q).K) > 1e-4) {
      const Measurement at = called(held, {q, Vector(6), Vector(6)});
      EXPECT_EQ(at.status, kRowGivenUp) << n;
      ++told;
    }
  }
  EXPECT_GT(told, 100);
}

// Two points of one body, at one place but for 1e-17 m: their row is rounding, and what it asks for
// is left as it is.
TEST(Rank, RowsThatAreRoundingTakeNoPlace) {
  const std::string held =
      "  point_constraint:\n    - {point: tip, along: [y]}\n"
      "    - {point: corner, along: [x]}\n";
  const SceneCode without(scene("plate", "effects:\n  gravity: [0, 0, -9.81]\n" + held));
  const SceneCode with(scene("plate", "effects:\n  gravity: [0, 0, -9.81]\n" + held +
                                          "  joined_constraint:\n    - {point: corner, other: "
                                          "hole, along: [x]}\n"));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> one(-1, 1);
  for (int n = 0; n < 20; ++n) {
    CompiledModel::Inputs inputs(3, Vector(5));
    for (Vector& input : inputs) {
      std::ranges::generate(input, [&] { return one(random); });
    }
    const Measurement a = called(with, inputs);
    const Measurement b = called(without, inputs);
    EXPECT_EQ(a.status, 0) << n;
    double size = 1;
    for (std::size_t k = 0; k < 5; ++k) {
      size = std::max(size, std::abs(b.values[k]));
    }
    for (std::size_t k = 0; k < 7; ++k) {  // qdd, and the reactions of what both have
      EXPECT_NEAR(a.values[k], b.values[k], 1e-10 * size) << n << ' ' << k;
    }
  }
}

/// Nothing that the plane does not keep by itself: J is 1e-16, with no other row beside it.
const char* const kOfThePlane[] = {
    "  orientation_constraint:\n    - {name: o, point: tip, along: [[0.7648421872844885, "
    "0.644217687237691, 0]]}\n",
    "  point_constraint:\n    - {name: n, point: tip, along: [[-0.644217687237691, "
    "0.7648421872844885, 0]]}\n",
    "  point_constraint:\n    - {name: n, point: tip, along: [[-sin(0.7), cos(0.7), 0]]}\n"};

TEST_P(InScalar, RowsOfRoundingAloneMoveNothing) {
  const std::string gravity = "effects:\n  gravity: [0, 0, -9.81]\n";
  const CompiledModel::Inputs inputs = {{1, 0.5}, {1, 2}, {0, 0}};
  const Measurement free = called(code(scene("planar", gravity)), inputs);
  for (const char* const rows : kOfThePlane) {
    CompiledModel::Inputs with_anchor = inputs;
    const SceneCode held = code(scene("planar", gravity + rows));
    if (held.code().manifest().function("constrained_dynamics").inputs.size() > 3) {
      with_anchor.push_back({0, 0, 0});
    }
    const Measurement result = called(held, with_anchor);
    EXPECT_EQ(result.status, 0) << rows;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(result.values[k], free.values[k], 100 * rounding()) << rows;
    }
    EXPECT_EQ(result.values[2], 0) << rows;
  }
}

/// Both feet can be held; phases follow.
const std::string kWalker =
    "scene: rank\nmodel: " TREEDYN_SOURCE_DIR
    "/models/compass_walker.yaml\neffects:\n  gravity: [0, 0, -9.81]\n  point_constraint:\n"
    "    - {name: left, point: left_foot, along: [x, z]}\n"
    "    - {name: right, point: right_foot, along: [x, z]}\nphases:\n";

/// The feet are together where the scene starts, where three of their four rows are independent,
/// and apart where they stand: what events place does not hold where the initial state has it.
TEST(Rank, OfFeetIsThatWhereTheyLand) {
  const SceneCode code(
      kWalker +
          "  - {name: swing, active: [left], until: [{touch_down: {point: right_foot}, "
          "not_before: 0.2, impact: {constraints: [left, right]}, then: both}]}\n"
          "  - {name: both, active: [left, right]}\n"
          "initial: {q: {hip_z: 1}, qd: {left_hip: 0.4, hip_x: 0.4}}\nduration: 1\n",
      Variant::kPlain, {});
  EXPECT_EQ(code.manifest("constrained_dynamics_swing").at("rank"), 2);
  for (const char* function : {"constrained_dynamics_both", "impact"}) {
    EXPECT_EQ(code.manifest(function).at("rank"), 4) << function;
  }
  const std::vector<double> landed = {0.331, 0.943, 0.338, -0.338};
  const std::vector<double> fast = {1.2, -0.1, 1.2, 1.4};
  const Measurement struck = code.code().measure("impact", {landed, fast});
  const Measurement standing =
      code.code().measure("constrained_dynamics_both", {landed, {0, 0, 0, 0}, {1, 2, 3, 4}});
  for (const Measurement& still : {struck, standing}) {
    EXPECT_EQ(still.status, 0);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(still.values[k], 0, 1e-11) << k;
    }
  }
}

/// A foot that is let go and never set down again holds where the scene starts.
TEST(Rank, OfFeetThatAreLetGoIsThatWhereTheyStand) {
  const SceneCode code(
      kWalker +
          "  - {name: stand, active: [left, right], until: [{time: 0.3, then: swing}]}\n"
          "  - {name: swing, active: [left]}\n"
          "initial: {q: {hip_z: 1, left_hip: 0.1, right_hip: 0.1}}\nduration: 0.6\n",
      Variant::kPlain, {});
  EXPECT_EQ(code.manifest("constrained_dynamics_stand").at("rank"), 3);
  const Measurement standing = code.code().measure("constrained_dynamics_stand",
                                                   {{0, 1, 0.1, 0.1}, {0, 0, 0, 0}, {0, 0, 0, 0}});
  EXPECT_EQ(standing.status, 0);
}

// Three rows, two joints without a drive: what is said of rows is not said of joints.
TEST(Rank, OfJointsWithoutADriveIsNotThatOfRows) {
  const SceneCode code(scene("plate",
                             "effects:\n  gravity: [0, 0, -9.81]\n  locked_joint: [{joint: j0}]\n  "
                             "point_constraint:\n    - {point: tip, along: [x, y]}\n"
                             "actuated: [j0, j1, j3]\n"));
  const CompiledModel::Inputs state = {
      {0.1, -0.5, 0.8, 0.7, 0.4}, {0.2, 0.3, -0.1, 0.5, 0.6}, {0, 0.5, -0.3, 0.2, 0.7}};
  const Measurement inverse = code.code().measure("constrained_inverse_dynamics", state);
  EXPECT_EQ(inverse.status, 0);
  for (const std::size_t passive : {3U, 4U}) {
    EXPECT_NEAR(inverse.values[passive], 0, 1e-10);  // of torques of some 10 N m
  }
}

TEST_P(InScalar, AllJointsOfAnArmAreLocked) {
  const Measurement held = called(code(kArm), {{0.3, 0.2, 0.7}, {0.1, -0.2, 0.3}, {0, 0, 0}});
  EXPECT_EQ(held.status, 0);
  for (int k = 0; k < 3; ++k) {  // relative to the fall of the tool without a lock
    EXPECT_NEAR(held.values[static_cast<std::size_t>(k)], 0, 100 * rounding());
  }
}

TEST_P(InScalar, ACraneIsLedBesideALockedCamera) {
  const double t = 1.3;
  const Measurement led = called(code(kCrane), {{0.3, 0.2}, {0.3, 0}, {0, 0}, {t}});
  EXPECT_EQ(led.status, 0);
  EXPECT_NEAR(led.values[0], -0.3 * std::sin(t), rounding());
  EXPECT_NEAR(led.values[1], 0, rounding());
}

/// The hand is held in six rows by three joints: they say where the loop is asked for its rank.
TEST_P(InScalar, ALoopBesideAHandThatIsHeldTurnsOn) {
  const SceneCode held = code(kTurntable);
  const std::vector<double> q = {
      0.3999999999999415, 1.669334733522869, -1.3187123918215478, 1.955452649925002, 0.3, 0.3, 0.3};
  const std::vector<double> qd = {
      1, 0.20215144454861966, -0.2249859567279937, 0.09793791409053748, 0, 0, 0};
  std::vector<double> drifted = q;
  drifted[3] += 1e-6;
  const double exact = called(held, {q, qd, std::vector<double>(7)}).values[0];
  EXPECT_GT(std::abs(exact), 0.1);
  EXPECT_NEAR(called(held, {drifted, qd, std::vector<double>(7)}).values[0], exact, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Rank, InScalar, ::testing::Values("double", "float"),
                         [](const auto& of) { return of.param; });

/// A chain of three links, of which the last two are scaled in mass and all in length.
std::string chain(double mass, double length) {
  return fmt::format(
      "name: chain\nparameters: {{m: {:e}, l: {:e}}}\nlinks:\n"
      "  - {{name: a, father: ground, joint: {{name: a, type: revolute, axis: [0, 1, 0]}}, mass: "
      "2, "
      "com: [l/2, 0, 0], inertia: [0.01*l^2, 0, 0, 0.1*l^2, 0, 0.1*l^2]}}\n"
      "  - {{name: b, father: a, joint: {{name: b, type: revolute, axis: [0, 1, 0], offset: [l, 0, "
      "0]}}, mass: m, com: [l/3, 0, 0], inertia: [0.01*m*l^2, 0, 0, 0.1*m*l^2, 0, 0.1*m*l^2]}}\n"
      "  - {{name: c, father: ground, joint: {{name: c, type: revolute, axis: [0, 1, 0], offset: "
      "[l, 0, l]}}, mass: 1, com: [0.3*l, 0, 0], inertia: [0.1*l^2, 0, 0, 0.1*l^2, 0, 0.1*l^2]}}\n"
      "points:\n  - {{name: tip, link: b, at: [l, 0, 0]}}\n  - {{name: end, link: c, at: [l, 0, "
      "0]}}\n",
      mass, length);
}

/// Accelerations of the three joints, the tip held and the end held twice along x.
Vector chain_accelerations(double mass, double length, bool reversed, const std::string& scalar) {
  const TemporaryFolder folder;
  write_file(folder.path() / "chain.yaml", chain(mass, length));
  const std::string tip = "    - {name: tip, point: tip, along: [z]}\n";
  const std::string end =
      "    - {name: end, point: end, along: [x]}\n    - {name: again, point: end, along: [x]}\n";
  const SceneCode code(fmt::format("scene: chain\nmodel: {}\neffects:\n  gravity: [0, 0, {:e}]\n  "
                                   "point_constraint:\n{}duration: 1\n",
                                   (folder.path() / "chain.yaml").string(), -9.81 * length,
                                   reversed ? end + tip : tip + end),
                       Variant::kPlain, {"--scalar", scalar});
  const Measurement motion = called(code, {{0.4, -0.7, 0.3}, {0.5, -1, 2}, {0, 0, 0}});
  EXPECT_EQ(motion.status, 0) << mass << ' ' << length;
  EXPECT_EQ(code.manifest("constrained_dynamics").at("rank"), 2);
  return {motion.values.begin(), motion.values.begin() + 3};
}

void expect_near(const Vector& a, const Vector& b, double relative) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k], b[k], relative * (1 + std::abs(a[k]))) << k;
  }
}

/// Free joints of a chain accelerate the same whatever the unit of length and the order of the
/// rows. The condition of A and of the scaled K is below 100 for equal masses: 1e2 roundings.
TEST(Rank, NeitherUnitsNorTheOrderOfRowsMatter) {
  const Vector metres = chain_accelerations(1, 1, false, "double");
  expect_near(metres, chain_accelerations(1, 1e3, false, "double"), 1e-12);
  expect_near(metres, chain_accelerations(1, 1e-3, false, "double"), 1e-12);
  expect_near(metres, chain_accelerations(1, 1, true, "double"), 1e-12);
  expect_near(metres, chain_accelerations(1, 1e3, true, "float"), 1e-4);
  expect_near(metres, chain_accelerations(1, 1e-3, false, "float"), 1e-4);
}

/// A branch of another mass leaves the other branch alone, and itself, as it is not driven, too.
TEST(Rank, MassesOfABranchDoNotMatter) {
  for (const double mass : {1e-6, 1e-3, 1e3, 1e6}) {
    const Vector in_double = chain_accelerations(mass, 1, false, "double");
    // the condition of A grows with the ratio of the masses: 1e6 of 1e-16, of 1e-7
    expect_near(in_double, chain_accelerations(mass, 1, true, "double"), 1e-8);
    EXPECT_NEAR(in_double[2], chain_accelerations(1, 1, false, "double")[2], 1e-12);
    EXPECT_NEAR(in_double[2], chain_accelerations(mass, 1, false, "float")[2], 1e-4);
  }
}

}  // namespace
}  // namespace treedyn::support
