#include "equations/kinematics.hpp"

namespace treedyn::equations {

block::Index index_of(const model::Tree& tree, std::span<const model::Point> points) {
  block::Index index;
  for (const model::Link& link : tree.links) {
    index.father.push_back(link.father);
    index.revolute.push_back(link.joint.turns());
  }
  for (const model::Point& point : points) {
    index.carrier.push_back(point.link);
  }
  return index;
}

}  // namespace treedyn::equations
