// The shipped equations against mechanics: positions and rotations of the bodies, differenced in
// time with 50 digits. Nothing here is derived.
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "derive/user_robot.hpp"
#include "description/equation_list.hpp"
#include "engine/engine.hpp"

namespace treedyn {
namespace {

using support::Numbers;
using support::UserRobot;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

const Real kStep(
    "1e-12");  // of central differences: errors of order 1e-24, of their rounding 1e-26
const Real kDifference("1e-20");

struct Body {
  Real m;
  Vector r;
  Matrix R, J;
};

/// A robot, and the shipped equations of it.
class Shipped : public testing::Test {
 protected:
  Shipped() : robot_({{-1, 0, 1, 1, 0, 4}, "RPRRRP"}), at_(states()) {
    robot_.tree.links[4].joint.name = "left_hip_yaw";
    std::vector<model::EquationText> texts;
    for (const char* file : {"centre_of_mass", "momentum", "centroidal", "zero_moment_point",
                             "power", "coriolis", "left_leg"}) {
      const std::string path =
          TREEDYN_SOURCE_DIR "/models/equations/" + std::string(file) + ".yaml";
      std::stringstream text;
      text << std::ifstream(path).rdbuf();
      const auto more = description::equations_of_file(text.str(), path);
      texts.insert(texts.end(), more.begin(), more.end());
    }
    for (const auto& equation : equations::read_equations(texts, robot_.tree, robot_.points)) {
      equations_.emplace(equation.name, equation);
    }
    for (std::size_t i = 0; i < robot_.tree.links.size(); ++i) {
      model::Point point;
      point.link = static_cast<int>(i);
      point.at = robot_.tree.links[i].inertia.com;
      centres_.push_back(point);
    }
  }

  std::map<std::string, Numbers> states() {
    std::map<std::string, Numbers> result;
    for (const char* name : {"q", "qd", "qdd", "tau"}) {
      result[name] = robot_.random(robot_.tree.size());
    }
    return result;
  }

  /// q(t) and its rate on a parabola through the state.
  [[nodiscard]] std::map<std::string, Numbers> later(const Real& t) const {
    std::map<std::string, Numbers> result = at_;
    for (std::size_t i = 0; i < at_.at("q").size(); ++i) {
      result["q"][i] += t * at_.at("qd")[i] + t * t / 2 * at_.at("qdd")[i];
      result["qd"][i] += t * at_.at("qdd")[i];
    }
    return result;
  }

  Numbers value(const std::string& name, const std::map<std::string, Numbers>& at) {
    const equations::UserEquation& equation = equations_.at(name);
    std::vector<Numbers> inputs;
    for (const auto& argument : equation.arguments) {
      inputs.push_back(at.at(argument.name));
    }
    return UserRobot::run(robot_.derived(equation, formulate::Way::kToRoot), inputs);
  }
  Numbers value(const std::string& name) { return value(name, at_); }

  [[nodiscard]] std::vector<Body> bodies(const Real& t) const {
    engine::Engine<Real> engine(robot_.tree, centres_, robot_.gravity);
    const Numbers q = later(t).at("q");
    const Numbers p = engine.evaluate("point_positions", {q});
    const Numbers R = engine.evaluate("point_rotations", {q});
    std::vector<Body> result;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      const model::Inertia& inertia = robot_.tree.links[i].inertia;
      Body body{inertia.mass, Eigen::Map<const Vector>(p.data() + 3 * i),
                Eigen::Map<const Matrix>(R.data() + 9 * i, 3, 3),
                Eigen::Map<const Matrix>(inertia.about_com.data(), 3, 3)};
      body.J = body.R * body.J * body.R.transpose();
      result.push_back(body);
    }
    return result;
  }

  /// Masses, places, speeds and angular speeds at time t.
  struct Moving : Body {
    Vector v, omega;
  };
  [[nodiscard]] std::vector<Moving> moving(const Real& t) const {
    const auto before = bodies(t - kStep);
    const auto now = bodies(t);
    const auto after = bodies(t + kStep);
    std::vector<Moving> result;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Matrix W = (after[i].R - before[i].R) / (2 * kStep) * now[i].R.transpose();
      result.push_back(
          {now[i], (after[i].r - before[i].r) / (2 * kStep),
           Vector((W(2, 1) - W(1, 2)) / 2, (W(0, 2) - W(2, 0)) / 2, (W(1, 0) - W(0, 1)) / 2)});
    }
    return result;
  }

  struct Momenta {
    Vector linear = Vector::Zero();
    Vector angular = Vector::Zero();  ///< about the base origin
    Vector centre = Vector::Zero();
    Real mass = 0;
  };
  [[nodiscard]] Momenta momenta(const Real& t) const {
    Momenta result;
    for (const Moving& body : moving(t)) {
      result.linear += body.m * body.v;
      result.angular += body.m * body.r.cross(body.v) + body.J * body.omega;
      result.centre += body.m * body.r;
      result.mass += body.m;
    }
    result.centre /= result.mass;
    return result;
  }

  static Numbers list(const Vector& v) { return {v.data(), v.data() + 3}; }
  [[nodiscard]] Numbers times_qd(const Numbers& matrix) const {
    const std::size_t n = at_.at("qd").size();
    Numbers result(matrix.size() / n);
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      result[k / n] += matrix[k] * at_.at("qd")[k % n];
    }
    return result;
  }
  void expect_close(const Numbers& ours, const Numbers& expected,
                    const Real& tolerance = kDifference) {
    EXPECT_LT(support::distance(ours, expected), tolerance);
  }

  UserRobot robot_;
  std::map<std::string, Numbers> at_;
  std::vector<model::Point> centres_;
  std::map<std::string, equations::UserEquation> equations_;
};

TEST_F(Shipped, CentreOfMassAndItsMotion) {
  const Momenta now = momenta(0);
  expect_close(value("centre_of_mass"), list(now.centre));
  expect_close(times_qd(value("centre_of_mass_jacobian")), list(now.linear / now.mass));
  at_["qdd"].assign(at_["qdd"].size(), 0);
  const Vector rate = (momenta(kStep).linear - momenta(-kStep).linear) / (2 * kStep * now.mass);
  expect_close(value("centre_of_mass_bias"), list(rate));
}

TEST_F(Shipped, Momentum) {
  const Momenta now = momenta(0);
  expect_close(value("linear_momentum"), list(now.linear));
  expect_close(value("angular_momentum"), list(now.angular));
  expect_close(times_qd(value("centroidal_linear")), list(now.linear));
  expect_close(times_qd(value("centroidal_angular")),
               list(now.angular - now.centre.cross(now.linear)));
}

TEST_F(Shipped, ZeroMomentPointFromTheRateOfMomentum) {
  const Momenta now = momenta(0);
  const Momenta before = momenta(-kStep);
  const Momenta after = momenta(kStep);
  const Vector weight = now.mass * Vector(robot_.gravity[0], robot_.gravity[1], robot_.gravity[2]);
  expect_close(value("ground_force"), list((after.linear - before.linear) / (2 * kStep) - weight));
  expect_close(value("ground_moment"),
               list((after.angular - before.angular) / (2 * kStep) - now.centre.cross(weight)),
               Real("1e-10"));
}

TEST_F(Shipped, EnergyOfALimbAndPower) {
  Real energy = 0;
  const std::vector<Moving> all = moving(0);
  for (std::size_t i = 4; i < all.size(); ++i) {  // link 4 and what it carries
    energy += (all[i].m * all[i].v.dot(all[i].v) + all[i].omega.dot(all[i].J * all[i].omega)) / 2;
  }
  expect_close(value("left_leg_energy"), {energy});
  Numbers power = at_["tau"];
  Real total = 0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    power[i] *= at_["qd"][i];
    total += power[i];
  }
  expect_close(value("joint_power"), power);
  expect_close(value("total_power"), {total});
}

TEST_F(Shipped, CoriolisMatrixLeavesASkewMatrix) {
  engine::Engine<Real> engine(robot_.tree, robot_.points, robot_.gravity);
  const Numbers after = engine.evaluate("mass_matrix", {later(kStep).at("q")});
  const Numbers before = engine.evaluate("mass_matrix", {later(-kStep).at("q")});
  Numbers rate(after.size());
  for (std::size_t k = 0; k < rate.size(); ++k) {
    rate[k] = (after[k] - before[k]) / (2 * kStep);
  }
  expect_close(value("mass_matrix_rate"), rate);
  const Numbers C = value("coriolis_matrix");
  expect_close(times_qd(C), engine.evaluate("bias_force", {at_["q"], at_["qd"]}), Real("1e-40"));
  const auto n = static_cast<std::size_t>(robot_.tree.size());
  Numbers twice_C(n * n);  // dA/dt - 2 C is skew: its symmetric part vanishes
  for (std::size_t k = 0; k < n * n; ++k) {
    twice_C[k] = C[k] + C[k % n * n + k / n];
  }
  expect_close(twice_C, rate);
}

}  // namespace
}  // namespace treedyn
