#include "formulate/regrouping.hpp"

namespace treedyn::formulate {

namespace {

/// Moves mass at the origin, first moment along z and Ψ_zz from revolute link l to its father:
/// exact, because the joint cannot feel them (EQUATIONS.md 8).
// Copies, as they may be numbers of the link itself.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void move_to_father(NormalTree& tree, NormalLink& l, Real mass, Real moment, Real pseudo) {
  l.mass -= mass;
  l.moment[2] -= moment;
  l.pseudo[8] -= pseudo;
  const Vector3 z = {l.rotation[2], l.rotation[5], l.rotation[8]};
  const Vector3 h = moment * z;
  const Vector3 received = h + mass * l.offset;
  if (l.father == model::kGround) {
    tree.ground_moment = tree.ground_moment + received;
    return;
  }
  NormalLink& f = tree.links[static_cast<std::size_t>(l.father)];
  const Vector3& r = l.offset;
  f.pseudo = f.pseudo + pseudo * outer(z, z) + outer(r, h) + outer(h, r) + mass * outer(r, r);
  f.moment = f.moment + received;
  f.mass += mass;
}

/// True if a mass may be chosen by its moment along `axis`: over a lever that is the rounding of a
/// zero (1e-12 m beside 1 m) it would be huge, and cancel later; one that is known at run time only
/// may be zero.
bool is_lever(const Vector3& seen, std::size_t axis) {
  const Vector3 offset = plain(seen);
  const Real length = abs(offset[0]) + abs(offset[1]) + abs(offset[2]);
  return seen[axis] != 0 && seen[axis].recipe() == 0 &&
         abs(offset[axis]) > Real("1e-6") + length * Real("1e-4");
}

/// The mass that passes to the father.
Real moved_mass(const NormalTree& tree, const NormalLink& l, MassGauge gauge) {
  if (gauge == MassGauge::kKeepMass) {
    return 0;
  }
  if (gauge == MassGauge::kAll || l.father == model::kGround) {
    return l.mass;
  }
  const auto axis = static_cast<std::size_t>(gauge) - static_cast<std::size_t>(MassGauge::kCancelX);
  if (!is_lever(l.offset, axis)) {
    return l.mass;
  }
  const NormalLink& father = tree.links[static_cast<std::size_t>(l.father)];
  return -(father.moment[axis] + l.rotation[3 * axis + 2] * l.moment[2]) / l.offset[axis];
}

/// The part of Ψ_zz that passes to the father.
Real moved_second_moment(const NormalLink& l, TensorGauge gauge) {
  switch (gauge) {
    case TensorGauge::kZz:
      return l.pseudo[8];
    case TensorGauge::kZzPlusXx:
      return l.pseudo[8] + l.pseudo[0];
    case TensorGauge::kZzPlusYy:
      return l.pseudo[8] + l.pseudo[4];
    case TensorGauge::kKeep:
      break;
  }
  return 0;
}

}  // namespace

void regroup(NormalTree& tree, int i, const LinkVariant& how) {
  NormalLink& l = tree.links[static_cast<std::size_t>(i)];
  if (!l.revolute || how.mass == MassGauge::kNothing) {
    return;
  }
  move_to_father(tree, l, moved_mass(tree, l, how.mass), l.moment[2],
                 moved_second_moment(l, how.tensor));
}

void clean_constants(NormalTree& tree) {
  Real mass = 0;
  Real moment = 0;
  Real pseudo = 0;
  Real offset = 0;
  const auto raise = [](Real& bound, const auto& values) {
    for (const Real& value : values) {
      bound = larger(bound, value);
    }
  };
  for (const NormalLink& l : tree.links) {
    mass = larger(mass, l.mass);
    raise(moment, l.moment);
    raise(pseudo, l.pseudo);
    raise(offset, l.offset);
  }
  const auto drop = [](auto& values, const Real& bound) {
    for (Real& value : values) {
      value = negligible(value, bound) ? Real(0) : value;
    }
  };
  for (NormalLink& l : tree.links) {
    l.mass = negligible(l.mass, mass) ? Real(0) : l.mass;
    drop(l.moment, moment);
    drop(l.pseudo, pseudo);
    drop(l.offset, offset);
  }
}

}  // namespace treedyn::formulate
