#include "simplify/forward.hpp"

#include "common/error.hpp"
#include "simplify/articulated.hpp"
#include "simplify/composite.hpp"
#include "simplify/factor.hpp"
#include "simplify/sweeps.hpp"

namespace treedyn::simplify {

namespace {

constexpr int kTrunk = 5;

/// Velocity of the trunk and the part of its angular acceleration that the speeds alone cause.
struct TrunkVelocity {
  Vec3 omega;
  Vec3 zeta;
};

TrunkVelocity trunk_velocity(const Kinematics& k) {
  TrunkVelocity v;
  for (int i = 3; i <= kTrunk; ++i) {
    const Expr qd = k.speed(i);
    const Vec3 w = k.from_father(i, v.omega);
    const Vec3 zeta = k.from_father(i, v.zeta);
    v.zeta = {zeta[0] + w[1] * qd, zeta[1] - w[0] * qd, zeta[2]};
    v.omega = {w[0], w[1], w[2] + qd};
  }
  return v;
}

/// The base's turning axes in the trunk: a3 = sine z + cosine b, a4, z with b, a4, z orthonormal.
struct Gimbal {
  BaseAxes axes;
  Vec3 b;
  Expr sine;
  Expr inverse_cosine;
};

Gimbal gimbal(const Kinematics& k) {
  Gimbal g;
  g.axes = base_axes(k);
  g.sine = g.axes.first[2];
  const Vec3 z = {Expr(), Expr(), constant(k.graph(), Real(1))};
  const Vec3 first = k.from_father(kTrunk - 1, z);  // axis of joint 3 in the frame of link 4
  const Vec3 last = k.axis_in_father(kTrunk);       // axis of joint 5 there
  std::size_t component = 3;
  for (std::size_t n = 0; n < 3; ++n) {
    if (!first[n].is_zero() && last[n].is_zero()) {
      component = n;
    }
  }
  TREEDYN_EXPECT(component < 3);
  Vec3 direction{};
  direction[component] = z[2];
  g.b = k.from_father(kTrunk, direction);
  g.inverse_cosine = z[2] / first[component];
  k.graph().name(g.inverse_cosine.ref(), "inverse_cosine", kTrunk - 1);
  return g;
}

/// The drive forces of the base joints as a wrench on the trunk.
Wrench drive_wrench(const Kinematics& k, const Gimbal& g) {
  Wrench w;
  for (int joint = 0; joint < 3; ++joint) {
    w.force = w.force + k.force(joint) * g.axes.sliding[static_cast<std::size_t>(joint)];
  }
  const Expr t = (k.force(3) - g.sine * k.force(5)) * g.inverse_cosine;
  for (std::size_t n = 0; n < 2; ++n) {
    w.moment[n] = k.force(4) * g.axes.second[n] + t * g.b[n];
  }
  w.moment[2] = k.force(5);
  return w;
}

/// The trunk's inertia at its origin as rows 0..2 (linear) and 3..5 (angular) of a matrix.
void add_trunk_rows(const Kinematics::Body& body, bool inertia_tensor, SparseSymmetric& a) {
  const Vec3& h = body.moment;
  const Mat3 coupling = {{{Expr(), h[2], -h[1]}, {-h[2], Expr(), h[0]}, {h[1], -h[0], Expr()}}};
  const Expr trace = body.pseudo[0][0] + body.pseudo[1][1] + body.pseudo[2][2];
  for (int r = 0; r < 3; ++r) {
    const auto i = static_cast<std::size_t>(r);
    a[{r, r}] = body.mass;
    for (int c = 0; c < 3; ++c) {
      const auto j = static_cast<std::size_t>(c);
      a[{3 + c, r}] = coupling[i][j];
      if (c <= r) {
        const Expr e = body.pseudo[i][j];
        a[{3 + r, 3 + c}] = inertia_tensor ? e : r == c ? trace - e : -e;
      }
    }
  }
}

/// Accelerations: trunk linear, trunk angular, joints of the limbs.
struct Accelerations {
  Vec3 linear;
  Vec3 angular;
  std::vector<Expr> qdd;
};

Accelerations by_factor(const Kinematics& k, const Wrench& drive, const Vec3& omega) {
  const Trunk trunk = trunk_composite(k);
  const TrunkBias bias = trunk_bias(k, omega);
  SparseSymmetric a = trunk.limbs;
  add_trunk_rows(trunk.body, k.variant().inertia_tensor, a);
  for (const Trunk::Column& column : trunk.columns) {
    const bool positive = k.link(column.joint).sign > 0;
    for (int n = 0; n < 3; ++n) {
      const auto m = static_cast<std::size_t>(n);
      a[{column.joint, n}] = positive ? column.force[m] : -column.force[m];
      a[{column.joint, 3 + n}] = positive ? column.moment[m] : -column.moment[m];
    }
  }
  std::vector<Expr> right(static_cast<std::size_t>(k.size()));
  for (std::size_t n = 0; n < 3; ++n) {
    right[n] = drive.force[n] - bias.trunk.force[n];
    right[3 + n] = drive.moment[n] - bias.trunk.moment[n];
  }
  for (int i = kTrunk + 1; i < k.size(); ++i) {
    const Expr tau = k.link(i).sign > 0 ? k.force(i) : -k.force(i);
    right[static_cast<std::size_t>(i)] = tau - bias.tau[static_cast<std::size_t>(i)];
  }
  Accelerations result;
  result.qdd = Factorization(k.graph(), k.size(), a).solve(right);
  result.linear = {result.qdd[0], result.qdd[1], result.qdd[2]};
  result.angular = {result.qdd[3], result.qdd[4], result.qdd[5]};
  return result;
}

Accelerations by_articulated_limbs(const Kinematics& k, const Wrench& drive, const Vec3& omega) {
  const ArticulatedLimbs limbs(k, kTrunk + 1, omega);
  const ArticulatedInertia& trunk = limbs.trunk();
  SparseSymmetric a;
  for (int r = 0; r < 3; ++r) {
    const auto i = static_cast<std::size_t>(r);
    for (int c = 0; c < 3; ++c) {
      const auto j = static_cast<std::size_t>(c);
      a[{3 + c, r}] = trunk.coupling[j][i];
      if (c <= r) {
        a[{r, c}] = trunk.mass[i][j];
        a[{3 + r, 3 + c}] = trunk.tensor[i][j];
      }
    }
  }
  std::vector<Expr> right(6);
  for (std::size_t n = 0; n < 3; ++n) {
    right[n] = drive.force[n] - trunk.bias.force[n];
    right[3 + n] = drive.moment[n] - trunk.bias.moment[n];
  }
  const std::vector<Expr> x = Factorization(k.graph(), 6, a).solve(right);
  Accelerations result;
  result.linear = {x[0], x[1], x[2]};
  result.angular = {x[3], x[4], x[5]};
  result.qdd = limbs.accelerations(result.angular, result.linear);
  return result;
}

}  // namespace

std::vector<Expr> forward_dynamics_by_trunk(const Kinematics& k, const Vec3& gravity,
                                            bool articulated) {
  k.graph().set_body(kTrunk);
  const Gimbal g = gimbal(k);
  const Wrench drive = drive_wrench(k, g);
  const TrunkVelocity velocity = trunk_velocity(k);
  Accelerations result = articulated ? by_articulated_limbs(k, drive, velocity.omega)
                                     : by_factor(k, drive, velocity.omega);
  k.graph().set_body(kTrunk);
  const Vec3 d = result.angular - velocity.zeta;
  const Expr q3 = dot(g.b, d) * g.inverse_cosine;
  const std::array<Expr, 3> turning = {q3, dot(g.axes.second, d), d[2] - g.sine * q3};
  Vec3 down = gravity;
  for (int joint = 0; joint < 6; ++joint) {
    const auto n = static_cast<std::size_t>(joint);
    Expr x;
    if (joint < 3) {
      down = k.from_father(joint, down);
      x = dot(g.axes.sliding[n], result.linear) + down[2];
    } else {
      x = turning[n - 3];
    }
    result.qdd[n] = k.link(joint).sign > 0 ? x : -x;
  }
  return result.qdd;
}

}  // namespace treedyn::simplify
