#include "simplify/points.hpp"

#include "simplify/sweeps.hpp"

namespace treedyn::simplify {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

void append(std::vector<Expr>& values, const Vec3& v) {
  values.insert(values.end(), v.begin(), v.end());
}

Vec3 unit(Graph& graph, std::size_t k) {
  Vec3 v;
  v[k] = constant(graph, Real(1));
  return v;
}

/// z x r.
Vec3 about_axis(const Vec3& r) { return {-r[1], r[0], Expr()}; }

/// A point of a link as it moves against the frame in which its path to the ground has arrived:
/// position, velocity, acceleration, angular velocity and acceleration with qdd = 0.
struct Carried {
  Vec3 r;
  Vec3 v;
  Vec3 a;
  Vec3 omega;
  Vec3 alpha;
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
    f.omega = k.to_father(i, {p.omega[0], p.omega[1], p.omega[2] + qd});
    f.alpha = k.to_father(i, p.alpha + qd * about_axis(p.omega));
  } else {
    f.v = k.to_father(i, {p.v[0], p.v[1], p.v[2] + qd});
    f.a = k.to_father(i, p.a);
    f.omega = k.to_father(i, p.omega);
    f.alpha = k.to_father(i, p.alpha);
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

/// Orientation and origin of every expression frame in the base frame, by D as prefix sum.
class BaseFrames {
 public:
  explicit BaseFrames(const Kinematics& k) : k_(k) {
    for (int i = 0; i < k.size(); ++i) {
      k.graph().set_body(i);
      const int f = k.link(i).father;
      Mat3 r;
      for (std::size_t row = 0; row < 3; ++row) {  // R_i = R_f T_i, row by row
        const Vec3 father = f == model::kGround ? unit(k.graph(), row) : rotation_[index(f)][row];
        r[row] = k.from_father(i, father);
      }
      for (std::size_t row = 0; row < 3; ++row) {
        name(k.graph(), r[row], row == 0 ? "Rx" : row == 1 ? "Ry" : "Rz", i);
      }
      rotation_.push_back(r);
    }
  }

  [[nodiscard]] const Mat3& rotation(int i) const { return rotation_[index(i)]; }
  [[nodiscard]] Vec3 axis(int i) const { return column(rotation_[index(i)], 2); }
  /// A vector of link i's expression frame (kGround: base frame) in the base frame.
  [[nodiscard]] Vec3 to_base(int i, const Vec3& v) const {
    return i == model::kGround ? v : rotation_[index(i)] * v;
  }
  /// Origins O_i of the normal frames in the base frame.
  [[nodiscard]] std::vector<Vec3> origins() const {
    std::vector<Vec3> result;
    for (int i = 0; i < k_.size(); ++i) {
      const int f = k_.link(i).father;
      const Vec3 s = to_base(f, k_.offset(i));
      result.push_back(f == model::kGround ? s : result[index(f)] + s);
    }
    return result;
  }

 private:
  const Kinematics& k_;
  std::vector<Mat3> rotation_;
};

template <class Value>
std::vector<Expr> from_ground(const Kinematics& k, const Points& points, Value value) {
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    append(result, value(to_ground(k, point)));
  }
  return result;
}

/// Where a vector stands that belongs to a link: `value(i, t)` in the link's frame, zero on the
/// ground.
template <class Value>
std::vector<Expr> from_root(const Kinematics& k, const Points& points, Value value) {
  const BaseFrames frames(k);
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const int i = point.link;
    append(result,
           i == model::kGround ? Vec3{} : frames.to_base(i, value(i, k.point(i, point.at))));
  }
  return result;
}

}  // namespace

std::vector<Velocity> velocities(const Kinematics& k) {
  std::vector<Velocity> result;
  for (int i = 0; i < k.size(); ++i) {
    k.graph().set_body(i);
    const int f = k.link(i).father;
    Velocity v;
    if (f != model::kGround) {
      const Velocity& father = result[index(f)];
      v.omega = k.from_father(i, father.omega);
      v.origin = k.from_father(i, father.origin + cross(father.omega, k.offset(i)));
    }
    (k.link(i).revolute ? v.omega : v.origin)[2] += k.speed(i);
    name(k.graph(), v.omega, "omega", i);
    name(k.graph(), v.origin, "v", i);
    result.push_back(v);
  }
  return result;
}

std::vector<Expr> point_positions(const Kinematics& k, const Points& points) {
  if (!k.variant().from_root) {
    return from_ground(k, points, [](const Carried& p) { return p.r; });
  }
  const BaseFrames frames(k);
  const std::vector<Vec3> origins = frames.origins();
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const int i = point.link;
    append(result, i == model::kGround
                       ? constant(k.graph(), point.at)
                       : origins[index(i)] + frames.to_base(i, k.point(i, point.at)));
  }
  return result;
}

std::vector<Expr> point_velocities(const Kinematics& k, const Points& points) {
  if (!k.variant().from_root) {
    return from_ground(k, points, [](const Carried& p) { return p.v; });
  }
  const std::vector<Velocity> velocity = velocities(k);
  return from_root(k, points, [&](int i, const Vec3& t) {
    return velocity[index(i)].origin + cross(velocity[index(i)].omega, t);
  });
}

std::vector<Expr> point_bias_acceleration(const Kinematics& k, const Points& points) {
  if (!k.variant().from_root) {
    return from_ground(k, points, [](const Carried& p) { return p.a; });
  }
  const std::vector<Motion> motion = motions(k, {});
  return from_root(k, points, [&](int i, const Vec3& t) {
    return motion[index(i)].a + motion[index(i)].Omega * t;
  });
}

std::vector<Expr> angular_bias_acceleration(const Kinematics& k, const Points& points) {
  if (!k.variant().from_root) {
    return from_ground(k, points, [](const Carried& p) { return p.alpha; });
  }
  const std::vector<Motion> motion = motions(k, {});
  return from_root(k, points, [&](int i, const Vec3&) { return motion[index(i)].alpha; });
}

std::vector<Expr> point_rotations(const Kinematics& k, const Points& points) {
  const BaseFrames frames(k);
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const bool ground = point.link == model::kGround;
    const Mat3 own = constant(k.graph(), point.rotation);
    const Mat3 r = ground ? own : frames.rotation(point.link) * (k.orientation(point.link) * own);
    for (const Vec3& row : r) {
      append(result, row);
    }
  }
  return result;
}

std::vector<JacobianBlock> force_jacobian_transpose(const Kinematics& k, const Points& points) {
  const BaseFrames frames(k);
  std::vector<JacobianBlock> blocks;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].link == model::kGround) {
      continue;
    }
    Vec3 r = k.point(points[p].link, points[p].at);
    for (int i = points[p].link; i != model::kGround; i = k.link(i).father) {
      k.graph().set_body(i);
      const bool revolute = k.link(i).revolute;
      const Vec3 column = revolute ? frames.to_base(i, about_axis(r)) : frames.axis(i);
      blocks.push_back({i, static_cast<int>(p), k.link(i).sign > 0 ? column : -column});
      r = k.to_father(i, r) + k.offset(i);
      name(k.graph(), r, "r", k.link(i).father);
    }
  }
  return blocks;
}

std::vector<JacobianBlock> moment_jacobian_transpose(const Kinematics& k, const Points& points) {
  const BaseFrames frames(k);
  std::vector<JacobianBlock> blocks;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (int i = points[p].link; i != model::kGround; i = k.link(i).father) {
      if (k.link(i).revolute) {
        blocks.push_back(
            {i, static_cast<int>(p), k.link(i).sign > 0 ? frames.axis(i) : -frames.axis(i)});
      }
    }
  }
  return blocks;
}

namespace {

Vec3 input(Graph& graph, int array, std::size_t point) {
  Vec3 v;
  for (std::size_t n = 0; n < 3; ++n) {
    v[n] = Expr(graph, graph.input(array, static_cast<int>(3 * point + n)));
  }
  return v;
}

Expr along_axis(const Kinematics& k, int i, const Wrench& w, const Vec3& axis) {
  const Expr x = dot(axis, k.link(i).revolute ? w.moment : w.force);
  return k.link(i).sign > 0 ? x : -x;
}

void add(Wrench& sum, const Vec3& force, const Vec3& moment) {
  sum.force = sum.force + force;
  sum.moment = sum.moment + moment;
}

/// All wrenches in the base frame, each about the origin of its link.
std::vector<Expr> applied_force_in_base(const Kinematics& k, const Points& points, int f, int n) {
  const BaseFrames frames(k);
  std::vector<Wrench> wrench(index(k.size()));
  for (std::size_t p = 0; p < points.size(); ++p) {
    const int i = points[p].link;
    if (i != model::kGround) {
      const Vec3 force = input(k.graph(), f, p);
      const Vec3 arm = frames.to_base(i, k.point(i, points[p].at));
      add(wrench[index(i)], force, input(k.graph(), n, p) + cross(arm, force));
    }
  }
  std::vector<Expr> q(index(k.size()));
  for (int i = k.size() - 1; i >= 0; --i) {
    k.graph().set_body(i);
    const Wrench& w = wrench[index(i)];
    q[index(i)] = along_axis(k, i, w, frames.axis(i));
    const int father = k.link(i).father;
    if (father != model::kGround) {
      add(wrench[index(father)], w.force,
          w.moment + cross(frames.to_base(father, k.offset(i)), w.force));
    }
  }
  return q;
}

/// A vector of the base frame in the expression frame of link i.
Vec3 from_base(const Kinematics& k, int i, const Vec3& v) {
  const int f = k.link(i).father;
  return k.from_father(i, f == model::kGround ? v : from_base(k, f, v));
}

}  // namespace

std::vector<Expr> applied_force(const Kinematics& k, const Points& points, int f, int n) {
  if (k.variant().from_root) {
    return applied_force_in_base(k, points, f, n);
  }
  std::vector<Wrench> wrench(index(k.size()));
  for (std::size_t p = 0; p < points.size(); ++p) {
    const int i = points[p].link;
    if (i != model::kGround) {
      const Vec3 force = from_base(k, i, input(k.graph(), f, p));
      const Vec3 moment = from_base(k, i, input(k.graph(), n, p));
      add(wrench[index(i)], force, moment + cross(k.point(i, points[p].at), force));
    }
  }
  std::vector<Expr> q(index(k.size()));
  const Vec3 z = unit(k.graph(), 2);
  for (int i = k.size() - 1; i >= 0; --i) {
    k.graph().set_body(i);
    const Wrench& w = wrench[index(i)];
    q[index(i)] = along_axis(k, i, w, z);
    const int father = k.link(i).father;
    if (father != model::kGround) {
      const Vec3 force = k.to_father(i, w.force);
      add(wrench[index(father)], force, k.to_father(i, w.moment) + cross(k.offset(i), force));
    }
  }
  return q;
}

namespace {

/// Rows of D s^d (D - E) + l^d D by prefix sums: block (i, j) = block (f, j) + O_i - O_f.
std::vector<std::vector<Vec3>> path_vectors(const Kinematics& k, const BaseFrames& frames) {
  const Vector3 origin{};
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i < k.size(); ++i) {
    k.graph().set_body(i);
    const int f = k.link(i).father;
    std::vector<Vec3> row(index(k.size()));
    if (f != model::kGround) {
      const Vec3 step = k.to_father(i, k.point(i, origin)) + k.offset(i) - k.point(f, origin);
      const Vec3 in_base = frames.to_base(f, step);
      for (int j = f; j != model::kGround; j = k.link(j).father) {
        row[index(j)] = rows[index(f)][index(j)] + in_base;
      }
    }
    row[index(i)] = k.link(i).revolute ? Vec3{} : k.displacement(i) * frames.axis(i);  // l_ii
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The blocks of the links whose joints are independent, row-major.
std::vector<Expr> row_major(const std::vector<std::vector<Vec3>>& blocks, const model::Tree& tree) {
  std::vector<Expr> result;
  for (const int i : tree.coordinates) {
    for (std::size_t n = 0; n < 3; ++n) {
      for (const int j : tree.coordinates) {
        result.push_back(blocks[index(i)][index(j)][n]);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Expr> joint_to_link_vectors(const Kinematics& k, const model::Tree& tree) {
  const BaseFrames frames(k);
  return row_major(path_vectors(k, frames), tree);
}

std::vector<Expr> joint_to_com_vectors(const Kinematics& k, const model::Tree& tree) {
  const BaseFrames frames(k);
  std::vector<std::vector<Vec3>> blocks = path_vectors(k, frames);
  for (int i = 0; i < k.size(); ++i) {
    const Vec3 c = k.point(i, tree.links[index(i)].inertia.com) - k.point(i, Vector3{});
    const Vec3 in_base = frames.to_base(i, c);
    for (int j = i; j != model::kGround; j = k.link(j).father) {
      blocks[index(i)][index(j)] = blocks[index(i)][index(j)] + in_base;
    }
  }
  return row_major(blocks, tree);
}

}  // namespace treedyn::simplify
