// Textbook dynamics of a tree of rigid bodies: recursive Newton-Euler (Luh, Walker, Paul 1980)
// about the centres of mass, and composite rigid bodies (Walker, Orin 1982) about the base origin.
//
// Shares no code and no formulation with generator/: it includes nothing of it. Any scalar type.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace treedyn::oracle {

template <class T>
using Vec = std::array<T, 3>;
template <class T>
using Mat = std::array<T, 9>;  ///< row-major

template <class T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
Vec<T> operator*(const T& k, const Vec<T>& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
Vec<T> operator*(const Mat<T>& m, const Vec<T>& a) {
  return {m[0] * a[0] + m[1] * a[1] + m[2] * a[2], m[3] * a[0] + m[4] * a[1] + m[5] * a[2],
          m[6] * a[0] + m[7] * a[1] + m[8] * a[2]};
}
template <class T>
Mat<T> transposed(const Mat<T>& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}
template <class T>
Mat<T> operator*(const Mat<T>& a, const Mat<T>& b) {
  Mat<T> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return result;
}

/// Rodrigues' formula.
template <class T>
Mat<T> rotation(const Vec<T>& axis, const T& angle) {
  using std::cos;
  using std::sin;
  const T c = cos(angle);
  const T s = sin(angle);
  const T d = T(1) - c;
  const auto& [x, y, z] = axis;
  return {c + d * x * x,     d * x * y - s * z, d * x * z + s * y, d * x * y + s * z, c + d * y * y,
          d * y * z - s * x, d * x * z - s * y, d * y * z + s * x, c + d * z * z};
}

/// A link and its joint to the father; SI units.
template <class T>
struct Body {
  int father = -1;  ///< index of an earlier body, -1 for the ground
  bool revolute = true;
  Vec<T> axis{};      ///< unit axis, joint frame
  Vec<T> offset{};    ///< joint origin in the father's frame
  Mat<T> rotation{};  ///< joint frame -> father's frame
  T mass{};
  Vec<T> com{};      ///< body frame
  Mat<T> inertia{};  ///< about the centre of mass, body frame
};

template <class T>
using Robot = std::vector<Body<T>>;  ///< fathers first

/// Pose, velocity and acceleration of a body; base frame.
template <class T>
struct Motion {
  Mat<T> R{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< body -> base
  Vec<T> origin{};
  Vec<T> axis{};   ///< of the joint
  Vec<T> omega{};  ///< angular velocity
  Vec<T> alpha{};  ///< angular acceleration
  Vec<T> v{};      ///< velocity of the origin
  Vec<T> a{};      ///< acceleration of the origin
};

template <class T>
Motion<T> moved(const Body<T>& body, const Motion<T>& father, const T& q, const T& qd,
                const T& qdd) {
  Motion<T> m;
  const Mat<T> joint = father.R * body.rotation;
  m.axis = joint * body.axis;
  m.R = body.revolute ? joint * rotation(body.axis, q) : joint;
  const T slide = body.revolute ? T(0) : q;
  const Vec<T> r = father.R * body.offset + slide * m.axis;
  const Vec<T>& w = father.omega;
  m.origin = father.origin + r;
  m.omega = father.omega;
  m.alpha = father.alpha;
  m.v = father.v + cross(w, r);
  m.a = father.a + cross(father.alpha, r) + cross(w, cross(w, r));
  if (body.revolute) {
    m.omega = m.omega + qd * m.axis;
    m.alpha = m.alpha + qdd * m.axis + cross(w, qd * m.axis);
  } else {
    m.v = m.v + qd * m.axis;
    m.a = m.a + qdd * m.axis + (T(2) * qd) * cross(w, m.axis);
  }
  return m;
}

/// The motion of every body.
template <class T>
std::vector<Motion<T>> motion(const Robot<T>& robot, const std::vector<T>& q,
                              const std::vector<T>& qd, const std::vector<T>& qdd) {
  std::vector<Motion<T>> result;
  for (std::size_t i = 0; i < robot.size(); ++i) {
    const int f = robot[i].father;
    const Motion<T> father = f < 0 ? Motion<T>{} : result[static_cast<std::size_t>(f)];
    result.push_back(moved(robot[i], father, q[i], qd[i], qdd[i]));
  }
  return result;
}

/// Velocity and acceleration of a point fixed in a body, `arm` from its origin, base frame.
template <class T>
Vec<T> point_velocity(const Motion<T>& m, const Vec<T>& arm) {
  return m.v + cross(m.omega, arm);
}
template <class T>
Vec<T> point_acceleration(const Motion<T>& m, const Vec<T>& arm) {
  return m.a + cross(m.alpha, arm) + cross(m.omega, cross(m.omega, arm));
}

/// Joint forces for given accelerations under `gravity` (base frame, m/s^2): Newton's and Euler's
/// laws of every body, then the moments about the joint origins from the leaves to the roots.
template <class T>
std::vector<T> inverse_dynamics(const Robot<T>& robot, const Vec<T>& gravity,
                                const std::vector<T>& q, const std::vector<T>& qd,
                                const std::vector<T>& qdd) {
  const std::vector<Motion<T>> all = motion(robot, q, qd, qdd);
  std::vector<Vec<T>> force(robot.size());
  std::vector<Vec<T>> moment(robot.size());
  std::vector<T> tau(robot.size());
  for (std::size_t i = robot.size(); i-- > 0;) {
    const Motion<T>& m = all[i];
    const Vec<T> c = m.R * robot[i].com;
    const Mat<T> J = m.R * robot[i].inertia * transposed(m.R);
    const Vec<T> F = robot[i].mass * (point_acceleration(m, c) - gravity);
    force[i] = force[i] + F;
    moment[i] = moment[i] + J * m.alpha + cross(m.omega, J * m.omega) + cross(c, F);
    tau[i] = dot(m.axis, robot[i].revolute ? moment[i] : force[i]);
    if (robot[i].father >= 0) {
      const auto f = static_cast<std::size_t>(robot[i].father);
      force[f] = force[f] + force[i];
      moment[f] = moment[f] + moment[i] + cross(m.origin - all[f].origin, force[i]);
    }
  }
  return tau;
}

/// Mass, first moment and inertia about the base origin.
template <class T>
struct Composite {
  T mass{};
  Vec<T> first{};
  Mat<T> inertia{};
};

template <class T>
Composite<T> about_base(const Body<T>& body, const Motion<T>& m) {
  const Vec<T> c = m.origin + m.R * body.com;
  Mat<T> I = m.R * body.inertia * transposed(m.R);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      I[3 * i + j] += body.mass * ((i == j ? dot(c, c) : T(0)) - c[i] * c[j]);
    }
  }
  return {body.mass, body.mass * c, I};
}

/// Joint-space inertia matrix, N x N, row-major.
template <class T>
std::vector<T> mass_matrix(const Robot<T>& robot, const std::vector<T>& q) {
  const std::size_t n = robot.size();
  const std::vector<T> rest(n);
  const std::vector<Motion<T>> all = motion(robot, q, rest, rest);
  const Vec<T> none{};
  // The velocity of joint i at unit rate: angular, and linear of the body point at the base origin.
  const auto angular = [&](std::size_t i) {
    return robot[i].revolute ? all[i].axis : none;
  };
  const auto linear = [&](std::size_t i) {
    return robot[i].revolute ? cross(all[i].origin, all[i].axis) : all[i].axis;
  };
  std::vector<Composite<T>> composite(n);
  std::vector<T> A(n * n);
  for (std::size_t i = n; i-- > 0;) {
    const Composite<T> own = about_base(robot[i], all[i]);
    const auto accumulate = [](Composite<T>& sum, const Composite<T>& part) {
      sum.mass += part.mass;
      sum.first = sum.first + part.first;
      for (std::size_t k = 0; k < 9; ++k) {
        sum.inertia[k] += part.inertia[k];
      }
    };
    accumulate(composite[i], own);
    const Composite<T>& c = composite[i];
    const Vec<T> p = c.mass * linear(i) + cross(angular(i), c.first);
    const Vec<T> L = c.inertia * angular(i) + cross(c.first, linear(i));
    for (int j = static_cast<int>(i); j >= 0; j = robot[static_cast<std::size_t>(j)].father) {
      const auto k = static_cast<std::size_t>(j);
      A[i * n + k] = A[k * n + i] = dot(angular(k), L) + dot(linear(k), p);
    }
    if (robot[i].father >= 0) {
      accumulate(composite[static_cast<std::size_t>(robot[i].father)], c);
    }
  }
  return A;
}

/// x with A x = b for a symmetric positive definite A (row-major), by elimination.
template <class T>
std::vector<T> solve(std::vector<T> A, std::vector<T> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) {
      const T factor = A[i * n + k] / A[k * n + k];
      for (std::size_t j = k; j < n; ++j) {
        A[i * n + j] -= factor * A[k * n + j];
      }
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) {
      b[i] -= A[i * n + j] * b[j];
    }
    b[i] /= A[i * n + i];
  }
  return b;
}

}  // namespace treedyn::oracle
