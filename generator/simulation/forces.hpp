// Forces that depend on the state: springs, loads and compliant ground.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"
#include "simulation/state.hpp"

namespace treedyn::simulation {

Eigen::Vector3d vector_of(const model::Vector3& x);

/// Height of a point over a plane.
class PlaneValues {
 public:
  explicit PlaneValues(const model::Plane& plane)
      : normal_(vector_of(plane.normal)), height_(static_cast<double>(plane.height)) {}
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }
  [[nodiscard]] double height(const Eigen::Vector3d& p) const { return normal_.dot(p) - height_; }
  void raise(double by) { height_ += by; }

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
  /// Elastic energy, J; 0 for a law of the user.
  [[nodiscard]] double energy(const Eigen::Vector3d& p) const;
  /// Its rate, W.
  [[nodiscard]] double energy_rate(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const;
  /// Moves the plane along its normal, m.
  void raise(double by) { plane_.raise(by); }

 private:
  int point_;
  PlaneValues plane_;
  double k_, n_;
  bool is_own_;  ///< the law is one of the user
  model::Expression normal_law_;
  VectorValue force_;
};

/// Everything that acts on a scene apart from reactions and exact dry friction.
class Forces {
 public:
  explicit Forces(const model::Scene& scene);

  /// Generalized force tau - springs - friction + C f + H n, N.
  void generalized(const Terms& terms, const State& state, Vector& Q);
  /// Energy of springs and of the elastic part of contacts, J. \param p  points, 3 P
  [[nodiscard]] double elastic_energy(const Vector& q, const VectorMap& p) const;
  /// Forces one by one, behind `values`: drives, springs of joints, springs of points (positive
  /// towards the anchor), contacts (x, y, z, base frame).
  void append_forces(const Terms& terms, const State& state, std::vector<double>& values);
  /// The rate of this energy, W, after `generalized` in the same state.
  [[nodiscard]] double elastic_power(const Terms& terms, const State& state) const;
  [[nodiscard]] const std::vector<ContactLaw>& contacts() const { return contacts_; }
  /// Whether a contact pushes below its plane; all do until they are told otherwise. A motion that
  /// switches contacts where they begin and end is smooth in between.
  void touch(std::size_t contact, bool touches) { touching_[contact] = touches; }
  /// Moves the plane of a contact along its normal, m.
  void raise(std::size_t contact, double by) { contacts_[contact].raise(by); }

 private:
  struct OfPoint {
    int point = -1;  ///< -1: of none
    model::Expression value;
  };
  struct Load {
    int point = 0;
    VectorValue value;
  };
  struct JointForce {
    int joint = 0;
    model::Expression value;
  };

  void add_point_forces(const Terms& terms, const State& state);
  /// Of the expression of a point, after `v_` in the same state.
  [[nodiscard]] double value_at(int point, const model::Variable& variable, const Terms& terms,
                                const State& state) const;
  [[nodiscard]] Eigen::Vector3d load(const Load& load, const Terms& terms,
                                     const State& state) const;

  std::vector<JointForce> joint_forces_;  ///< all, by joint
  std::vector<OfPoint> shown_;            ///< of drives and springs, as the scene lists them
  std::vector<OfPoint> energies_;         ///< that springs store, of places
  std::vector<Load> torques_;
  std::vector<Load> loads_;  ///< forces
  std::vector<ContactLaw> contacts_;
  std::vector<bool> touching_;
  Vector v_;
  Vector f_;
  Vector n_;
};

}  // namespace treedyn::simulation
