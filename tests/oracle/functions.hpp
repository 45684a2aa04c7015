// The functions of INTERFACE.md 3 by name, computed from the recursive oracle.
#pragma once

#include <map>
#include <string>

#include "oracle/recursive.hpp"

namespace treedyn::oracle {

/// A point fixed in a body (-1: the ground).
template <class T>
struct Point {
  int body = -1;
  Vec<T> at{};
  Mat<T> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< frame whose rotation is asked for -> body
};

template <class T>
struct Problem {
  Robot<T> robot;
  Vec<T> gravity{};
  std::vector<Point<T>> points;
};

/// True if `a` is `b` or an ancestor of it.
template <class T>
bool carries(const Robot<T>& robot, int a, int b) {
  while (b > a) {
    b = robot[static_cast<std::size_t>(b)].father;
  }
  return a == b;
}

/// One evaluation: the inputs by the names of INTERFACE.md 3, absent ones zero.
template <class T>
class Evaluation {
 public:
  using List = std::vector<T>;

  Evaluation(const Problem<T>& problem, const List& q, const List& qd)
      : problem_(problem),
        n_(problem.robot.size()),
        q_(q),
        qd_(qd),
        motion_(motion(problem.robot, q, qd, List(n_))) {}

  [[nodiscard]] List mass_matrix() const { return oracle::mass_matrix(problem_.robot, q_); }
  [[nodiscard]] List inverse_dynamics(const List& qdd) const {
    return oracle::inverse_dynamics(problem_.robot, problem_.gravity, q_, qd_, qdd);
  }
  [[nodiscard]] List bias_force() const {
    return oracle::inverse_dynamics(problem_.robot, Vec<T>{}, q_, qd_, List(n_));
  }
  [[nodiscard]] List gravity_force() const {
    return oracle::inverse_dynamics(problem_.robot, problem_.gravity, q_, List(n_), List(n_));
  }
  [[nodiscard]] List forward_dynamics(const List& tau) const {
    List rest = inverse_dynamics(List(n_));
    for (std::size_t i = 0; i < n_; ++i) {
      rest[i] = tau[i] - rest[i];
    }
    return solve(mass_matrix(), rest);
  }
  /// A, B and G, one after the other.
  [[nodiscard]] List dynamics_terms() const {
    List result = mass_matrix();
    for (const List& part : {bias_force(), gravity_force()}) {
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }
  /// Columns of tau for robots that have nothing but one parameter; a first moment is that of a
  /// unit mass at 1 m less that of the mass in the origin.
  [[nodiscard]] List inverse_dynamics_regressor(const List& qdd) const {
    constexpr std::array<std::array<std::size_t, 2>, 6> kPlaces = {
        {{0, 0}, {1, 3}, {2, 6}, {4, 4}, {5, 7}, {8, 8}}};
    List Y(n_ * 10 * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const auto tau_of = [&](const T& mass, const Vec<T>& com, const Mat<T>& inertia) {
        Robot<T> robot = problem_.robot;
        for (Body<T>& body : robot) {
          body.mass = T(0);
          body.com = {};
          body.inertia = {};
        }
        robot[i].mass = mass;
        robot[i].com = com;
        robot[i].inertia = inertia;
        return oracle::inverse_dynamics(robot, problem_.gravity, q_, qd_, qdd);
      };
      const auto put = [&](std::size_t k, const List& tau, const List& less) {
        for (std::size_t row = 0; row < n_; ++row) {
          Y[row * 10 * n_ + 10 * i + k] = tau[row] - less[row];
        }
      };
      const List nothing(n_);
      const List at_origin = tau_of(T(1), {}, {});
      put(0, at_origin, nothing);
      for (std::size_t k = 0; k < 3; ++k) {
        Vec<T> com{};
        com[k] = T(1);
        Mat<T> inertia{T(-1), T(0), T(0), T(0), T(-1), T(0), T(0), T(0), T(-1)};
        inertia[4 * k] = T(0);  // none about the origin
        put(1 + k, tau_of(T(1), com, inertia), at_origin);
      }
      for (std::size_t k = 0; k < 6; ++k) {
        Mat<T> inertia{};
        inertia[kPlaces[k][0]] = T(1);
        inertia[kPlaces[k][1]] = T(1);
        put(4 + k, tau_of(T(0), {}, inertia), nothing);
      }
    }
    return Y;
  }
  [[nodiscard]] List mass_matrix_inverse() const {
    const List A = mass_matrix();
    List result;
    for (std::size_t k = 0; k < n_; ++k) {
      List unit(n_);
      unit[k] = T(1);
      const List row = solve(A, unit);  // the inverse is symmetric
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  }
  /// L (unit lower triangular) and d of A = L^T diag(d) L: elimination from the last joint on.
  [[nodiscard]] List mass_matrix_factor() const {
    List A = mass_matrix();
    List L(n_ * n_);
    List d(n_);
    for (std::size_t k = n_; k-- > 0;) {
      d[k] = A[k * n_ + k];
      for (std::size_t i = 0; i <= k; ++i) {
        L[k * n_ + i] = A[k * n_ + i] / d[k];
      }
      for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j) {
          A[i * n_ + j] -= L[k * n_ + i] * A[k * n_ + j];
        }
      }
    }
    L.insert(L.end(), d.begin(), d.end());
    return L;
  }
  [[nodiscard]] List point_positions() const {
    return per_point([](const Motion<T>& m, const Vec<T>& arm) { return m.origin + arm; });
  }
  [[nodiscard]] List point_velocities() const {
    return per_point([](const Motion<T>& m, const Vec<T>& arm) { return point_velocity(m, arm); });
  }
  [[nodiscard]] List point_bias_acceleration() const {
    return per_point(
        [](const Motion<T>& m, const Vec<T>& arm) { return point_acceleration(m, arm); });
  }
  [[nodiscard]] List angular_bias_acceleration() const {
    return per_point([](const Motion<T>& m, const Vec<T>&) { return m.alpha; });
  }
  [[nodiscard]] List point_rotations() const {
    List result;
    for (const Point<T>& point : problem_.points) {
      const Mat<T> R = carrier(point).R * point.rotation;
      result.insert(result.end(), R.begin(), R.end());
    }
    return result;
  }

  /// N x 3P: velocity of every point at unit rate of one joint (angular velocity for `moment`).
  [[nodiscard]] List jacobian_transpose(bool moment) const {
    List result;
    for (std::size_t k = 0; k < n_; ++k) {
      for (const Point<T>& point : problem_.points) {
        const Vec<T> column =
            moment ? joint_angular(k, point.body) : joint_linear(k, point.body, position(point));
        result.insert(result.end(), column.begin(), column.end());
      }
    }
    return result;
  }

  [[nodiscard]] List applied_force(const List& f, const List& n) const {
    const List C = jacobian_transpose(false);
    const List H = jacobian_transpose(true);
    List result(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t j = 0; j < f.size(); ++j) {
        result[k] += C[k * f.size() + j] * f[j] + H[k * f.size() + j] * n[j];
      }
    }
    return result;
  }

  /// 3N x N, block (i, j): from the joint-j frame carried by the father of j to the origin (or the
  /// centre of mass) of link i if j carries i.
  [[nodiscard]] List vectors_from_joints(bool to_com) const {
    List result(3 * n_ * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const Vec<T> end =
          motion_[i].origin + (to_com ? motion_[i].R * problem_.robot[i].com : Vec<T>{});
      for (std::size_t j = 0; j <= i; ++j) {
        if (carries(problem_.robot, static_cast<int>(j), static_cast<int>(i))) {
          const Vec<T> block = end - joint_origin(j);
          for (std::size_t axis = 0; axis < 3; ++axis) {
            result[(3 * i + axis) * n_ + j] = block[axis];
          }
        }
      }
    }
    return result;
  }

  [[nodiscard]] List kinetic_energy() const {
    T sum{};
    for (std::size_t i = 0; i < n_; ++i) {
      const Body<T>& body = problem_.robot[i];
      const Motion<T>& m = motion_[i];
      const Vec<T> v = point_velocity(m, m.R * body.com);
      const Vec<T> w = transposed(m.R) * m.omega;
      sum += (body.mass * dot(v, v) + dot(w, body.inertia * w)) / T(2);
    }
    return {sum};
  }
  [[nodiscard]] List potential_energy() const {
    T sum{};
    for (std::size_t i = 0; i < n_; ++i) {
      const Body<T>& body = problem_.robot[i];
      sum -= body.mass * dot(problem_.gravity, motion_[i].origin + motion_[i].R * body.com);
    }
    return {sum};
  }

 private:
  [[nodiscard]] Motion<T> carrier(const Point<T>& point) const {
    return point.body < 0 ? Motion<T>{} : motion_[static_cast<std::size_t>(point.body)];
  }
  [[nodiscard]] Vec<T> position(const Point<T>& point) const {
    const Motion<T> m = carrier(point);
    return m.origin + m.R * point.at;
  }
  template <class Quantity>
  List per_point(Quantity quantity) const {
    List result;
    for (const Point<T>& point : problem_.points) {
      const Motion<T> m = carrier(point);
      const Vec<T> value = quantity(m, m.R * point.at);
      result.insert(result.end(), value.begin(), value.end());
    }
    return result;
  }
  [[nodiscard]] bool moves(std::size_t joint, int body) const {
    return carries(problem_.robot, static_cast<int>(joint), body);
  }
  [[nodiscard]] Vec<T> joint_angular(std::size_t k, int body) const {
    return moves(k, body) && problem_.robot[k].revolute ? motion_[k].axis : Vec<T>{};
  }
  [[nodiscard]] Vec<T> joint_linear(std::size_t k, int body, const Vec<T>& p) const {
    if (!moves(k, body)) {
      return {};
    }
    return problem_.robot[k].revolute ? cross(motion_[k].axis, p - motion_[k].origin)
                                      : motion_[k].axis;
  }
  /// P_j of EQUATIONS.md: the joint origin before its slide.
  [[nodiscard]] Vec<T> joint_origin(std::size_t j) const {
    const T slide = problem_.robot[j].revolute ? T(0) : q_[j];
    return motion_[j].origin - slide * motion_[j].axis;
  }

  const Problem<T>& problem_;
  std::size_t n_;
  List q_;
  List qd_;
  std::vector<Motion<T>> motion_;
};

/// The output of a function of INTERFACE.md 3 for its inputs in order.
/// \throws std::out_of_range for a function that the oracle does not know.
template <class T>
std::vector<T> evaluate(const Problem<T>& problem, const std::string& function,
                        const std::vector<std::vector<T>>& in) {
  using Inputs = std::vector<std::vector<T>>;
  using Step = std::vector<T> (*)(const Evaluation<T>&, const Inputs&);
  struct Entry {
    bool has_velocity;
    Step step;
  };
  static const std::map<std::string, Entry> kTable{
      {"mass_matrix",
       {false,
        [](const auto& e, const auto&) {
          return e.mass_matrix();
        }}},
      {"bias_force",
       {true,
        [](const auto& e, const auto&) {
          return e.bias_force();
        }}},
      {"gravity_force",
       {false,
        [](const auto& e, const auto&) {
          return e.gravity_force();
        }}},
      {"inverse_dynamics",
       {true,
        [](const auto& e, const auto& x) {
          return e.inverse_dynamics(x[2]);
        }}},
      {"forward_dynamics",
       {true,
        [](const auto& e, const auto& x) {
          return e.forward_dynamics(x[2]);
        }}},
      {"point_positions",
       {false,
        [](const auto& e, const auto&) {
          return e.point_positions();
        }}},
      {"point_velocities",
       {true,
        [](const auto& e, const auto&) {
          return e.point_velocities();
        }}},
      {"point_rotations",
       {false,
        [](const auto& e, const auto&) {
          return e.point_rotations();
        }}},
      {"force_jacobian_transpose",
       {false,
        [](const auto& e, const auto&) {
          return e.jacobian_transpose(false);
        }}},
      {"moment_jacobian_transpose",
       {false,
        [](const auto& e, const auto&) {
          return e.jacobian_transpose(true);
        }}},
      {"point_bias_acceleration",
       {true,
        [](const auto& e, const auto&) {
          return e.point_bias_acceleration();
        }}},
      {"angular_bias_acceleration",
       {true,
        [](const auto& e, const auto&) {
          return e.angular_bias_acceleration();
        }}},
      {"joint_to_link_vectors",
       {false,
        [](const auto& e, const auto&) {
          return e.vectors_from_joints(false);
        }}},
      {"joint_to_com_vectors",
       {false,
        [](const auto& e, const auto&) {
          return e.vectors_from_joints(true);
        }}},
      {"applied_force",
       {false,
        [](const auto& e, const auto& x) {
          return e.applied_force(x[1], x[2]);
        }}},
      {"kinetic_energy",
       {true,
        [](const auto& e, const auto&) {
          return e.kinetic_energy();
        }}},
      {"potential_energy",
       {false,
        [](const auto& e, const auto&) {
          return e.potential_energy();
        }}},
      {"inverse_dynamics_regressor",
       {true,
        [](const auto& e, const auto& x) {
          return e.inverse_dynamics_regressor(x[2]);
        }}},
      {"dynamics_terms",
       {true,
        [](const auto& e, const auto&) {
          return e.dynamics_terms();
        }}},
      {"mass_matrix_factor",
       {false,
        [](const auto& e, const auto&) {
          return e.mass_matrix_factor();
        }}},
      {"mass_matrix_inverse",
       {false,
        [](const auto& e, const auto&) {
          return e.mass_matrix_inverse();
        }}},
      {"mass_matrix_solve", {false, [](const auto& e, const auto& x) {
                               return solve(e.mass_matrix(), x[1]);
                             }}}};
  const Entry& entry = kTable.at(function);
  const std::vector<T> rest(problem.robot.size());
  return entry.step(Evaluation<T>(problem, in.at(0), entry.has_velocity ? in.at(1) : rest), in);
}

}  // namespace treedyn::oracle
