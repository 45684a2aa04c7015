#include "simulation/constraints.hpp"

#include <cmath>

namespace treedyn::simulation {

namespace {

using model::ConstraintKind;

double value(const Real& x) { return static_cast<double>(x); }

Eigen::Matrix3d rotation(const Terms& terms, int point) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(terms.R().data() +
                                                                        9 * point);
}

/// sin(angle) axis of the turn from `from` to `to`, base frame.
Eigen::Vector3d turn(const Eigen::Matrix3d& to, const Eigen::Matrix3d& from) {
  const Eigen::Matrix3d E = to * from.transpose();
  return 0.5 * Eigen::Vector3d(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1));
}

}  // namespace

Eigen::Vector3d Constraints::Curve::at(double t, int derivative) const {
  const double angle = omega * t + phase;
  switch (derivative) {
    case 0:
      return center + velocity * t + A1 * std::cos(angle) * u + A2 * std::sin(angle) * v;
    case 1:
      return velocity - A1 * omega * std::sin(angle) * u + A2 * omega * std::cos(angle) * v;
    default:
      return -omega * omega * (A1 * std::cos(angle) * u + A2 * std::sin(angle) * v);
  }
}

Constraints::Constraints(const model::Scene& scene) {
  for (const model::Constraint& c : scene.constraints) {
    Item item{c.kind, c.point, c.other, {}, {}, Eigen::Matrix3d::Identity()};
    for (const model::Vector3& d : c.directions) {
      item.directions.push_back(vector_of(d));
    }
    item.curve = {vector_of(c.curve.center), vector_of(c.curve.velocity), vector_of(c.curve.u),
                  vector_of(c.curve.v),      value(c.curve.A1),           value(c.curve.A2),
                  value(c.curve.omega),      value(c.curve.phase)};
    items_.push_back(std::move(item));
  }
}

void Constraints::activate(const std::vector<int>& constraints) {
  active_ = constraints;
  rows_.clear();
  for (const int c : constraints) {
    for (const Eigen::Vector3d& d : item(c).directions) {
      rows_.push_back({c, d});
    }
  }
}

bool Constraints::is_force(int row) const {
  return item(at(row).item).kind == ConstraintKind::kPoint;
}

void Constraints::hold(int constraint, const Terms& terms) {
  Item& item = items_[static_cast<std::size_t>(constraint)];
  if (item.kind == ConstraintKind::kOrientation) {
    item.orientation = rotation(terms, item.point);
  }
}

void Constraints::pin(int constraint, double t, const Terms& terms) {
  Item& item = items_[static_cast<std::size_t>(constraint)];
  if (item.kind == ConstraintKind::kPoint) {
    item.curve.center += terms.p().segment<3>(3 * item.point) - item.curve.at(t, 0);
  }
  hold(constraint, terms);
}

void Constraints::jacobian(const Terms& terms, Matrix& J) const {
  J.resize(rows(), terms.dof());
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    if (c.kind == ConstraintKind::kOrientation) {
      J.row(k).noalias() = (terms.H().middleCols<3>(3 * c.point) * at(k).d).transpose();
      continue;
    }
    J.row(k).noalias() = (terms.C().middleCols<3>(3 * c.point) * at(k).d).transpose();
    if (c.kind == ConstraintKind::kJoined) {
      J.row(k).noalias() -= (terms.C().middleCols<3>(3 * c.other) * at(k).d).transpose();
    }
  }
}

void Constraints::errors(const Terms& terms, double t, Vector& phi) const {
  phi.resize(rows());
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    if (c.kind == ConstraintKind::kOrientation) {
      phi[k] = at(k).d.dot(turn(rotation(terms, c.point), c.orientation));
    } else {
      const Eigen::Vector3d goal = c.kind == ConstraintKind::kJoined
                                       ? Eigen::Vector3d(terms.p().segment<3>(3 * c.other))
                                       : c.curve.at(t, 0);
      phi[k] = at(k).d.dot(terms.p().segment<3>(3 * c.point) - goal);
    }
  }
}

void Constraints::velocities(double t, Vector& rate) const {
  rate.resize(rows());
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    rate[k] = c.kind == ConstraintKind::kPoint ? at(k).d.dot(c.curve.at(t, 1)) : 0;
  }
}

void Constraints::accelerations(const Terms& terms, double t, Vector& rhs) const {
  rhs.resize(rows());
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    const auto gamma = [&](const VectorMap& all, int point) {
      return at(k).d.dot(all.segment<3>(3 * point));
    };
    switch (c.kind) {
      case ConstraintKind::kPoint:
        rhs[k] = at(k).d.dot(c.curve.at(t, 2)) - gamma(terms.gamma_f(), c.point);
        break;
      case ConstraintKind::kOrientation:
        rhs[k] = -gamma(terms.gamma_n(), c.point);
        break;
      case ConstraintKind::kJoined:
        rhs[k] = gamma(terms.gamma_f(), c.other) - gamma(terms.gamma_f(), c.point);
        break;
    }
  }
}

}  // namespace treedyn::simulation
