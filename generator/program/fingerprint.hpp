// Values at pseudo-random points: what tells two expressions apart, whatever their form.
#pragma once

#include <cmath>
#include <vector>

#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

/// The value of every node that `outputs` need, at the point number `point`; others are zero.
///
/// Only + - * / and sqrt, so that every machine computes the same: sine and cosine are replaced by
/// the rational points 2t / (1 + t^2), (1 - t^2) / (1 + t^2) of the circle at t = the argument.
/// Identities of sines and cosines of one argument hold, sums of angles mean nothing.
/// Inputs lie in +-[1/4, 1]. O(size of the graph).
template <class Scalar>
std::vector<Scalar> fingerprint(const Graph& graph, std::span<const Ref> outputs, int point) {
  using std::sqrt;
  std::vector<Scalar> value(graph.size(), Scalar(0));
  const auto at = [&](Ref a) -> Scalar {
    return a < 0 ? Scalar(-value[static_cast<std::size_t>(-a)])
                 : value[static_cast<std::size_t>(a)];
  };
  for (const Ref k : reachable(graph, outputs)) {
    const Node& node = graph.node(k);
    Scalar& result = value[static_cast<std::size_t>(k)];
    switch (node.kind) {
      case Kind::kConstant:
        result = from_real<Scalar>(graph.value(k));
        break;
      case Kind::kInput: {
        const double u = Random(scramble(static_cast<std::uint64_t>(node.a) << 32U |
                                         static_cast<std::uint32_t>(node.b)) +
                                static_cast<std::uint64_t>(point) * 0x10001U)
                             .symmetric();
        result = Scalar(u < 0 ? u * 0.75 - 0.25 : u * 0.75 + 0.25);
        break;
      }
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
        result = 2 * at(node.a) / (1 + at(node.a) * at(node.a));
        break;
      case Kind::kCos:
        result = (1 - at(node.a) * at(node.a)) / (1 + at(node.a) * at(node.a));
        break;
      case Kind::kSqrt: {
        const Scalar a = at(node.a);
        result = sqrt(a < 0 ? Scalar(-a) : a);
        break;
      }
    }
  }
  return value;
}

}  // namespace treedyn::program
