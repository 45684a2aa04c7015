#include "program/graph.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/error.hpp"

namespace treedyn::program {

namespace {

std::uint64_t hash(const Node& node) {
  std::uint64_t x = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(node.a)) << 32U) |
                    static_cast<std::uint64_t>(static_cast<std::uint32_t>(node.b));
  x = x * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(node.kind);
  x ^= x >> 29U;
  x *= 0xBF58476D1CE4E5B9ULL;
  return x ^ (x >> 32U);
}

}  // namespace

Graph::Graph() : nodes_(1), hints_(2), sections_(1), fixed_(1, true), table_(1024) {}

std::size_t Graph::slot(const Node& node) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = static_cast<std::size_t>(hash(node)) & mask;
  while (table_[place] != 0 && this->node(table_[place]) != node) {
    place = (place + 1) & mask;
  }
  return place;
}

void Graph::grow_table() {
  table_.assign(2 * table_.size(), 0);
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    table_[slot(nodes_[k])] = static_cast<Ref>(k);
  }
}

Ref Graph::make(Kind kind, Ref a, Ref b) {
  const Node node{kind, a, b};
  const std::size_t place = slot(node);
  if (table_[place] != 0) {
    return table_[place];
  }
  const auto made = static_cast<Ref>(nodes_.size());
  table_[place] = made;
  const bool input = kind == Kind::kInput;
  fixed_.push_back(kind == Kind::kConstant ||
                   (input ? a >= kFixedArrays : is_fixed(a) && is_fixed(b)));
  nodes_.push_back(node);
  hints_.push_back({nullptr, body_, nullptr});
  hints_.push_back({nullptr, body_, nullptr});
  sections_.push_back(section_);
  if (2 * nodes_.size() > table_.size()) {
    grow_table();
  }
  return made;
}

Ref Graph::constant(const Real& value) {
  if (value == 0) {
    return 0;
  }
  const Real magnitude = abs(value);
  const double key = nearly(magnitude.seen());
  for (auto it = constant_table_.lower_bound(key * (1 - 1e-14));
       it != constant_table_.end() && it->first <= key * (1 + 1e-14); ++it) {
    const Real& known = constants_[static_cast<std::size_t>(node(it->second).a)];
    if (identical(known, magnitude)) {
      return value < 0 ? -it->second : it->second;
    }
  }
  constants_.push_back(magnitude);
  const Ref made = make(Kind::kConstant, static_cast<Ref>(constants_.size() - 1), 0);
  constant_table_.emplace(key, made);
  return value < 0 ? -made : made;
}

Ref Graph::input(int array, int element) { return make(Kind::kInput, array, element); }

bool Graph::is_constant(Ref a) const { return a == 0 || node(a).kind == Kind::kConstant; }

bool Graph::is_one(Ref a) const {
  static const Real one = 1;
  return node(a).kind == Kind::kConstant && constants_[static_cast<std::size_t>(node(a).a)] == one;
}

Real Graph::value(Ref a) const {
  TREEDYN_EXPECT(is_constant(a));
  if (a == 0) {
    return 0;
  }
  const Real& magnitude = constants_[static_cast<std::size_t>(node(a).a)];
  return a < 0 ? Real(-magnitude) : magnitude;
}

Ref Graph::add_constant(Ref sum, Ref constant) {
  const Real a = value(sum);
  const Real b = value(constant);
  const Real total = a + b;
  return negligible(total, larger(a, b)) ? 0 : this->constant(total);
}

Ref Graph::add(Ref a, Ref b) {
  if (a == 0 || b == 0) {
    return a + b;
  }
  if (a == -b) {
    return 0;
  }
  if (is_constant(a) && is_constant(b)) {
    return add_constant(a, b);
  }
  if (is_constant(a)) {
    std::swap(a, b);
  }
  if (const Node n = node(a);
      is_constant(b) && n.kind == Kind::kAdd) {  // (x + c1) + c2 = x + (c1 + c2)
    const auto [x, c] = is_constant(n.a) ? std::pair(n.b, n.a) : std::pair(n.a, n.b);
    if (is_constant(c)) {
      return add(a < 0 ? -x : x, add_constant(a < 0 ? -c : c, b));
    }
  }
  if (std::abs(b) < std::abs(a)) {
    std::swap(a, b);
  }
  return a < 0 ? -make(Kind::kAdd, -a, -b) : make(Kind::kAdd, a, b);
}

Ref Graph::multiply(Ref a, Ref b) {
  if (a == 0 || b == 0) {
    return 0;
  }
  const bool negative = (a < 0) != (b < 0);
  a = std::abs(a);
  b = std::abs(b);
  if (is_constant(b)) {
    std::swap(a, b);
  }
  Ref product = 0;
  if (is_one(a)) {
    product = b;
  } else if (is_constant(a) && is_constant(b)) {
    product = constant(value(a) * value(b));
  } else if (const Node n = node(b);
             is_constant(a) && n.kind == Kind::kMultiply && is_constant(n.a)) {
    product = multiply(constant(value(a) * value(n.a)), n.b);  // c1 (c2 x) = (c1 c2) x
  } else {
    if (!is_constant(a) && b < a) {
      std::swap(a, b);
    }
    product = make(Kind::kMultiply, a, b);
  }
  return negative ? -product : product;
}

Ref Graph::divide(Ref a, Ref b) {
  TREEDYN_EXPECT(b != 0);
  if (a == 0) {
    return 0;
  }
  if (is_constant(b)) {
    return multiply(a, constant(1 / value(b)));
  }
  const Ref quotient = make(Kind::kDivide, std::abs(a), std::abs(b));
  return (a < 0) != (b < 0) ? -quotient : quotient;
}

Ref Graph::sin(Ref a) {
  if (is_constant(a)) {
    return constant(treedyn::sin(value(a)));
  }
  return a < 0 ? -make(Kind::kSin, -a, 0) : make(Kind::kSin, a, 0);
}

Ref Graph::cos(Ref a) {
  if (is_constant(a)) {
    return constant(treedyn::cos(value(a)));
  }
  return make(Kind::kCos, std::abs(a), 0);
}

Ref Graph::sqrt(Ref a) {
  return is_constant(a) ? constant(treedyn::sqrt(value(a))) : make(Kind::kSqrt, a, 0);
}

void Graph::name(Ref a, const char* symbol, int body, const char* component) {
  ++section_;
  if (is_constant(a) || node(a).kind == Kind::kInput || hint(a).symbol != nullptr) {
    return;
  }
  set_hint(a, {symbol, body, component});
}

void Graph::set_body(int body) {
  ++section_;
  body_ = body;
}

std::vector<Ref> reachable(const Graph& graph, std::span<const Ref> outputs) {
  std::vector<bool> needed(graph.size(), false);
  for (const Ref output : outputs) {
    needed[node_index(output)] = true;
  }
  std::vector<Ref> order;
  for (std::size_t k = graph.size() - 1; k > 0; --k) {
    if (needed[k]) {
      order.push_back(static_cast<Ref>(k));
      for_each_operand(graph.node(static_cast<Ref>(k)),
                       [&](Ref operand) { needed[node_index(operand)] = true; });
    }
  }
  std::ranges::reverse(order);
  return order;
}

}  // namespace treedyn::program
