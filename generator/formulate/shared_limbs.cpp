// What limbs that share code have in common: constants where all are equal, otherwise leaves.

#include "common/transformed.hpp"
#include "formulate/link_kinematics.hpp"

namespace treedyn::formulate {

SharedLimbs shared_limbs(const model::Tree& tree, const NormalTree& normal,
                         const std::vector<LimbLinks>& links) {
  SharedLimbs result;
  result.links = links;
  result.places.resize(tree.links.size());
  for (const LimbLinks& limbs : links) {
    program::LimbClass limb_class;
    for (const std::vector<int>& limb : limbs) {
      limb_class.links.push_back(limb);
      std::vector<program::LimbJoint>& joints = limb_class.joints.emplace_back();
      for (const int i : limb) {
        const auto k = static_cast<std::size_t>(i);
        result.places[k] = {static_cast<int>(result.table.size()),
                            static_cast<int>(limb_class.joints.size()) - 1,
                            static_cast<int>(joints.size())};
        joints.push_back({tree.drives[k].coordinate, normal.links[k].coordinate_sign});
      }
    }
    result.table.push_back(std::move(limb_class));
  }
  return result;
}

std::vector<int> Kinematics::peers(int i) const {
  if (!is_of_limb(i)) {
    return {i};
  }
  const SharedLimbs::Place& place = limbs_->places[to_index(i)];
  return transformed(limbs_->links[to_index(place.limb_class)],
                     [&](const std::vector<int>& limb) { return limb[to_index(place.position)]; });
}

Expr Kinematics::own(int i, const std::vector<Real>& values) const {
  if (!is_of_limb(i)) {
    return constant(graph_, values.front());
  }
  const SharedLimbs::Place& place = limbs_->places[to_index(i)];
  return {graph_,
          program::limb_constant(graph_, limbs_->table, place.limb_class, place.limb, values)};
}

Vec3 Kinematics::own_vector(int i, Vector3 NormalLink::*vector) const {
  Vec3 result;
  for (std::size_t n = 0; n < 3; ++n) {
    result[n] = own(i, of_peers(i, [&](int peer) { return (link(peer).*vector)[n]; }));
  }
  return result;
}

Mat3 Kinematics::own_matrix(int i, Matrix3 (*matrix)(const NormalLink&)) const {
  const std::vector<Matrix3> all = of_peers(i, [&](int peer) { return matrix(link(peer)); });
  Mat3 result;
  for (std::size_t n = 0; n < 9; ++n) {
    const std::vector<Real> values = transformed(all, [n](const Matrix3& m) { return m[n]; });
    result[n / 3][n % 3] = own(i, values);
  }
  return result;
}

/// The argument of a limb is a leaf: the sign of the coordinate belongs to the leaf.
Expr Kinematics::coordinate(int array, int k) const {
  if (array == inputs_.tau && !forces_.empty()) {
    return forces_[to_index(k)];
  }
  if (array == inputs_.qd && is_from_trunk_ && k <= kTrunkLink) {
    return {};
  }
  const bool leaf = is_of_limb(tree_.coordinates[to_index(k)]);
  return {graph_, graph_.input(leaf ? program::kLimbInputs + array : array, k)};
}

Expr Kinematics::argument(int array, int k) const { return result(k, coordinate(array, k)); }

Expr Kinematics::result(int k, Expr of_joint) const {
  return link(tree_.coordinates[to_index(k)]).coordinate_sign < 0 ? -of_joint : of_joint;
}

}  // namespace treedyn::formulate
