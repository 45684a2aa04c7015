// Facts about A, B, G and the energies that need no second implementation, in 50 digits.
#include <gtest/gtest.h>

#include "common/real.hpp"
#include "engine/eigen_real.hpp"
#include "engine/engine.hpp"
#include "engine/inertia_factor.hpp"
#include "support/random_tree.hpp"

namespace treedyn {
namespace {

using Engine = engine::Engine<Real>;
using Vector = Engine::Vector;
using Matrix = Engine::Matrix;

// Central differences with h = 1e-12 of functions of third derivatives below 1e4 are wrong by less
// than 1e4 h^2 = 1e-20; rounding adds 1e-48 / h = 1e-36.
const Real kStep("1e-12");
const Real kDifferenceTolerance("1e-20");
// 50 digits and below 10^5 operations on numbers below 10^4.
const Real kRoundingTolerance("1e-40");

struct Case {
  model::Tree tree;
  Engine engine;
  Vector q, qd;
};

Vector random_vector(int n, support::Dice& dice) {
  Vector x(n);
  for (int i = 0; i < n; ++i) {
    x(i) = dice.number(1.5);
  }
  return x;
}

template <class Check>
void for_random_trees(int trials, const Check& check) {
  support::Dice dice(5);
  for (int trial = 0; trial < trials; ++trial) {
    const int n = 1 + dice.below(6);
    const model::Tree tree = support::random_tree(support::random_shape(n, dice), dice);
    const std::vector<model::Point> points = support::random_points(tree, 2, dice);
    Case c{tree, Engine(tree, points, {Real(1), Real(2), Real(-9)}), random_vector(n, dice),
           random_vector(n, dice)};
    check(c);
  }
}

Matrix mass_matrix(Case& c, const Vector& q) {
  Matrix A(c.tree.dof(), c.tree.dof());
  c.engine.mass_matrix(q, A);
  return A;
}

Real largest(const Matrix& m) { return m.size() == 0 ? Real(0) : Real(m.cwiseAbs().maxCoeff()); }

/// dA/dq_k by central differences.
Matrix mass_matrix_slope(Case& c, int k) {
  Vector forward = c.q;
  Vector backward = c.q;
  forward(k) += kStep;
  backward(k) -= kStep;
  return (mass_matrix(c, forward) - mass_matrix(c, backward)) / (2 * kStep);
}

TEST(MassMatrix, IsSymmetric) {
  for_random_trees(20, [](Case& c) {
    const Matrix A = mass_matrix(c, c.q);
    EXPECT_LE(largest(A - A.transpose()), kRoundingTolerance);
  });
}

TEST(MassMatrix, IsPositiveDefinite) {
  for_random_trees(20, [](Case& c) {
    Matrix A = mass_matrix(c, c.q);
    engine::factorize(A);
    for (int i = 0; i < c.tree.dof(); ++i) {
      EXPECT_GT(A(i, i), Real(0));
    }
  });
}

TEST(BiasForce, FollowsFromChristoffelSymbolsOfMassMatrix) {
  for_random_trees(12, [](Case& c) {
    const int n = c.tree.dof();
    Vector expected = Vector::Zero(n);
    for (int k = 0; k < n; ++k) {
      const Matrix slope = mass_matrix_slope(c, k);  // dA/dq_k
      expected += slope * c.qd * c.qd(k);
      expected(k) -= c.qd.dot(slope * c.qd) / 2;
    }
    Vector B(n);
    c.engine.bias_force(c.q, c.qd, B);
    EXPECT_LE(largest(B - expected), kDifferenceTolerance);
  });
}

TEST(BiasForce, DoesNoWorkBesidesThatOfChangingMassMatrix) {
  for_random_trees(12, [](Case& c) {
    Real work = 0;
    for (int k = 0; k < c.tree.dof(); ++k) {
      work += c.qd(k) * c.qd.dot(mass_matrix_slope(c, k) * c.qd);
    }
    Vector B(c.tree.dof());
    c.engine.bias_force(c.q, c.qd, B);
    EXPECT_LE(abs(work - 2 * c.qd.dot(B)), kDifferenceTolerance);
  });
}

TEST(GravityForce, IsGradientOfPotentialEnergy) {
  for_random_trees(12, [](Case& c) {
    Vector G(c.tree.dof());
    c.engine.gravity_force(c.q, G);
    for (int k = 0; k < c.tree.dof(); ++k) {
      Vector forward = c.q;
      Vector backward = c.q;
      forward(k) += kStep;
      backward(k) -= kStep;
      const Real slope =
          (c.engine.potential_energy(forward) - c.engine.potential_energy(backward)) / (2 * kStep);
      EXPECT_LE(abs(G(k) - slope), kDifferenceTolerance);
    }
  });
}

TEST(KineticEnergy, IsHalfOfMassMatrixForm) {
  for_random_trees(12, [](Case& c) {
    const Real expected = c.qd.dot(mass_matrix(c, c.q) * c.qd) / 2;
    EXPECT_LE(abs(c.engine.kinetic_energy(c.q, c.qd) - expected), kRoundingTolerance);
  });
}

TEST(ForwardDynamics, InvertsInverseDynamics) {
  for_random_trees(12, [](Case& c) {
    support::Dice dice(9);
    const Vector qdd = random_vector(c.tree.dof(), dice);
    Vector tau(c.tree.dof());
    Vector back(c.tree.dof());
    c.engine.inverse_dynamics(c.q, c.qd, qdd, tau);
    c.engine.forward_dynamics(c.q, c.qd, tau, back);
    EXPECT_LE(largest(back - qdd), kRoundingTolerance * 1000);  // condition of A
  });
}

TEST(PointVelocities, AreSlopesOfPositions) {
  for_random_trees(12, [](Case& c) {
    Vector forward(6);
    Vector backward(6);
    Vector v(6);
    c.engine.point_positions(c.q + kStep * c.qd, forward);
    c.engine.point_positions(c.q - kStep * c.qd, backward);
    c.engine.point_velocities(c.q, c.qd, v);
    EXPECT_LE(largest((forward - backward) / (2 * kStep) - v), kDifferenceTolerance);
  });
}

TEST(PointBiasAcceleration, IsSlopeOfVelocitiesAtConstantRates) {
  for_random_trees(12, [](Case& c) {
    Vector forward(6);
    Vector backward(6);
    Vector gamma(6);
    c.engine.point_velocities(c.q + kStep * c.qd, c.qd, forward);
    c.engine.point_velocities(c.q - kStep * c.qd, c.qd, backward);
    c.engine.point_bias_acceleration(c.q, c.qd, gamma);
    EXPECT_LE(largest((forward - backward) / (2 * kStep) - gamma), kDifferenceTolerance);
  });
}

TEST(AngularBiasAcceleration, IsSlopeOfAngularVelocityAtConstantRates) {
  for_random_trees(12, [](Case& c) {
    const auto omega = [&](const Vector& q) {
      Matrix H(c.tree.dof(), 6);
      c.engine.moment_jacobian_transpose(q, H);
      return Vector(H.transpose() * c.qd);
    };
    Vector gamma(6);
    c.engine.angular_bias_acceleration(c.q, c.qd, gamma);
    const Vector slope = (omega(c.q + kStep * c.qd) - omega(c.q - kStep * c.qd)) / (2 * kStep);
    EXPECT_LE(largest(slope - gamma), kDifferenceTolerance);
  });
}

TEST(PointRotations, TurnWithMomentJacobian) {  // dR/dt = Λ(ω) R
  for_random_trees(12, [](Case& c) {
    Vector forward(18);
    Vector backward(18);
    Vector R(18);
    Matrix H(c.tree.dof(), 6);
    c.engine.point_rotations(c.q + kStep * c.qd, forward);
    c.engine.point_rotations(c.q - kStep * c.qd, backward);
    c.engine.point_rotations(c.q, R);
    c.engine.moment_jacobian_transpose(c.q, H);
    const Vector omega = H.transpose() * c.qd;
    const Vector slope = (forward - backward) / (2 * kStep);
    for (int p = 0; p < 2; ++p) {
      for (int col = 0; col < 3; ++col) {
        const auto entry = [&](const Vector& m, int row) {
          return m(9 * p + 3 * row + col);
        };
        for (int row = 0; row < 3; ++row) {
          const int a = (row + 1) % 3;
          const int b = (row + 2) % 3;
          const Real turned = omega(3 * p + a) * entry(R, b) - omega(3 * p + b) * entry(R, a);
          EXPECT_LE(abs(entry(slope, row) - turned), kDifferenceTolerance);
        }
      }
    }
  });
}

}  // namespace
}  // namespace treedyn
