#include "optimise/network.hpp"

#include <algorithm>
#include <cstdlib>

#include "common/error.hpp"
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
  Item& item = items_[index(a)];
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

/// Depth first below one root; everything that is not there yet takes the position of the root.
void visit(const Network& network, int root, std::vector<bool>& done, std::vector<Step>& order) {
  struct Frame {
    int item;
    std::size_t next;
  };
  const int position = network.item(root).position;
  std::vector<Frame> stack;
  if (!done[program::node_index(root)]) {
    done[program::node_index(root)] = true;
    stack.push_back({root, 0});
  }
  while (!stack.empty()) {
    Frame& frame = stack.back();
    const auto operands = network.operands(frame.item);
    if (frame.next == operands.size()) {
      order.push_back({frame.item, position});
      stack.pop_back();
      continue;
    }
    const int operand = std::abs(operands[frame.next++]);
    if (!done[program::node_index(operand)]) {
      done[program::node_index(operand)] = true;
      stack.push_back({operand, 0});
    }
  }
}

/// Ascending.
std::vector<int> needed_items(const Network& network) {
  std::vector<bool> needed(static_cast<std::size_t>(network.size()), false);
  std::vector<int> open;
  const auto need = [&](Ref a) {
    if (a != 0 && !needed[program::node_index(a)]) {
      needed[program::node_index(a)] = true;
      open.push_back(std::abs(a));
    }
  };
  std::ranges::for_each(network.outputs(), need);
  while (!open.empty()) {
    const int k = open.back();
    open.pop_back();
    std::ranges::for_each(network.operands(k), need);
  }
  std::vector<int> items;
  for (int k = 1; k < network.size(); ++k) {
    if (needed[program::node_index(k)]) {
      items.push_back(k);
    }
  }
  return items;
}

/// The needed items, operands first, otherwise by position.
std::vector<Step> evaluation_order(const Network& network) {
  std::vector<int> items = needed_items(network);
  const auto position = [&](int k) {
    return network.item(k).position;
  };
  if (!std::ranges::is_sorted(items, {}, position)) {
    std::ranges::stable_sort(items, {}, position);
  }
  std::vector<bool> done(static_cast<std::size_t>(network.size()), false);
  done[0] = true;
  std::vector<Step> order;
  order.reserve(items.size());
  for (const int root : items) {
    visit(network, root, done, order);
  }
  return order;
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
  std::vector<Ref> result;
  result.reserve(refs.size());
  for (const Ref a : refs) {
    result.push_back(program::with_sign(image[program::node_index(a)], a));
  }
  return result;
}

/// Equal items become one.
Network without_duplicates(const Network& network) {
  const std::vector<Step> order = evaluation_order(network);
  NetworkBuilder builder(network.shared_constants(), order.size());
  std::vector<Ref> image(static_cast<std::size_t>(network.size()), 0);
  std::vector<Ref> operands;
  for (const Step& step : order) {
    operands.clear();
    for (const Ref operand : network.operands(step.item)) {
      if (const Ref a = program::with_sign(image[program::node_index(operand)], operand);
          a != 0 || network.item(step.item).kind != Kind::kAdd) {
        operands.push_back(a);
      }
    }
    image[program::node_index(step.item)] =
        rebuild(builder, network.item(step.item), operands, step.position);
  }
  return builder.finish(mapped(image, network.outputs()));
}

/// Marks the sums (products) that only one sum (product) uses.
std::vector<bool> parts(const Network& network) {
  const std::vector<int> count = uses(network);
  std::vector<bool> part(static_cast<std::size_t>(network.size()), false);
  for (int k = 1; k < network.size(); ++k) {
    for (const Ref operand : network.operands(k)) {
      part[program::node_index(operand)] =
          part[program::node_index(operand)] ||
          (count[program::node_index(k)] > 0 && count[program::node_index(operand)] == 1 &&
           merges_into(network.item(operand).kind, network.item(k).kind));
    }
  }
  return part;
}

/// Appends the operands of `k`, those of its parts instead of the parts.
void append_flat(const Network& network, const std::vector<bool>& part,
                 const std::vector<Ref>& image, Ref k, std::vector<Ref>& operands) {
  for (const Ref operand : network.operands(k)) {
    if (part[program::node_index(operand)]) {
      append_flat(network, part, image, program::with_sign(operand, k), operands);
    } else {
      operands.push_back(
          program::with_sign(program::with_sign(image[program::node_index(operand)], operand), k));
    }
  }
}

/// Sums within sums and products within products become one, where nobody else needs them.
Network flat(Network network) {
  const std::vector<bool> part = parts(network);
  if (std::ranges::find(part, true) == part.end()) {
    return network;
  }
  NetworkBuilder builder(network.shared_constants(), static_cast<std::size_t>(network.size()));
  std::vector<Ref> image(static_cast<std::size_t>(network.size()), 0);
  std::vector<Ref> operands;
  for (int k = 1; k < network.size(); ++k) {
    if (!part[program::node_index(k)]) {
      operands.clear();
      append_flat(network, part, image, k, operands);
      if (network.item(k).kind == Kind::kAdd) {
        std::erase(operands, 0);
      }
      image[program::node_index(k)] =
          rebuild(builder, network.item(k), operands, network.item(k).position);
    }
  }
  return builder.finish(mapped(image, network.outputs()));
}

bool has_unneeded_operations(const Network& network) {
  const std::vector<int> count = uses(network);
  for (int k = 1; k < network.size(); ++k) {
    if (count[program::node_index(k)] == 0 && !network.operands(k).empty()) {
      return true;
    }
  }
  return false;
}

}  // namespace

Network normalise(const Network& network) {
  Network normal = flat(without_duplicates(network));
  while (has_unneeded_operations(normal)) {  // terms cancelled when sums became one
    normal = flat(without_duplicates(normal));
  }
  return normal;
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
    for_each_operand(node, [&](Ref a) {
      operands.push_back(program::with_sign(image[program::node_index(a)], a));
    });
    const Item leaf{node.kind, node.a, node.b, k};
    image[program::node_index(k)] = rebuild(builder, leaf, operands, k);
  }
  return normalise(builder.finish(mapped(image, outputs)));
}

std::vector<int> uses(const Network& network) {
  std::vector<int> count(static_cast<std::size_t>(network.size()), 0);
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
  return count;
}

int operations(const Network& network) {
  const std::vector<int> count = uses(network);
  int total = 0;
  for (int k = 1; k < network.size(); ++k) {
    const Kind kind = network.item(k).kind;
    if (count[program::node_index(k)] > 0 &&
        (kind == Kind::kAdd || kind == Kind::kMultiply || kind == Kind::kDivide)) {
      total += network.item(k).size - 1;
    }
  }
  return total;
}

}  // namespace treedyn::optimise
