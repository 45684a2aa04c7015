#include "formulate/forward.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "formulate/factored.hpp"

namespace treedyn::formulate {

namespace {

BaseAxes base_axes(const Kinematics& k) {
  const Vec3 z = {Expr(), Expr(), constant(k.graph(), Real(1))};
  BaseAxes axes;
  axes.second = k.from_father(kTrunkLink, z);
  axes.first = k.from_father(kTrunkLink, k.from_father(kTrunkLink - 1, z));
  for (int joint = 0; joint < 3; ++joint) {
    Vec3 v = z;
    for (int i = joint + 1; i <= kTrunkLink; ++i) {
      v = k.from_father(i, v);
    }
    axes.sliding[static_cast<std::size_t>(joint)] = v;
  }
  return axes;
}

Gimbal gimbal(const Kinematics& k) {
  Gimbal g;
  g.axes = base_axes(k);
  g.sine = g.axes.first[2];
  const Vec3 z = {Expr(), Expr(), constant(k.graph(), Real(1))};
  const Vec3 first = k.from_father(kTrunkLink - 1, z);  // axis of joint 3 in the frame of link 4
  const Vec3 last = k.axis_in_father(kTrunkLink);       // axis of joint 5 there
  std::size_t component = 3;
  for (std::size_t n = 0; n < 3; ++n) {
    if (!first[n].is_zero() && last[n].is_zero()) {
      component = n;
    }
  }
  TREEDYN_EXPECT(component < 3);
  Vec3 direction{};
  direction[component] = z[2];
  g.b = k.from_father(kTrunkLink, direction);
  g.inverse_cosine = z[2] / first[component];
  k.graph().name(g.inverse_cosine.ref(), "inverse_cosine", kTrunkLink - 1);
  return g;
}

/// The drive forces of the base joints as a wrench on the trunk.
Wrench drive_wrench(const Gimbal& g, const JointForce& force) {
  Wrench w;
  for (int joint = 0; joint < 3; ++joint) {
    w.force = w.force + force(joint) * g.axes.sliding[static_cast<std::size_t>(joint)];
  }
  const Expr t = (force(3) - g.sine * force(5)) * g.inverse_cosine;
  for (std::size_t n = 0; n < 2; ++n) {
    w.moment[n] = force(4) * g.axes.second[n] + t * g.b[n];
  }
  w.moment[2] = force(5);
  return w;
}

/// The trunk's inertia at its origin as rows 0..2 (linear) and 3..5 (angular) of a matrix.
void add_trunk_rows(const Trunk& trunk, SparseSymmetric& a) {
  const Vec3& h = trunk.moment;
  const Mat3 coupling = {{{Expr(), h[2], -h[1]}, {-h[2], Expr(), h[0]}, {h[1], -h[0], Expr()}}};
  for (int r = 0; r < 3; ++r) {
    const auto i = static_cast<std::size_t>(r);
    a[{r, r}] = trunk.mass;
    for (int c = 0; c < 3; ++c) {
      const auto j = static_cast<std::size_t>(c);
      a[{3 + c, r}] = coupling[i][j];
      if (c <= r) {
        a[{3 + r, 3 + c}] = trunk.inertia[i][j];
      }
    }
  }
}

/// The rows of A and of the right side, in the coordinates of a TrunkSystem.
void add_equations(const Task& task, const Wrench& drive, const JointForce& force,
                   TrunkSystem& system) {
  const Kinematics& k = task.kinematics;
  const Trunk trunk = trunk_of_mass_matrix(task);
  const TrunkBias bias = trunk_bias(task, system.velocity.omega);
  system.a = trunk.limbs;
  add_trunk_rows(trunk, system.a);
  for (const Trunk::Column& column : trunk.columns) {
    for (int n = 0; n < 3; ++n) {
      const auto m = static_cast<std::size_t>(n);
      system.a[{column.joint, n}] = column.force[m];
      system.a[{column.joint, 3 + n}] = column.moment[m];
    }
  }
  system.right.resize(static_cast<std::size_t>(k.size()));
  for (std::size_t n = 0; n < 3; ++n) {
    system.right[n] = drive.force[n] - bias.trunk.force[n];
    system.right[3 + n] = drive.moment[n] - bias.trunk.moment[n];
  }
  for (int i = kTrunkLink + 1; i < k.size(); ++i) {
    const Expr tau = k.link(i).sign > 0 ? force(i) : -force(i);
    system.right[static_cast<std::size_t>(i)] = tau - bias.tau[static_cast<std::size_t>(i)];
  }
}

/// x of `joint_accelerations`.
std::vector<Expr> by_articulated_limbs(const Task& task, const Wrench& drive, const Vec3& omega,
                                       const JointForce& force) {
  std::vector<Expr> x;
  const auto solve = [&](const ArticulatedTrunk& trunk) {
    SparseSymmetric a;
    std::vector<Expr> right(6);
    for (int r = 0; r < 3; ++r) {
      const auto i = static_cast<std::size_t>(r);
      right[i] = drive.force[i] - trunk.bias.force[i];
      right[3 + i] = drive.moment[i] - trunk.bias.moment[i];
      for (int c = 0; c < 3; ++c) {
        const auto j = static_cast<std::size_t>(c);
        a[{3 + c, r}] = trunk.coupling[j][i];
        if (c <= r) {
          a[{r, c}] = trunk.mass[i][j];
          a[{3 + r, 3 + c}] = trunk.tensor[i][j];
        }
      }
    }
    x = formulate::solve(task.kinematics.graph(), a, right);
    return std::array{Vec3{x[3], x[4], x[5]}, Vec3{x[0], x[1], x[2]}};
  };
  std::vector<Expr> result = limb_accelerations(task, omega, force, solve);
  std::copy(x.begin(), x.end(), result.begin());
  return result;
}

}  // namespace

TrunkVelocity trunk_velocity(const Kinematics& k) {
  TrunkVelocity v;
  for (int i = 3; i <= kTrunkLink; ++i) {
    const Expr qd = k.speed(i);
    const Vec3 w = k.from_father(i, v.omega);
    const Vec3 zeta = k.from_father(i, v.zeta);
    v.zeta = {zeta[0] + w[1] * qd, zeta[1] - w[0] * qd, zeta[2]};
    v.omega = {w[0], w[1], w[2] + qd};
  }
  return v;
}

TrunkSystem trunk_system(const Task& task, const JointForce& force) {
  const Kinematics& k = task.kinematics;
  k.graph().set_body(kTrunkLink);
  TrunkSystem system;
  system.gimbal = gimbal(k);
  const Wrench drive = drive_wrench(system.gimbal, force);
  system.velocity = trunk_velocity(k);
  add_equations(task, drive, force, system);
  return system;
}

std::vector<Expr> joint_accelerations(const Kinematics& k, const Gimbal& g,
                                      const TrunkVelocity& velocity, const Vec3& gravity,
                                      std::vector<Expr> x) {
  const Vec3 linear = {x[0], x[1], x[2]};
  const Vec3 angular = {x[3], x[4], x[5]};
  k.graph().set_body(kTrunkLink);
  const Vec3 d = angular - velocity.zeta;
  const Expr q3 = dot(g.b, d) * g.inverse_cosine;
  const std::array<Expr, 3> turning = {q3, dot(g.axes.second, d), d[2] - g.sine * q3};
  Vec3 down = gravity;
  for (int joint = 0; joint < 6; ++joint) {
    const auto n = static_cast<std::size_t>(joint);
    Expr a;
    if (joint < 3) {
      down = k.from_father(joint, down);
      a = dot(g.axes.sliding[n], linear) + down[2];
    } else {
      a = turning[n - 3];
    }
    x[n] = k.link(joint).sign > 0 ? a : -a;
  }
  return x;
}

std::vector<Expr> forward_dynamics_by_trunk(const Task& task, const Vec3& gravity,
                                            bool articulated) {
  const Kinematics& k = task.kinematics;
  const JointForce force = [&k](int i) {
    return k.force(i);
  };
  if (!articulated) {
    const TrunkSystem s = trunk_system(task, force);
    const std::vector<Expr> x = formulate::solve(k.graph(), s.a, s.right);
    return joint_accelerations(k, s.gimbal, s.velocity, gravity, x);
  }
  k.graph().set_body(kTrunkLink);
  const Gimbal g = gimbal(k);
  const Wrench drive = drive_wrench(g, force);
  const TrunkVelocity velocity = trunk_velocity(k);
  return joint_accelerations(k, g, velocity, gravity,
                             by_articulated_limbs(task, drive, velocity.omega, force));
}

}  // namespace treedyn::formulate
