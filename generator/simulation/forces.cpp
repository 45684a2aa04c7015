#include "simulation/forces.hpp"

#include <algorithm>
#include <cmath>

#include "model/force_laws.hpp"

namespace treedyn::simulation {

namespace {

double value(const Real& x) { return static_cast<double>(x); }

/// A value and its time derivative.
struct Moving {
  double x = 0;
  double rate = 0;

  Moving operator-() const { return {-x, -rate}; }
  friend Moving operator+(Moving a, Moving b) { return {a.x + b.x, a.rate + b.rate}; }
  friend Moving operator-(Moving a, Moving b) { return a + -b; }
  friend Moving operator*(Moving a, Moving b) { return {a.x * b.x, a.rate * b.x + a.x * b.rate}; }
  friend Moving operator/(Moving a, Moving b) {
    return {a.x / b.x, (a.rate - a.x / b.x * b.rate) / b.x};
  }
  friend Moving sqrt(Moving a) { return {std::sqrt(a.x), a.rate / (2 * std::sqrt(a.x))}; }
  friend Moving sin(Moving a) { return {std::sin(a.x), std::cos(a.x) * a.rate}; }
  friend Moving cos(Moving a) { return {std::cos(a.x), -std::sin(a.x) * a.rate}; }
};

}  // namespace

Eigen::Vector3d vector_of(const model::Vector3& x) {
  return {value(x[0]), value(x[1]), value(x[2])};
}

ContactLaw::ContactLaw(const model::GroundContact& contact)
    : point_(contact.point),
      plane_(contact.plane),
      k_(value(contact.stiffness)),
      n_(value(contact.exponent)),
      is_own_(contact.law.has_value()),
      normal_law_(model::normal_law(contact)),
      force_(model::contact_force(contact)) {}

Eigen::Vector3d ContactLaw::force(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const {
  const double d = -plane_.height(p);
  if (d <= 0) {
    return Eigen::Vector3d::Zero();
  }
  const Eigen::Vector3d& normal = plane_.normal();
  const double vn = normal.dot(v);
  const double law = normal_law_.evaluate([&](const model::Variable& variable) {
    switch (variable.quantity) {
      case model::Quantity::kDepth:
        return d;
      case model::Quantity::kRaisedDepth:
        return std::pow(d, n_);
      default:
        return vn;
    }
  });
  const double press = law < 0 ? 0 : law;  // a law without a value stays no number
  return force_.evaluate([&](const model::Variable& variable) {
    return variable.quantity == model::Quantity::kPress         ? press
           : variable.quantity == model::Quantity::kNormalSpeed ? vn
                                                                : v[variable.index];
  });
}

double ContactLaw::energy(const Eigen::Vector3d& p) const {
  const double d = is_own_ ? 0 : std::max(0.0, -plane_.height(p));
  return k_ * std::pow(d, n_ + 1) / (n_ + 1);
}

double ContactLaw::energy_rate(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const {
  const double d = is_own_ ? 0 : std::max(0.0, -plane_.height(p));
  return -k_ * std::pow(d, n_) * plane_.normal().dot(v);
}

Forces::Forces(const model::Scene& scene) {
  for (int joint = 0; joint < scene.tree.dof(); ++joint) {
    for (const model::Expression& force : model::joint_forces(scene, joint)) {
      joint_forces_.push_back({joint, force});
    }
  }
  for (const auto& [effect, name] : model::kShownOfJoints) {
    for (const model::JointLaw& law : model::laws_of(scene.joint_laws, effect)) {
      shown_.push_back({-1, law.force});
    }
  }
  for (const model::PointLaw& law : model::laws_of(scene.point_laws, "point_spring")) {
    shown_.push_back({law.point, law.tension});
  }
  for (const model::JointLaw& law : scene.joint_laws) {
    energies_.push_back({-1, law.energy});
  }
  for (const model::PointLaw& law : scene.point_laws) {
    (law.is_moment ? torques_ : loads_).push_back({law.point, VectorValue(law.value)});
    energies_.push_back({law.point, law.energy});
  }
  std::erase_if(energies_, [](const OfPoint& stored) { return stored.value.is_zero(); });
  for (const model::GroundContact& contact : scene.contacts) {
    contacts_.emplace_back(contact);
    touching_.push_back(true);
  }
}

void Forces::generalized(const Terms& terms, const State& state, Vector& Q) {
  Q = Vector::Zero(state.q.size());
  for (const JointForce& force : joint_forces_) {
    Q[force.joint] += value_of(force.value, state);
  }
  if (!terms.needs().points) {
    return;
  }
  v_.noalias() = terms.C().transpose() * state.qd;
  if (!loads_.empty() || !contacts_.empty()) {
    add_point_forces(terms, state);
    Q.noalias() += terms.C() * f_;  // (8)
  }
  if (!torques_.empty()) {
    n_ = Vector::Zero(terms.H().cols());
    for (const Load& torque : torques_) {
      n_.segment<3>(3 * torque.point) += load(torque, terms, state);
    }
    Q.noalias() += terms.H() * n_;  // (8)
  }
}

double Forces::value_at(int point, const model::Variable& variable, const Terms& terms,
                        const State& state) const {
  const Eigen::Index at = 3 * point + variable.index;
  switch (variable.quantity) {
    case model::Quantity::kPointPosition:
      return terms.p()[at];
    case model::Quantity::kPointVelocity:
      return v_[at];
    default:
      return value_in(state, variable);
  }
}

Eigen::Vector3d Forces::load(const Load& load, const Terms& terms, const State& state) const {
  return load.value.evaluate([&](const model::Variable& variable) {
    return value_at(load.point, variable, terms, state);
  });
}

void Forces::add_point_forces(const Terms& terms, const State& state) {
  f_ = Vector::Zero(v_.size());
  const auto p = terms.p();
  for (const Load& force : loads_) {
    f_.segment<3>(3 * force.point) += load(force, terms, state);
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (!touching_[k]) {
      continue;
    }
    const ContactLaw& contact = contacts_[k];
    const int at = 3 * contact.point();
    f_.segment<3>(at) += contact.force(p.segment<3>(at), v_.segment<3>(at));
  }
}

double Forces::elastic_energy(const Vector& q, const VectorMap& p) const {
  double energy = 0;
  for (const OfPoint& stored : energies_) {
    energy += stored.value.evaluate([&](const model::Variable& place) {
      return place.quantity == model::Quantity::kPosition ? q[place.index]
                                                          : p[3 * stored.point + place.index];
    });
  }
  for (const ContactLaw& contact : contacts_) {
    energy += contact.energy(p.segment<3>(3 * contact.point()));
  }
  return energy;
}

void Forces::append_forces(const Terms& terms, const State& state, std::vector<double>& values) {
  if (terms.needs().points) {
    v_.noalias() = terms.C().transpose() * state.qd;
  }
  for (const OfPoint& force : shown_) {
    values.push_back(force.value.evaluate([&](const model::Variable& variable) {
      return value_at(force.point, variable, terms, state);
    }));
  }
  const auto p = terms.p();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const int at = 3 * contacts_[k].point();
    const Eigen::Vector3d f = touching_[k] ? contacts_[k].force(p.segment<3>(at), v_.segment<3>(at))
                                           : Eigen::Vector3d(Eigen::Vector3d::Zero());
    values.insert(values.end(), f.begin(), f.end());
  }
}

double Forces::elastic_power(const Terms& terms, const State& state) const {
  double power = 0;
  for (const OfPoint& stored : energies_) {
    const auto moving = [&](const model::Variable& place) {
      const bool of_joint = place.quantity == model::Quantity::kPosition;
      const Eigen::Index at = 3 * stored.point + place.index;
      return of_joint ? Moving{state.q[place.index], state.qd[place.index]}
                      : Moving{terms.p()[at], v_[at]};
    };
    power += stored.value.evaluate<Moving>([](double x) { return Moving{x, 0}; }, moving).rate;
  }
  const auto p = terms.p();
  for (const ContactLaw& contact : contacts_) {
    const int at = 3 * contact.point();
    power += contact.energy_rate(p.segment<3>(at), v_.segment<3>(at));
  }
  return power;
}

}  // namespace treedyn::simulation
