#include "engine/engine.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "engine/outputs.hpp"
#include "support/random_tree.hpp"

namespace treedyn {
namespace {

using Engine = engine::Engine<double>;
using Eigen::VectorXd;

const model::Vector3 kGravity{0, 0, Real(-9.75)};

model::Tree chain(const std::string& types) {
  support::Dice dice(1);
  return support::random_tree(support::chain(types), dice);
}

model::Point point_on(int link, double x, double y, double z) {
  model::Point point;
  point.link = link;
  point.at = {Real(x), Real(y), Real(z)};
  return point;
}

std::string message_of(Engine& engine, const char* function,
                       const std::vector<std::vector<double>>& inputs) {
  try {
    engine.evaluate(function, inputs);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Engine, RejectsUnknownFunctionsAndWrongInputs) {
  Engine engine(chain("RP"));
  EXPECT_EQ(message_of(engine, "mass", {{0, 0}}), "engine: no function 'mass' with 1 inputs");
  EXPECT_EQ(message_of(engine, "bias_force", {{0, 0}}),
            "engine: no function 'bias_force' with 1 inputs");
  EXPECT_EQ(message_of(engine, "bias_force", {{0, 0}, {0}}),
            "engine: bias_force: input qd has 1 numbers; expected 2");
}

TEST(Engine, GivesEveryFunctionItsSize) {
  const model::Tree tree = chain("RPR");
  const std::vector<model::Point> points = {point_on(2, 0, 0, 0), point_on(1, 0, 1, 0)};
  Engine engine(tree, points, kGravity);
  for (const equations::Equation* function : engine::functions()) {
    std::vector<std::vector<double>> inputs;
    for (const equations::Argument& input : function->inputs) {
      inputs.emplace_back(static_cast<std::size_t>(input.rows.count(3, 2)), 0.5);
    }
    const std::vector<double> result = engine.evaluate(function->name, inputs);
    const int size = function->outputs.front().size(3, 2);
    EXPECT_EQ(result.size(), static_cast<std::size_t>(size)) << function->name;
    for (const double x : result) {
      EXPECT_TRUE(std::isfinite(x)) << function->name;
    }
  }
}

TEST(Engine, ForgetsEarlierStates) {
  const model::Tree tree = chain("RPRR");
  Engine engine(tree, {}, kGravity);
  support::Dice dice(2);
  const std::vector<double> q = dice.numbers(4, 1);
  const std::vector<double> qd = dice.numbers(4, 1);
  const auto first = engine.evaluate("bias_force", {q, qd});
  engine.evaluate("inverse_dynamics", {dice.numbers(4, 1), dice.numbers(4, 1), q});
  EXPECT_EQ(engine.evaluate("bias_force", {q, qd}), first);
}

TEST(Engine, AcceptsTreesWithoutPoints) {
  Engine engine(chain("RR"), {}, kGravity);
  EXPECT_TRUE(engine.evaluate("point_positions", {{0, 0}}).empty());
  EXPECT_TRUE(engine.evaluate("force_jacobian_transpose", {{0, 0}}).empty());
  EXPECT_EQ(engine.evaluate("applied_force", {{0, 0}, {}, {}}), (std::vector<double>{0, 0}));
}

TEST(Engine, HoldsPointsOfTheGround) {
  const std::vector<model::Point> points = {point_on(model::kGround, 1, 2, 3)};
  Engine engine(chain("RR"), points, kGravity);
  const std::vector<double> q{0.5, -0.25};
  EXPECT_EQ(engine.evaluate("point_positions", {q}), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(engine.evaluate("point_rotations", {q}),
            (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(engine.evaluate("point_velocities", {q, q}), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(engine.evaluate("force_jacobian_transpose", {q}), std::vector<double>(6, 0));
}

TEST(Engine, TreatsSeveralPointsOfOneLinkAlike) {
  const model::Tree tree = chain("RPR");
  const std::vector<model::Point> points = {point_on(2, 0.5, 0, 0), point_on(0, 1, 0, 0),
                                            point_on(2, 0.5, 0, 0)};
  Engine engine(tree, points, kGravity);
  const std::vector<double> p = engine.evaluate("point_positions", {{0.5, 0.25, 1}});
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(p[n], p[6 + n]);
  }
}

// q_1 = 2 u_0 + 1/2, q_2 = u_1: A_r = T^T A T and so on.
class Mimic : public testing::Test {
 protected:
  Mimic()
      : free_(chain("RRP")),
        reduced_(free_),
        points_{point_on(2, 0.25, 0.5, 0)},
        full_(free_, points_, kGravity) {
    reduced_.drives = {{0, 1, 0}, {0, 2, Real(0.5)}, {1, 1, 0}};
    reduced_.coordinates = {0, 2};
    T_ << 1, 0, 2, 0, 0, 1;
  }

  [[nodiscard]] VectorXd q(const VectorXd& u) const { return T_ * u + Eigen::Vector3d(0, 0.5, 0); }

  model::Tree free_;
  model::Tree reduced_;
  std::vector<model::Point> points_;
  Engine full_;
  Eigen::Matrix<double, 3, 2> T_;
  VectorXd u_ = Eigen::Vector2d(0.25, 0.5);
  VectorXd ud_ = Eigen::Vector2d(-1, 0.75);
  VectorXd udd_ = Eigen::Vector2d(0.5, 2);
};

// Below 1000 operations on numbers below 1000.
constexpr double kTolerance = 1000 * 1000 * std::numeric_limits<double>::epsilon();

TEST_F(Mimic, ReducesMassMatrix) {
  Engine engine(reduced_, points_, kGravity);
  ASSERT_EQ(engine.dof(), 2);
  Engine::Matrix A(3, 3);
  Engine::Matrix A_r(2, 2);
  full_.mass_matrix(q(u_), A);
  engine.mass_matrix(u_, A_r);
  EXPECT_LE((A_r - T_.transpose() * A * T_).cwiseAbs().maxCoeff(), kTolerance);
}

TEST_F(Mimic, ReducesForces) {
  Engine engine(reduced_, points_, kGravity);
  VectorXd tau(3);
  VectorXd tau_r(2);
  full_.inverse_dynamics(q(u_), T_ * ud_, T_ * udd_, tau);
  engine.inverse_dynamics(u_, ud_, udd_, tau_r);
  EXPECT_LE((tau_r - T_.transpose() * tau).cwiseAbs().maxCoeff(), kTolerance);
}

TEST_F(Mimic, ReducesJacobians) {
  Engine engine(reduced_, points_, kGravity);
  Engine::Matrix C(3, 3);
  Engine::Matrix C_r(2, 3);
  full_.force_jacobian_transpose(q(u_), C);
  engine.force_jacobian_transpose(u_, C_r);
  EXPECT_LE((C_r - T_.transpose() * C).cwiseAbs().maxCoeff(), kTolerance);
}

TEST_F(Mimic, SolvesForIndependentAccelerations) {
  Engine engine(reduced_, points_, kGravity);
  VectorXd tau(2);
  VectorXd back(2);
  engine.inverse_dynamics(u_, ud_, udd_, tau);
  engine.forward_dynamics(u_, ud_, tau, back);
  EXPECT_LE((back - udd_).cwiseAbs().maxCoeff(), kTolerance);
}

TEST_F(Mimic, KeepsVectorsOfIndependentJoints) {
  Engine engine(reduced_, points_, kGravity);
  Engine::Matrix c(9, 3);
  Engine::Matrix c_r(6, 2);
  full_.joint_to_com_vectors(q(u_), c);
  engine.joint_to_com_vectors(u_, c_r);
  EXPECT_LE((c_r.block<3, 1>(3, 0) - c.block<3, 1>(6, 0)).cwiseAbs().maxCoeff(), kTolerance);
  EXPECT_LE((c_r.block<3, 1>(3, 1) - c.block<3, 1>(6, 2)).cwiseAbs().maxCoeff(), kTolerance);
}

// Bias of a linear map at constant rates: gamma of the full tree at T ud.
TEST_F(Mimic, KeepsPointMotion) {
  Engine engine(reduced_, points_, kGravity);
  VectorXd full(3);
  VectorXd reduced(3);
  full_.point_bias_acceleration(q(u_), T_ * ud_, full);
  engine.point_bias_acceleration(u_, ud_, reduced);
  EXPECT_LE((full - reduced).cwiseAbs().maxCoeff(), kTolerance);
}

}  // namespace
}  // namespace treedyn
