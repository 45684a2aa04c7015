// The engine on the golden cases of EQUATIONS.md 9.

#include <gtest/gtest.h>

#include "common/real.hpp"
#include "engine/eigen_real.hpp"
#include "engine/engine.hpp"
#include "support/golden_tree.hpp"

namespace treedyn {
namespace {

template <class Scalar>
std::vector<Scalar> cast(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

template <class Scalar>
struct State {
  explicit State(const support::GoldenCase& golden)
      : q(cast<Scalar>(golden.q)),
        qd(cast<Scalar>(golden.qd)),
        qdd(cast<Scalar>(golden.qdd_in)),
        tau(cast<Scalar>(golden.tau)),
        f(cast<Scalar>(golden.f)),
        n(cast<Scalar>(golden.n)) {}
  std::vector<Scalar> q, qd, qdd, tau, f, n;
};

template <class Scalar>
std::vector<Scalar> sum(std::vector<Scalar> x, const std::vector<Scalar>& y, int sign) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += sign * y[i];
  }
  return x;
}

/// Every quantity of `expected` that the engine computes, by its name in the file.
template <class Scalar>
std::map<std::string, std::vector<Scalar>> compute(const support::GoldenCase& golden) {
  engine::Engine<Scalar> engine(golden.tree, golden.points, golden.gravity);
  const State<Scalar> s(golden);
  const auto Q = engine.evaluate("applied_force", {s.q, s.f, s.n});
  std::vector<Scalar> zero(s.q.size(), Scalar(0));
  return {
      {"A", engine.evaluate("mass_matrix", {s.q})},
      {"B", engine.evaluate("bias_force", {s.q, s.qd})},
      {"C", engine.evaluate("force_jacobian_transpose", {s.q})},
      {"H", engine.evaluate("moment_jacobian_transpose", {s.q})},
      {"G", sum(zero, engine.evaluate("gravity_force", {s.q}), -1)},
      {"R", engine.evaluate("point_rotations", {s.q})},
      {"gamma_f", engine.evaluate("point_bias_acceleration", {s.q, s.qd})},
      {"gamma_n", engine.evaluate("angular_bias_acceleration", {s.q, s.qd})},
      {"tau_id", sum(engine.evaluate("inverse_dynamics", {s.q, s.qd, s.qdd}), Q, -1)},
      {"qdd", engine.evaluate("forward_dynamics", {s.q, s.qd, sum(s.tau, Q, 1)})},
  };
}

template <class Scalar>
void expect_golden(double tolerance) {
  const std::vector<std::string> files = support::golden_files();
  ASSERT_EQ(files.size(), 18U);
  for (const std::string& file : files) {
    const support::GoldenCase golden = support::read_golden(file);
    for (const auto& [name, values] : compute<Scalar>(golden)) {
      EXPECT_LE(support::golden_error(values, golden.expected.at(name)), tolerance)
          << golden.name << " " << name;
    }
  }
}

TEST(Engine, ReproducesGoldenCasesInDouble) { expect_golden<double>(1e-12); }

// Long double and Real leave the rounding of the data: inputs and expected values have 17 digits.
TEST(Engine, ReproducesGoldenCasesInLongDouble) { expect_golden<long double>(1e-13); }

TEST(Engine, ReproducesGoldenCasesInFiftyDigits) { expect_golden<Real>(1e-13); }

}  // namespace
}  // namespace treedyn
