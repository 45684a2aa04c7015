#include "simulation/pose.hpp"

#include <Eigen/Geometry>

#include "simulation/forces.hpp"

namespace treedyn::simulation {

namespace {

Eigen::Matrix3d matrix_of(const model::Matrix3& m) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = static_cast<double>(m[static_cast<std::size_t>(3 * i + j)]);
    }
  }
  return result;
}

LinkState ground() {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return {Eigen::Matrix3d::Identity(), zero, zero, zero, zero, zero};
}

}  // namespace

Pose::Pose(const model::Tree& tree, const model::Vector3& gravity)
    : states_(tree.links.size(), ground()), gravity_(vector_of(gravity)) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const model::Link& link = tree.links[i];
    const model::Drive& drive = tree.drives[i];
    bodies_.push_back({drive.coordinate, static_cast<double>(drive.multiplier),
                       static_cast<double>(drive.offset), link.father, link.joint.turns(),
                       vector_of(link.joint.axis), vector_of(link.joint.offset),
                       vector_of(link.inertia.com), matrix_of(link.joint.rotation),
                       matrix_of(link.inertia.about_com), static_cast<double>(link.inertia.mass)});
  }
}

void Pose::update(const Vector& q, const Vector& qd) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    const LinkState father =
        body.father == model::kGround ? ground() : states_[static_cast<std::size_t>(body.father)];
    const double x = body.multiplier * q[body.coordinate] + body.lead;
    const double rate = body.multiplier * qd[body.coordinate];
    LinkState& s = states_[i];
    const Eigen::Matrix3d R0 = father.R * body.R0;
    const Eigen::Vector3d z = R0 * body.axis;
    Eigen::Vector3d step = father.R * body.offset;
    s.R = R0;
    if (body.revolute) {
      s.R = R0 * Eigen::AngleAxisd(x, body.axis);
    }
    step += body.revolute ? Eigen::Vector3d::Zero() : Eigen::Vector3d(x * z);
    s.O = father.O + step;
    s.omega = father.omega;
    s.v = father.v + father.omega.cross(step);
    (body.revolute ? s.omega : s.v) += rate * z;
    s.r = s.O + s.R * body.com;
    s.r_dot = s.v + s.omega.cross(s.r - s.O);
  }
}

Eigen::Matrix3d Pose::inertia(std::size_t i) const {
  return states_[i].R * bodies_[i].J * states_[i].R.transpose();
}

double Pose::kinetic_energy() const {
  double T = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const LinkState& s = states_[i];
    T += 0.5 * (bodies_[i].mass * s.r_dot.squaredNorm() + s.omega.dot(inertia(i) * s.omega));
  }
  return T;
}

double Pose::potential_energy() const {
  double U = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    U -= bodies_[i].mass * gravity_.dot(states_[i].r);
  }
  return U;
}

Eigen::Vector3d Pose::linear_momentum() const {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    p += bodies_[i].mass * states_[i].r_dot;
  }
  return p;
}

Eigen::Vector3d Pose::angular_momentum() const {
  Eigen::Vector3d L = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const LinkState& s = states_[i];
    L += bodies_[i].mass * s.r.cross(s.r_dot) + inertia(i) * s.omega;
  }
  return L;
}

Eigen::Vector3d Pose::point(int link, const Eigen::Vector3d& at) const {
  const LinkState& s = states_[static_cast<std::size_t>(link)];
  return s.O + s.R * at;
}

}  // namespace treedyn::simulation
