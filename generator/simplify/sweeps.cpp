#include "simplify/sweeps.hpp"

#include <optional>

namespace treedyn::simplify {

namespace {

bool any(const Vec3& v) { return !v[0].is_zero() || !v[1].is_zero() || !v[2].is_zero(); }

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

class NewtonEuler {
 public:
  explicit NewtonEuler(const Kinematics& k)
      : k_(k),
        motion_(static_cast<std::size_t>(k.size())),
        load_(static_cast<std::size_t>(k.size())) {}

  void set_motion(int i, const Motion& motion) { at(i) = motion; }
  [[nodiscard]] const Motion& motion_of(int i) { return at(i); }
  /// Motion of link i from its father's. \param ground acceleration of the ground
  void forward(int i, const Vec3& ground);
  /// F_i = m a + Omega h,  M_i = vee(Omega E) + h x a.
  void load(int i);
  /// Joint force, and the load passed to the father: F_f += F_i, M_f += M_i + s_i x F_i.
  Expr backward(int i);
  [[nodiscard]] const Wrench& wrench(int i) const { return load_[static_cast<std::size_t>(i)]; }

 private:
  Motion& at(int i) { return motion_[static_cast<std::size_t>(i)]; }
  Motion turned(int i, const Vec3& omega, const Vec3& a, const Motion& father);
  Motion turned_by_column(int i, const Vec3& omega, const Vec3& a, const Motion& father,
                          const CoordinateAxis& axis);
  Motion slid(int i, const Vec3& omega, const Vec3& a, const Motion& father);
  void name_motion(int i);

  const Kinematics& k_;
  std::vector<Motion> motion_;
  std::vector<Wrench> load_;
};

void NewtonEuler::forward(int i, const Vec3& ground) {
  const int f = k_.link(i).father;
  Motion rest;
  rest.a = ground;
  const Motion& father = f == model::kGround ? rest : at(f);
  k_.graph().set_body(i);
  const Vec3 a = k_.from_father(i, father.a + father.Omega * k_.offset(i));
  const Vec3 omega = k_.from_father(i, father.omega);
  if (!k_.link(i).revolute) {
    at(i) = slid(i, omega, a, father);
  } else {
    const std::optional<CoordinateAxis> axis = coordinate_axis(k_.axis_in_father(i));
    const bool by_column =
        axis && f != model::kGround && any(father.omega) && k_.choice(i).column_of_father;
    at(i) = by_column ? turned_by_column(i, omega, a, father, *axis) : turned(i, omega, a, father);
  }
  name_motion(i);
}

/// a += 2 qd omega x z + qdd z for a sliding joint (7.2).
Motion NewtonEuler::slid(int i, const Vec3& omega, const Vec3& a, const Motion& father) {
  const Expr qd = k_.speed(i);
  const Expr two = constant(k_.graph(), Real(2));
  const Vec3 coriolis = {two * (omega[1] * qd), -(two * (omega[0] * qd)), k_.acceleration(i)};
  return motion(omega, k_.from_father(i, father.alpha), a + coriolis);
}

/// alpha_i = alpha_f + qd omega_f x z + qdd z,  omega_i = omega_f + qd z (7.2).
Motion NewtonEuler::turned(int i, const Vec3& omega, const Vec3& a, const Motion& father) {
  const Expr qd = k_.speed(i);
  const Vec3 alpha = k_.from_father(i, father.alpha);
  return motion({omega[0], omega[1], omega[2] + qd},
                {alpha[0] + omega[1] * qd, alpha[1] - omega[0] * qd, alpha[2] + k_.acceleration(i)},
                a);
}

/// Omega_i z = Omega_f z for the common axis z: a joint changes Omega only across its own axis. So
/// the third column of Omega_i is the father's column along the axis, rotated, and alpha follows
/// from it:
///   Omega_xz = omega_x omega_z + alpha_y,  Omega_yz = omega_y omega_z - alpha_x,
///   Omega_zz = -omega_x^2 - omega_y^2.
Motion NewtonEuler::turned_by_column(int i, const Vec3& omega, const Vec3& a, const Motion& father,
                                     const CoordinateAxis& axis) {
  Motion m;
  m.a = a;
  m.omega = {omega[0], omega[1], omega[2] + k_.speed(i)};
  const auto& [x, y, z] = m.omega;
  Vec3 along = column(father.Omega, axis.index);
  for (Expr& component : along) {
    component = axis.signed_value(component);
  }
  const Vec3 third = k_.from_father(i, along);
  const Expr alpha_z = axis.signed_value(father.alpha[axis.index]) + k_.acceleration(i);
  const Expr xy = x * y;
  const Expr xz = x * z;
  const Expr yz = y * z;
  const Expr zz = z * z;
  Expr Omega_xx;
  Expr Omega_zz = third[2];
  if (k_.shares_frame(i)) {
    m.xx = father.xx;
    m.yy = father.yy;
    Omega_xx = -(m.yy + zz);
    m.xx_zz = Omega_xx - Omega_zz;
  } else if (x.is_zero() || y.is_zero()) {
    m.xx = x * x;
    m.yy = y * y;
    Omega_zz = -(m.xx + m.yy);
    m.xx_zz = m.xx - zz;
    Omega_xx = Omega_zz + m.xx_zz;
  } else {
    m.xx = x * x;
    m.yy = -(Omega_zz + m.xx);
    m.xx_zz = m.xx - zz;
    Omega_xx = Omega_zz + m.xx_zz;
  }
  m.alpha = {yz - third[1], third[0] - xz, alpha_z};
  m.Omega = {{{Omega_xx, xy - alpha_z, third[0]},
              {xy + alpha_z, -(m.xx + zz), third[1]},
              {xz - m.alpha[1], yz + m.alpha[0], Omega_zz}}};
  return m;
}

void NewtonEuler::name_motion(int i) {
  Graph& graph = k_.graph();
  name(graph, at(i).omega, "omega", i);
  name(graph, at(i).alpha, "alpha", i);
  name(graph, at(i).a, "a", i);
  constexpr std::array<const char*, 9> kEntry = {"xx", "xy", "xz", "yx", "yy",
                                                 "yz", "zx", "zy", "zz"};
  for (std::size_t n = 0; n < 9; ++n) {
    graph.name(at(i).Omega[n / 3][n % 3].ref(), "Omega", i, kEntry[n]);
  }
}

/// vee(Omega E): the moment of a turning body by its pseudo-inertia.
Vec3 moment_by_pseudo_inertia(const Motion& m, const Mat3& e) {
  const Mat3& u = m.Omega;
  return {sum({u[2][1] * e[1][1], u[2][0] * e[0][1], -(u[1][0] * e[0][2]), -(u[1][2] * e[2][2]),
               (u[2][2] - u[1][1]) * e[1][2]}),
          sum({u[0][2] * e[2][2], u[0][1] * e[1][2], -(u[2][1] * e[0][1]), -(u[2][0] * e[0][0]),
               m.xx_zz * e[0][2]}),
          sum({u[1][0] * e[0][0], u[1][2] * e[0][2], -(u[0][2] * e[1][2]), -(u[0][1] * e[1][1]),
               (u[1][1] - u[0][0]) * e[0][1]})};
}

/// J alpha + omega x J omega by the inertia tensor J = tr(E) - E.
Vec3 moment_by_tensor(const Motion& m, const Mat3& e) {
  const Mat3& u = m.Omega;
  const auto& [x, y, z] = m.omega;
  const Expr zz = z * z;
  const Expr jx = e[1][1] + e[2][2];
  const Expr jy = e[0][0] + e[2][2];
  const Expr jz = e[0][0] + e[1][1];
  return {sum({jx * m.alpha[0], (jz - jy) * (y * z), e[0][1] * u[2][0], -(e[0][2] * u[1][0]),
               -((m.yy - zz) * e[1][2])}),
          sum({jy * m.alpha[1], (jx - jz) * (x * z), -(e[0][1] * u[2][1]), e[1][2] * u[0][1],
               -((zz - m.xx) * e[0][2])}),
          sum({jz * m.alpha[2], (jy - jx) * (x * y), e[0][2] * u[1][2], -(e[1][2] * u[0][2]),
               -((m.xx - m.yy) * e[0][1])})};
}

void NewtonEuler::load(int i) {
  k_.graph().set_body(i);
  const Kinematics::Body body = k_.body(i);
  const Motion& m = at(i);
  Wrench& w = load_[static_cast<std::size_t>(i)];
  w.force = m.Omega * body.moment + body.mass * m.a;
  const Vec3 turning = k_.choice(i).tensor_moment ? moment_by_tensor(m, body.pseudo)
                                                  : moment_by_pseudo_inertia(m, body.pseudo);
  w.moment = turning + cross(body.moment, m.a);
}

Expr NewtonEuler::backward(int i) {
  Graph& graph = k_.graph();
  graph.set_body(i);
  const Wrench& w = load_[static_cast<std::size_t>(i)];
  name(graph, w.force, "F", i);
  name(graph, w.moment, "M", i);
  const Expr along = k_.link(i).revolute ? w.moment[2] : w.force[2];
  const int f = k_.link(i).father;
  if (f != model::kGround) {
    Wrench& father = load_[static_cast<std::size_t>(f)];
    const Vec3 force = k_.to_father(i, w.force);
    const Vec3 moment = k_.to_father(i, w.moment) + cross(k_.offset(i), force);
    father.force = father.force + force;
    father.moment = father.moment + moment;
  }
  return k_.link(i).sign > 0 ? along : -along;
}

}  // namespace

Motion motion(const Vec3& omega, const Vec3& alpha, const Vec3& a) {
  Motion m;
  m.omega = omega;
  m.alpha = alpha;
  m.a = a;
  m.Omega = skew_squared(omega);
  m.xx = omega[0] * omega[0];
  m.yy = omega[1] * omega[1];
  m.Omega[0][1] -= alpha[2];
  m.Omega[0][2] += alpha[1];
  m.Omega[1][0] += alpha[2];
  m.Omega[1][2] -= alpha[0];
  m.Omega[2][0] -= alpha[1];
  m.Omega[2][1] += alpha[0];
  m.xx_zz = m.Omega[0][0] - m.Omega[2][2];
  return m;
}

std::vector<Motion> motions(const Kinematics& k, const Vec3& ground) {
  NewtonEuler sweep(k);
  std::vector<Motion> result;
  for (int i = 0; i < k.size(); ++i) {
    sweep.forward(i, ground);
    result.push_back(sweep.motion_of(i));
  }
  return result;
}

TrunkBias trunk_bias(const Kinematics& k, const Vec3& omega) {
  NewtonEuler sweep(k);
  sweep.set_motion(kTrunkLink, motion(omega, {}, {}));
  sweep.load(kTrunkLink);
  for (int i = kTrunkLink + 1; i < k.size(); ++i) {
    sweep.forward(i, {});
    sweep.load(i);
  }
  TrunkBias bias;
  bias.tau.resize(static_cast<std::size_t>(k.size()));
  for (int i = k.size() - 1; i > kTrunkLink; --i) {
    bias.tau[static_cast<std::size_t>(i)] = sweep.backward(i);
  }
  bias.trunk = sweep.wrench(kTrunkLink);
  return bias;
}

std::vector<Motion> limb_motions(const Kinematics& k, const Vec3& omega) {
  NewtonEuler sweep(k);
  sweep.set_motion(kTrunkLink, motion(omega, {}, {}));
  std::vector<Motion> result(kTrunkLink);
  result.push_back(sweep.motion_of(kTrunkLink));
  for (int i = kTrunkLink + 1; i < k.size(); ++i) {
    sweep.forward(i, {});
    result.push_back(sweep.motion_of(i));
  }
  return result;
}

}  // namespace treedyn::simplify
