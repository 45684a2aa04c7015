// The generic engine: equations (1)-(11) evaluated with Eigen for any tree, at run time.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "engine/signatures.hpp"
#include "model/tree.hpp"

namespace treedyn::engine {

/// Evaluates the block expressions of equations/equations.hpp, and nothing else, so that generated
/// code can be compared with the equations themselves.
///
/// Scalar: float, double, long double, treedyn::Real, boost cpp_bin_float<100> (see engine.cpp).
/// All functions take and return *independent* coordinates u: if mimic joints are reduced
/// (model::Tree::drives), q = T u + q0, A_r = T^T A T, tau_r = T^T tau and so on; l_D and c_fD keep
/// the links of the independent joints. Sizes and units: engine/signatures.hpp and EQUATIONS.md; N
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

  /// Any function by name, inputs in the order of its signature, the output row-major.
  /// \throws std::invalid_argument for an unknown name or inputs of wrong number or size.
  std::vector<Scalar> evaluate(std::string_view function,
                               const std::vector<std::vector<Scalar>>& inputs);
  /// The same without allocation; the result is valid until the next call. \pre sizes fit.
  std::span<const Scalar> evaluate(Function function,
                                   std::span<const std::span<const Scalar>> inputs);

  /// The natural scale of every value of a function: the sum of the magnitudes of the terms of its
  /// equation, multiplied out down to masses, tensors and vectors of the links, which count with
  /// their norms: the same in every frame. Of accelerations |A^-1| (|tau| + |B| + |G| + |A| |qdd|)
  /// with such sums, of rotations 1. Allocates. \pre `inputs` as for `evaluate`
  std::vector<double> scales(std::string_view function,
                             const std::vector<std::vector<Scalar>>& inputs);

  void mass_matrix(In q, MatrixOut A);                       ///< (2)
  void bias_force(In q, In qd, Out B);                       ///< (3)
  void gravity_force(In q, Out G);                           ///< 6.5, left-hand side
  void inverse_dynamics(In q, In qd, In qdd, Out tau);       ///< (1)
  void forward_dynamics(In q, In qd, In tau, Out qdd);       ///< (1), \pre A is positive definite
  void point_positions(In q, Out p);                         ///< base frame
  void point_velocities(In q, In qd, Out v);                 ///< C^T qd
  void point_rotations(In q, Out R);                         ///< 9 P, link to base
  void force_jacobian_transpose(In q, MatrixOut C);          ///< (9)
  void moment_jacobian_transpose(In q, MatrixOut H);         ///< (11)
  void point_bias_acceleration(In q, In qd, Out gamma_f);    ///< 6.1
  void angular_bias_acceleration(In q, In qd, Out gamma_n);  ///< 6.1
  void joint_to_link_vectors(In q, MatrixOut l_D);           ///< (6)
  void joint_to_com_vectors(In q, MatrixOut c_fD);           ///< (7)
  void applied_force(In q, In f, In n, Out Q);               ///< (8), C f + H n
  Scalar kinetic_energy(In q, In qd);                        ///< 1/2 qd^T A qd
  Scalar potential_energy(In q);                             ///< zero at the base origin

 private:
  class Implementation;

  void write(Function function, std::initializer_list<std::span<const Scalar>> inputs, Out out);
  void write_matrix(Function function, In q, MatrixOut out);

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace treedyn::engine
