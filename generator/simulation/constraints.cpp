#include "simulation/constraints.hpp"

#include <Eigen/QR>

namespace treedyn::simulation {

namespace {

using model::ConstraintKind;

Eigen::Matrix3d rotation(const Terms& terms, int point) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(terms.R().data() +
                                                                        9 * point);
}

/// sin(angle) axis of the turn from `from` to `to`, base frame.
Eigen::Vector3d turn(const Eigen::Matrix3d& to, const Eigen::Matrix3d& from) {
  const Eigen::Matrix3d E = to * from.transpose();
  return 0.5 * Eigen::Vector3d(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1));
}

/// What a constraint asks for is the rate of a position; of an orientation only if its directions
/// span the space.
bool is_rate_of_position(const model::Constraint& c) {
  if (c.kind != ConstraintKind::kOrientation) {
    return true;
  }
  Eigen::Matrix3Xd directions(3, static_cast<Eigen::Index>(c.rows()));
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    directions.col(k) = vector_of(c.directions[static_cast<std::size_t>(k)]);
  }
  return directions.colPivHouseholderQr().rank() == 3;
}

}  // namespace

Constraints::Constraints(const model::Scene& scene) {
  for (const model::Constraint& c : scene.constraints) {
    Item item{c.pinned,
              is_rate_of_position(c),
              c.kind,
              c.point,
              c.other,
              c.joint,
              {},
              {VectorValue(c.curve.position), VectorValue(c.curve.velocity),
               VectorValue(c.curve.acceleration)},
              c.accelerations,
              Eigen::Vector3d::Zero(),
              Eigen::Matrix3d::Identity()};
    for (const model::Vector3& d : c.directions) {
      item.directions.push_back(vector_of(d));
    }
    if (c.kind == ConstraintKind::kJoint) {
      item.directions = {Eigen::Vector3d::UnitX()};  // of the curve, whose x is the joint's goal
    }
    items_.push_back(std::move(item));
  }
}

void Constraints::activate(const std::vector<int>& constraints) {
  active_ = constraints;
  rows_.clear();
  for (const int c : constraints) {
    for (std::size_t k = 0; k < item(c).directions.size(); ++k) {
      rows_.push_back({c, k, item(c).directions[k]});
    }
  }
}

void Constraints::reset() {
  activate({});
  for (Item& item : items_) {
    item.shift.setZero();
  }
}

Eigen::Vector3d Constraints::position(const Item& item, double t) const {
  return item.curve[0].at(t) + item.shift;
}

void Constraints::begin(int constraint, double t, const Vector& q, const Terms& terms) {
  const Item& item = items_[static_cast<std::size_t>(constraint)];
  if (item.pinned || item.kind == ConstraintKind::kOrientation) {
    pin(constraint, t, q, terms);
  }
}

void Constraints::pin(int constraint, double t, const Vector& q, const Terms& terms) {
  Item& item = items_[static_cast<std::size_t>(constraint)];
  if (item.kind == ConstraintKind::kPoint) {
    item.shift += terms.p().segment<3>(3 * item.point) - position(item, t);
  }
  if (item.kind == ConstraintKind::kJoint) {
    item.shift[0] += q[item.joint] - position(item, t)[0];
  }
  if (item.kind == ConstraintKind::kOrientation) {
    item.orientation = rotation(terms, item.point);
  }
}

void Constraints::jacobian(const Terms& terms, Matrix& J) const {
  J.setZero(rows(), terms.dof());
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    const Eigen::Vector3d& d = at(k).d;
    switch (c.kind) {
      case ConstraintKind::kPoint:
        J.row(k).noalias() = (terms.C().middleCols<3>(3 * c.point) * d).transpose();
        break;
      case ConstraintKind::kOrientation:
        J.row(k).noalias() = (terms.H().middleCols<3>(3 * c.point) * d).transpose();
        break;
      case ConstraintKind::kJoined:
        J.row(k).noalias() = (terms.C().middleCols<3>(3 * c.point) * d).transpose();
        J.row(k).noalias() -= (terms.C().middleCols<3>(3 * c.other) * d).transpose();
        break;
      case ConstraintKind::kJoint:
        J(k, c.joint) = 1;
        break;
    }
  }
}

void Constraints::errors(const Terms& terms, double t, const Vector& q, Vector& phi) const {
  phi.setZero(rows());
  for (int k = 0; k < rows(); ++k) {
    if (!has_position(k)) {
      continue;
    }
    const Item& c = item(at(k).item);
    const auto p = [&](int point) {
      return Eigen::Vector3d(terms.p().segment<3>(3 * point));
    };
    switch (c.kind) {
      case ConstraintKind::kPoint:
        phi[k] = at(k).d.dot(p(c.point) - position(c, t));
        break;
      case ConstraintKind::kOrientation:
        phi[k] = at(k).d.dot(turn(rotation(terms, c.point), c.orientation));
        break;
      case ConstraintKind::kJoined:
        phi[k] = at(k).d.dot(p(c.point) - p(c.other));
        break;
      case ConstraintKind::kJoint:
        phi[k] = q[c.joint] - position(c, t)[0];
        break;
    }
  }
}

void Constraints::velocities(double t, Vector& rate) const {
  rate.setZero(rows());
  for (int k = 0; k < rows(); ++k) {
    if (is_held(k)) {
      rate[k] = at(k).d.dot(item(at(k).item).curve[1].at(t));
    }
  }
}

/// gamma of a row: d/dt(J) qd.
double Constraints::bias(const Terms& terms, const Row& row) const {
  const Item& c = item(row.item);
  const auto gamma = [&](const VectorMap& all, int point) {
    return row.d.dot(all.segment<3>(3 * point));
  };
  switch (c.kind) {
    case ConstraintKind::kPoint:
      return gamma(terms.gamma_f(), c.point);
    case ConstraintKind::kOrientation:
      return gamma(terms.gamma_n(), c.point);
    case ConstraintKind::kJoined:
      return gamma(terms.gamma_f(), c.point) - gamma(terms.gamma_f(), c.other);
    case ConstraintKind::kJoint:
      break;
  }
  return 0;
}

void Constraints::accelerations(const Terms& terms, const State& state, Vector& rhs) const {
  bends(terms, rhs);
  for (int k = 0; k < rows(); ++k) {
    const Item& c = item(at(k).item);
    const double wanted = is_held(k) ? at(k).d.dot(c.curve[2].at(state.t))
                                     : value_of(c.accelerations[at(k).number], state);
    rhs[k] += wanted;
  }
}

void Constraints::bends(const Terms& terms, Vector& rhs) const {
  rhs.resize(rows());
  for (int k = 0; k < rows(); ++k) {
    rhs[k] = -bias(terms, at(k));
  }
}

}  // namespace treedyn::simulation
