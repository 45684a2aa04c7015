#include "simplify/articulated.hpp"

namespace treedyn::simplify {

namespace {

Mat3 inertia_tensor(const Mat3& e) {
  return {{{e[1][1] + e[2][2], -e[0][1], -e[0][2]},
           {-e[0][1], e[0][0] + e[2][2], -e[1][2]},
           {-e[0][2], -e[1][2], e[0][0] + e[1][1]}}};
}

Mat3 skew(const Vec3& h) {
  return {{{Expr(), -h[2], h[1]}, {h[2], Expr(), -h[0]}, {-h[1], h[0], Expr()}}};
}

/// vee(Omega E) for Omega = Lambda(omega)^2.
Vec3 centrifugal_moment(const Mat3& Omega, const Mat3& e) {
  const Mat3 m = Omega * e;
  return {m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
}

Mat3 transposed(const Mat3& a) {
  return {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
}

}  // namespace

ArticulatedLimbs::ArticulatedLimbs(const Kinematics& k, int first, const Vec3& omega,
                                   const JointForce& force)
    : k_(k),
      force_(force),
      first_(first),
      omega_(index(k.size())),
      zeta_angular_(index(k.size())),
      zeta_linear_(index(k.size())),
      inertia_(index(k.size())),
      joint_(index(k.size())) {
  if (first > 0) {
    start(first - 1, omega);
  }
  for (int i = first; i < k.size(); ++i) {
    velocity(i);
  }
  for (int i = k.size() - 1; i >= first; --i) {
    fold(i);
  }
}

/// The link's own inertia and p = (Omega h, vee(Omega E)).
void ArticulatedLimbs::start(int i, const Vec3& omega) {
  Graph& graph = k_.graph();
  graph.set_body(i);
  omega_[index(i)] = omega;
  const Kinematics::Body body = k_.body(i);
  const Mat3 Omega = skew_squared(omega);
  ArticulatedInertia& own = inertia_[index(i)];
  own.tensor = inertia_tensor(body.pseudo);
  own.coupling = skew(body.moment);
  own.mass[0][0] = own.mass[1][1] = own.mass[2][2] = body.mass;
  own.bias = {Omega * body.moment, centrifugal_moment(Omega, body.pseudo)};
  name(graph, omega, "omega", i);
}

void ArticulatedLimbs::velocity(int i) {
  const int f = k_.link(i).father;
  const Vec3 father = f == model::kGround ? Vec3{} : omega_[index(f)];
  k_.graph().set_body(i);
  const Expr qd = k_.speed(i);
  const Vec3 w = k_.from_father(i, father);
  Vec3& linear = zeta_linear_[index(i)];
  linear = k_.from_father(i, skew_squared(father) * k_.offset(i));  // omega x (omega x s)
  if (k_.link(i).revolute) {
    zeta_angular_[index(i)] = {w[1] * qd, -(w[0] * qd), Expr()};  // omega x z qd
    start(i, {w[0], w[1], w[2] + qd});
  } else {
    const Expr two = constant(k_.graph(), Real(2));
    linear = linear + Vec3{two * (w[1] * qd), -(two * (w[0] * qd)), Expr()};
    start(i, w);
  }
  name(k_.graph(), linear, "zeta", i);
}

void ArticulatedLimbs::fold(int i) {
  const ArticulatedInertia& body = inertia_[index(i)];
  k_.graph().set_body(i);
  const bool revolute = k_.link(i).revolute;
  Joint& joint = joint_[index(i)];
  joint.moment = column(revolute ? body.tensor : body.coupling, 2);
  joint.force = revolute ? body.coupling[2] : body.mass[2];
  const Expr diagonal = revolute ? joint.moment[2] : joint.force[2];
  const Expr bias = revolute ? body.bias.moment[2] : body.bias.force[2];
  joint.inverse = constant(k_.graph(), Real(1)) / diagonal;
  joint.rest = force_(i) - bias;
  k_.graph().name(joint.inverse.ref(), "inverse_pivot", i);
  k_.graph().name(joint.rest.ref(), "u", i);
  const int f = k_.link(i).father;
  if (f != model::kGround) {
    ArticulatedInertia projected;
    project(i, projected);
    add_to_father(i, projected);
  }
}

/// Inertia and bias of link i without the direction in which its joint yields.
void ArticulatedLimbs::project(int i, ArticulatedInertia& projected) {
  const ArticulatedInertia& body = inertia_[index(i)];
  const Joint& joint = joint_[index(i)];
  const bool revolute = k_.link(i).revolute;
  const Expr one = constant(k_.graph(), Real(1));
  Vec3 moment = joint.inverse * joint.moment;
  Vec3 force = joint.inverse * joint.force;
  (revolute ? moment : force)[2] = one;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      if (!(revolute && b == 2)) {
        projected.tensor[a][b] = projected.tensor[b][a] =
            body.tensor[a][b] - joint.moment[a] * moment[b];
      }
      if (revolute || b != 2) {
        projected.mass[a][b] = projected.mass[b][a] = body.mass[a][b] - joint.force[a] * force[b];
      }
    }
    for (std::size_t b = 0; b < 3; ++b) {
      if (revolute ? a != 2 : b != 2) {
        projected.coupling[a][b] = body.coupling[a][b] - joint.moment[a] * force[b];
      }
    }
  }
  Wrench bias = {body.bias.force + joint.rest * force, body.bias.moment + joint.rest * moment};
  (revolute ? bias.moment : bias.force)[2] = force_(i);
  const Vec3& angular = zeta_angular_[index(i)];
  const Vec3& linear = zeta_linear_[index(i)];
  projected.bias.force =
      bias.force + (transposed(projected.coupling) * angular + projected.mass * linear);
  projected.bias.moment = bias.moment + (projected.tensor * angular + projected.coupling * linear);
}

/// Shifts by s to the father's origin: H' = H + s x M,  I' = I - H' s x + s x H^T.
void ArticulatedLimbs::add_to_father(int i, const ArticulatedInertia& projected) {
  const Vec3& s = k_.offset(i);
  const Mat3 tensor = k_.to_father_symmetric(i, projected.tensor);
  const Mat3 mass = k_.to_father_symmetric(i, projected.mass);
  const Mat3 coupling = k_.to_father_general(i, projected.coupling);
  const Vec3 force = k_.to_father(i, projected.bias.force);
  const Vec3 moment = k_.to_father(i, projected.bias.moment);
  ArticulatedInertia& father = inertia_[index(k_.link(i).father)];
  Mat3 shifted;
  for (std::size_t b = 0; b < 3; ++b) {
    const Vec3 lever = cross(s, column(mass, b));
    for (std::size_t a = 0; a < 3; ++a) {
      shifted[a][b] = coupling[a][b] + lever[a];
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3 first = cross(shifted[a], s);
    for (std::size_t b = a; b < 3; ++b) {
      const Vec3 second = cross(s, coupling[b]);
      father.tensor[a][b] += tensor[a][b] + (second[a] - first[b]);
      father.tensor[b][a] = father.tensor[a][b];
    }
    for (std::size_t b = 0; b < 3; ++b) {
      father.mass[a][b] += mass[a][b];
      father.coupling[a][b] += shifted[a][b];
    }
  }
  father.bias.force = father.bias.force + force;
  father.bias.moment = father.bias.moment + (moment + cross(s, force));
}

std::vector<Expr> ArticulatedLimbs::accelerations(const Vec3& alpha, const Vec3& a) const {
  std::vector<Vec3> angular(index(k_.size()));
  std::vector<Vec3> linear(index(k_.size()));
  std::vector<Expr> qdd(index(k_.size()));
  for (int i = first_; i < k_.size(); ++i) {
    const int f = k_.link(i).father;
    const bool from_start = f < first_;
    k_.graph().set_body(i);
    const Vec3 father_alpha = from_start ? alpha : angular[index(f)];
    const Vec3 father_a = from_start ? a : linear[index(f)];
    Vec3 alpha_i = k_.from_father(i, father_alpha) + zeta_angular_[index(i)];
    Vec3 a_i =
        k_.from_father(i, father_a + cross(father_alpha, k_.offset(i))) + zeta_linear_[index(i)];
    const Joint& joint = joint_[index(i)];
    const Expr x =
        joint.inverse * (joint.rest - (dot(joint.moment, alpha_i) + dot(joint.force, a_i)));
    (k_.link(i).revolute ? alpha_i : a_i)[2] += x;
    angular[index(i)] = alpha_i;
    linear[index(i)] = a_i;
    qdd[index(i)] = k_.link(i).sign > 0 ? x : -x;
  }
  return qdd;
}

std::vector<Expr> articulated_forward_dynamics(const Kinematics& k, const Vec3& ground,
                                               const JointForce& force) {
  return ArticulatedLimbs(k, 0, {}, force).accelerations({}, ground);
}

}  // namespace treedyn::simplify
