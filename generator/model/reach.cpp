#include "model/reach.hpp"

#include <algorithm>

namespace treedyn::model {

namespace {

double longest(const Vector3& v) {
  Real most = 0;
  for (const Real& x : v) {
    most = std::max(most, Real(abs(x)));
  }
  return most.convert_to<double>();
}

}  // namespace

double size_of(const Tree& tree, const std::vector<Point>& points) {
  double size = 0;
  for (const Link& link : tree.links) {
    size = std::max({size, longest(link.joint.offset), longest(link.inertia.com)});
  }
  for (const Point& point : points) {
    size = std::max(size, longest(point.at));
  }
  return size;
}

std::vector<double> reach_of(const Tree& tree, const std::vector<Point>& points) {
  const double size = size_of(tree, points);
  std::vector<double> result;
  for (const int k : tree.coordinates) {
    const JointType type = tree.links[static_cast<std::size_t>(k)].joint.type;
    result.push_back(type == JointType::kPrismatic && size > 0 ? size : 1);
  }
  return result;
}

}  // namespace treedyn::model
