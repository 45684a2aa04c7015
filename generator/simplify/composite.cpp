#include "simplify/composite.hpp"

namespace treedyn::simplify {

namespace {

constexpr int kTrunk = 5;  // link that carries the body of a free base

/// Subtree sums of mass, first moment and pseudo-inertia, kept as lists of terms so that constants
/// add up first.
class CompositeBodies {
 public:
  explicit CompositeBodies(const Kinematics& kinematics)
      : k_(kinematics), terms_(static_cast<std::size_t>(k_.size())) {
    for (int i = 0; i < k_.size(); ++i) {
      const Kinematics::Body own =
          k_.variant().inertia_tensor ? k_.body_with_inertia_tensor(i) : k_.body(i);
      Terms& t = at(i);
      t.mass.push_back(own.mass);
      for (std::size_t a = 0; a < 3; ++a) {
        t.moment[a].push_back(own.moment[a]);
        for (std::size_t b = a; b < 3; ++b) {
          t.tensor[a][b].push_back(own.pseudo[a][b]);
        }
      }
    }
  }

  /// m^c, h^c and E^c (or I^c) of the subtree of i. \pre the sons of i have been added.
  Kinematics::Body composite(int i) {
    Graph& graph = k_.graph();
    const Terms& t = at(i);
    Kinematics::Body body{sum(t.mass), {}, {}};
    for (std::size_t a = 0; a < 3; ++a) {
      body.moment[a] = sum(t.moment[a]);
      for (std::size_t b = a; b < 3; ++b) {
        body.pseudo[a][b] = body.pseudo[b][a] = sum(t.tensor[a][b]);
      }
    }
    name(graph, body.moment, "h", i);
    name_tensor(body.pseudo, i);
    return body;
  }

  /// m_f += m,  h_f += h + m s,  E_f += E + s h^T + h s^T + m s s^T (7.3, pseudo-inertia).
  void add_to_father(int i, const Kinematics::Body& body) {
    Terms& f = at(k_.link(i).father);
    const Vec3& s = k_.offset(i);
    const Vec3 h = k_.to_father(i, body.moment);
    const Mat3 e = k_.to_father_symmetric(i, body.pseudo);
    f.mass.push_back(body.mass);
    for (std::size_t a = 0; a < 3; ++a) {
      f.moment[a].push_back(h[a]);
      f.moment[a].push_back(body.mass * s[a]);
      for (std::size_t b = a; b < 3; ++b) {
        f.tensor[a][b].push_back(e[a][b]);
      }
    }
    k_.variant().inertia_tensor ? shift_inertia(f, h, body.mass, s)
                                : shift_pseudo(f, h, body.mass, s);
  }

  [[nodiscard]] Expr zz_about_axis(const Kinematics::Body& body) const {
    return k_.variant().inertia_tensor ? body.pseudo[2][2] : body.pseudo[0][0] + body.pseudo[1][1];
  }
  [[nodiscard]] Vec3 moment_of_unit_turn(const Kinematics::Body& body) const {
    const Mat3& e = body.pseudo;
    const Expr zz = zz_about_axis(body);
    return k_.variant().inertia_tensor ? Vec3{e[0][2], e[1][2], zz} : Vec3{-e[0][2], -e[1][2], zz};
  }

 private:
  struct Terms {
    std::vector<Expr> mass;
    std::array<std::vector<Expr>, 3> moment;
    std::array<std::array<std::vector<Expr>, 3>, 3> tensor;
  };
  Terms& at(int i) { return terms_[static_cast<std::size_t>(i)]; }

  /// 2 s_a h_a and m s_a^2, merged into one product where s is not constant.
  static std::array<Expr, 2> diagonal_shift(Expr h, Expr mass, Expr s) {
    if (s.is_fixed()) {
      return {(s + s) * h, (mass * s) * s};
    }
    return {s * ((h + h) + mass * s), Expr()};
  }

  static void shift_pseudo(Terms& f, const Vec3& h, Expr mass, const Vec3& s) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (const Expr& term : diagonal_shift(h[a], mass, s[a])) {
        f.tensor[a][a].push_back(term);
      }
      for (std::size_t b = a + 1; b < 3; ++b) {
        f.tensor[a][b].push_back(s[b] * h[a]);
        if (s[a].is_fixed()) {
          f.tensor[a][b].push_back(s[a] * h[b]);
          f.tensor[a][b].push_back((mass * s[a]) * s[b]);
        } else {
          f.tensor[a][b].push_back(s[a] * (h[b] + mass * s[b]));
        }
      }
    }
  }

  static void shift_inertia(Terms& f, const Vec3& h, Expr mass, const Vec3& s) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (const Expr& term : diagonal_shift(h[a], mass, s[a])) {
        f.tensor[(a + 1) % 3][(a + 1) % 3].push_back(term);
        f.tensor[(a + 2) % 3][(a + 2) % 3].push_back(term);
      }
      for (std::size_t b = a + 1; b < 3; ++b) {
        f.tensor[a][b].push_back(-(s[a] * h[b]));
        f.tensor[a][b].push_back(-(s[b] * h[a]));
        f.tensor[a][b].push_back(-((mass * s[a]) * s[b]));
      }
    }
  }

  void name_tensor(const Mat3& e, int i) {
    Graph& graph = k_.graph();
    const char* symbol = k_.variant().inertia_tensor ? "I" : "E";
    constexpr std::array<const char*, 9> kEntry = {"xx", "xy", "xz", "xy", "yy",
                                                   "yz", "xz", "yz", "zz"};
    for (std::size_t n = 0; n < 9; ++n) {
      graph.name(e[n / 3][n % 3].ref(), symbol, i, kEntry[n]);
    }
  }

  const Kinematics& k_;
  std::vector<Terms> terms_;
};

/// Column i of A while it is carried from link i to the root: force and moment of a unit
/// acceleration of joint i.
struct Column {
  int joint = 0;
  Vec3 force;
  Vec3 moment;
};

/// F = z x h (revolute), m z (prismatic);  M = I z (revolute), h x z (prismatic); 7.3 with z = (0,
/// 0, 1).
Column new_column(const Kinematics& k, const CompositeBodies& composites,
                  const Kinematics::Body& body, int i) {
  const Vec3& h = body.moment;
  if (k.link(i).revolute) {
    return {i, {-h[1], h[0], Expr()}, composites.moment_of_unit_turn(body)};
  }
  return {i, {Expr(), Expr(), body.mass}, {h[1], -h[0], Expr()}};
}

/// Carries columns and composites from link i to its father; `a` receives row i.
void fold(const Kinematics& k, int i, std::vector<Column>& columns,
          std::vector<Column>& father_columns, SparseSymmetric& a) {
  for (const Column& column : columns) {
    const Expr entry = k.link(i).revolute ? column.moment[2] : column.force[2];
    const bool same_sign = k.link(i).sign == k.link(column.joint).sign;
    if (!entry.is_zero()) {
      a[{column.joint, i}] = same_sign ? entry : -entry;
    }
  }
  if (k.link(i).father == model::kGround) {
    return;
  }
  for (const Column& column : columns) {
    const Vec3 f = k.to_father(i, column.force);
    const Vec3 m = k.to_father(i, column.moment) + cross(k.offset(i), f);
    father_columns.push_back({column.joint, f, m});
  }
}

Expr projected(const Kinematics& k, int i, int j, Expr entry) {
  return k.link(i).sign == k.link(j).sign ? entry : -entry;
}

}  // namespace

SparseSymmetric mass_matrix(const Kinematics& k) {
  CompositeBodies composites(k);
  std::vector<std::vector<Column>> columns(static_cast<std::size_t>(k.size()));
  std::vector<Column> nowhere;
  SparseSymmetric a;
  for (int i = k.size() - 1; i >= 0; --i) {
    k.graph().set_body(i);
    const Kinematics::Body body = composites.composite(i);
    std::vector<Column>& own = columns[static_cast<std::size_t>(i)];
    own.push_back(new_column(k, composites, body, i));
    const int f = k.link(i).father;
    if (f != model::kGround) {
      composites.add_to_father(i, body);
    }
    fold(k, i, own, f == model::kGround ? nowhere : columns[static_cast<std::size_t>(f)], a);
  }
  return a;
}

Trunk trunk_composite(const Kinematics& k) {
  CompositeBodies composites(k);
  std::vector<std::vector<Column>> columns(static_cast<std::size_t>(k.size()));
  Trunk trunk;
  for (int i = k.size() - 1; i > kTrunk; --i) {
    k.graph().set_body(i);
    const Kinematics::Body body = composites.composite(i);
    std::vector<Column>& own = columns[static_cast<std::size_t>(i)];
    own.push_back(new_column(k, composites, body, i));
    composites.add_to_father(i, body);
    fold(k, i, own, columns[static_cast<std::size_t>(k.link(i).father)], trunk.limbs);
  }
  k.graph().set_body(kTrunk);
  trunk.body = composites.composite(kTrunk);
  for (const Column& column : columns[kTrunk]) {
    trunk.columns.push_back({column.joint, column.force, column.moment});
  }
  return trunk;
}

BaseAxes base_axes(const Kinematics& k) {
  const Vec3 z = {Expr(), Expr(), constant(k.graph(), Real(1))};
  BaseAxes axes;
  axes.second = k.from_father(kTrunk, z);
  axes.first = k.from_father(kTrunk, k.from_father(kTrunk - 1, z));
  for (int joint = 0; joint < 3; ++joint) {
    Vec3 v = z;
    for (int i = joint + 1; i <= kTrunk; ++i) {
      v = k.from_father(i, v);
    }
    axes.sliding[static_cast<std::size_t>(joint)] = v;
  }
  return axes;
}

namespace {

/// The columns of the base's own turning joints: F = a x h, M = J a.
void add_base_columns(const BaseAxes& axes, const Kinematics::Body& body, bool inertia_tensor,
                      std::vector<Trunk::Column>& columns) {
  const Vec3& h = body.moment;
  const Mat3& e = body.pseudo;
  const Expr trace = e[0][0] + e[1][1] + e[2][2];
  const auto moment = [&](const Vec3& a) {
    return inertia_tensor ? e * a : trace * a - e * a;
  };
  const Vec3 own = inertia_tensor ? Vec3{e[0][2], e[1][2], e[2][2]}
                                  : Vec3{-e[0][2], -e[1][2], e[0][0] + e[1][1]};
  columns.push_back({kTrunk, {-h[1], h[0], Expr()}, own});
  columns.push_back({kTrunk - 1, cross(axes.second, h), moment(axes.second)});
  columns.push_back({kTrunk - 2, cross(axes.first, h), moment(axes.first)});
}

}  // namespace

SparseSymmetric mass_matrix_by_trunk(const Kinematics& k) {
  Trunk trunk = trunk_composite(k);
  const BaseAxes axes = base_axes(k);
  add_base_columns(axes, trunk.body, k.variant().inertia_tensor, trunk.columns);
  SparseSymmetric a = trunk.limbs;
  for (const Trunk::Column& column : trunk.columns) {
    const int j = column.joint;
    const std::array<Expr, 3> turning = {dot(axes.first, column.moment),
                                         dot(axes.second, column.moment), column.moment[2]};
    for (int row = 3; row <= kTrunk && row <= j; ++row) {
      a[{j, row}] = projected(k, row, j, turning[static_cast<std::size_t>(row - 3)]);
    }
    for (int row = 0; row < 3; ++row) {
      a[{j, row}] =
          projected(k, row, j, dot(axes.sliding[static_cast<std::size_t>(row)], column.force));
    }
  }
  for (int row = 0; row < 3; ++row) {
    a[{row, row}] = trunk.body.mass;
  }
  std::erase_if(a, [](const auto& entry) { return entry.second.is_zero(); });
  return a;
}

}  // namespace treedyn::simplify
