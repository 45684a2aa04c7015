#include "formulate/scene_frame.hpp"

#include "formulate/blocks.hpp"
#include "formulate/forward.hpp"

namespace treedyn::formulate {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// z x r.
Vec3 about_axis(const Vec3& r) { return {-r[1], r[0], Expr()}; }

Vec3 unit(Graph& graph, std::size_t n) {
  Vec3 v;
  v[n] = constant(graph, Real(1));
  return v;
}

Vec3 triple(const std::vector<Expr>& values) { return {values[0], values[1], values[2]}; }

}  // namespace

SceneFrame::SceneFrame(const Task& task, bool by_trunk, bool velocity_products)
    : task_(task), k_(task.kinematics), by_trunk_(by_trunk), velocity_products_(velocity_products) {
  if (by_trunk_) {
    place_limbs();
  }
}

/// R_i = R_f T_i, row by row, the trunk's own being the unit matrix.
void SceneFrame::place_limbs() {
  rotation_.resize(index(k_.size()));
  for (int i = kTrunkLink + 1; i < k_.size(); ++i) {
    k_.graph().set_body(i);
    const int f = k_.link(i).father;
    Mat3& r = rotation_[index(i)];
    for (std::size_t row = 0; row < 3; ++row) {
      r[row] =
          k_.from_father(i, f == kTrunkLink ? unit(k_.graph(), row) : rotation_[index(f)][row]);
      name(k_.graph(), r[row], row == 0 ? "Rx" : row == 1 ? "Ry" : "Rz", i);
    }
  }
  if (velocity_products_) {
    motions_ = limb_motions(task_, trunk_velocity(k_).omega);
  }
}

/// A vector of the expression frame of `link` in F.
Vec3 SceneFrame::to_frame(int link, const Vec3& v) const {
  return link == kTrunkLink ? v : rotation_[index(link)] * v;
}

void SceneFrame::add(int joint, const Vec3& column, MotionMap& map) const {
  const model::Drive& drive = task_.tree.drives[index(joint)];
  const Expr factor = constant(k_.graph(), k_.link(joint).sign * drive.multiplier);
  Vec3& sum = map.columns[by_trunk_ ? joint : drive.coordinate];
  const Vec3 term = factor * column;
  sum = sum + term;
}

MotionMap SceneFrame::in_base(const model::Point& point, bool turning) const {
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
  if (velocity_products_) {
    map.gamma =
        triple(values_at(task_, turning ? "angular_bias_acceleration" : "point_bias_acceleration",
                         points, Way::kToRoot));
  }
  return map;
}

MotionMap SceneFrame::point(const model::Point& point) const {
  if (!by_trunk_) {
    return in_base(point, false);
  }
  MotionMap map;
  if (point.link == model::kGround) {  // the ground accelerates upwards in free fall
    map.gamma = -free_fall();
    return map;
  }
  const Vec3 t = k_.point(point.link, point.at);
  Vec3 r = t;
  for (int i = point.link; i != kTrunkLink; i = k_.link(i).father) {
    k_.graph().set_body(i);
    const bool revolute = k_.link(i).revolute;
    add(i, revolute ? to_frame(i, about_axis(r)) : column(rotation_[index(i)], 2), map);
    const Vec3 turned = k_.to_father(i, r);
    r = turned + k_.offset(i);
    name(k_.graph(), r, "r", k_.link(i).father);
  }
  for (std::size_t n = 0; n < 3; ++n) {
    const Vec3 e = unit(k_.graph(), n);
    map.columns[static_cast<int>(n)] = e;
    map.columns[static_cast<int>(3 + n)] = cross(e, r);
  }
  if (velocity_products_) {
    const Motion& m = motions_[index(point.link)];
    const Vec3 turned = m.Omega * t;
    map.gamma = to_frame(point.link, m.a + turned);
  }
  return map;
}

MotionMap SceneFrame::turning(const model::Point& point) const {
  if (!by_trunk_) {
    return in_base(point, true);
  }
  MotionMap map;
  if (point.link == model::kGround) {
    return map;
  }
  for (int i = point.link; i != kTrunkLink; i = k_.link(i).father) {
    if (k_.link(i).revolute) {
      add(i, column(rotation_[index(i)], 2), map);
    }
  }
  for (std::size_t n = 0; n < 3; ++n) {
    map.columns[static_cast<int>(3 + n)] = unit(k_.graph(), n);
  }
  if (velocity_products_) {
    map.gamma = to_frame(point.link, motions_[index(point.link)].alpha);
  }
  return map;
}

Vec3 SceneFrame::direction(const Vec3& base) const {
  Vec3 v = base;
  for (int i = 0; by_trunk_ && i <= kTrunkLink; ++i) {
    v = k_.from_father(i, v);
  }
  return v;
}

Vec3 SceneFrame::direction(const model::Vector3& base) const {
  return direction(constant(k_.graph(), base));
}

Vec3 SceneFrame::free_fall() const {
  return by_trunk_ ? direction(-k_.ground_acceleration()) : Vec3{};
}

}  // namespace treedyn::formulate
