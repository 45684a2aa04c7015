#include "formulate/scene_frame.hpp"

namespace treedyn::formulate {

SceneFrame::SceneFrame(const Task& task, bool velocity_products, const Trunk* trunk)
    : task_(trunk != nullptr ? trunk->seen() : task),
      velocity_products_(velocity_products),
      trunk_(trunk) {}

MotionMap SceneFrame::motion(const model::Point& point, bool turning) const {
  MotionMap map;
  const std::vector<model::Point> points = {point};
  const std::vector<Expr> J =
      values_at(task_, turning ? "moment_jacobian_transpose" : "force_jacobian_transpose", points,
                Way::kInLinks);
  for (std::size_t k = 0; k < J.size(); k += 3) {
    const Vec3 row = {J[k], J[k + 1], J[k + 2]};
    if (!is_zero(row)) {
      map.columns[static_cast<int>(k / 3)] = row;
    }
  }
  if (!velocity_products_) {
    return map;
  }
  if (turning && trunk_ != nullptr && point.link != model::kGround) {
    map.gamma = angular_bias(task_, point);
  } else {
    map.gamma =
        triple(values_at(task_, turning ? "angular_bias_acceleration" : "point_bias_acceleration",
                         points, trunk_ != nullptr ? Way::kInLinks : Way::kToRoot));
  }
  return map;
}

MotionMap SceneFrame::point(const model::Point& point) const {
  if (trunk_ != nullptr && point.link == model::kGround) {  // it accelerates upwards in free fall
    return {{}, -free_fall()};
  }
  return motion(point, false);
}

MotionMap SceneFrame::turning(const model::Point& point) const { return motion(point, true); }

Vec3 SceneFrame::direction(const Vec3& base) const {
  return trunk_ != nullptr ? trunk_->direction(base) : base;
}

Vec3 SceneFrame::direction(const model::Vector3& base) const {
  return direction(constant(task_.kinematics.graph(), base));
}

Vec3 SceneFrame::free_fall() const { return trunk_ != nullptr ? trunk_->free_fall() : Vec3{}; }

}  // namespace treedyn::formulate
