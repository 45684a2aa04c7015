// A function as sums and products of any number of operands: the form that the passes rewrite.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "optimise/constants.hpp"
#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// The place of a value that the original function does not have: just before its first user.
inline constexpr int kNoPosition = std::numeric_limits<int>::max();

/// One value. kAdd: signed operands. kMultiply: two or more positive operands. kDivide: two
/// positive ones. kSin, kCos: one positive. kSqrt: one. kConstant: `first` is the index in the
/// constant table. kInput: `first` is the array, `size` the element.
struct Item {
  Kind kind = Kind::kConstant;
  int first = 0;
  int size = 0;
  int position = kNoPosition;  ///< number of the node in the original graph
};

/// Items are numbered from 1; a Ref is an item, its negative or zero, as in Graph.
///
/// After `normalise` operands come before their users, no two items are equal (sums up to sign),
/// constants are merged, and a sum (product) that only one sum (product) uses is part of it.
/// Passes append items and shorten lists of operands, and leave this order to `normalise`.
class Network {
 public:
  Network() : items_(1), constants_(std::make_shared<ConstantTable>()) {}
  explicit Network(std::shared_ptr<ConstantTable> constants)
      : items_(1), constants_(std::move(constants)) {}

  [[nodiscard]] int size() const { return static_cast<int>(items_.size()); }
  [[nodiscard]] const Item& item(Ref a) const { return items_[program::node_index(a)]; }
  [[nodiscard]] std::span<Ref> operands(Ref a) {
    const Item& item = items_[program::node_index(a)];
    return {pool_.data() + begin(item), count(item)};
  }
  [[nodiscard]] std::span<const Ref> operands(Ref a) const {
    const Item& item = items_[program::node_index(a)];
    return {pool_.data() + begin(item), count(item)};
  }
  [[nodiscard]] bool is_constant(Ref a) const { return item(a).kind == Kind::kConstant; }
  [[nodiscard]] const Real& magnitude(Ref a) const { return constants_->value(item(a).first); }
  [[nodiscard]] ConstantTable& constants() const { return *constants_; }
  [[nodiscard]] const std::shared_ptr<ConstantTable>& shared_constants() const {
    return constants_;
  }

  /// A new item, also if an equal one exists.
  int append(Kind kind, std::span<const Ref> operands, int position = kNoPosition);
  int append_leaf(const Item& leaf);
  int append_constant(const Real& value);
  /// Keeps the first `size` operands. \pre size <= item(a).size
  void shorten(Ref a, int size) { items_[program::node_index(a)].size = size; }
  /// Gives an item another operation on its (already rewritten) operands.
  void set_kind(Ref a, Kind kind) { items_[program::node_index(a)].kind = kind; }
  /// Replaces all operands; O(number of operands).
  void set_operands(Ref a, std::span<const Ref> operands);

  std::vector<Ref>& outputs() { return outputs_; }
  [[nodiscard]] const std::vector<Ref>& outputs() const { return outputs_; }
  void reserve(std::size_t items, std::size_t operands);

 private:
  static std::size_t count(const Item& item) {
    const bool leaf = item.kind == Kind::kConstant || item.kind == Kind::kInput;
    return leaf ? 0 : to_index(item.size);
  }
  static std::size_t begin(const Item& item) { return count(item) == 0 ? 0 : to_index(item.first); }

  std::vector<Item> items_;
  std::vector<Ref> pool_;
  std::vector<Ref> outputs_;
  std::shared_ptr<ConstantTable> constants_;
};

/// The network of a graph, normalised.
Network network_of(const Graph& graph, std::span<const Ref> outputs);
/// Restores the invariant of Network; items that no output needs vanish. O(n log n).
Network normalise(const Network& network);
/// The graph, its nodes in the order of the positions. \pre normalised
Graph graph_of(const Network& network, std::vector<Ref>& outputs);

/// How often each item is used, by items and outputs. \pre normalised
std::vector<int> uses(const Network& network);
/// add + mul + div of what the outputs need. \pre normalised
int operations(const Network& network);

}  // namespace treedyn::optimise
