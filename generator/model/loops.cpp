#include "model/loops.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/index.hpp"

namespace treedyn::model {

namespace {

using Ends = std::pair<int, int>;  ///< links, or the ground; ascending

/// Links, and the ground, in groups that hang together.
class Groups {
 public:
  explicit Groups(int links) : leader_(static_cast<std::size_t>(links) + 1) {
    std::iota(leader_.begin(), leader_.end(), 0);
  }

  void join(const Ends& ends) { leader_[to_index(leader(ends.first))] = leader(ends.second); }
  [[nodiscard]] bool together(const Ends& ends) const {
    return leader(ends.first) == leader(ends.second);
  }

 private:
  [[nodiscard]] int leader(int link) const {
    int group = link == kGround ? static_cast<int>(leader_.size()) - 1 : link;
    while (leader_[to_index(group)] != group) {
      group = leader_[to_index(group)];
    }
    return group;
  }

  std::vector<int> leader_;
};

Ends ends_of(const Scene& scene, const Constraint& constraint) {
  const auto link = [&](int point) {
    return point < 0 ? kGround : scene.points[static_cast<std::size_t>(point)].link;
  };
  return std::minmax({link(constraint.point), link(constraint.other)});
}

bool joins_links(const Constraint& constraint) { return constraint.kind != ConstraintKind::kJoint; }

/// True if nothing but constraints acts on a link and its joint.
bool is_empty(const Scene& scene, int link) {
  const Link& at = scene.tree.links[static_cast<std::size_t>(link)];
  const auto moves = [&](const auto& effect) {
    return scene.tree.coordinates[static_cast<std::size_t>(effect.joint)] == link;
  };
  return at.inertia.mass == 0 && at.inertia.about_com == Matrix3{} &&
         std::ranges::none_of(scene.armatures, moves) &&
         std::ranges::none_of(scene.joint_laws, moves);
}

/// Joints that carry a body to anywhere, first of all links: one without mass, or more, in a row
/// from the ground, and the next one.
int base_joints(const Scene& scene) {
  int count = 0;
  while (count < scene.tree.size() && is_empty(scene, count) &&
         scene.tree.links[static_cast<std::size_t>(count)].father == count - 1) {
    ++count;
  }
  return count > 0 ? count + 1 : 0;
}

}  // namespace

bool closes_loop(const Scene& scene, int constraint) {
  const Constraint& c = scene.constraints[to_index(constraint)];
  if (!joins_links(c)) {
    return false;
  }
  const Ends ends = ends_of(scene, c);
  const int base = base_joints(scene);
  return std::ranges::any_of(scene.phases, [&](const Phase& phase) {
    if (std::ranges::find(phase.active, constraint) == phase.active.end()) {
      return false;
    }
    Groups groups(scene.tree.size());
    for (int link = base; link < scene.tree.size(); ++link) {
      groups.join({link, scene.tree.links[to_index(link)].father});
    }
    for (const int other : phase.active) {
      const Constraint& o = scene.constraints[to_index(other)];
      if (joins_links(o) && ends_of(scene, o) != ends) {
        groups.join(ends_of(scene, o));
      }
    }
    return c.kind == ConstraintKind::kJoined ||
           (ends.first != ends.second && groups.together(ends));
  });
}

}  // namespace treedyn::model
