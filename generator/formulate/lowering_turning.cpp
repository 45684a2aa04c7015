// Turning bodies: Ω = Λ(α) + Λ(ω)² link by link, and the moments that it needs.
#include <optional>

#include "common/index.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

/// An axis that coincides with a coordinate axis: which, and in which direction.
struct CoordinateAxis {
  std::size_t index = 0;
  bool negative = false;

  [[nodiscard]] Expr signed_value(Expr x) const { return negative ? -x : x; }
};

std::optional<CoordinateAxis> coordinate_axis(const Vec3& v) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (v[(k + 1) % 3].is_zero() && v[(k + 2) % 3].is_zero() && v[k].is_constant() &&
        identical(abs(v[k].value()), 1)) {
      return CoordinateAxis{k, v[k].value() < 0};
    }
  }
  return std::nullopt;
}

/// Λ(α) + Λ(ω)².
Mat3 turning_tensor(const Vec3& alpha, const Vec3& omega) {
  Mat3 Omega = skew_squared(omega);
  Omega[0][1] -= alpha[2];
  Omega[0][2] += alpha[1];
  Omega[1][0] += alpha[2];
  Omega[1][2] -= alpha[0];
  Omega[2][0] -= alpha[1];
  Omega[2][1] += alpha[0];
  return Omega;
}

}  // namespace

/// α and Ω of link i. Ω_i z = Ω_f z for the common axis z, so where z is a coordinate axis of the
/// father the third column of Ω_i is the father's column along the axis, rotated, and α follows
/// from it:
///   Omega_xz = omega_x omega_z + alpha_y,  Omega_yz = omega_y omega_z - alpha_x,
///   Omega_zz = -omega_x^2 - omega_y^2.
void Lowering::turn(const derive::Turning& turning, int i) {
  const Kinematics& k = task_.kinematics;
  const int f = father(i);
  const bool root = f == kBase;
  std::vector<Squares>& squares = squares_[turning.Omega];
  squares.resize(to_index(task_.tree.size()));
  Squares& s = squares[to_index(i)];
  const Vec3 omega = frames_.in(of(turning.omega, i).vector, i);
  const Vec3 of_father = root ? Vec3{} : frames_.in(of(turning.alpha, f).vector, f);
  const Vec3 father_omega = root ? Vec3{} : frames_.in(of(turning.omega, f).vector, f);
  Vec3 alpha = frames_.moved(of_father, f, i) +
               frames_.in(of(value(turning.alpha).operands.front(), i).vector, i);
  const std::optional<CoordinateAxis> axis = coordinate_axis(k.axis_in_father(i));
  Mat3 Omega;
  const bool turns = k.link(i).revolute && !k.speed(i).is_zero();
  if (turns && axis && !is_zero(father_omega) && k.choice(i).column_of_father) {
    Vec3 along = column(of(turning.Omega, f).tensor.value, axis->index);
    for (Expr& component : along) {
      component = axis->signed_value(component);
    }
    Omega = turned_by_column(i, omega, k.from_father(i, along), squares[to_index(f)], alpha, s);
  } else {
    Omega = turning_tensor(alpha, omega);
    s = {omega[0] * omega[0], omega[1] * omega[1], Omega[0][0] - Omega[2][2]};
  }
  memo_[to_index(turning.alpha)][to_index(i)].vector = {{i, alpha}};
  memo_[to_index(turning.Omega)][to_index(i)].tensor = {i, Omega};
  for (const int id : {turning.alpha, turning.Omega}) {
    known_[to_index(id)][to_index(i)] = true;
    named_.push_back(id);
  }
}

/// Ω of link i from its third column; α_x and α_y follow. \pre alpha[2] is right.
Mat3 Lowering::turned_by_column(int i, const Vec3& omega, const Vec3& third, const Squares& father,
                                Vec3& alpha, Squares& s) const {
  const auto& [x, y, z] = omega;
  const Expr xy = x * y;
  const Expr xz = x * z;
  const Expr yz = y * z;
  const Expr zz = z * z;
  Expr Omega_xx;
  Expr Omega_zz = third[2];
  if (task_.kinematics.shares_frame(i)) {
    s.xx = father.xx;
    s.yy = father.yy;
    Omega_xx = -(s.yy + zz);
    s.xx_zz = Omega_xx - Omega_zz;
  } else if (x.is_zero() || y.is_zero()) {
    s.xx = x * x;
    s.yy = y * y;
    Omega_zz = -(s.xx + s.yy);
    s.xx_zz = s.xx - zz;
    Omega_xx = Omega_zz + s.xx_zz;
  } else {
    s.xx = x * x;
    s.yy = -(Omega_zz + s.xx);
    s.xx_zz = s.xx - zz;
    Omega_xx = Omega_zz + s.xx_zz;
  }
  alpha = {yz - third[1], third[0] - xz, alpha[2]};
  return {{{Omega_xx, xy - alpha[2], third[0]},
           {xy + alpha[2], -(s.xx + zz), third[1]},
           {xz - alpha[1], yz + alpha[0], Omega_zz}}};
}

namespace {

/// vee(Ω Ψ) of a body that does not accelerate: Omega is symmetric.
Vec3 centrifugal_moment(const Mat3& Omega, const Mat3& Psi) {
  const Mat3 m = Omega * Psi;
  return {m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
}

/// vee(Ω Ψ): the moment of a turning body by its second moments.
Vec3 moment_by_second_moments(const Mat3& Omega, Expr xx_zz, const Mat3& Psi) {
  return {sum({Omega[2][1] * Psi[1][1], Omega[2][0] * Psi[0][1], -(Omega[1][0] * Psi[0][2]),
               -(Omega[1][2] * Psi[2][2]), (Omega[2][2] - Omega[1][1]) * Psi[1][2]}),
          sum({Omega[0][2] * Psi[2][2], Omega[0][1] * Psi[1][2], -(Omega[2][1] * Psi[0][1]),
               -(Omega[2][0] * Psi[0][0]), xx_zz * Psi[0][2]}),
          sum({Omega[1][0] * Psi[0][0], Omega[1][2] * Psi[0][2], -(Omega[0][2] * Psi[1][2]),
               -(Omega[0][1] * Psi[1][1]), (Omega[1][1] - Omega[0][0]) * Psi[0][1]})};
}

/// I α + ω×I ω by the inertia tensor I = tr(Ψ) E_3 - Ψ.
Vec3 moment_by_tensor(const Mat3& Omega, const Vec3& alpha, const Vec3& omega, Expr xx, Expr yy,
                      const Mat3& Psi) {
  const auto& [x, y, z] = omega;
  const Expr zz = z * z;
  const Expr jx = Psi[1][1] + Psi[2][2];
  const Expr jy = Psi[0][0] + Psi[2][2];
  const Expr jz = Psi[0][0] + Psi[1][1];
  return {sum({jx * alpha[0], (jz - jy) * (y * z), Psi[0][1] * Omega[2][0],
               -(Psi[0][2] * Omega[1][0]), -((yy - zz) * Psi[1][2])}),
          sum({jy * alpha[1], (jx - jz) * (x * z), -(Psi[0][1] * Omega[2][1]),
               Psi[1][2] * Omega[0][1], -((zz - xx) * Psi[0][2])}),
          sum({jz * alpha[2], (jy - jx) * (x * y), Psi[0][2] * Omega[1][2],
               -(Psi[1][2] * Omega[0][2]), -((xx - yy) * Psi[0][1])})};
}

}  // namespace

Block Lowering::moment(const Value& v, int e) const {
  const Tensor& Omega = of(v.operands[0], e).tensor;
  const int frame = Omega.frame;
  const Mat3 Psi = frames_.moved({e, second_moments(e)}, frame).value;
  if (value(v.operands[1]).op == derive::Op::kZero) {
    return {{}, {{frame, centrifugal_moment(Omega.value, Psi)}}, {}};
  }
  const Vec3 alpha = frames_.in(of(v.operands[1], e).vector, frame);
  const Vec3 omega = frames_.in(of(v.operands[2], e).vector, frame);
  const auto known = squares_.find(v.operands[0]);
  const Squares s = known != squares_.end() ? known->second[to_index(e)]
                                            : Squares{omega[0] * omega[0], omega[1] * omega[1],
                                                      Omega.value[0][0] - Omega.value[2][2]};
  const Vec3 M = task_.kinematics.choice(e).tensor_moment
                     ? moment_by_tensor(Omega.value, alpha, omega, s.xx, s.yy, Psi)
                     : moment_by_second_moments(Omega.value, s.xx_zz, Psi);
  return {{}, {{frame, M}}, {}};
}

/// ω·(I ω) = -tr(Λ(ω)² Ψ).
Block Lowering::square(const Value& v, int e) const {
  const int frame = home(v.set, e);
  const Mat3 u = skew_squared(frames_.in(of(v.operands[0], e).vector, frame));
  const Mat3 Psi = frames_.moved({e, second_moments(e)}, frame).value;
  const Expr squares = sum({-u[0][0] * Psi[0][0], -u[1][1] * Psi[1][1], -u[2][2] * Psi[2][2]});
  const Expr products = sum({u[0][1] * Psi[0][1], u[0][2] * Psi[0][2], u[1][2] * Psi[1][2]});
  return {squares - number(2) * products, {}, {}};
}

}  // namespace treedyn::formulate
