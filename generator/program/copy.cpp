#include "program/copy.hpp"

namespace treedyn::program {

Ref copy_node(const Graph& from, Ref k, std::span<const Ref> copies, Graph& to) {
  const Node& node = from.node(k);
  switch (node.kind) {
    case Kind::kConstant:
      return to.constant(from.value(k));
    case Kind::kInput:
      return to.input(node.a, node.b);
    case Kind::kAdd:
      return to.add(copy_of(copies, node.a), copy_of(copies, node.b));
    case Kind::kMultiply:
      return to.multiply(copy_of(copies, node.a), copy_of(copies, node.b));
    case Kind::kDivide:
      return to.divide(copy_of(copies, node.a), copy_of(copies, node.b));
    case Kind::kSin:
      return to.sin(copy_of(copies, node.a));
    case Kind::kCos:
      return to.cos(copy_of(copies, node.a));
    case Kind::kSqrt:
      return to.sqrt(copy_of(copies, node.a));
  }
  return 0;
}

}  // namespace treedyn::program
