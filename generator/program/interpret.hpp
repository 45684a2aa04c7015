// Evaluates a function in any scalar type: double, float, 50 digits, intervals, a counting type.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// A constant of the program in the scalar type; specialise for types that Real does not convert
/// to.
template <class Scalar>
Scalar from_real(const Real& value) {
  return static_cast<Scalar>(value);
}

/// The output values for the given input arrays (one span per array of `signature.inputs`, in
/// order). \pre the spans have the sizes that the signature states.
template <class Scalar>
std::vector<Scalar> interpret(const Function& function,
                              const std::vector<std::span<const Scalar>>& inputs) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Graph& graph = function.graph;
  std::vector<Scalar> value(graph.size(), Scalar(0));
  const auto at = [&](Ref a) -> Scalar {
    return a < 0 ? Scalar(-value[static_cast<std::size_t>(-a)])
                 : value[static_cast<std::size_t>(a)];
  };
  for (const Ref k : reachable(graph, function.outputs)) {
    const Node& node = graph.node(k);
    Scalar& result = value[static_cast<std::size_t>(k)];
    switch (node.kind) {
      case Kind::kConstant:
        result = from_real<Scalar>(graph.value(k));
        break;
      case Kind::kInput:
        result = inputs[static_cast<std::size_t>(node.a)][static_cast<std::size_t>(node.b)];
        break;
      case Kind::kAdd:
        result = at(node.a) + at(node.b);
        break;
      case Kind::kMultiply:
        result = at(node.a) * at(node.b);
        break;
      case Kind::kDivide:
        result = at(node.a) / at(node.b);
        break;
      case Kind::kSin:
        result = sin(at(node.a));
        break;
      case Kind::kCos:
        result = cos(at(node.a));
        break;
      case Kind::kSqrt:
        result = sqrt(at(node.a));
        break;
    }
  }
  std::vector<Scalar> outputs;
  outputs.reserve(function.outputs.size());
  for (const Ref output : function.outputs) {
    outputs.push_back(at(output));
  }
  return outputs;
}

}  // namespace treedyn::program
