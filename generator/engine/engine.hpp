// The generic engine: equations (1)-(11) evaluated with Eigen for any tree, at run time.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "model/tree.hpp"

namespace treedyn::engine {

/// Evaluates the block expressions of equations/equations.hpp, and nothing else, so that generated
/// code can be compared with the equations themselves.
///
/// Scalar: float, double, long double, treedyn::Real, boost cpp_bin_float<100>.
/// All functions take and return *independent* coordinates u: if mimic joints are reduced
/// (model::Tree::drives), q = T u + q0, A_r = T^T A T, tau_r = T^T tau and so on; l_D and c_fD keep
/// the links of the independent joints. Sizes and units: equations/table.hpp and EQUATIONS.md; N
/// = dof(), P = points(). Matrices are row-major. Nothing is allocated after construction, except
/// by the std::vector form of `evaluate` and by software floats themselves.
template <class Scalar>
class Engine {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using In = const Eigen::Ref<const Vector>&;
  using Out = Eigen::Ref<Vector>;
  using MatrixOut = Eigen::Ref<Matrix>;

  /// \param points   points attached to links; points on the ground have zero columns
  /// \param gravity  m/s^2, base frame
  Engine(const model::Tree& tree, std::span<const model::Point> points,
         const model::Vector3& gravity);
  /// The model's own points, gravity 0, 0, -9.81.
  explicit Engine(const model::Tree& tree);
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;
  ~Engine();

  [[nodiscard]] int dof() const;
  [[nodiscard]] int points() const;

  /// Any of `functions` (engine/outputs.hpp), inputs in the order of its row in
  /// equations/table.hpp; the output is row-major. \throws std::invalid_argument for an unknown
  /// name or inputs of wrong number or size.
  std::vector<Scalar> evaluate(std::string_view function,
                               const std::vector<std::vector<Scalar>>& inputs);
  /// The same without allocation; the result is valid until the next call. \pre there is such a
  /// function, sizes fit
  std::span<const Scalar> evaluate(std::string_view function,
                                   std::span<const std::span<const Scalar>> inputs);

  /// The natural scale of every value of a function: the sum of the magnitudes of the terms of its
  /// equation, multiplied out down to masses, tensors and vectors of the links, which count with
  /// their norms: the same in every frame. Of accelerations |A^-1| (|tau| + |B| + |G| + |A| |qdd|)
  /// with such sums, of rotations 1. Allocates. \pre `inputs` as for `evaluate`
  std::vector<double> scales(std::string_view function,
                             const std::vector<std::vector<Scalar>>& inputs);

  /// (2)
  void mass_matrix(In q, MatrixOut A) { write("mass_matrix", {view(q)}, A); }
  /// (3)
  void bias_force(In q, In qd, Out B) { write("bias_force", {view(q), view(qd)}, B); }
  /// 6.5, left-hand side
  void gravity_force(In q, Out G) { write("gravity_force", {view(q)}, G); }
  /// (1)
  void inverse_dynamics(In q, In qd, In qdd, Out tau) {
    write("inverse_dynamics", {view(q), view(qd), view(qdd)}, tau);
  }
  /// (1), \pre A is positive definite
  void forward_dynamics(In q, In qd, In tau, Out qdd) {
    write("forward_dynamics", {view(q), view(qd), view(tau)}, qdd);
  }
  /// base frame
  void point_positions(In q, Out p) { write("point_positions", {view(q)}, p); }
  /// C^T qd
  void point_velocities(In q, In qd, Out v) { write("point_velocities", {view(q), view(qd)}, v); }
  /// 9 P, link to base
  void point_rotations(In q, Out R) { write("point_rotations", {view(q)}, R); }
  /// (9)
  void force_jacobian_transpose(In q, MatrixOut C) {
    write("force_jacobian_transpose", {view(q)}, C);
  }
  /// (11)
  void moment_jacobian_transpose(In q, MatrixOut H) {
    write("moment_jacobian_transpose", {view(q)}, H);
  }
  /// 6.1
  void point_bias_acceleration(In q, In qd, Out gamma_f) {
    write("point_bias_acceleration", {view(q), view(qd)}, gamma_f);
  }
  /// 6.1
  void angular_bias_acceleration(In q, In qd, Out gamma_n) {
    write("angular_bias_acceleration", {view(q), view(qd)}, gamma_n);
  }
  /// (7)
  void joint_to_com_vectors(In q, MatrixOut c_fD) {
    write("joint_to_com_vectors", {view(q)}, c_fD);
  }
  /// (8), C f + H n
  void applied_force(In q, In f, In n, Out Q) {
    write("applied_force", {view(q), view(f), view(n)}, Q);
  }
  /// 1/2 qd^T A qd
  Scalar kinetic_energy(In q, In qd) { return value("kinetic_energy", {view(q), view(qd)}); }
  /// Zero at the base origin.
  Scalar potential_energy(In q) { return value("potential_energy", {view(q)}); }

 private:
  class Implementation;
  using View = std::span<const Scalar>;

  static View view(In x) { return {x.data(), static_cast<std::size_t>(x.size())}; }
  Scalar value(std::string_view function, std::initializer_list<View> inputs) {
    return evaluate(function, std::span<const View>(inputs.begin(), inputs.size())).front();
  }
  template <class Numbers>
  void write(std::string_view function, std::initializer_list<View> inputs, Numbers& out) {
    const View result = evaluate(function, std::span<const View>(inputs.begin(), inputs.size()));
    out = Eigen::Map<const typename Numbers::PlainObject>(result.data(), out.rows(), out.cols());
  }

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace treedyn::engine
