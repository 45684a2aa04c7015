// Joints without inertia, from the pivots of A at a general position.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/algebra.hpp"
#include "description/read.hpp"

namespace treedyn::description {

namespace {

using Motion = std::array<Real, 6>;    ///< (omega, velocity of the link's origin), link frame
using Spatial = std::array<Real, 36>;  ///< row-major 6x6

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Matrix3 skew(const Vector3& a) { return {0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0}; }

void set_block(Spatial& a, std::size_t row, std::size_t column, const Matrix3& block) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      a[6 * (3 * row + k) + 3 * column + l] = block[3 * k + l];
    }
  }
}

Spatial product(const Spatial& a, const Spatial& b) {
  Spatial result{};
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t m = 0; m < 6; ++m) {
      if (a[6 * k + m] == 0) {
        continue;
      }
      for (std::size_t l = 0; l < 6; ++l) {
        result[6 * k + l] += a[6 * k + m] * b[6 * m + l];
      }
    }
  }
  return result;
}

Spatial transposed(const Spatial& a) {
  Spatial result;
  for (std::size_t k = 0; k < 36; ++k) {
    result[k] = a[6 * (k % 6) + k / 6];
  }
  return result;
}

Motion product(const Spatial& a, const Motion& x) {
  Motion result{};
  for (std::size_t k = 0; k < 36; ++k) {
    result[k / 6] += a[k] * x[k % 6];
  }
  return result;
}

Real dot(const Motion& a, const Motion& b) {
  Real result = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    result += a[k] * b[k];
  }
  return result;
}

void add(Spatial& a, const Spatial& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                 [](const Real& x, const Real& y) { return Real(x + y); });
}

/// Inertia about the link's origin: [ J - m Lambda(c)^2, m Lambda(c); -m Lambda(c), m E ].
Spatial spatial_inertia(const model::Inertia& inertia) {
  Spatial result{};
  const Real& m = inertia.mass;
  const Matrix3 h = skew(m * inertia.com);
  set_block(result, 0, 0, inertia.about_com + point_inertia(m, inertia.com));
  set_block(result, 0, 1, h);
  set_block(result, 1, 0, description::transposed(h));
  set_block(result, 1, 1, {m, 0, 0, 0, m, 0, 0, 0, m});
  return result;
}

/// A position without symmetry: 0.3 .. 1.3, spread by the golden ratio.
Real general_position(int i) {
  const Real turns = Real(i + 1) * Real("0.6180339887498948482");
  return Real("0.3") + turns - floor(turns);
}

/// Motions of the father's frame to motions of the link's frame: [ E, 0; -E Lambda(r), E ].
Spatial to_link(const model::Joint& joint, const Real& q) {
  const Vector3& a = joint.axis;
  Matrix3 r = joint.rotation;
  Vector3 origin = joint.offset;
  if (joint.type == model::JointType::kRevolute) {
    const Real s = sin(q);
    const Real v = 1 - cos(q);
    const Matrix3 l = skew(a);
    const Matrix3 l2 = l * l;
    Matrix3 turn = identity();
    for (std::size_t k = 0; k < 9; ++k) {
      turn[k] += s * l[k] + v * l2[k];
    }
    r = r * turn;
  } else {
    origin = origin + r * (q * a);
  }
  const Matrix3 e = description::transposed(r);
  Spatial x{};
  set_block(x, 0, 0, e);
  set_block(x, 1, 1, e);
  set_block(x, 1, 0, e * skew(Real(-1) * origin));
  return x;
}

Motion joint_motion(const model::Joint& joint) {
  const Vector3& a = joint.axis;
  return joint.type == model::JointType::kRevolute ? Motion{a[0], a[1], a[2], 0, 0, 0}
                                                   : Motion{0, 0, 0, a[0], a[1], a[2]};
}

/// What a joint moves: everything rigid, and everything with the joints beyond free to give way.
struct Moved {
  std::vector<Spatial> composite;
  std::vector<Spatial> articulated;
};

/// Takes the joint out of the articulated inertia: I - U U^T / d.
void give_way(Spatial& articulated, const Motion& u, const Real& d) {
  for (std::size_t k = 0; k < 36; ++k) {
    articulated[k] -= u[k / 6] * u[k % 6] / d;
  }
}

Real size_of(const Spatial& a) {
  Real result = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    result += a[7 * k];
  }
  return result;
}

/// Pivots of A = L^T Delta L by articulated bodies (EQUATIONS.md 7.4), O(N); true where the pivot
/// is zero.
std::vector<bool> zero_pivots(const model::Tree& tree) {
  Moved moved;
  for (const model::Link& link : tree.links) {
    moved.composite.push_back(spatial_inertia(link.inertia));
  }
  moved.articulated = moved.composite;
  std::vector<bool> zero(tree.links.size(), false);
  for (int i = tree.size() - 1; i >= 0; --i) {
    const model::Link& link = tree.links[index(i)];
    Spatial& composite = moved.composite[index(i)];
    Spatial& articulated = moved.articulated[index(i)];
    const Motion s = joint_motion(link.joint);
    const Motion u = product(articulated, s);
    const Real d = dot(s, u);
    const Real rigid = dot(s, product(composite, s));
    zero[index(i)] = negligible(rigid, size_of(composite)) || d <= rigid * Real("1e-25");
    if (!zero[index(i)]) {
      give_way(articulated, u, d);
    }
    if (link.father != model::kGround) {
      const Spatial x = to_link(link.joint, general_position(i));
      const Spatial xt = transposed(x);
      add(moved.composite[index(link.father)], product(xt, product(composite, x)));
      add(moved.articulated[index(link.father)], product(xt, product(articulated, x)));
    }
  }
  return zero;
}

/// A(q) of the independent joints, A_r = T^T A T, by composite bodies (EQUATIONS.md 7.3); dense,
/// row-major.
std::vector<Real> reduced_mass_matrix(const model::Tree& tree) {
  const auto n = static_cast<std::size_t>(tree.dof());
  std::vector<Real> a(n * n, Real(0));
  const auto add_entry = [&](int i, int j, const Real& value) {
    const model::Drive& row = tree.drives[index(i)];
    const model::Drive& column = tree.drives[index(j)];
    a[index(row.coordinate) * n + index(column.coordinate)] +=
        row.multiplier * column.multiplier * value;
  };
  std::vector<Spatial> composite;
  for (const model::Link& link : tree.links) {
    composite.push_back(spatial_inertia(link.inertia));
  }
  const auto position = [&](int i) {
    const model::Drive& drive = tree.drives[index(i)];
    return Real(drive.multiplier * general_position(drive.coordinate) + drive.offset);
  };
  for (int i = tree.size() - 1; i >= 0; --i) {
    const model::Link& link = tree.links[index(i)];
    Motion force = product(composite[index(i)], joint_motion(link.joint));
    add_entry(i, i, dot(joint_motion(link.joint), force));
    for (int j = i; tree.links[index(j)].father != model::kGround;) {
      force = product(transposed(to_link(tree.links[index(j)].joint, position(j))), force);
      j = tree.links[index(j)].father;
      const Real entry = dot(joint_motion(tree.links[index(j)].joint), force);
      add_entry(i, j, entry);
      add_entry(j, i, entry);
    }
    if (link.father != model::kGround) {
      const Spatial x = to_link(link.joint, position(i));
      add(composite[index(link.father)], product(transposed(x), product(composite[index(i)], x)));
    }
  }
  return a;
}

/// The same for joints tied by mimics: a joint counts only if its coordinate has a zero pivot in
/// A_r.
std::vector<bool> zero_reduced_pivots(const model::Tree& tree) {
  const auto n = static_cast<std::size_t>(tree.dof());
  std::vector<Real> a = reduced_mass_matrix(tree);
  Real scale = 0;
  for (std::size_t k = 0; k < n; ++k) {
    scale = std::max(scale, a[k * n + k]);
  }
  std::vector<bool> zero(tree.links.size(), false);
  std::vector<Real> diagonal;
  for (std::size_t k = 0; k < n; ++k) {
    diagonal.push_back(a[k * n + k]);
  }
  for (std::size_t k = n; k-- > 0;) {
    const Real d = a[k * n + k];
    if (negligible(diagonal[k], scale) || d <= diagonal[k] * Real("1e-25")) {
      zero[index(tree.coordinates[k])] = true;
      continue;
    }
    for (std::size_t i = 0; i < k; ++i) {
      const Real factor = a[k * n + i] / d;
      for (std::size_t j = 0; j < k && factor != 0; ++j) {
        a[i * n + j] -= factor * a[k * n + j];
      }
    }
  }
  return zero;
}

/// Where A of the model's coordinates is singular. A mimic can only add inertia to a coordinate, so
/// the O(N) test of the free tree comes first.
std::vector<bool> singular_joints(const model::Tree& tree) {
  std::vector<bool> zero = zero_pivots(tree);
  const bool tied = tree.dof() < tree.size();
  const bool suspicious = std::find(zero.begin(), zero.end(), true) != zero.end();
  return tied && suspicious ? zero_reduced_pivots(tree) : zero;
}

}  // namespace

std::vector<Warning> joints_without_inertia(const model::Tree& tree) {
  const std::vector<bool> zero = singular_joints(tree);
  std::vector<Warning> result;
  for (int i = 0; i < tree.size(); ++i) {
    const model::Joint& joint = tree.links[index(i)].joint;
    if (zero[index(i)]) {
      const bool turns = joint.type == model::JointType::kRevolute;
      result.push_back(
          {joint.where, fmt::format("joint '{}': what it moves has no inertia {} its axis; "
                                    "forward dynamics has no solution",
                                    shown(joint.name), turns ? "about" : "along")});
    }
  }
  return result;
}

}  // namespace treedyn::description
