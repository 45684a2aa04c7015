#include "model/tree.hpp"

namespace treedyn::model {

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

}  // namespace treedyn::model
