#include "optimise/network.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "common/transformed.hpp"
#include "optimise/kept.hpp"
#include "optimise/network_builder.hpp"

namespace treedyn::optimise {

namespace {

bool merges_into(Kind operand, Kind user) {
  return operand == user && (user == Kind::kAdd || user == Kind::kMultiply);
}

}  // namespace

int Network::append(Kind kind, std::span<const Ref> operands, int position) {
  const auto first = static_cast<int>(pool_.size());
  pool_.insert(pool_.end(), operands.begin(), operands.end());
  items_.push_back({kind, first, static_cast<int>(operands.size()), position});
  return size() - 1;
}

int Network::append_leaf(const Item& leaf) {
  items_.push_back(leaf);
  return size() - 1;
}

int Network::append_constant(const Real& value) {
  return append_leaf({Kind::kConstant, constants_->find_or_add(value), 0, 0});
}

void Network::set_operands(Ref a, std::span<const Ref> operands) {
  Item& item = items_[program::node_index(a)];
  if (static_cast<int>(operands.size()) > item.size) {
    item.first = static_cast<int>(pool_.size());
    pool_.resize(pool_.size() + operands.size());
  }
  item.size = static_cast<int>(operands.size());
  std::ranges::copy(operands, this->operands(a).begin());
}

void Network::reserve(std::size_t items, std::size_t operands) {
  items_.reserve(items + 1);
  pool_.reserve(operands);
}

namespace {

/// Item and the position that it gets.
struct Step {
  int item = 0;
  int position = 0;
};

struct Frame {
  int item = 0;
  std::size_t next = 0;
};

/// What is needed again for every network.
struct Workspace {
  std::vector<char> marks;
  std::vector<int> open;
  std::vector<std::uint64_t> keys;  ///< position, then number of the item
  std::vector<Frame> stack;
  std::vector<Step> order;
  std::vector<Ref> image;
  std::vector<Ref> operands;
  std::vector<int> count;
};

/// Depth first below one root; everything that is not there yet takes the position of the root.
void visit(const Network& network, int root, Workspace& w) {
  if (w.marks[program::node_index(root)] != 0) {
    return;
  }
  w.marks[program::node_index(root)] = 1;
  const int position = network.item(root).position;
  if (std::ranges::all_of(network.operands(root), [&](Ref operand) {
        return w.marks[program::node_index(operand)] != 0;
      })) {
    w.order.push_back({root, position});
    return;
  }
  w.stack.push_back({root, 0});
  while (!w.stack.empty()) {
    Frame& frame = w.stack.back();
    const auto operands = network.operands(frame.item);
    if (frame.next == operands.size()) {
      w.order.push_back({frame.item, position});
      w.stack.pop_back();
      continue;
    }
    const int operand = std::abs(operands[frame.next++]);
    if (w.marks[program::node_index(operand)] == 0) {
      w.marks[program::node_index(operand)] = 1;
      w.stack.push_back({operand, 0});
    }
  }
}

/// The needed items as keys, ascending.
void find_needed(const Network& network, Workspace& w) {
  const auto size = static_cast<std::size_t>(network.size());
  w.marks.assign(size, 0);
  w.open.clear();
  const auto need = [&](Ref a) {
    if (a != 0 && w.marks[program::node_index(a)] == 0) {
      w.marks[program::node_index(a)] = 1;
      w.open.push_back(std::abs(a));
    }
  };
  std::ranges::for_each(network.outputs(), need);
  while (!w.open.empty()) {
    const int k = w.open.back();
    w.open.pop_back();
    std::ranges::for_each(network.operands(k), need);
  }
  w.keys.clear();
  for (std::size_t k = 1; k < size; ++k) {
    if (w.marks[k] != 0) {
      const auto position = static_cast<std::uint64_t>(network.item(static_cast<Ref>(k)).position);
      w.keys.push_back((position << 32U) | k);
    }
  }
  if (!std::ranges::is_sorted(w.keys)) {
    std::ranges::sort(w.keys);
  }
}

/// `order`: the needed items, operands first, otherwise by position.
void find_order(const Network& network, Workspace& w) {
  find_needed(network, w);
  w.marks.assign(static_cast<std::size_t>(network.size()), 0);
  w.marks[0] = 1;
  w.order.clear();
  for (const std::uint64_t key : w.keys) {
    visit(network, static_cast<int>(key & 0xFFFFFFFFU), w);
  }
}

/// Appends to `builder` the item with the given operands.
Ref rebuild(NetworkBuilder& builder, const Item& item, std::vector<Ref>& operands, int position) {
  switch (item.kind) {
    case Kind::kAdd:
      return builder.sum(operands, position);
    case Kind::kMultiply:
      return builder.product(operands, position);
    case Kind::kDivide:
      return builder.quotient(operands[0], operands[1], position);
    case Kind::kSin:
    case Kind::kCos:
    case Kind::kSqrt:
      return builder.function(item.kind, operands[0], position);
    case Kind::kConstant:
    case Kind::kInput:
      break;
  }
  return builder.leaf(item);
}

std::vector<Ref> mapped(const std::vector<Ref>& image, std::span<const Ref> refs) {
  return transformed(refs, [&](Ref a) { return copy_of(image, a); });
}

/// Equal items become one.
Network without_duplicates(const Network& network) {
  Workspace& w = kept_by_thread<Workspace>();
  find_order(network, w);
  NetworkBuilder builder(network.shared_constants(), w.order.size());
  w.image.assign(static_cast<std::size_t>(network.size()), 0);
  for (const Step& step : w.order) {
    const Item& item = network.item(step.item);
    const auto operands = network.operands(step.item);
    w.operands.assign(operands.begin(), operands.end());
    for (Ref& operand : w.operands) {
      operand = copy_of(w.image, operand);
    }
    w.image[program::node_index(step.item)] = rebuild(builder, item, w.operands, step.position);
  }
  return builder.finish(mapped(w.image, network.outputs()));
}

void count_uses(const Network& network, std::vector<int>& count) {
  count.assign(static_cast<std::size_t>(network.size()), 0);
  for (const Ref output : network.outputs()) {
    ++count[program::node_index(output)];
  }
  count[0] = 0;
  for (int k = network.size() - 1; k > 0; --k) {
    if (count[program::node_index(k)] > 0) {
      for (const Ref operand : network.operands(k)) {
        ++count[program::node_index(operand)];
      }
    }
  }
}

/// Marks the sums (products) that only one sum (product) uses; false if there is none.
bool mark_parts(const Network& network, Workspace& w) {
  count_uses(network, w.count);
  w.marks.assign(static_cast<std::size_t>(network.size()), 0);
  bool found = false;
  for (int k = 1; k < network.size(); ++k) {
    const Kind kind = network.item(k).kind;
    if (w.count[program::node_index(k)] == 0 || !merges_into(kind, kind)) {
      continue;
    }
    for (const Ref operand : network.operands(k)) {
      const std::size_t at = program::node_index(operand);
      if (w.count[at] == 1 && network.item(operand).kind == kind) {
        w.marks[at] = 1;
        found = true;
      }
    }
  }
  return found;
}

/// Appends the operands of `k`, those of its parts instead of the parts.
void append_flat(const Network& network, Ref k, Workspace& w) {
  for (const Ref operand : network.operands(k)) {
    const std::size_t at = program::node_index(operand);
    if (w.marks[at] != 0) {
      append_flat(network, program::with_sign(operand, k), w);
    } else {
      w.operands.push_back(program::with_sign(program::with_sign(w.image[at], operand), k));
    }
  }
}

/// Sums within sums and products within products become one, where nobody else needs them.
/// \pre mark_parts(network, w)
Network flat(const Network& network, Workspace& w) {
  NetworkBuilder builder(network.shared_constants(), static_cast<std::size_t>(network.size()));
  w.image.assign(static_cast<std::size_t>(network.size()), 0);
  for (int k = 1; k < network.size(); ++k) {
    if (w.marks[program::node_index(k)] == 0) {
      w.operands.clear();
      append_flat(network, k, w);
      w.image[program::node_index(k)] =
          rebuild(builder, network.item(k), w.operands, network.item(k).position);
    }
  }
  return builder.finish(mapped(w.image, network.outputs()));
}

/// \param count  of uses
bool has_unneeded_operations(const Network& network, const std::vector<int>& count) {
  for (int k = 1; k < network.size(); ++k) {
    if (count[program::node_index(k)] == 0 && !network.operands(k).empty()) {
      return true;
    }
  }
  return false;
}

}  // namespace

Network normalise(const Network& network) {
  Workspace& w = kept_by_thread<Workspace>();
  Network normal = without_duplicates(network);
  for (;;) {
    if (mark_parts(normal, w)) {
      normal = flat(normal, w);
      count_uses(normal, w.count);
    }
    if (!has_unneeded_operations(normal, w.count)) {
      return normal;
    }
    normal = without_duplicates(normal);  // terms cancelled when sums became one
  }
}

Network network_of(const Graph& graph, std::span<const Ref> outputs) {
  NetworkBuilder builder(std::make_shared<ConstantTable>(), graph.size());
  std::vector<Ref> image(graph.size(), 0);
  std::vector<Ref> operands;
  for (const Ref k : reachable(graph, outputs)) {
    const Node& node = graph.node(k);
    if (node.kind == Kind::kConstant) {
      image[program::node_index(k)] = builder.constant(graph.value(k));
      continue;
    }
    operands.clear();
    for_each_operand(node, [&](Ref a) { operands.push_back(copy_of(image, a)); });
    const Item leaf{node.kind, node.a, node.b, k};
    image[program::node_index(k)] = rebuild(builder, leaf, operands, k);
  }
  return normalise(builder.finish(mapped(image, outputs)));
}

std::vector<int> uses(const Network& network) {
  std::vector<int> count;
  count_uses(network, count);
  return count;
}

int operations(const Network& network) {
  std::vector<int>& count = kept_by_thread<Workspace>().count;
  count_uses(network, count);
  int total = 0;
  for (int k = 1; k < network.size(); ++k) {
    if (count[program::node_index(k)] > 0 && program::is_arithmetic(network.item(k).kind)) {
      total += network.item(k).size - 1;
    }
  }
  return total;
}

}  // namespace treedyn::optimise
