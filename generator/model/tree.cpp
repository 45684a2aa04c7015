#include "model/tree.hpp"

#include <algorithm>

namespace treedyn::model {

Vector3 place_in_frame(const Tree& tree, const Point& point) {
  const auto frame = std::ranges::find_if(tree.frames, [&](const Frame& f) {
    return f.name == point.link_name && f.link == point.link;
  });
  const Vector3 origin = frame == tree.frames.end() ? Vector3{} : frame->origin;
  Vector3 at;
  for (std::size_t k = 0; k < 3; ++k) {
    Real sum = 0;
    Real scale = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      const Real turn = point.rotation[3 * n + k].plain();
      sum += turn * Real(point.at[n].plain() - origin[n].plain());
      scale += abs(turn) * Real(abs(point.at[n].plain()) + abs(origin[n].plain()));
    }
    at[k] = negligible(sum, scale) ? Real(0) : sum;
  }
  return at;
}

std::vector<std::vector<int>> sons(const Tree& tree) {
  std::vector<std::vector<int>> result(tree.links.size());
  for (int i = 0; i < tree.size(); ++i) {
    const int father = tree.links[static_cast<std::size_t>(i)].father;
    if (father != kGround) {
      result[static_cast<std::size_t>(father)].push_back(i);
    }
  }
  return result;
}

std::vector<int> depths(const Tree& tree) {
  std::vector<int> result;
  result.reserve(tree.links.size());
  for (const Link& link : tree.links) {
    result.push_back(link.father == kGround ? 1
                                            : result[static_cast<std::size_t>(link.father)] + 1);
  }
  return result;
}

bool reaches(const Tree& tree, int link, int ancestor) {
  int i = link;
  while (i > ancestor) {
    i = tree.links[static_cast<std::size_t>(i)].father;
  }
  return i == ancestor;
}

bool has_free_base(const Tree& tree) {
  if (tree.size() < 7) {
    return false;
  }
  const auto link = [&](int i) -> const Link& {
    return tree.links[static_cast<std::size_t>(i)];
  };
  for (int i = 0; i < 6; ++i) {
    const Link& l = link(i);
    const auto type = i < 3 ? JointType::kPrismatic : JointType::kRevolute;
    const bool at_origin = l.joint.offset == Vector3{};
    const bool massless = l.inertia.mass == 0 && l.inertia.about_com == Matrix3{};
    if (l.father != i - 1 || l.joint.type != type || !(at_origin || i == 0) ||
        (i < 5 && !massless)) {
      return false;
    }
  }
  for (int i = 6; i < tree.size(); ++i) {
    if (link(i).father < 5) {
      return false;
    }
  }
  return true;
}

}  // namespace treedyn::model
