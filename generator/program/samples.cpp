#include "program/samples.hpp"

#include "program/fingerprint.hpp"

namespace treedyn::program {

SampleTable::SampleTable(const Network& network)
    : network_(network), samples_(1), fast_{{0, 0}}, rounding_{{0, 0}} {
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
  rounding_.push_back({rounding(k, 0), rounding(k, 1)});
}

/// What the operations below `k` make of roundings, to first order and not less than |value|: a sum
/// that cancels keeps the roundings of its terms.
double SampleTable::rounding(int k, std::size_t point) const {
  const auto of = [&](Ref a) {
    return rounding_[static_cast<std::size_t>(std::abs(a))][point];
  };
  const auto size = [&](Ref a) {
    return std::abs(fast_[static_cast<std::size_t>(std::abs(a))][point]);
  };
  const auto operands = network_.operands(k);
  double result = size(k);
  switch (network_.item(k).kind) {
    case Kind::kConstant:
    case Kind::kInput:
      break;
    case Kind::kAdd:
      for (const Ref term : operands) {
        result += of(term);
      }
      break;
    case Kind::kMultiply:
      for (std::size_t i = 0; i < operands.size(); ++i) {
        double product = of(operands[i]);
        for (std::size_t j = 0; j < operands.size(); ++j) {
          product *= i == j ? 1 : size(operands[j]);
        }
        result += product;
      }
      break;
    case Kind::kDivide:
      result += (of(operands[0]) + size(k) * of(operands[1])) / size(operands[1]);
      break;
    case Kind::kSin:
    case Kind::kCos:
      result += 4 * (1 + size(operands[0])) * of(operands[0]);
      break;
    case Kind::kSqrt:
      result += of(operands[0]) / (2 * size(k));
      break;
  }
  return result;
}

bool SampleTable::is_zero(int k) const {
  const auto& scale = rounding_[static_cast<std::size_t>(k)];
  return std::isfinite(scale[0]) && std::isfinite(scale[1]) &&
         negligible(sample(k).first, scale[0]) && negligible(sample(k).second, scale[1]);
}

}  // namespace treedyn::program
