// Forces that depend on the state: springs, loads and compliant ground.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

Eigen::Vector3d vector_of(const model::Vector3& x);

/// Height of a point over a plane.
class PlaneValues {
 public:
  explicit PlaneValues(const model::Plane& plane)
      : normal_(vector_of(plane.normal)), height_(static_cast<double>(plane.height)) {}
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }
  [[nodiscard]] double height(const Eigen::Vector3d& p) const { return normal_.dot(p) - height_; }

 private:
  Eigen::Vector3d normal_;
  double height_;
};

/// Compliant ground under one point, model::GroundContact.
class ContactLaw {
 public:
  explicit ContactLaw(const model::GroundContact& contact);
  /// The force on the point, base frame, N; zero above the plane.
  [[nodiscard]] Eigen::Vector3d force(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const;
  [[nodiscard]] int point() const { return point_; }
  [[nodiscard]] const PlaneValues& plane() const { return plane_; }
  /// Elastic energy, J.
  [[nodiscard]] double energy(const Eigen::Vector3d& p) const;

 private:
  int point_;
  PlaneValues plane_;
  double k_, n_, c_, mu_, vs_;
};

/// Everything that acts on a scene apart from reactions and dry friction.
class Forces {
 public:
  explicit Forces(const model::Scene& scene);

  /// Generalized force tau - springs + C f + H n, N.
  void generalized(const Terms& terms, const Vector& q, const Vector& qd, Vector& Q);
  /// Energy of springs and of the elastic part of contacts, J. \param p  points, 3 P
  [[nodiscard]] double elastic_energy(const Vector& q, const VectorMap& p) const;
  [[nodiscard]] const std::vector<ContactLaw>& contacts() const { return contacts_; }

 private:
  struct JointSpring {
    int joint;
    double k, d, rest;
  };
  struct PointSpring {
    int point;
    Eigen::Vector3d anchor;
    double k, d, length;
  };
  struct Load {
    int point;
    Eigen::Vector3d value;
  };

  void add_point_forces(const Terms& terms, const Vector& qd);

  Vector tau_;
  std::vector<JointSpring> joint_springs_;
  std::vector<PointSpring> point_springs_;
  std::vector<Load> torques_;
  std::vector<Load> loads_;
  std::vector<ContactLaw> contacts_;
  Vector v_;
  Vector f_;
  Vector n_;
};

}  // namespace treedyn::simulation
