#include "formulate/blocks.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace treedyn::formulate {
namespace {

Vec3 unit(Graph& graph, std::size_t k) {
  Vec3 v;
  v[k] = constant(graph, Real(1));
  return v;
}

}  // namespace

bool is_zero(const Vec3& v) {
  return std::ranges::all_of(v, [](const Expr& x) { return x.is_zero(); });
}

FrameChanges::FrameChanges(const Kinematics& kinematics, Way way)
    : kinematics_(kinematics), way_(way) {
  for (int i = 0; i < kinematics.size(); ++i) {
    const int f = kinematics.link(i).father;
    depth_.push_back(depth(f) + 1);
    if (way_ != Way::kToRoot) {
      kinematics.graph().set_body(i);
      Mat3 r;
      for (std::size_t row = 0; row < 3; ++row) {  // R_i = R_f T_i, row by row
        const Vec3 father =
            f == kBase ? unit(kinematics.graph(), row) : rotation_[to_index(f)][row];
        r[row] = kinematics.from_father(i, father);
        name(kinematics.graph(), r[row], row == 0 ? "Rx" : row == 1 ? "Ry" : "Rz", i);
      }
      rotation_.push_back(r);
    }
  }
}

Vec3 FrameChanges::moved(const Vec3& v, int from, int to) const {
  if (from == to || is_zero(v)) {
    return v;
  }
  if (in_base() || (way_ == Way::kInLinks && to == kBase)) {
    const Vec3 base = from == kBase ? v : rotation_[to_index(from)] * v;
    return to == kBase ? base : transposed(rotation_[to_index(to)]) * base;
  }
  if (depth(from) > depth(to)) {
    return moved(kinematics_.to_father(from, v), kinematics_.link(from).father, to);
  }
  const int f = kinematics_.link(to).father;
  return kinematics_.from_father(to, moved(v, from, f));
}

Tensor FrameChanges::moved(const Tensor& t, int to) const {
  if (t.frame == to) {
    return t;
  }
  if (!in_base() && to != kBase && t.frame != kBase && kinematics_.link(t.frame).father == to) {
    return {to,
            t.symmetric ? kinematics_.to_father_symmetric(t.frame, t.value)
                        : kinematics_.to_father_general(t.frame, t.value),
            t.symmetric};
  }
  const auto rows = [&](const Mat3& m) {
    Mat3 result;
    std::ranges::transform(m, result.begin(),
                           [&](const Vec3& row) { return moved(row, t.frame, to); });
    return result;
  };
  return {to, transposed(rows(transposed(rows(t.value))))};
}

bool FrameChanges::is_above(int i, int of) const {
  while (depth(of) > depth(i)) {
    of = kinematics_.link(of).father;
  }
  return i == of;
}

Parts FrameChanges::risen(Parts parts, int frame) const {
  const auto below = [&](const Part& part) {
    return is_above(part.frame, frame) ? -1 : part.frame;
  };
  const auto deepest = [&] {
    return std::ranges::max_element(
        parts, [&](const Part& a, const Part& b) { return below(a) < below(b); });
  };
  for (auto part = deepest(); part != parts.end() && below(*part) >= 0; part = deepest()) {
    const Part from = *part;
    parts.erase(part);
    kinematics_.graph().set_body(from.frame);
    add(parts,
        {{kinematics_.link(from.frame).father, kinematics_.to_father(from.frame, from.value)}},
        constant(kinematics_.graph(), Real(1)));
  }
  return parts;
}

Vec3 FrameChanges::in(const Parts& parts, int frame) const {
  Vec3 sum;
  for (const Part& part : parts.size() > 1 && !in_base() ? risen(parts, frame) : parts) {
    sum = sum + moved(part.value, part.frame, frame);
  }
  return sum;
}

void FrameChanges::add(Parts& a, const Parts& b, Expr factor) const {
  for (const Part& part : b) {
    const Vec3 value = factor * part.value;
    const auto place = std::ranges::find(a, part.frame, &Part::frame);
    if (is_zero(value)) {
      continue;
    }
    if (place == a.end()) {
      a.push_back({part.frame, value});
    } else {
      place->value = place->value + value;
    }
  }
}

std::vector<Expr> point_rotations(const Kinematics& k, const std::vector<model::Point>& points) {
  const FrameChanges frames(k, Way::kInLinks);
  std::vector<Expr> result;
  for (const model::Point& point : points) {
    const Mat3 own = constant(k.graph(), point.rotation);
    const Mat3 r = point.link == kBase ? own : k.orientation(point.link) * own;
    Mat3 columns;
    for (std::size_t n = 0; n < 3; ++n) {
      columns[n] = frames.moved(column(r, n), point.link, kBase);
    }
    for (const Vec3& row : transposed(columns)) {
      result.insert(result.end(), row.begin(), row.end());
    }
  }
  return result;
}

}  // namespace treedyn::formulate
