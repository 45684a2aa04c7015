// What a simulation needs to know of a scene's tree in one state.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "model/scene.hpp"

namespace treedyn::simulation {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using MatrixMap = Eigen::Map<const Matrix>;
using VectorMap = Eigen::Map<const Vector>;

/// What of the points is asked for.
struct Needs {
  bool points = false;     ///< p, C, gamma_f
  bool rotations = false;  ///< R, H, gamma_n
};
/// By the effects of a scene.
Needs needs_of(const model::Scene& scene);

/// The functions of INTERFACE.md 3 in one state, one array behind the other.
class Terms {
 public:
  Terms(int dof, int points, Needs needs);

  [[nodiscard]] MatrixMap A() const { return {at(0), dof_, dof_}; }         ///< (2)
  [[nodiscard]] VectorMap h() const { return {at(1), dof_}; }               ///< B + G
  [[nodiscard]] VectorMap p() const { return {at(2), 3 * points_}; }        ///< base frame, m
  [[nodiscard]] MatrixMap C() const { return {at(3), dof_, 3 * points_}; }  ///< (9)
  [[nodiscard]] VectorMap gamma_f() const { return {at(4), 3 * points_}; }  ///< 6.1
  [[nodiscard]] VectorMap R() const { return {at(5), 9 * points_}; }        ///< row-major, to base
  [[nodiscard]] MatrixMap H() const { return {at(6), dof_, 3 * points_}; }  ///< (11)
  [[nodiscard]] VectorMap gamma_n() const { return {at(7), 3 * points_}; }  ///< 6.1

  [[nodiscard]] int dof() const { return dof_; }
  [[nodiscard]] Needs needs() const { return needs_; }
  [[nodiscard]] std::span<double> values() { return values_; }
  /// p, C, R, H, those that are needed, one behind the other.
  void set_geometry(std::span<const double> values);
  /// Where array number k of the list above stands in `values`.
  [[nodiscard]] std::size_t offset(std::size_t k) const { return offsets_[k]; }

 private:
  [[nodiscard]] const double* at(std::size_t k) const { return values_.data() + offsets_[k]; }

  int dof_;
  int points_;
  Needs needs_;
  std::vector<std::size_t> offsets_;
  std::vector<double> values_;
};

/// Evaluates the terms; whoever computes them (the scene's own program, the generic engine).
class Dynamics {
 public:
  virtual ~Dynamics() = default;
  /// All terms that `terms.needs()` names. \pre sizes fit.
  virtual void evaluate(const Vector& q, const Vector& qd, Terms& terms) = 0;
  /// Only p, C, R, H.
  virtual void evaluate_geometry(const Vector& q, Terms& terms) = 0;
  /// Of one `evaluate`, sines and cosines among them, if they are counted.
  [[nodiscard]] virtual std::optional<long> operations() const { return std::nullopt; }
};

}  // namespace treedyn::simulation
