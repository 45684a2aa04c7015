// Joints that move no inertia: vectors x with A x = 0 at a general position. Typed by hand, not
// derived: models are refused before there is a derivation, and this folder sees no equations.
#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "description/read.hpp"
#include "description/scene_reader.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {

namespace {

using Motion = std::array<Real, 6>;    ///< (omega, velocity of the link's origin), link frame
using Spatial = std::array<Real, 36>;  ///< row-major 6x6

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

Spatial spatial_transposed(const Spatial& a) {
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

Real spatial_dot(const Motion& a, const Motion& b) {
  Real result = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    result += a[k] * b[k];
  }
  return result;
}

void add(Spatial& a, const Spatial& b) {
  std::ranges::transform(a, b, a.begin(), [](const Real& x, const Real& y) { return Real(x + y); });
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
  if (joint.turns()) {
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
  return joint.turns() ? Motion{a[0], a[1], a[2], 0, 0, 0} : Motion{0, 0, 0, a[0], a[1], a[2]};
}

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

using Movement = std::vector<std::size_t>;  ///< links or coordinates that move together, ascending

/// A pivot of A = L^T Delta L and what it takes to be positive.
struct Pivot {
  Motion u{};        ///< I^A s
  Real d = 0;        ///< s^T I^A s + armature
  bool zero = true;  ///< within rounding of 50 digits
};

/// Pivots Δ of A = L^T Δ L (EQUATIONS.md 7.4) as articulated bodies have them (R9), O(N).
/// \param armature  by link
std::vector<Pivot> articulated_pivots(const model::Tree& tree, const std::vector<Real>& armature) {
  std::vector<Pivot> pivots(tree.links.size());
  std::vector<Spatial> rigid = transformed(
      tree.links, [&](const model::Link& link) { return spatial_inertia(link.inertia); });
  std::vector<Spatial> articulated = rigid;
  for (int i = tree.size() - 1; i >= 0; --i) {
    const model::Link& link = tree.links[to_index(i)];
    const Motion s = joint_motion(link.joint);
    Pivot& pivot = pivots[to_index(i)];
    pivot.u = product(articulated[to_index(i)], s);
    pivot.d = spatial_dot(s, pivot.u) + armature[to_index(i)];
    const Real whole = spatial_dot(s, product(rigid[to_index(i)], s)) + armature[to_index(i)];
    pivot.zero = negligible(whole, size_of(rigid[to_index(i)]) + armature[to_index(i)]) ||
                 pivot.d <= whole * Real("1e-25");
    if (!pivot.zero) {
      give_way(articulated[to_index(i)], pivot.u, pivot.d);
    }
    if (link.father != model::kGround) {
      const Spatial x = to_link(link.joint, general_position(i));
      const Spatial xt = spatial_transposed(x);
      add(rigid[to_index(link.father)], product(xt, product(rigid[to_index(i)], x)));
      add(articulated[to_index(link.father)], product(xt, product(articulated[to_index(i)], x)));
    }
  }
  return pivots;
}

/// The links whose joints give way when the joint of `link`, whose pivot is zero, turns without
/// moving any inertia: a vector x with A x = 0 is x_link = 1 and x_j = -u_j . v / d_j beyond, where
/// v is the motion that the joints before j cause.
Movement free_movement(const model::Tree& tree, const std::vector<Pivot>& pivots, int link) {
  Movement result = {to_index(link)};
  std::vector<std::optional<Motion>> motions(tree.links.size());
  motions[to_index(link)] = joint_motion(tree.links[to_index(link)].joint);
  for (int j = link + 1; j < tree.size(); ++j) {
    const int father = tree.links[to_index(j)].father;
    if (father == model::kGround || !motions[to_index(father)]) {
      continue;
    }
    const Pivot& pivot = pivots[to_index(j)];
    const Motion s = joint_motion(tree.links[to_index(j)].joint);
    Motion v = product(to_link(tree.links[to_index(j)].joint, general_position(j)),
                       *motions[to_index(father)]);
    const Real x = pivot.zero ? Real(0) : Real(-spatial_dot(pivot.u, v) / pivot.d);
    const Real size = sqrt(spatial_dot(pivot.u, pivot.u) * spatial_dot(v, v));
    if (abs(x) * pivot.d > size * Real("1e-25")) {
      result.push_back(to_index(j));
    }
    for (std::size_t k = 0; k < 6; ++k) {
      v[k] += s[k] * x;
    }
    motions[to_index(j)] = v;
  }
  return result;
}

/// A(q) of the independent joints, A_r = T^T A T, by composite bodies (EQUATIONS.md 7.3); dense,
/// row-major.
std::vector<Real> reduced_mass_matrix(const model::Tree& tree) {
  const auto n = to_index(tree.dof());
  std::vector<Real> a(n * n, Real(0));
  const auto add_entry = [&](int i, int j, const Real& value) {
    const model::Drive& row = tree.drives[to_index(i)];
    const model::Drive& column = tree.drives[to_index(j)];
    a[to_index(row.coordinate) * n + to_index(column.coordinate)] +=
        row.multiplier * column.multiplier * value;
  };
  std::vector<Spatial> composite = transformed(
      tree.links, [&](const model::Link& link) { return spatial_inertia(link.inertia); });
  const auto position = [&](int i) {
    const model::Drive& drive = tree.drives[to_index(i)];
    return Real(drive.multiplier * general_position(drive.coordinate) + drive.offset);
  };
  for (int i = tree.size() - 1; i >= 0; --i) {
    const model::Link& link = tree.links[to_index(i)];
    Motion force = product(composite[to_index(i)], joint_motion(link.joint));
    add_entry(i, i, spatial_dot(joint_motion(link.joint), force));
    for (int j = i; tree.links[to_index(j)].father != model::kGround;) {
      force =
          product(spatial_transposed(to_link(tree.links[to_index(j)].joint, position(j))), force);
      j = tree.links[to_index(j)].father;
      const Real entry = spatial_dot(joint_motion(tree.links[to_index(j)].joint), force);
      add_entry(i, j, entry);
      add_entry(j, i, entry);
    }
    if (link.father != model::kGround) {
      const Spatial x = to_link(link.joint, position(i));
      add(composite[to_index(link.father)],
          product(spatial_transposed(x), product(composite[to_index(i)], x)));
    }
  }
  return a;
}

/// Gauss's elimination in A_r, from its last row. \param diagonal  of A_r as it was
/// \return whose pivots are zero
std::vector<bool> eliminated(std::vector<Real>& a, const std::vector<Real>& diagonal) {
  const std::size_t n = diagonal.size();
  const Real scale = *std::ranges::max_element(diagonal);
  std::vector<bool> zero(n, false);
  for (std::size_t k = n; k-- > 0;) {
    const Real d = a[k * n + k];
    zero[k] = negligible(diagonal[k], scale) || d <= diagonal[k] * Real("1e-25");
    for (std::size_t i = 0; i < k && !zero[k]; ++i) {
      const Real factor = a[k * n + i] / d;
      for (std::size_t j = 0; j < k && factor != 0; ++j) {
        a[i * n + j] -= factor * a[k * n + j];
      }
    }
  }
  return zero;
}

/// What moves with coordinate k, whose pivot is zero. \param a  after the elimination
Movement free_reduced_movement(const std::vector<Real>& a, const std::vector<bool>& zero,
                               std::size_t k) {
  const std::size_t n = zero.size();
  std::vector<Real> x(n, Real(0));
  x[k] = 1;
  Movement movement = {k};
  for (std::size_t j = k + 1; j < n; ++j) {
    Real size = 0;
    for (std::size_t i = k; i < j && !zero[j]; ++i) {
      x[j] -= a[j * n + i] * x[i] / a[j * n + j];
      size += abs(a[j * n + i]) / a[j * n + j];
    }
    const Real largest = abs(
        *std::ranges::max_element(x, [](const Real& l, const Real& r) { return abs(l) < abs(r); }));
    if (abs(x[j]) > size * largest * Real("1e-25")) {
      movement.push_back(j);
    }
  }
  return movement;
}

/// The same for joints tied by mimics, by Gauss's elimination in A_r: coordinates.
std::vector<Movement> free_reduced_movements(const model::Tree& tree,
                                             const std::vector<Real>& armature) {
  const auto n = to_index(tree.dof());
  std::vector<Real> a = reduced_mass_matrix(tree);
  std::vector<Real> diagonal;
  for (std::size_t k = 0; k < n; ++k) {
    a[k * n + k] += armature[k];
    diagonal.push_back(a[k * n + k]);
  }
  const std::vector<bool> zero = eliminated(a, diagonal);
  std::vector<Movement> result;
  for (std::size_t k = 0; k < n; ++k) {
    if (zero[k]) {
      result.push_back(free_reduced_movement(a, zero, k));
    }
  }
  return result;
}

/// What moves without inertia, as links of the joints. A mimic can only add inertia to a
/// coordinate, so the O(N) test of the free tree comes first.
std::vector<Movement> free_movements(const model::Tree& tree, const std::vector<Real>& armature) {
  std::vector<Real> by_link(tree.links.size(), Real(0));
  for (std::size_t k = 0; k < tree.coordinates.size(); ++k) {
    by_link[to_index(tree.coordinates[k])] = armature[k];
  }
  const std::vector<Pivot> pivots = articulated_pivots(tree, by_link);
  std::vector<Movement> result;
  for (int i = 0; i < tree.size(); ++i) {
    if (pivots[to_index(i)].zero) {
      result.push_back(free_movement(tree, pivots, i));
    }
  }
  if (tree.mimics() == 0 || result.empty()) {
    return result;
  }
  result = free_reduced_movements(tree, armature);
  for (Movement& movement : result) {
    std::ranges::transform(movement, movement.begin(),
                           [&](std::size_t k) { return to_index(tree.coordinates[k]); });
  }
  return result;
}

constexpr const char* kNoSolution = "forward dynamics has no solution";
constexpr const char* kNoInverse =
    "the mass matrix has no inverse, which motions under constraints need, too";

/// "joint 'a': what it moves has ..", or "joints 'a', 'b' ..": at most eight of them.
std::string description_of(const model::Tree& tree, const Movement& movement) {
  constexpr std::size_t kMost = 8;
  const model::Joint& first = tree.links[movement.front()].joint;
  if (movement.size() == 1) {
    const bool turns = first.type == model::JointType::kRevolute;
    return fmt::format("joint '{}': what it moves has no inertia {} its axis", shown(first.name),
                       turns ? "about" : "along");
  }
  std::string names;
  for (std::size_t k = 0; k < std::min(movement.size(), kMost); ++k) {
    names += fmt::format("{}'{}'", k == 0 ? "" : ", ", shown(tree.links[movement[k]].joint.name));
  }
  return fmt::format("joints {}{}: they can move together without moving any inertia", names,
                     movement.size() > kMost ? ", .." : "");
}

std::vector<Warning> warnings(const model::Tree& tree, const std::vector<Real>& armature,
                              const char* consequence) {
  std::vector<Warning> result;
  for (const Movement& movement : free_movements(tree, armature)) {
    result.push_back(
        {tree.links[movement.front()].joint.where,
         fmt::format("{}{}; {}", description_of(tree, movement),
                     tree.parameters.empty() ? "" : ", with its nominal values", consequence)});
  }
  return result;
}

}  // namespace

std::vector<Warning> joints_without_inertia(const model::Tree& tree,
                                            const std::vector<Real>& armature) {
  return warnings(tree, armature, kNoSolution);
}

std::vector<Warning> joints_without_inertia(const model::Tree& tree) {
  return joints_without_inertia(tree, std::vector<Real>(to_index(tree.dof()), Real(0)));
}

std::vector<Warning> joints_without_inertia(const model::Scene& scene) {
  std::vector<Real> armature(to_index(scene.tree.dof()), Real(0));
  for (const model::Armature& added : scene.armatures) {
    armature[to_index(added.joint)] += added.inertia;
  }
  return warnings(scene.tree, armature, scene.constraints.empty() ? kNoSolution : kNoInverse);
}

void require_inertia(const model::Scene& scene) {
  const std::vector<Warning> singular = joints_without_inertia(scene);
  if (!singular.empty()) {
    throw InputError(singular.front().where,
                     singular.front().message + "; expected inertia or an armature");
  }
}

}  // namespace treedyn::description
