#include "simulation/forces.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::simulation {

namespace {

double value(const Real& x) { return static_cast<double>(x); }

}  // namespace

Eigen::Vector3d vector_of(const model::Vector3& x) {
  return {value(x[0]), value(x[1]), value(x[2])};
}

ContactLaw::ContactLaw(const model::GroundContact& contact)
    : point_(contact.point),
      plane_(contact.plane),
      k_(value(contact.stiffness)),
      n_(value(contact.exponent)),
      c_(value(contact.dissipation)),
      mu_(value(contact.friction)),
      vs_(value(contact.slip_speed)) {}

Eigen::Vector3d ContactLaw::force(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const {
  const double d = -plane_.height(p);
  if (d <= 0) {
    return Eigen::Vector3d::Zero();
  }
  const Eigen::Vector3d& normal = plane_.normal();
  const double vn = normal.dot(v);
  const double f = std::max(0.0, k_ * std::pow(d, n_) * (1 - c_ * vn));
  const Eigen::Vector3d vt = v - vn * normal;
  const double slip = std::sqrt(vt.squaredNorm() + vs_ * vs_);
  return mu_ == 0 ? Eigen::Vector3d(f * normal)
                  : Eigen::Vector3d(f * normal - (mu_ * f / slip) * vt);
}

double ContactLaw::energy(const Eigen::Vector3d& p) const {
  const double d = std::max(0.0, -plane_.height(p));
  return k_ * std::pow(d, n_ + 1) / (n_ + 1);
}

Forces::Forces(const model::Scene& scene) : tau_(Vector::Zero(scene.tree.dof())) {
  for (std::size_t k = 0; k < scene.tau.size(); ++k) {
    tau_[static_cast<Eigen::Index>(k)] = value(scene.tau[k]);
  }
  for (const model::JointSpring& s : scene.joint_springs) {
    joint_springs_.push_back({s.joint, value(s.stiffness), value(s.damping), value(s.rest)});
  }
  for (const model::PointSpring& s : scene.point_springs) {
    point_springs_.push_back(
        {s.point, vector_of(s.anchor), value(s.stiffness), value(s.damping), value(s.rest_length)});
  }
  for (const model::PointLoad& load : scene.torques) {
    torques_.push_back({load.point, vector_of(load.value)});
  }
  for (const model::PointLoad& load : scene.forces) {
    loads_.push_back({load.point, vector_of(load.value)});
  }
  for (const model::GroundContact& contact : scene.contacts) {
    contacts_.emplace_back(contact);
  }
  n_ = Vector::Zero(3 * static_cast<Eigen::Index>(scene.points.size()));
  for (const Load& load : torques_) {
    n_.segment<3>(3 * load.point) += load.value;
  }
}

void Forces::generalized(const Terms& terms, const Vector& q, const Vector& qd, Vector& Q) {
  Q = tau_;
  for (const JointSpring& s : joint_springs_) {
    Q[s.joint] -= s.k * (q[s.joint] - s.rest) + s.d * qd[s.joint];
  }
  if (!point_springs_.empty() || !loads_.empty() || !contacts_.empty()) {
    add_point_forces(terms, qd);
    Q.noalias() += terms.C() * f_;  // (8)
  }
  if (!torques_.empty()) {
    Q.noalias() += terms.H() * n_;  // (8)
  }
}

void Forces::add_point_forces(const Terms& terms, const Vector& qd) {
  v_.noalias() = terms.C().transpose() * qd;
  f_ = Vector::Zero(v_.size());
  const auto p = terms.p();
  for (const PointSpring& s : point_springs_) {
    const Eigen::Vector3d line = p.segment<3>(3 * s.point) - s.anchor;
    const double l = line.norm();
    if (l > 0) {
      const double rate = line.dot(v_.segment<3>(3 * s.point)) / l;
      f_.segment<3>(3 * s.point) -= (s.k * (l - s.length) + s.d * rate) / l * line;
    }
  }
  for (const Load& load : loads_) {
    f_.segment<3>(3 * load.point) += load.value;
  }
  for (const ContactLaw& contact : contacts_) {
    const int at = 3 * contact.point();
    f_.segment<3>(at) += contact.force(p.segment<3>(at), v_.segment<3>(at));
  }
}

double Forces::elastic_energy(const Vector& q, const VectorMap& p) const {
  double energy = 0;
  for (const JointSpring& s : joint_springs_) {
    energy += s.k / 2 * (q[s.joint] - s.rest) * (q[s.joint] - s.rest);
  }
  for (const PointSpring& s : point_springs_) {
    const double l = (p.segment<3>(3 * s.point) - s.anchor).norm();
    energy += s.k / 2 * (l - s.length) * (l - s.length);
  }
  for (const ContactLaw& contact : contacts_) {
    energy += contact.energy(p.segment<3>(3 * contact.point()));
  }
  return energy;
}

}  // namespace treedyn::simulation
