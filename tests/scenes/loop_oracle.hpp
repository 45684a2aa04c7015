// A closed loop by Eigen's decompositions: what generated functions of its scene have to give.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Dense>

#include "support/compiled.hpp"

namespace treedyn::support {

/// Two points of a model that coincide, or points that stay where they are; of known rank.
class LoopOracle {
 public:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;

  struct Motion {
    Vector qdd;
    Vector lambda;  ///< of least norm
  };

  /// \param options  of generate: base and gravity
  /// \param rank     of the rows where they hold
  /// \param place    of all points that stay; empty: the first point is on the second
  LoopOracle(const std::string& model, std::vector<std::string> options, int rank,
             std::vector<double> place = {})
      : rank_(rank), place_(std::move(place)), code_(compiled(model, std::move(options))) {}

  [[nodiscard]] int dof() const { return code_.manifest().dof; }

  /// Errors of the rows, m.
  [[nodiscard]] Vector errors(const Vector& q) const {
    const Vector p = call("point_positions", {q});
    if (place_.empty()) {
      return p.head(3) - p.segment(3, 3);
    }
    return p - Eigen::Map<const Vector>(place_.data(), static_cast<Eigen::Index>(place_.size()));
  }

  [[nodiscard]] Matrix jacobian(const Vector& q) const {
    const Vector C = call("force_jacobian_transpose", {q});
    const Eigen::Index width = C.size() / q.size();
    const Matrix J =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            C.data(), q.size(), width)
            .transpose();
    return place_.empty() ? Matrix(J.topRows(3) - J.middleRows(3, 3)) : J;
  }

  /// The state on the loop next to this one.
  void project(Vector& q, Vector& qd) const {
    for (int k = 0; k < 10; ++k) {
      q -= pseudo_inverse(jacobian(q)) * errors(q);
    }
    const Matrix J = jacobian(q);
    qd -= pseudo_inverse(J) * (J * qd);
  }

  /// Accelerations and reactions under joint forces beside gravity. \pre on the loop
  [[nodiscard]] Motion motion(const Vector& q, const Vector& qd, const Vector& force) const {
    const Eigen::Index n = q.size();
    const Matrix A = Eigen::Map<const Matrix>(call("mass_matrix", {q}).data(), n, n);
    const Vector h = call("inverse_dynamics", {q, qd, Vector::Zero(n)});
    Vector gamma = call("point_bias_acceleration", {q, qd});
    if (place_.empty()) {
      gamma = (gamma.head(3) - gamma.segment(3, 3)).eval();
    }
    const Matrix J = jacobian(q);
    const Matrix K = J * A.ldlt().solve(J.transpose());
    const Vector b = -gamma - J * A.ldlt().solve(force - h);
    Motion result;
    result.lambda = pseudo_inverse(K) * b;
    result.qdd = A.ldlt().solve(force - h + J.transpose() * result.lambda);
    return result;
  }

  [[nodiscard]] double energy(const Vector& q, const Vector& qd) const {
    return call("kinetic_energy", {q, qd})[0] + call("potential_energy", {q})[0];
  }

 private:
  static CompiledModel compiled(const std::string& model, std::vector<std::string> options) {
    options.insert(options.end(),
                   {"--effort", "0", "--functions",
                    "mass_matrix,inverse_dynamics,point_positions,force_jacobian_transpose,"
                    "point_bias_acceleration,kinetic_energy,potential_energy"});
    return generate_and_compile(model, options);
  }

  /// By the singular values that are not those of dependent rows.
  [[nodiscard]] Matrix pseudo_inverse(const Matrix& J) const {
    const Eigen::JacobiSVD<Matrix> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
    return svd.matrixV().leftCols(rank_) *
           svd.singularValues().head(rank_).cwiseInverse().asDiagonal() *
           svd.matrixU().leftCols(rank_).transpose();
  }

  [[nodiscard]] Vector call(const std::string& function, const std::vector<Vector>& inputs) const {
    CompiledModel::Inputs arrays;
    for (const Vector& input : inputs) {
      arrays.emplace_back(input.begin(), input.end());
    }
    const std::vector<double> values = code_.call(function, arrays);
    return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  int rank_;
  std::vector<double> place_;
  CompiledModel code_;
};

}  // namespace treedyn::support
