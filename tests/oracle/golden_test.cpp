// The oracle, MuJoCo and KDL on the frozen cases: they must agree before they may judge.
#include <filesystem>

#include <gtest/gtest.h>

#include "oracle/engines.hpp"
#include "oracle/functions.hpp"
#include "oracle/golden_robot.hpp"
#include "support/process.hpp"

namespace treedyn::oracle {
namespace {

using support::Json;
using Vector = std::vector<double>;

std::vector<Json> golden_cases() {
  std::vector<Json> result;
  for (const auto& entry :
       std::filesystem::directory_iterator(TREEDYN_SOURCE_DIR "/tests/data/golden")) {
    result.push_back(Json::parse(support::read_file(entry.path())));
  }
  EXPECT_EQ(result.size(), 18U);  // c01 to c18, EQUATIONS.md 9
  return result;
}

/// The rows and columns of an N x N matrix in the order of the robot.
Vector square(const GoldenRobot& golden, const Json& rows) {
  Vector result;
  for (const std::size_t i : golden.link) {
    for (const std::size_t j : golden.link) {
      result.push_back(rows.at(i).at(j).get<double>());
    }
  }
  return result;
}

/// EQUATIONS.md 9.
void expect_equal(const Json& data, const char* quantity, const Vector& x, const Vector& expected) {
  EXPECT_LE(support::error_of(x, expected, {}), 1e-12) << data.at("name") << " " << quantity;
}

Problem<double> problem_of(const Json& data, const GoldenRobot& golden) {
  Problem<double> result{golden.robot, numbers<3>(data.at("gravity")), {}};
  for (std::size_t i = 0; i < golden.link.size(); ++i) {
    result.points.push_back({static_cast<int>(i), numbers<3>(data.at("t").at(golden.link[i]))});
  }
  return result;
}

/// Columns of C and H (one block of 3 a link) in the order of the robot.
Vector blocks(const GoldenRobot& golden, const Json& rows) {
  Vector result;
  for (const std::size_t i : golden.link) {
    for (const std::size_t j : golden.link) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result.push_back(rows.at(i).at(3 * j + axis).get<double>());
      }
    }
  }
  return result;
}

/// A list of 3N numbers in the order of the robot.
Vector triples(const GoldenRobot& golden, const Json& list) {
  Vector result;
  for (const std::size_t i : golden.link) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back(list.at(3 * i + axis).get<double>());
    }
  }
  return result;
}

TEST(RecursiveOracle, MatchesTheGoldenCases) {
  for (const Json& data : golden_cases()) {
    const GoldenRobot golden = golden_robot(data);
    const Problem<double> problem = problem_of(data, golden);
    const Json& expected = data.at("expected");
    const Vector q = golden.rows(data.at("q"));
    const Vector qd = golden.rows(data.at("qd"));
    const auto of = [&](const char* function) {
      return evaluate<double>(problem, function, {q, qd});
    };
    Vector G = of("gravity_force");
    std::transform(G.begin(), G.end(), G.begin(), std::negate<>());
    expect_equal(data, "A", of("mass_matrix"), square(golden, expected.at("A")));
    expect_equal(data, "B", of("bias_force"), golden.rows(expected.at("B")));
    expect_equal(data, "G", G, golden.rows(expected.at("G")));
    expect_equal(data, "R", of("point_rotations"), golden.rows(expected.at("R")));
    expect_equal(data, "C", of("force_jacobian_transpose"), blocks(golden, expected.at("C")));
    expect_equal(data, "H", of("moment_jacobian_transpose"), blocks(golden, expected.at("H")));
    expect_equal(data, "gamma_f", of("point_bias_acceleration"),
                 triples(golden, expected.at("gamma_f")));
    expect_equal(data, "gamma_n", of("angular_bias_acceleration"),
                 triples(golden, expected.at("gamma_n")));
  }
}

/// A, and tau = A qdd + B - G, of another engine.
void expect_agreement(const Json& data, const GoldenRobot& golden, Engine& engine) {
  const Json& expected = data.at("expected");
  const Vector q = golden.rows(data.at("q"));
  const Vector qdd = golden.rows(data.at("qdd_in"));
  const Vector A = square(golden, expected.at("A"));
  expect_equal(data, "A", engine.mass_matrix(q), A);
  Vector tau = golden.rows(expected.at("B"));
  const Vector G = golden.rows(expected.at("G"));
  for (std::size_t i = 0; i < tau.size(); ++i) {
    tau[i] -= G[i];
    for (std::size_t j = 0; j < tau.size(); ++j) {
      tau[i] += A[i * tau.size() + j] * qdd[j];
    }
  }
  expect_equal(data, "tau", engine.inverse_dynamics(q, golden.rows(data.at("qd")), qdd), tau);
}

TEST(Kdl, MatchesTheGoldenCases) {
  for (const Json& data : golden_cases()) {
    const GoldenRobot golden = golden_robot(data);
    expect_agreement(data, golden, *make_kdl(golden.robot, numbers<3>(data.at("gravity"))));
  }
}

TEST(Mujoco, MatchesTheGoldenCasesThatItReads) {
  int read = 0;
  for (const Json& data : golden_cases()) {
    const GoldenRobot golden = golden_robot(data);
    if (mujoco_reads(golden.robot)) {
      ++read;
      expect_agreement(data, golden, *make_mujoco(golden.robot, numbers<3>(data.at("gravity"))));
    }
  }
  EXPECT_GE(read, 10);
}

}  // namespace
}  // namespace treedyn::oracle
