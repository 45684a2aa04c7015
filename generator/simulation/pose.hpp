// Where the links are and how they move: for energies, momenta and pictures.
#pragma once

#include <vector>

#include "model/tree.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// One link in one state, base frame.
struct LinkState {
  Eigen::Matrix3d R;      ///< link to base
  Eigen::Vector3d O;      ///< main origin, m
  Eigen::Vector3d omega;  ///< rad/s
  Eigen::Vector3d v;      ///< velocity of the main origin, m/s
  Eigen::Vector3d r;      ///< centre of mass, m
  Eigen::Vector3d r_dot;  ///< its velocity, m/s
};

/// Forward kinematics of EQUATIONS.md 1.2, link by link.
class Pose {
 public:
  explicit Pose(const model::Tree& tree, const model::Vector3& gravity);

  /// O(N); fills links().
  void update(const Vector& q, const Vector& qd);
  [[nodiscard]] const std::vector<LinkState>& links() const { return states_; }

  [[nodiscard]] double kinetic_energy() const;
  /// -sum m g.r, J.
  [[nodiscard]] double potential_energy() const;
  [[nodiscard]] Eigen::Vector3d linear_momentum() const;
  /// About the origin of the base frame.
  [[nodiscard]] Eigen::Vector3d angular_momentum() const;
  /// A point of a link, base frame. \param at  link frame
  [[nodiscard]] Eigen::Vector3d point(int link, const Eigen::Vector3d& at) const;

 private:
  struct Body {
    int coordinate;
    double multiplier, lead;  ///< x = multiplier q[coordinate] + lead
    int father;
    bool revolute;
    Eigen::Vector3d axis, offset, com;
    Eigen::Matrix3d R0, J;
    double mass;
  };
  [[nodiscard]] Eigen::Matrix3d inertia(std::size_t i) const;

  std::vector<Body> bodies_;
  std::vector<LinkState> states_;
  Eigen::Vector3d gravity_;
};

}  // namespace treedyn::simulation
