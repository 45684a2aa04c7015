// A biped without rotors, in float: both feet clamped, against 50 digits, and standing for long.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/scene_reader.hpp"
#include "scenes/arm_scene.hpp"
#include "verify/scene_equations.hpp"

namespace treedyn::support {
namespace {

using Exact = std::vector<Real>;

std::string clamped_biped() {
  return fmt::format(
      "scene: clamped\nmodel: {}/models/biped.yaml\nbase: axes\neffects:\n  gravity: [0, 0, "
      "-9.81]\n  point_constraint:\n    - {{point: left_heel}}\n    - {{point: right_heel}}\n"
      "  orientation_constraint:\n    - {{name: left_flat, point: left_heel}}\n"
      "    - {{name: right_flat, point: right_heel}}\nduration: 1\n",
      TREEDYN_SOURCE_DIR);
}

/// x of M x = b, by Gauss with the largest pivots of each column.
Exact solved(std::vector<Exact> M, Exact b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i) {
      best = abs(M[i][k]) > abs(M[best][k]) ? i : best;
    }
    std::swap(M[k], M[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real share = M[i][k] / M[k][k];
      for (std::size_t j = k; j < n; ++j) {
        M[i][j] -= share * M[k][j];
      }
      b[i] -= share * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) {
      b[k] -= M[k][j] * b[j];
    }
    b[k] /= M[k][k];
  }
  return b;
}

/// qdd and lambda by [A, -J^T; J, 0], 6.2, in 50 digits.
Exact exact_motion(const model::Scene& scene, const CompiledModel::Inputs& state) {
  const auto digits = [](const Vector& x) {
    return Exact(x.begin(), x.end());
  };
  const verify::SceneEquations equations(scene, digits(state[0]), digits(state[1]), 0);
  const std::vector<verify::SceneEquations::Row> rows = equations.rows(scene.phases.front().active);
  const std::size_t n = state[0].size();
  const std::size_t size = n + rows.size();
  std::vector<Exact> M(size, Exact(size));
  Exact b(size);
  for (std::size_t i = 0; i < n; ++i) {
    b[i] = state[2][i] - equations.bias()[i];
    for (std::size_t j = 0; j < n; ++j) {
      M[i][j] = equations.inertia()[i][j];
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      M[i][n + k] = -rows[k].J[i];
      M[n + k][i] = rows[k].J[i];
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    b[n + k] = rows[k].wanted - rows[k].gamma;
  }
  return solved(M, b);
}

/// Positions, velocities and joint forces of a crouch, numbers of float.
CompiledModel::Inputs crouch(const std::vector<std::string>& joints, std::mt19937& engine) {
  const auto number = [&](double size) {
    return std::uniform_real_distribution<double>(-size, size)(engine);
  };
  const double bend = 0.6 + number(0.58);
  CompiledModel::Inputs state(3, Vector(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const bool knee = joints[k].find("knee") != std::string::npos;
    const bool pitch = joints[k].find("pitch") != std::string::npos;
    const double angle = (knee ? 2 * bend : pitch ? -bend : 0) + number(0.05);
    state[0][k] = static_cast<float>(angle);
    state[1][k] = static_cast<float>(number(0.5));
    state[2][k] = static_cast<float>(number(20));
  }
  return state;
}

/// The largest difference of [first, last) as a part of the largest number there.
double error_of(const Vector& values, const Exact& exact, std::size_t first, std::size_t last) {
  Real size = 0;
  Real error = 0;
  for (std::size_t k = first; k < last; ++k) {
    size = std::max(size, Real(abs(exact[k])));
    error = std::max(error, Real(abs(values[k] - exact[k])));
  }
  return Real(error / size).convert_to<double>();
}

/// Small pivots that are no dependence. The condition of the scaled K is below 1e3 in these
/// crouches, and its entries are sums of some ten terms of either sign: 1e4 roundings of float.
TEST(Crouch, AClampedBipedInFloatIsThatOf50Digits) {
  const SceneCode code(clamped_biped(), Variant::kPlain, {"--scalar", "float"});
  const model::Scene scene = description::read_scene((code.folder() / "scene.yaml").string());
  const std::vector<std::string>& joints = code.code().manifest().joints;
  const std::size_t n = joints.size();
  std::mt19937 engine(1);
  for (int trial = 0; trial < 200; ++trial) {
    const CompiledModel::Inputs state = crouch(joints, engine);
    const Exact exact = exact_motion(scene, state);
    const Measurement rounded = code.code().measure("constrained_dynamics", state);
    ASSERT_EQ(rounded.status, 0) << trial;
    ASSERT_EQ(rounded.values.size(), exact.size());
    const double motion = error_of(rounded.values, exact, 0, n);
    const double reactions = error_of(rounded.values, exact, n, exact.size());
    EXPECT_LT(motion, 1e-3) << trial;
    EXPECT_LT(reactions, 1e-3) << trial;
  }
}

std::string standing_biped() {
  std::string text = read_file(std::filesystem::path(TREEDYN_SOURCE_DIR) /
                               "models/scenes/biped_double_support.yaml");
  const std::string model = "model: ../";
  text.replace(text.find(model), model.size(),
               fmt::format("model: {}/models/", TREEDYN_SOURCE_DIR));
  return text + "stepping: {integrator: semi-implicit-euler, step: 0.001}\n";
}

/// Where the four points of the feet are, and the energy.
class Stance {
 public:
  Stance()
      : code_(generate_and_compile(
            fmt::format("{}/models/biped.yaml", TREEDYN_SOURCE_DIR),
            {"--base", "axes", "--gravity", "0,0,-9.81", "--effort", "0", "--functions",
             "point_positions,kinetic_energy,potential_energy"})) {}

  [[nodiscard]] double off(const Vector& q, const Vector& start) const {
    const Vector now = code_.call("point_positions", {q});
    const Vector then = code_.call("point_positions", {start});
    double most = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
      most = std::max(most, std::abs(now[k] - then[k]));
    }
    return most;
  }
  [[nodiscard]] double kinetic(const Vector& q, const Vector& qd) const {
    return code_.call("kinetic_energy", {q, qd})[0];
  }
  [[nodiscard]] double potential(const Vector& q) const {
    return code_.call("potential_energy", {q})[0];
  }

 private:
  CompiledModel code_;
};

/// Heels and toes stay within some ten roundings of positions of 1 m; behind the first 50 s nothing
/// moves, and the energy is what it was to some roundings of 790 J.
TEST(Crouch, ABipedStandsInFloatForAMillionSteps) {
  const SceneCode code(standing_biped(), Variant::kPlain, {"--scalar", "float"});
  const model::Scene scene = description::read_scene((code.folder() / "scene.yaml").string());
  const Stance stance;
  Vector start;
  for (const Real& x : scene.q0) {
    start.push_back(x.convert_to<double>());
  }
  const std::size_t n = start.size();
  Vector q = start;
  Vector qd(n);
  double settled = 0;
  for (int k = 0; k <= 1000000; ++k) {
    const Measurement next = code.code().measure("step", {q, qd, Vector(n)});
    ASSERT_EQ(next.status, 0) << k;
    if (k % 50000 == 0) {
      settled = k == 50000 ? stance.potential(q) : settled;
      EXPECT_LT(stance.off(q, start), 1e-5) << k;
      EXPECT_LT(stance.kinetic(q, qd), 1e-6) << k;
      EXPECT_TRUE(k < 50000 || std::abs(stance.potential(q) - settled) < 1e-6) << k;
    }
    q.assign(next.values.begin(), next.values.begin() + static_cast<std::ptrdiff_t>(n));
    qd.assign(next.values.begin() + static_cast<std::ptrdiff_t>(n),
              next.values.begin() + static_cast<std::ptrdiff_t>(2 * n));
  }
}

}  // namespace
}  // namespace treedyn::support
