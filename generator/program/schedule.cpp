#include "program/schedule.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace treedyn::program {

namespace {

/// An operand this many operations away from its only user keeps its statement: inlining it would
/// keep its own operands alive for so long.
constexpr int kFar = 24;

bool is_trigonometric(Kind kind) { return kind == Kind::kSin || kind == Kind::kCos; }

/// For every sine the cosine of the same angle and the other way round; 0: none is needed.
std::vector<Ref> trigonometric_partners(const Graph& graph, const std::vector<Ref>& nodes) {
  std::vector<Ref> by_angle(graph.size(), 0);
  std::vector<Ref> partner(graph.size(), 0);
  for (const Ref k : nodes) {
    const Node& node = graph.node(k);
    if (!is_trigonometric(node.kind)) {
      continue;
    }
    Ref& first = by_angle[node_index(node.a)];
    if (first != 0) {
      partner[node_index(k)] = first;
      partner[node_index(first)] = k;
    }
    first = k;
  }
  return partner;
}

/// True for sines, cosines and what nothing else needs than they.
std::vector<bool> needed_by_angles_only(const Graph& graph, std::span<const Ref> outputs,
                                        const std::vector<Ref>& nodes) {
  std::vector<bool> result(graph.size(), true);
  for (const Ref output : outputs) {
    result[node_index(output)] = is_trigonometric(graph.node(output).kind);
  }
  for (auto k = nodes.rbegin(); k != nodes.rend(); ++k) {
    if (!result[node_index(*k)]) {
      for_each_operand(graph.node(*k), [&](Ref operand) {
        result[node_index(operand)] = is_trigonometric(graph.node(operand).kind);
      });
    }
  }
  return result;
}

/// Puts operations into an order, each behind its operands.
class Order {
 public:
  Order(const Graph& graph, std::vector<Ref> partner)
      : graph_(graph), partner_(std::move(partner)), seen_(graph.size(), false) {}

  void add(Ref value);
  std::vector<Ref> take() { return std::move(order_); }

 private:
  [[nodiscard]] bool is_missing(Ref a) const {
    return graph_.is_operation(a) && !seen_[node_index(a)];
  }

  const Graph& graph_;
  std::vector<Ref> partner_;
  std::vector<bool> seen_;
  std::vector<Ref> order_;
};

/// Appends what `value` needs and what is missing, then itself and the cosine of its sine.
void Order::add(Ref value) {
  std::vector<Ref> waiting = {std::abs(value)};
  const auto add_missing = [&](Ref operand) {
    if (is_missing(operand)) {
      waiting.push_back(std::abs(operand));
    }
  };
  while (!waiting.empty()) {
    const Ref k = waiting.back();
    const std::size_t before = waiting.size();
    if (is_missing(k)) {
      for_each_operand(graph_.node(k), add_missing);
    }
    if (waiting.size() > before) {
      continue;
    }
    waiting.pop_back();
    for (const Ref each : {k, partner_[node_index(k)]}) {
      if (is_missing(each)) {
        seen_[node_index(each)] = true;
        order_.push_back(each);
      }
    }
  }
}

/// The sines and cosines; those of the k-th list depend on some of the list before it.
std::vector<std::vector<Ref>> by_dependence(const Graph& graph, const std::vector<Ref>& nodes) {
  std::vector<std::vector<Ref>> result;
  std::vector<std::size_t> before(graph.size(), 0);  // by node: lists that its operands need
  for (const Ref k : nodes) {
    for_each_operand(graph.node(k), [&](Ref operand) {
      const std::size_t own = is_trigonometric(graph.node(operand).kind) ? 1 : 0;
      before[node_index(k)] = std::max(before[node_index(k)], before[node_index(operand)] + own);
    });
    if (is_trigonometric(graph.node(k).kind)) {
      result.resize(std::max(result.size(), before[node_index(k)] + 1));
      result[before[node_index(k)]].push_back(k);
    }
  }
  return result;
}

/// All angles of a list, then their sines and cosines.
void add_together(const Graph& graph, const std::vector<Ref>& nodes, Order& order) {
  for (const std::vector<Ref>& list : by_dependence(graph, nodes)) {
    for (const Ref k : list) {
      order.add(graph.node(k).a);
    }
    for (const Ref k : list) {
      order.add(k);
    }
  }
}

}  // namespace

std::vector<Ref> operations_in_order(const Graph& graph, std::span<const Ref> outputs,
                                     Trigonometry trigonometry) {
  const std::vector<Ref> nodes = reachable(graph, outputs);
  const std::vector<bool> waits = trigonometry == Trigonometry::kLate
                                      ? needed_by_angles_only(graph, outputs, nodes)
                                      : std::vector<bool>(graph.size(), false);
  Order order(graph, trigonometric_partners(graph, nodes));
  if (trigonometry == Trigonometry::kTogether) {
    add_together(graph, nodes, order);
  }
  for (const Ref k : nodes) {
    if (!waits[node_index(k)]) {
      order.add(k);
    }
  }
  for (const Ref output : outputs) {
    order.add(output);
  }
  return order.take();
}

namespace {

bool is_sum(const Graph& graph, Ref a, const Schedule& schedule) {
  return schedule.is_inlined(a) && graph.node(a).kind == Kind::kAdd;
}

bool is_product(const Graph& graph, Ref a, const Schedule& schedule) {
  const Kind kind = graph.node(a).kind;
  return schedule.is_inlined(a) && (kind == Kind::kMultiply || kind == Kind::kDivide);
}

}  // namespace

Shape shape(const Graph& graph, const Node& node, const Schedule& schedule) {
  const bool a_sum = is_sum(graph, node.a, schedule);
  const bool b_sum = node.b != 0 && is_sum(graph, node.b, schedule);
  Shape result;
  if (node.kind == Kind::kAdd) {
    result.swapped = b_sum && !a_sum && node.b > 0;
    result.second_in_parentheses = b_sum && !result.swapped;
  } else if (node.kind == Kind::kMultiply || node.kind == Kind::kDivide) {
    const bool a_product = is_product(graph, node.a, schedule);
    const bool b_product = is_product(graph, node.b, schedule);
    result.swapped = node.kind == Kind::kMultiply && b_product && !a_product;
    result.first_in_parentheses = a_sum && !result.swapped;
    result.second_in_parentheses = result.swapped ? a_sum : b_sum || b_product;
  }
  return result;
}

namespace {

/// Builds a schedule operation by operation; an operand waits (is inlined) until it no longer fits.
class Inliner {
 public:
  Inliner(const Graph& graph, const Measure& measure) : graph_(graph), measure_(measure) {
    result_.inlined.assign(graph.size(), false);
    width_.assign(graph.size(), 0);
  }

  void mark_candidates(std::span<const Ref> outputs, std::span<const Ref> operations);

  void add(Ref k) {
    const Node& node = graph_.node(k);
    while (expression_width(node) > measure_.available(k) && materialise_widest(node)) {
    }
    width_[node_index(k)] = expression_width(node);
    if (!result_.inlined[node_index(k)]) {
      result_.statements.push_back(k);
    }
  }

  Schedule take() { return std::move(result_); }

 private:
  [[nodiscard]] int operand_width(Ref a) const {
    return result_.is_inlined(a) ? width_[node_index(a)] : measure_.atom(std::abs(a));
  }

  [[nodiscard]] int expression_width(const Node& node) const {
    if (node.b == 0) {
      return operand_width(node.a) + (node.a < 0 ? 9 : 6);  // "sqrt()", "sqrt(-())"
    }
    const Shape form = shape(graph_, node, result_);
    return operand_width(node.a) + operand_width(node.b) + 3 + (form.first_in_parentheses ? 2 : 0) +
           (form.second_in_parentheses ? 2 : 0);
  }

  [[nodiscard]] Ref widest_waiting(const Node& node, bool products) const {
    Ref widest = 0;
    for_each_operand(node, [&](Ref operand) {
      if (result_.is_inlined(operand) &&
          (products || graph_.node(operand).kind != Kind::kMultiply) &&
          (widest == 0 || operand_width(operand) > operand_width(widest))) {
        widest = std::abs(operand);
      }
    });
    return widest;
  }

  /// Gives the widest waiting operand a statement; false if none waits, or the expression gets a
  /// line of its own. A product stays in its sum as long as something else, or one of its own
  /// factors, can leave the line.
  bool materialise_widest(const Node& node) {
    const bool sum = node.kind == Kind::kAdd;
    Ref widest = widest_waiting(node, !sum);
    const Ref product = widest == 0 ? widest_waiting(node, true) : 0;
    if (product != 0 && !has_two_products(node)) {
      widest = widest_waiting(graph_.node(product), true);
    }
    if (widest == 0 && product != 0 &&
        (has_two_products(node) || expression_width(node) > measure_.own_line)) {
      widest = product;
    }
    if (widest == 0) {
      return false;
    }
    result_.inlined[node_index(widest)] = false;
    result_.statements.push_back(widest);
    if (product != 0 && widest != product) {
      width_[node_index(product)] = expression_width(graph_.node(product));
    }
    return true;
  }

  /// Only one of two products can be contracted with their sum.
  [[nodiscard]] bool has_two_products(const Node& node) const {
    return is_product(graph_, node.a, result_) && is_product(graph_, node.b, result_);
  }

  const Graph& graph_;
  const Measure& measure_;
  Schedule result_;
  std::vector<int> width_;
};

void Inliner::mark_candidates(std::span<const Ref> outputs, std::span<const Ref> operations) {
  std::vector<int> uses(graph_.size(), 0);
  std::vector<std::size_t> place(graph_.size(), 0);
  for (const Ref output : outputs) {
    uses[node_index(output)] += 2;
  }
  for (std::size_t at = 0; at < operations.size(); ++at) {
    place[node_index(operations[at])] = at;
    for_each_operand(graph_.node(operations[at]),
                     [&](Ref operand) { ++uses[node_index(operand)]; });
  }
  for (std::size_t at = 0; at < operations.size(); ++at) {
    const Node& user = graph_.node(operations[at]);
    for_each_operand(user, [&](Ref operand) {
      const Kind kind = graph_.node(operand).kind;
      const bool named = graph_.hint(operand).symbol != nullptr &&
                         !(kind == Kind::kMultiply && user.kind == Kind::kAdd);
      result_.inlined[node_index(operand)] =
          graph_.is_operation(operand) && !is_trigonometric(kind) && !is_trigonometric(user.kind) &&
          !named && uses[node_index(operand)] == 1 && at - place[node_index(operand)] <= kFar;
    });
  }
}

}  // namespace

Schedule schedule(const Graph& graph, std::span<const Ref> outputs, std::span<const Ref> operations,
                  const Measure& measure) {
  Inliner inliner(graph, measure);
  inliner.mark_candidates(outputs, operations);
  for (const Ref k : operations) {
    inliner.add(k);
  }
  return inliner.take();
}

}  // namespace treedyn::program
