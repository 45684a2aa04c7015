#include "formulate/find_limbs.hpp"

#include <algorithm>
#include <map>

#include "common/index.hpp"

namespace treedyn::formulate {

std::vector<std::string> subtree_shapes(const model::Tree& tree) {
  const std::vector<std::vector<int>> sons = model::sons(tree);
  std::vector<std::string> shape(sons.size());
  for (std::size_t i = sons.size(); i-- > 0;) {
    shape[i] = tree.links[i].joint.turns() ? "(r" : "(p";
    for (const int son : sons[i]) {
      shape[i] += shape[to_index(son)];
    }
    shape[i] += ")";
  }
  return shape;
}

std::vector<std::vector<int>> similar_links(const model::Tree& tree) {
  const std::vector<std::string> shape = subtree_shapes(tree);
  const std::vector<int> depth = model::depths(tree);
  std::map<std::pair<int, std::string>, std::vector<int>> groups;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    groups[{depth[i], shape[i]}].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<int>> result;
  for (auto& [key, links] : groups) {
    result.push_back(std::move(links));
  }
  return result;
}

namespace {

class Finder {
 public:
  explicit Finder(const model::Tree& tree)
      : tree_(tree), sons_(model::sons(tree)), shapes_(subtree_shapes(tree)) {}

  std::vector<LimbLinks> find() {
    std::vector<int> roots;
    for (int i = 0; i < tree_.size(); ++i) {
      if (tree_.links[to_index(i)].father == model::kGround) {
        roots.push_back(i);
      }
    }
    search(roots);
    return std::move(result_);
  }

 private:
  /// True if the joint is its coordinate, and no other joint moves with it.
  [[nodiscard]] bool moves_alone(int i) const {
    const model::Drive& drive = tree_.drives[to_index(i)];
    return drive.multiplier == 1 && drive.offset == 0 &&
           std::ranges::count(tree_.drives, drive.coordinate, &model::Drive::coordinate) == 1;
  }

  /// Classes among `brothers`; what is in none is searched further out.
  void search(const std::vector<int>& brothers) {
    std::map<std::string, LimbLinks> classes;
    for (const int i : brothers) {
      std::vector<int> links;
      append(i, links);
      if (std::ranges::all_of(links, [&](int k) { return moves_alone(k); })) {
        classes[shapes_[to_index(i)]].push_back(links);
      }
    }
    for (const int i : brothers) {
      const auto found = classes.find(shapes_[to_index(i)]);
      const bool is_one = found != classes.end() && found->second.size() > 1 &&
                          std::ranges::any_of(found->second, [&](const std::vector<int>& links) {
                            return links.front() == i;
                          });
      if (!is_one) {
        search(sons_[to_index(i)]);
      } else if (found->second.front().front() == i) {
        result_.push_back(found->second);
      }
    }
  }

  /// The links of a subtree, brothers ordered by shape.
  void append(int i, std::vector<int>& links) const {
    links.push_back(i);
    std::vector<int> sons = sons_[to_index(i)];
    std::ranges::stable_sort(sons, {}, [&](int k) { return shapes_[to_index(k)]; });
    std::ranges::for_each(sons, [&](int son) { append(son, links); });
  }

  const model::Tree& tree_;
  std::vector<std::vector<int>> sons_;
  std::vector<std::string> shapes_;
  std::vector<LimbLinks> result_;
};

}  // namespace

std::vector<LimbLinks> find_limbs(const model::Tree& tree) { return Finder(tree).find(); }

}  // namespace treedyn::formulate
