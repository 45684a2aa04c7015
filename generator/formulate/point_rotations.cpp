#include "formulate/point_rotations.hpp"

#include "formulate/blocks.hpp"

namespace treedyn::formulate {

namespace {

void append(std::vector<Expr>& values, const Vec3& v) {
  values.insert(values.end(), v.begin(), v.end());
}

}  // namespace

std::vector<Expr> point_rotations(const Kinematics& k, const Points& points) {
  const FrameChanges frames(k, Way::kInLinks);
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const bool ground = point.link == model::kGround;
    const Mat3 own = constant(k.graph(), point.rotation);
    const Mat3 r = ground ? own : k.orientation(point.link) * own;
    Mat3 columns;
    for (std::size_t n = 0; n < 3; ++n) {
      columns[n] = frames.moved(column(r, n), point.link, kBase);
    }
    for (std::size_t n = 0; n < 3; ++n) {
      append(result, column(columns, n));
    }
  }
  return result;
}

}  // namespace treedyn::formulate
