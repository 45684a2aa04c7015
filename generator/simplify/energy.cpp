#include "simplify/energy.hpp"

#include "simplify/points.hpp"

namespace treedyn::simplify {

namespace {

/// 2 T of one body: m v.v + 2 v.(omega x h) + omega.J omega, J = tr(E) - E.
Expr twice_kinetic_energy(Graph& graph, const Kinematics::Body& body, const Velocity& velocity) {
  const auto& [x, y, z] = velocity.omega;
  const Mat3& e = body.pseudo;
  const Vec3 momentum = body.mass * velocity.origin;
  const Vec3 turning = cross(velocity.omega, body.moment);
  const Expr two = constant(graph, Real(2));
  const Expr rotation =
      sum({(y * y + z * z) * e[0][0], (x * x + z * z) * e[1][1], (x * x + y * y) * e[2][2]});
  const Expr products = sum({(x * y) * e[0][1], (x * z) * e[0][2], (y * z) * e[1][2]});
  return dot(velocity.origin, momentum + two * turning) + (rotation - two * products);
}

}  // namespace

Expr kinetic_energy(const Kinematics& k) {
  const std::vector<Velocity> velocity = velocities(k);
  Expr twice;
  for (int i = 0; i < k.size(); ++i) {
    k.graph().set_body(i);
    twice += twice_kinetic_energy(k.graph(), k.body(i), velocity[static_cast<std::size_t>(i)]);
  }
  return constant(k.graph(), Real("0.5")) * twice;
}

}  // namespace treedyn::simplify
