#include "program/canonical.hpp"

#include <algorithm>
#include <tuple>

#include "program/copy.hpp"
#include "program/residue.hpp"

namespace treedyn::program {

namespace {

using namespace residue;  // NOLINT(google-build-using-namespace): operators of residues

/// Keys of the nodes by structure: the key of -a is the negative of that of a, the operands of sums
/// and products may change places, numbers count in double.
class Structure {
 public:
  Structure(const Graph& graph, const std::vector<Ref>& nodes)
      : graph_(graph), keys_(graph.size(), 0), heights_(graph.size(), 0) {
    for (const Ref k : nodes) {
      keys_[static_cast<std::size_t>(k)] = make_key(k);
      int& height = heights_[static_cast<std::size_t>(k)];
      for_each_operand(graph.node(k),
                       [&](Ref a) { height = std::max(height, this->height(a) + 1); });
    }
  }

  [[nodiscard]] int height(Ref a) const { return heights_[node_index(a)]; }
  /// True if node `a` comes before node `b`: long chains of operations first, cosines before sines,
  /// inputs by their index.
  [[nodiscard]] bool before(Ref a, Ref b) const { return rank(a) < rank(b); }

 private:
  [[nodiscard]] std::tuple<int, int, int, int, Key> rank(Ref a) const {
    const Node& node = graph_.node(a);
    const bool is_input = node.kind == Kind::kInput;
    const Key positive = key(std::abs(a));
    return {-height(a), -static_cast<int>(node.kind), is_input ? node.a : 0, is_input ? node.b : 0,
            std::min(positive, negative(positive))};
  }
  [[nodiscard]] Key key(Ref a) const {
    const Key positive = keys_[node_index(a)];
    return a < 0 ? negative(positive) : positive;
  }
  [[nodiscard]] Key make_key(Ref k) const {
    const Node& node = graph_.node(k);
    switch (node.kind) {
      case Kind::kConstant:
        return key_of(static_cast<double>(graph_.value(k).seen()));
      case Kind::kInput:
        return key_of(node.a, node.b);
      case Kind::kAdd:
        return odd(sum(key(node.a), key(node.b)), node.kind);
      case Kind::kMultiply:
        return odd(product(key(node.a), key(node.b)), node.kind);
      case Kind::kDivide:
        return odd(product(key(node.a), odd(key(node.b), node.kind)), node.kind);
      case Kind::kSin:
        return odd(key(node.a), node.kind);
      case Kind::kCos:
        return even(key(node.a), node.kind);
      case Kind::kSqrt:
        return image(key(node.a), node.kind);
    }
    return 0;
  }

  const Graph& graph_;
  std::vector<Key> keys_;
  std::vector<int> heights_;
};

/// Copies nodes section by section, the operands of a node just before it.
class Copy {
 public:
  Copy(const Function& from, Graph& to)
      : from_(from.graph),
        to_(to),
        nodes_(reachable(from_, from.outputs)),
        structure_(from_, nodes_),
        copies_(from_.size(), 0),
        done_(from_.size(), false) {
    const auto by_structure = [&](Ref a, Ref b) {
      const int x = from_.section(a);
      const int y = from_.section(b);
      return x != y ? x < y : structure_.before(a, b);
    };
    std::ranges::sort(nodes_, by_structure);
    std::ranges::for_each(nodes_, [&](Ref k) { visit(k); });
  }

  [[nodiscard]] Ref of(Ref a) const { return copy_of(copies_, a); }

 private:
  void visit(Ref k) {
    if (done_[static_cast<std::size_t>(k)]) {
      return;
    }
    done_[static_cast<std::size_t>(k)] = true;
    std::vector<Ref> operands;
    for_each_operand(from_.node(k), [&](Ref a) { operands.push_back(std::abs(a)); });
    std::ranges::sort(operands, [&](Ref a, Ref b) { return structure_.before(a, b); });
    std::ranges::for_each(operands, [&](Ref a) { visit(a); });
    const Ref copy = copy_node(from_, k, copies_, to_);
    copies_[static_cast<std::size_t>(k)] = copy;
    copy_hints(from_, k, copy, to_);
  }

  const Graph& from_;
  Graph& to_;
  std::vector<Ref> nodes_;
  Structure structure_;
  std::vector<Ref> copies_;
  std::vector<bool> done_;
};

}  // namespace

Function canonical(const Function& function) {
  Function result;
  result.signature = function.signature;
  const Copy copy(function, result.graph);
  for (const Ref output : function.outputs) {
    result.outputs.push_back(copy.of(output));
  }
  return result;
}

}  // namespace treedyn::program
