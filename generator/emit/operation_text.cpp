#include "emit/operation_text.hpp"

#include <cstdlib>
#include <utility>

#include <fmt/format.h>

namespace treedyn::emit {

using program::Graph;
using program::Kind;
using program::Node;
using program::Ref;
using program::Schedule;
using program::Shape;

namespace {

struct Printer {
  const Graph& graph;
  const Schedule& schedule;
  const Atom& atom;

  [[nodiscard]] std::string operand(Ref a, bool in_parentheses) const {
    const Ref k = std::abs(a);
    if (!schedule.is_inlined(k)) {
      return atom(k);
    }
    return in_parentheses ? fmt::format("({})", operation(k)) : operation(k);
  }

  [[nodiscard]] std::string binary(const Node& node, char sign) const {
    const Shape form = shape(graph, node, schedule);
    const auto [first, second] =
        form.swapped ? std::pair(node.b, node.a) : std::pair(node.a, node.b);
    return fmt::format("{} {} {}", operand(first, form.first_in_parentheses), sign,
                       operand(second, form.second_in_parentheses));
  }

  [[nodiscard]] std::string operation(Ref k) const {
    const Node& node = graph.node(k);
    switch (node.kind) {
      case Kind::kAdd:
        return binary(node, node.b < 0 ? '-' : '+');
      case Kind::kMultiply:
        return binary(node, '*');
      case Kind::kDivide:
        return binary(node, '/');
      case Kind::kSin:
        return fmt::format("sin({})", operand(node.a, false));
      case Kind::kCos:
        return fmt::format("cos({})", operand(node.a, false));
      case Kind::kSqrt:
        return fmt::format("sqrt({})", node.a > 0                    ? operand(node.a, false)
                                       : schedule.is_inlined(node.a) ? negative(-node.a)
                                                                     : "-" + atom(-node.a));
      case Kind::kConstant:
      case Kind::kInput:
        break;
    }
    return atom(k);
  }

  /// -(a - b) is b - a, exactly.
  [[nodiscard]] std::string negative(Ref k) const {
    const Node& node = graph.node(k);
    if (node.kind != Kind::kAdd) {
      return fmt::format("-{}", operation(k));
    }
    const bool a_sum = schedule.is_inlined(node.a) && graph.node(node.a).kind == Kind::kAdd;
    if (node.b < 0) {
      return fmt::format("{} - {}", operand(node.b, false), operand(node.a, a_sum));
    }
    return fmt::format("-({})", operation(k));
  }
};

}  // namespace

std::string expression(const Graph& graph, const Schedule& schedule, const Atom& atom, Ref value) {
  const Printer printer{graph, schedule, atom};
  return value < 0 ? printer.negative(-value) : printer.operation(value);
}

void for_each_atom(const Graph& graph, const Schedule& schedule, Ref value,
                   const std::function<void(Ref)>& visit) {
  program::for_each_operand(graph.node(value), [&](Ref operand) {
    if (schedule.is_inlined(operand)) {
      for_each_atom(graph, schedule, operand, visit);
    } else {
      visit(std::abs(operand));
    }
  });
}

}  // namespace treedyn::emit
