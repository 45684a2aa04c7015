// Keeps equivalent networks from amplifying rounding.
#pragma once

#include <array>
#include <vector>

#include "optimise/network.hpp"
#include "program/rounding.hpp"

namespace treedyn::optimise {

using program::Rounded;

/// The item `k` of a network from `of(operand)`. \pre sums, products, quotients and functions only
template <class Scalar, class Of, class Elementary>
Scalar operation(const Network& network, int k, Of of, Elementary elementary) {
  const auto operands = network.operands(k);
  const Kind kind = network.item(k).kind;
  if (kind == Kind::kDivide) {
    return of(operands[0]) / of(operands[1]);
  }
  if (kind != Kind::kAdd && kind != Kind::kMultiply) {
    return elementary(kind, of(operands[0]));
  }
  Scalar result = operands.empty() ? Scalar() : of(operands[0]);
  for (std::size_t i = 1; i < operands.size(); ++i) {
    result = kind == Kind::kAdd ? result + of(operands[i]) : result * of(operands[i]);
  }
  return result;
}

/// Error bounds of a value at two pseudo-random points, see `fingerprint`.
using ErrorBounds = std::array<double, 2>;

/// Those of the outputs. \pre normalised. O(n)
std::vector<ErrorBounds> output_errors(const Network& network);

/// True if `bounds` exceed `reference` at most `factor` times. Infinite references bound nothing.
inline bool within(const ErrorBounds& bounds, const ErrorBounds& reference, double factor) {
  return bounds[0] <= factor * reference[0] && bounds[1] <= factor * reference[1];
}

/// Keeps equivalent networks from amplifying rounding: the bounds of their outputs may exceed those
/// of the network at the start by a small factor only.
class RoundingGuard {
 public:
  /// \pre normalised
  explicit RoundingGuard(const Network& start) : reference_(output_errors(start)) {}
  /// \pre normalised, the outputs of the start
  [[nodiscard]] bool accepts(const Network& network) const;

 private:
  std::vector<ErrorBounds> reference_;
};

}  // namespace treedyn::optimise
