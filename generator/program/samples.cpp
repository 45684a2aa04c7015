#include "program/samples.hpp"

#include "program/fingerprint.hpp"

namespace treedyn::program {

SampleTable::SampleTable(const Network& network) : network_(network), samples_(1), fast_{{0, 0}} {
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
}

bool SampleTable::is_zero(int k) const {
  if (network_.item(k).kind != Kind::kAdd) {
    return sample(k).first == 0 && sample(k).second == 0;
  }
  Sample scale;
  for (const Ref term : network_.operands(k)) {
    scale = scale + Sample{abs(sample(term).first), abs(sample(term).second)};
  }
  return negligible(sample(k).first, scale.first) && negligible(sample(k).second, scale.second);
}

}  // namespace treedyn::program
