#include "model/mass_unit.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::model {

namespace {

/// What resists the joint of a link: m, or I + m c^2.
double resistance(const Link& link) {
  const Inertia& inertia = link.inertia;
  if (link.joint.type == JointType::kPrismatic) {
    return inertia.mass.convert_to<double>();
  }
  double most = 0;
  for (std::size_t k = 0; k < 9; k += 4) {
    most = std::max(most, inertia.about_com[k].convert_to<double>());
  }
  double arm = 0;
  for (const Real& c : inertia.com) {
    arm += c.convert_to<double>() * c.convert_to<double>();
  }
  return most + inertia.mass.convert_to<double>() * arm;
}

}  // namespace

Real mass_unit(const Tree& tree) {
  double most = 0;
  for (const Link& link : tree.links) {
    most = std::max(most, resistance(link));
  }
  const bool near = most == 0 || !std::isfinite(most) || (most > 1e-12 && most < 1e12);
  return near ? Real(1) : Real(ldexp(Real(1), std::ilogb(most)));
}

Tree in_mass_unit(Tree tree, const Real& unit) {
  for (Link& link : tree.links) {
    link.inertia.mass /= unit;
    for (Real& x : link.inertia.about_com) {
      x /= unit;
    }
  }
  return tree;
}

}  // namespace treedyn::model
