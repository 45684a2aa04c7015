// Values at pseudo-random points: what tells two expressions apart, whatever their form.
#pragma once

#include <cmath>
#include <vector>

#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

/// Element of an input array at the point number `point`, in +-[1/4, 1].
inline double sample_input(int array, int element, int point) {
  const std::uint64_t name = static_cast<std::uint64_t>(static_cast<std::uint32_t>(array)) << 32U |
                             static_cast<std::uint32_t>(element);
  const double u =
      Random(scramble(name) + static_cast<std::uint64_t>(point) * 0x10001U).symmetric();
  return u < 0 ? u * 0.75 - 0.25 : u * 0.75 + 0.25;
}

/// Sine and cosine are replaced by rational points 2t / (1 + t^2), (1 - t^2) / (1 + t^2) of the
/// circle, t an odd irrational function of the argument: every machine computes the same and only
/// c^2 + s^2 = 1 and what follows from it holds; sums of angles mean nothing. So are roots, of
/// which nothing holds: the root of x^2 is x in states where x is positive, and no others. They
/// exist of negative numbers as well, and are not those of their opposites.
template <class Scalar>
Scalar sample_function(Kind kind, const Scalar& a) {
  using std::sqrt;
  const Scalar square = a * a;
  if (kind == Kind::kSqrt) {
    const Scalar root = a * Scalar(sqrt(square + Scalar(1.5)));
    return a < 0 ? Scalar(Scalar(-0.75) * root) : root;
  }
  const Scalar t = a * Scalar(sqrt(square + Scalar(1.25)));
  const Scalar scale = 1 / (1 + t * t);
  return kind == Kind::kSin ? Scalar(2 * t * scale) : Scalar((1 - t * t) * scale);
}

/// What is seen of every node that `outputs` need, at the point number `point`; others are zero.
/// O(size of the graph).
template <class Scalar>
std::vector<Scalar> fingerprint(const Graph& graph, std::span<const Ref> outputs, int point) {
  return node_values<Scalar>(
      graph, outputs,
      [point](int array, int element) { return Scalar(sample_input(array, element, point)); },
      sample_function<Scalar>, Numbers::kSeen);
}

}  // namespace treedyn::program
