// Evaluates a function in any scalar type: double, float, 50 digits, intervals, a counting type.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "program/function.hpp"

namespace treedyn::program {

/// A constant of the program in the scalar type; specialise for types that Real does not convert
/// to.
template <class Scalar>
Scalar from_real(const Real& value) {
  return static_cast<Scalar>(value);
}

/// Constants as they are, or as decisions see them.
enum class Numbers { kPlain, kSeen };

/// The value of every node that `outputs` need; others are zero. O(size of the graph).
/// \param input       value of (array, element)
/// \param elementary  value of (kSin, kCos or kSqrt, argument)
template <class Scalar, class Input, class Elementary>
std::vector<Scalar> node_values(const Graph& graph, std::span<const Ref> outputs, Input input,
                                Elementary elementary, Numbers numbers = Numbers::kPlain) {
  std::vector<Scalar> value(graph.size(), Scalar(0));
  const auto at = [&](Ref a) -> const Scalar& {
    return value[to_index(a)];
  };
  for (const Ref k : reachable(graph, outputs)) {
    const Node& node = graph.node(k);
    Scalar& result = value[to_index(k)];
    switch (node.kind) {
      case Kind::kConstant:
        result = from_real<Scalar>(numbers == Numbers::kPlain ? graph.value(k).plain()
                                                              : Real(graph.value(k).seen()));
        break;
      case Kind::kInput:
        result = input(node.a, node.b);
        break;
      case Kind::kAdd:
        result = node.b < 0 ? Scalar(at(node.a) + Scalar(-at(-node.b)))
                            : Scalar(at(node.a) + at(node.b));
        break;
      case Kind::kMultiply:
        result = at(node.a) * at(node.b);
        break;
      case Kind::kDivide:
        result = at(node.a) / at(node.b);
        break;
      case Kind::kSin:
      case Kind::kCos:
      case Kind::kSqrt:
        result = elementary(node.kind, node.a < 0 ? Scalar(-at(-node.a)) : at(node.a));
        break;
    }
  }
  return value;
}

/// The value of a kSin, kCos or kSqrt.
template <class Scalar>
Scalar elementary(Kind kind, const Scalar& a) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  return kind == Kind::kSin   ? Scalar(sin(a))
         : kind == Kind::kCos ? Scalar(cos(a))
                              : Scalar(sqrt(a));
}

/// The same with roots of magnitudes: every number has a value.
template <class Scalar>
Scalar elementary_of_any(Kind kind, const Scalar& a) {
  using std::abs;
  return elementary(kind, kind == Kind::kSqrt ? Scalar(abs(a)) : a);
}

/// The values of the outputs, given those of all nodes.
template <class Scalar>
std::vector<Scalar> outputs_of(const Function& function, const std::vector<Scalar>& values) {
  return transformed<Scalar>(function.outputs, [&](Ref output) {
    const Scalar& value = values[node_index(output)];
    return output < 0 ? Scalar(-value) : value;
  });
}

/// The output values for the given input arrays (one span per array of `signature.inputs`, in
/// order). \pre the spans have the sizes that the signature states.
template <class Scalar>
std::vector<Scalar> interpret(const Function& function,
                              const std::vector<std::span<const Scalar>>& inputs) {
  return outputs_of(function, node_values<Scalar>(
                                  function.graph, function.outputs,
                                  [&](int array, int element) {
                                    return inputs[to_index(array)][to_index(element)];
                                  },
                                  elementary<Scalar>));
}

}  // namespace treedyn::program
