#include "optimise/window.hpp"

#include <algorithm>
#include <cstdlib>

#include "common/index.hpp"

namespace treedyn::optimise {

namespace {

/// Users of every item, those of item k in users[first[k] .. first[k + 1]).
struct Users {
  std::vector<int> first;
  std::vector<int> users;
};

Users users_of(const Network& network) {
  Users result;
  result.first.assign(to_index(network.size()) + 1, 0);
  for (int k = 1; k < network.size(); ++k) {
    for (const Ref operand : network.operands(k)) {
      ++result.first[program::node_index(operand) + 1];
    }
  }
  for (std::size_t k = 1; k < result.first.size(); ++k) {
    result.first[k] += result.first[k - 1];
  }
  result.users.resize(to_index(result.first.back()));
  std::vector<int> next = result.first;
  for (int k = 1; k < network.size(); ++k) {
    for (const Ref operand : network.operands(k)) {
      result.users[to_index(next[program::node_index(operand)]++)] = k;
    }
  }
  return result;
}

}  // namespace

std::vector<int> random_neighbourhood(const Network& network, Random& random, int size) {
  const Users users = users_of(network);
  std::vector<bool> seen(to_index(network.size()), false);
  std::vector<int> found;
  const auto visit = [&](int k) {
    if (!seen[program::node_index(k)] && program::is_arithmetic(network.item(k).kind)) {
      seen[program::node_index(k)] = true;
      found.push_back(k);
    }
  };
  while (found.empty()) {
    visit(1 + random.below(network.size() - 1));
  }
  for (std::size_t i = 0; i < found.size() && static_cast<int>(found.size()) < size; ++i) {
    std::swap(found[i], found[i + to_index(random.below(static_cast<int>(found.size() - i)))]);
    for (const Ref operand : network.operands(found[i])) {
      visit(std::abs(operand));
    }
    for (int u = users.first[program::node_index(found[i])];
         u < users.first[program::node_index(found[i]) + 1]; ++u) {
      visit(users.users[to_index(u)]);
    }
  }
  std::ranges::sort(found);
  return found;
}

Window cut_window(const Network& network, std::span<const int> items) {
  Window window{Network(network.shared_constants()), {}};
  std::vector<int> image(to_index(network.size()), 0);
  std::vector<int> inner_uses(to_index(network.size()), 0);
  std::vector<Ref> operands;
  for (const int k : items) {
    operands.clear();
    for (const Ref operand : network.operands(k)) {
      int& known = image[program::node_index(operand)];
      if (known == 0) {
        const Item& item = network.item(operand);
        known = window.network.append_leaf(
            item.kind == Kind::kConstant
                ? item
                : Item{Kind::kInput, -1, std::abs(operand), item.position});
      }
      operands.push_back(program::with_sign(known, operand));
      ++inner_uses[program::node_index(operand)];
    }
    image[program::node_index(k)] =
        window.network.append(network.item(k).kind, operands, network.item(k).position);
  }
  const std::vector<int> all_uses = uses(network);
  for (const int k : items) {
    if (all_uses[program::node_index(k)] > inner_uses[program::node_index(k)]) {
      window.results.push_back(k);
      window.network.outputs().push_back(image[program::node_index(k)]);
    }
  }
  window.network = normalise(window.network);
  return window;
}

Network with_window(Network network, const Window& window) {
  std::vector<Ref> image(to_index(window.network.size()), 0);
  std::vector<Ref> operands;
  for (int k = 1; k < window.network.size(); ++k) {
    const Item& item = window.network.item(k);
    if (item.kind == Kind::kInput) {
      image[program::node_index(k)] = item.size;
    } else if (item.kind == Kind::kConstant) {
      image[program::node_index(k)] = network.append_leaf(item);
    } else {
      operands.clear();
      for (const Ref operand : window.network.operands(k)) {
        operands.push_back(copy_of(image, operand));
      }
      image[program::node_index(k)] = network.append(item.kind, operands, item.position);
    }
  }
  for (std::size_t i = 0; i < window.results.size(); ++i) {
    const Ref output = window.network.outputs()[i];
    const Ref value = copy_of(image, output);
    network.set_kind(window.results[i], Kind::kAdd);  // a sum of one term is that term
    network.set_operands(window.results[i], std::span(&value, 1));
  }
  return normalise(network);
}

}  // namespace treedyn::optimise
