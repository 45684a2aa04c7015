#include "simplify/points.hpp"

#include "simplify/blocks.hpp"
#include "simplify/sweeps.hpp"

namespace treedyn::simplify {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

void append(std::vector<Expr>& values, const Vec3& v) {
  values.insert(values.end(), v.begin(), v.end());
}

/// z x r.
Vec3 about_axis(const Vec3& r) { return {-r[1], r[0], Expr()}; }

/// A point of a link as it moves against the frame in which its path to the ground has arrived:
/// position, velocity, acceleration with qdd = 0.
struct Carried {
  Vec3 r;
  Vec3 v;
  Vec3 a;
};

/// Carries a point from link i to its father: what it does in the father is what it does in the
/// link, turned by the joint, plus the joint's own motion.
Carried to_father(const Kinematics& k, int i, const Carried& p) {
  Graph& graph = k.graph();
  graph.set_body(i);
  const Expr qd = k.speed(i);
  Carried f;
  f.r = k.to_father(i, p.r) + k.offset(i);
  if (k.link(i).revolute) {
    const Expr two = constant(graph, Real(2));
    const Vec3 turned = about_axis(p.r);
    f.v = k.to_father(i, p.v + qd * turned);
    f.a = k.to_father(i, p.a + qd * (two * about_axis(p.v) + qd * about_axis(turned)));
  } else {
    f.v = k.to_father(i, {p.v[0], p.v[1], p.v[2] + qd});
    f.a = k.to_father(i, p.a);
  }
  name(graph, f.r, "r", k.link(i).father);
  return f;
}

Carried to_ground(const Kinematics& k, const model::Point& point) {
  Carried p;
  p.r =
      point.link == model::kGround ? constant(k.graph(), point.at) : k.point(point.link, point.at);
  for (int i = point.link; i != model::kGround; i = k.link(i).father) {
    p = to_father(k, i, p);
  }
  return p;
}

}  // namespace

std::vector<Expr> point_bias_acceleration(const Kinematics& k, const Points& points) {
  const bool to_root = k.variant().way == Way::kToRoot;
  const FrameChanges frames(k, to_root ? Way::kToRoot : Way::kInLinks);
  const std::vector<Motion> motion = to_root ? std::vector<Motion>{} : motions(k, {});
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const int i = point.link;
    Vec3 a;
    if (to_root) {
      a = to_ground(k, point).a;
    } else if (i != model::kGround) {
      a = frames.moved(motion[index(i)].a + motion[index(i)].Omega * k.point(i, point.at), i,
                       kBase);
    }
    append(result, a);
  }
  return result;
}

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

}  // namespace treedyn::simplify
