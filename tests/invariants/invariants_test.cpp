// Laws of mechanics that generated code must obey, whatever the model: no second implementation.
#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <gtest/gtest.h>

#include "support/models.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

using support::Committed;
using support::CompiledModel;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kUnit = 0x1p-53;

std::vector<double> list(const Vector& x) { return {x.begin(), x.end()}; }
Vector vector(const std::vector<double>& x) {
  return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// The functions of one model in double.
class Dynamics {
 public:
  explicit Dynamics(const Committed& model)
      : code_(support::with_all_functions(model, "double", support::Variant::kPlain)) {}

  [[nodiscard]] Eigen::Index dof() const { return code_.manifest().dof; }
  [[nodiscard]] Matrix A(const Vector& q) const {
    const std::vector<double> values = code_.call("mass_matrix", {list(q)});
    return Eigen::Map<const Matrix>(values.data(), dof(), dof());
  }
  [[nodiscard]] Vector B(const Vector& q, const Vector& qd) const {
    return vector(code_.call("bias_force", {list(q), list(qd)}));
  }
  [[nodiscard]] Vector G(const Vector& q) const {
    return vector(code_.call("gravity_force", {list(q)}));
  }
  [[nodiscard]] Vector acceleration(const Vector& q, const Vector& qd, const Vector& tau) const {
    return vector(code_.call("forward_dynamics", {list(q), list(qd), list(tau)}));
  }
  [[nodiscard]] Vector force(const Vector& q, const Vector& qd, const Vector& qdd) const {
    return vector(code_.call("inverse_dynamics", {list(q), list(qd), list(qdd)}));
  }
  [[nodiscard]] double energy(const Vector& q, const Vector& qd) const {
    return code_.call("kinetic_energy", {list(q), list(qd)})[0] +
           code_.call("potential_energy", {list(q)})[0];
  }

 private:
  CompiledModel code_;
};

class Invariants : public testing::TestWithParam<Committed> {
 protected:
  /// Random coordinates, then a velocity with sum |qd_i| = 1.
  std::pair<Vector, Vector> state(Eigen::Index n) {
    const auto size = static_cast<std::size_t>(n);
    const Vector q = vector(random_.list(size, std::numbers::pi));
    const Vector qd = vector(random_.list(size));
    return {q, qd / qd.lpNorm<1>()};
  }
  Dynamics dynamics_{GetParam()};
  support::Random random_{7};
};

/// d/ds f(s) at 0 by the five-point rule; error 4 h^4/120 |f^(5)| + 1.5 |rounding of f| / h.
template <class Function>
auto derivative(const Function& f, double h) {
  return ((8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)).eval();
}

// Along q + s qd with sum |qd_i| <= 1 the entries of A are trigonometric sums of frequencies up to
// 2 (times polynomials of degree 2 in the slides), so |A^(5)| <= 2^5 max|A| by Bernstein's
// inequality.
constexpr double kStep = 1e-3;
constexpr double kTruncation = 32 * kStep * kStep * kStep * kStep / 30;

/// Error of the derivative of entries of A, which carry up to 4 N roundings each.
double tolerance(const Matrix& A) {
  const double rounding = 1.5 * 4 * static_cast<double>(A.rows()) * kUnit / kStep;
  return (kTruncation + rounding) * A.cwiseAbs().maxCoeff();
}

TEST_P(Invariants, MassMatrixIsSymmetricAndPositiveDefinite) {
  for (int k = 0; k < 100; ++k) {
    const auto [q, qd] = state(dynamics_.dof());
    const Matrix A = dynamics_.A(q);
    EXPECT_EQ(A, Matrix(A.transpose()));
    EXPECT_EQ(Eigen::LLT<Matrix>(A).info(), Eigen::Success);
  }
}

TEST_P(Invariants, MassMatrixRateMinusTwiceTheBiasDoesNoWork) {
  for (int k = 0; k < 50; ++k) {
    const auto [q, qd] = state(dynamics_.dof());
    const Matrix rate =
        derivative([&, &q = q, &qd = qd](double s) { return dynamics_.A(q + s * qd); }, kStep);
    const Vector B = dynamics_.B(q, qd);
    EXPECT_NEAR(qd.dot(rate * qd), 2 * qd.dot(B), tolerance(dynamics_.A(q)));
  }
}

TEST_P(Invariants, BiasForceIsTheChristoffelSumOfTheMassMatrix) {
  for (int k = 0; k < 20; ++k) {
    const auto [q, qd] = state(dynamics_.dof());
    Vector expected = Vector::Zero(q.size());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Vector unit = Vector::Unit(q.size(), j);
      const Matrix dA =
          derivative([&, &q = q](double s) { return dynamics_.A(q + s * unit); }, kStep);
      expected += qd[j] * dA * qd;           // dA_ki/dq_j qd_i qd_j
      expected[j] -= 0.5 * qd.dot(dA * qd);  // -1/2 dA_il/dq_j qd_i qd_l
    }
    const double error = (dynamics_.B(q, qd) - expected).cwiseAbs().maxCoeff();
    EXPECT_LE(error, 1.5 * tolerance(dynamics_.A(q)));
  }
}

TEST_P(Invariants, InverseDynamicsIsLinearInTheAccelerationWithMatrixA) {
  for (int k = 0; k < 100; ++k) {
    const auto [q, qd] = state(dynamics_.dof());
    const Vector qdd = state(dynamics_.dof()).second;
    const Matrix A = dynamics_.A(q);
    const Vector expected = A * qdd + dynamics_.B(q, qd) + dynamics_.G(q);
    const double scale =
        A.cwiseAbs().maxCoeff() + dynamics_.G(q).cwiseAbs().maxCoeff();  // |qdd|, |qd| <= 1
    const double error = (dynamics_.force(q, qd, qdd) - expected).cwiseAbs().maxCoeff();
    EXPECT_LE(error, 16 * static_cast<double>(q.size()) * kUnit * scale);
  }
}

TEST_P(Invariants, ForwardDynamicsUndoesInverseDynamics) {
  for (int k = 0; k < 100; ++k) {
    const auto [q, qd] = state(dynamics_.dof());
    const Vector qdd = state(dynamics_.dof()).second;
    const Vector tau = dynamics_.force(q, qd, qdd);
    const Vector residual = dynamics_.force(q, qd, dynamics_.acceleration(q, qd, tau)) - tau;
    const double scale =
        dynamics_.A(q).cwiseAbs().maxCoeff() + dynamics_.G(q).cwiseAbs().maxCoeff();
    EXPECT_LE(residual.cwiseAbs().maxCoeff(), 100 * static_cast<double>(q.size()) * kUnit * scale);
  }
}

TEST_P(Invariants, GravityForceIsTheSlopeOfThePotentialEnergy) {
  for (int k = 0; k < 50; ++k) {
    const auto [q, direction] = state(dynamics_.dof());
    const Vector rest = Vector::Zero(q.size());
    const auto along = [&, &q = q, &direction = direction](double s) {
      return Vector::Constant(1, dynamics_.energy(q + s * direction, rest));
    };
    double scale = 0;
    for (double s = -2 * kStep; s <= 2 * kStep; s += kStep) {
      scale = std::max(scale, std::fabs(along(s)[0]));
    }
    scale = std::max(scale, dynamics_.G(q).cwiseAbs().maxCoeff());
    const double rounding = 1.5 * 16 * static_cast<double>(q.size()) * kUnit / kStep;
    EXPECT_NEAR(derivative(along, kStep)[0], direction.dot(dynamics_.G(q)),
                (kTruncation + rounding) * scale);
  }
}

/// Position, velocity and the work of the joint forces.
struct Course {
  Vector q;
  Vector qd;
  double work = 0;
};

/// RK4 with the joint forces tau(t) = amplitude * sin(t).
Course integrate(const Dynamics& dynamics, Course run, const Vector& amplitude, double duration,
                 int steps) {
  const double h = duration / steps;
  const auto rate = [&](const Course& at, double t) {
    const Vector tau = amplitude * std::sin(t);
    return Course{at.qd, dynamics.acceleration(at.q, at.qd, tau), at.qd.dot(tau)};
  };
  const auto moved = [](const Course& from, const Course& by, double s) {
    return Course{from.q + s * by.q, from.qd + s * by.qd, from.work + s * by.work};
  };
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    const Course k1 = rate(run, t);
    const Course k2 = rate(moved(run, k1, h / 2), t + h / 2);
    const Course k3 = rate(moved(run, k2, h / 2), t + h / 2);
    const Course k4 = rate(moved(run, k3, h), t + h);
    run = moved(moved(moved(moved(run, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return run;
}

/// |E(end) - E(start) - work| of a run.
double energy_defect(const Dynamics& dynamics, const Course& start, const Vector& amplitude,
                     int steps) {
  const Course end = integrate(dynamics, start, amplitude, 0.02, steps);
  return std::fabs(dynamics.energy(end.q, end.qd) - dynamics.energy(start.q, start.qd) - end.work);
}

TEST_P(Invariants, EnergyGrowsByTheWorkOfTheJointForces) {
  const auto [q, qd] = state(dynamics_.dof());
  const Course start{q, qd, 0};
  const double scale = dynamics_.G(q).cwiseAbs().maxCoeff() + dynamics_.A(q).cwiseAbs().maxCoeff();
  const Vector amplitude = 0.1 * scale * Vector::Ones(q.size());
  const double coarse = energy_defect(dynamics_, start, amplitude, 50);
  const double fine = energy_defect(dynamics_, start, amplitude, 100);
  const double rounding =
      1e4 * static_cast<double>(q.size()) * kUnit * (scale + std::fabs(dynamics_.energy(q, qd)));
  EXPECT_LE(fine, std::max(coarse / 8, rounding));  // fourth order: 16
}

/// Robots on six base joints; the ground takes the momentum of all others.
class FreeRobot : public Invariants {};

TEST_P(FreeRobot, HasTheMomentumThatGravityGivesIt) {
  const auto [q, qd] = state(dynamics_.dof());
  const auto momentum = [&](const Course& run) {
    return Vector((dynamics_.A(run.q) * run.qd).head(3));
  };
  const Course start{q, qd, 0};
  const Vector none = Vector::Zero(q.size());
  const double duration = 0.02;
  const double weight = dynamics_.G(q)[2];  // d/dt p_z = -m g
  const auto defect = [&](int steps) {
    const Course end = integrate(dynamics_, start, none, duration, steps);
    const Vector expected = momentum(start) - Vector::Unit(3, 2) * weight * duration;
    return (momentum(end) - expected).cwiseAbs().maxCoeff();
  };
  const double rounding =
      1e4 * static_cast<double>(q.size()) * kUnit * (weight + dynamics_.A(q).cwiseAbs().maxCoeff());
  EXPECT_LE(defect(100), std::max(defect(50) / 8, rounding));
}

std::vector<Committed> free_robots() {
  std::vector<Committed> result = support::committed_models(TREEDYN_SOURCE_DIR);
  std::erase_if(result, [](const Committed& c) { return c.manifest.base != "axes"; });
  return result;
}

INSTANTIATE_TEST_SUITE_P(Models, FreeRobot, testing::ValuesIn(free_robots()),
                         [](const auto& model) { return support::test_name(model.param); });

INSTANTIATE_TEST_SUITE_P(Models, Invariants,
                         testing::ValuesIn(support::committed_models(TREEDYN_SOURCE_DIR)),
                         [](const auto& model) { return support::test_name(model.param); });

}  // namespace
}  // namespace treedyn
