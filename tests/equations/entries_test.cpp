// The block equations against the entry formulas that EQUATIONS.md 3 gives beside them.
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "common/index.hpp"
#include "engine/engine.hpp"
#include "equations/kinematics.hpp"
#include "support/random_tree.hpp"

namespace treedyn {
namespace {

using Vector3 = equations::Vector3<double>;
using Matrix3 = equations::Matrix3<double>;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd random_vector(int n, support::Dice& dice) {
  const std::vector<double> x = dice.numbers(to_index(n), 1.5);
  return Eigen::Map<const VectorXd>(x.data(), n);
}

/// The entries of (2), (3), (9), (11) and 6.1, loop by loop.
class Entries {
 public:
  Entries(const model::Tree& tree, const std::vector<model::Point>& points, const VectorXd& q,
          const VectorXd& qd)
      : tree_(tree),
        constants_(equations::constants_of<double>(
            tree, points, [](const Real& x) { return static_cast<double>(x); })),
        poses_(tree.links.size()),
        qd_(qd) {
    const VectorXd sine = q.array().sin();
    const VectorXd cosine = q.array().cos();
    equations::compute_poses<double>(constants_, {view(sine), view(cosine), view(q)}, poses_);
  }

  [[nodiscard]] int size() const { return tree_.size(); }
  [[nodiscard]] bool reaches(int i, int j) const { return model::reaches(tree_, i, j); }
  [[nodiscard]] double sigma(int i) const { return constants_.links[to_index(i)].revolute ? 1 : 0; }
  [[nodiscard]] Vector3 z(int i) const { return poses_.z[to_index(i)]; }
  [[nodiscard]] double m(int i) const { return constants_.links[to_index(i)].mass; }
  [[nodiscard]] Matrix3 J(int i) const {
    const Matrix3& R = poses_.R[to_index(i)];
    return R * constants_.links[to_index(i)].inertia * R.transpose();
  }
  [[nodiscard]] Vector3 com(int i) const {
    return poses_.O[to_index(i)] + poses_.R[to_index(i)] * constants_.links[to_index(i)].com;
  }
  [[nodiscard]] Vector3 point(int p) const {
    const auto& point = constants_.points[to_index(p)];
    return poses_.O[to_index(point.link)] + poses_.R[to_index(point.link)] * point.at;
  }
  [[nodiscard]] int carrier(int p) const { return constants_.points[to_index(p)].link; }
  [[nodiscard]] Vector3 from_joint(int j, const Vector3& x) const {
    return x - poses_.P[to_index(j)];
  }

  [[nodiscard]] Vector3 omega(int i) const {
    Vector3 sum = Vector3::Zero();
    for (int j = i; j >= 0; j = tree_.links[to_index(j)].father) {
      sum += sigma(j) * qd_(j) * z(j);
    }
    return sum;
  }
  [[nodiscard]] Vector3 omega_f(int j) const { return omega(j) - sigma(j) * qd_(j) * z(j); }
  [[nodiscard]] Vector3 zd(int j) const { return omega_f(j).cross(z(j)); }

  [[nodiscard]] Vector3 alpha0(int i) const {
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j <= i; ++j) {
      if (reaches(i, j)) {
        sum += sigma(j) * qd_(j) * zd(j);
      }
    }
    return sum;
  }

  /// a0 of point x of link i: T1 + T2 + T3.
  [[nodiscard]] Vector3 a0(int i, const Vector3& x) const {
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j <= i; ++j) {
      if (!reaches(i, j)) {
        continue;
      }
      const Vector3 c_ij = from_joint(j, x);
      Vector3 inner = omega_f(j).cross(c_ij);
      for (int k = j; k <= i; ++k) {
        if (reaches(i, k) && reaches(k, j)) {
          inner += sigma(k) * qd_(k) * z(k).cross(from_joint(k, x));
        }
      }
      sum += sigma(j) * qd_(j) * zd(j).cross(c_ij);
      sum += 2 * (1 - sigma(j)) * qd_(j) * zd(j);
      sum += sigma(j) * qd_(j) * z(j).cross(inner);
    }
    return sum;
  }

  [[nodiscard]] Vector3 v(int k, const Vector3& x) const {
    return sigma(k) * z(k).cross(from_joint(k, x)) + (1 - sigma(k)) * z(k);
  }

  [[nodiscard]] MatrixXd A() const {
    MatrixXd result = MatrixXd::Zero(size(), size());
    for (int k = 0; k < size(); ++k) {
      for (int l = 0; l < size(); ++l) {
        for (int i = 0; i < size(); ++i) {
          if (reaches(i, k) && reaches(i, l)) {
            result(k, l) +=
                m(i) * v(k, com(i)).dot(v(l, com(i))) + sigma(k) * sigma(l) * z(k).dot(J(i) * z(l));
          }
        }
      }
    }
    return result;
  }

  [[nodiscard]] VectorXd B() const {
    VectorXd result = VectorXd::Zero(size());
    for (int k = 0; k < size(); ++k) {
      for (int i = 0; i < size(); ++i) {
        if (reaches(i, k)) {
          const Vector3 force = m(i) * a0(i, com(i));
          const Vector3 moment = from_joint(k, com(i)).cross(force) + J(i) * alpha0(i) +
                                 omega(i).cross(J(i) * omega(i));
          result(k) += sigma(k) * z(k).dot(moment) + (1 - sigma(k)) * z(k).dot(force);
        }
      }
    }
    return result;
  }

 private:
  static std::span<const double> view(const VectorXd& x) {
    return {x.data(), to_index(int(x.size()))};
  }

  const model::Tree& tree_;
  equations::Constants<double> constants_;
  equations::Poses<double> poses_;
  VectorXd qd_;
};

/// Entries of 8 links come from below 8 * 8 * 100 operations on numbers of the size of the largest
/// partial sums, which exceed the largest entry by less than 50 for these trees (limits of the
/// dice).
constexpr double kTolerance = 8 * 8 * 100 * 50 * std::numeric_limits<double>::epsilon();

void expect_near(const MatrixXd& actual, const MatrixXd& expected) {
  const double scale = std::max(1.0, expected.cwiseAbs().maxCoeff());
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), kTolerance * scale);
}

template <class Check>
void for_random_trees(const Check& check) {
  support::Dice dice(3);
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 1 + dice.below(8);
    const model::Tree tree = support::random_tree(support::random_shape(n, dice), dice);
    std::vector<model::Point> points = support::random_points(tree, 3, dice);
    for (model::Point& point : points) {
      point.link = std::max(point.link, 0);
    }
    const VectorXd q = random_vector(n, dice);
    const VectorXd qd = random_vector(n, dice);
    engine::Engine<double> engine(tree, points, {0, 0, Real(-9.75)});
    const Entries entries(tree, points, q, qd);
    check(engine, entries, q, qd);
  }
}

using Engine = engine::Engine<double>;

TEST(MassMatrix, HasEntriesOfItsSource) {
  for_random_trees([](Engine& engine, const Entries& entries, const VectorXd& q, const VectorXd&) {
    Engine::Matrix A(engine.dof(), engine.dof());
    engine.mass_matrix(q, A);
    expect_near(A, entries.A());
  });
}

TEST(BiasForce, HasEntriesOfItsSource) {
  for_random_trees(
      [](Engine& engine, const Entries& entries, const VectorXd& q, const VectorXd& qd) {
        VectorXd B(engine.dof());
        engine.bias_force(q, qd, B);
        expect_near(B, entries.B());
      });
}

TEST(Jacobians, HaveEntriesOfTheirSource) {
  for_random_trees([](Engine& engine, const Entries& entries, const VectorXd& q, const VectorXd&) {
    Engine::Matrix C(engine.dof(), 9);
    Engine::Matrix H(engine.dof(), 9);
    engine.force_jacobian_transpose(q, C);
    engine.moment_jacobian_transpose(q, H);
    Engine::Matrix C_entries = Engine::Matrix::Zero(engine.dof(), 9);
    Engine::Matrix H_entries = Engine::Matrix::Zero(engine.dof(), 9);
    for (int p = 0; p < 3; ++p) {
      for (int k = 0; k < engine.dof(); ++k) {
        if (entries.reaches(entries.carrier(p), k)) {
          C_entries.block<1, 3>(k, 3 * p) = entries.v(k, entries.point(p)).transpose();
          H_entries.block<1, 3>(k, 3 * p) = entries.sigma(k) * entries.z(k).transpose();
        }
      }
    }
    expect_near(C, C_entries);
    expect_near(H, H_entries);
  });
}

TEST(AccelerationRows, HaveEntriesOfTheirSource) {
  for_random_trees(
      [](Engine& engine, const Entries& entries, const VectorXd& q, const VectorXd& qd) {
        VectorXd gamma_f(9);
        VectorXd gamma_n(9);
        engine.point_bias_acceleration(q, qd, gamma_f);
        engine.angular_bias_acceleration(q, qd, gamma_n);
        for (int p = 0; p < 3; ++p) {
          expect_near(gamma_f.segment<3>(3 * p), entries.a0(entries.carrier(p), entries.point(p)));
          expect_near(gamma_n.segment<3>(3 * p), entries.alpha0(entries.carrier(p)));
        }
      });
}

TEST(AppliedForce, IsSumOfForcesAndMoments) {
  for_random_trees([](Engine& engine, const Entries&, const VectorXd& q, const VectorXd&) {
    support::Dice dice(8);
    const VectorXd f = random_vector(9, dice);
    const VectorXd n = random_vector(9, dice);
    Engine::Matrix C(engine.dof(), 9);
    Engine::Matrix H(engine.dof(), 9);
    VectorXd Q(engine.dof());
    engine.force_jacobian_transpose(q, C);
    engine.moment_jacobian_transpose(q, H);
    engine.applied_force(q, f, n, Q);
    expect_near(Q, C * f + H * n);
  });
}

}  // namespace
}  // namespace treedyn
