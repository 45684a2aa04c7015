#include "program/samples.hpp"

#include "program/fingerprint.hpp"

namespace treedyn::program {

SampleTable::SampleTable(const Network& network)
    : network_(network), samples_(1), fast_{{0, 0}}, zero_{true} {
  for (int k = 1; k < network.size(); ++k) {
    append(k);
    table_.push_back({std::abs(fast_.back()[0]), k});
  }
  std::ranges::sort(table_, [](const Entry& a, const Entry& b) {
    return a.magnitude != b.magnitude ? a.magnitude < b.magnitude : a.item < b.item;
  });
}

Sample SampleTable::evaluate(int k) const {
  const Item& item = network_.item(k);
  const auto operands = network_.operands(k);
  Sample result;
  switch (item.kind) {
    case Kind::kConstant:
      return {network_.magnitude(k), network_.magnitude(k)};
    case Kind::kInput:
      return {sample_input(item.first, item.size, 1), sample_input(item.first, item.size, 2)};
    case Kind::kAdd:
      for (const Ref term : operands) {
        result = result + sample(term);
      }
      return result;
    case Kind::kMultiply:
      result = {1, 1};
      for (const Ref factor : operands) {
        result = result * sample(factor);
      }
      return result;
    case Kind::kDivide:
      return {sample(operands[0]).first / sample(operands[1]).first,
              sample(operands[0]).second / sample(operands[1]).second};
    case Kind::kSin:
    case Kind::kCos:
    case Kind::kSqrt:
      break;
  }
  return {sample_function(item.kind, sample(operands[0]).first),
          sample_function(item.kind, sample(operands[0]).second)};
}

void SampleTable::append(int k) {
  samples_.push_back(evaluate(k));
  fast_.push_back(
      {static_cast<double>(samples_.back().first), static_cast<double>(samples_.back().second)});
  zero_.push_back(vanishes(k));
}

/// A sum is zero if its terms cancel to rounding at 50 digits, other items by their operands.
bool SampleTable::vanishes(int k) const {
  const auto operands = network_.operands(k);
  const auto zero = [this](Ref a) {
    return is_zero(a);
  };
  switch (network_.item(k).kind) {
    case Kind::kConstant:
    case Kind::kInput:
    case Kind::kCos:
      return false;
    case Kind::kMultiply:
      return std::ranges::any_of(operands, zero);
    case Kind::kDivide:
    case Kind::kSin:
    case Kind::kSqrt:
      return zero(operands[0]);
    case Kind::kAdd:
      break;
  }
  Sample largest;
  for (const Ref term : operands) {
    largest.first = std::max(largest.first, Real(abs(sample(term).first)));
    largest.second = std::max(largest.second, Real(abs(sample(term).second)));
  }
  const Real rounding("1e-30");  // leaves 20 digits to what the terms themselves have lost
  return std::ranges::all_of(operands, zero) ||
         (abs(sample(k).first) <= rounding * largest.first &&
          abs(sample(k).second) <= rounding * largest.second);
}

}  // namespace treedyn::program
