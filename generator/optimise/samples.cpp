#include "optimise/samples.hpp"

namespace treedyn::optimise {

SampleTable::SampleTable(const Network& network)
    : network_(network), samples_(1), fast_{{0, 0}}, errors_(1), zero_{true}, present_(kBits) {
  for (int k = 1; k < network.size(); ++k) {
    append(k);
    table_.push_back({std::abs(fast_.back()[0]), k});
    note_magnitude(table_.back().magnitude);
  }
  std::ranges::sort(table_, [](const Entry& a, const Entry& b) {
    return a.magnitude != b.magnitude ? a.magnitude < b.magnitude : a.item < b.item;
  });
}

/// What is close to it has its leading bits, or those of one of these neighbours.
void SampleTable::note_magnitude(double magnitude) {
  for (const double part : {1 - 2 * kTolerance, 1 + 2 * kTolerance}) {
    present_[bit_of(leading_bits(magnitude * part))] = true;
  }
}

Sample SampleTable::evaluate(int k) const {
  const Item& item = network_.item(k);
  if (item.kind == Kind::kConstant) {
    const Real& value = network_.magnitude(k);
    const Real sample = value.recipe() == 0 ? value : Real::seen_as(value.digits(), value.seen());
    return {sample, sample};
  }
  if (item.kind == Kind::kInput) {
    return {sample_input(item.first, item.size, 1), sample_input(item.first, item.size, 2)};
  }
  return operation<Sample>(
      network_, k, [this](Ref a) { return sample(a); },
      [](Kind kind, const Sample& a) -> Sample {
        const bool has_root = kind != Kind::kSqrt || a.first.seen() >= 0;
        if (has_root && identical(a.first, a.second)) {  // the same in every state
          const Real value = program::elementary(kind, a.first);
          return {value, value};
        }
        return {sample_function(kind, a.first), sample_function(kind, a.second)};
      });
}

double SampleTable::error_at(std::size_t point, int k) const {
  using Number = Rounded<double>;
  const auto value = [&](Ref a) {
    const double x = fast_[program::node_index(a)][point];
    return a < 0 ? -x : x;
  };
  if (network_.operands(k).empty()) {
    return Number(value(k)).error;
  }
  return operation<Number>(
             network_, k, [&](Ref a) { return Number(value(a), errors(a)[point]); },
             [&](Kind kind, const Number& a) { return Number::function(kind, a, value(k)); })
      .error;
}

void SampleTable::update_errors(std::span<const int> order) {
  for (const int k : order) {
    errors_[static_cast<std::size_t>(k)] = {error_at(0, k), error_at(1, k)};
  }
}

void SampleTable::append(int k) {
  samples_.push_back(evaluate(k));
  fast_.push_back({static_cast<double>(samples_.back().first.seen()),
                   static_cast<double>(samples_.back().second.seen())});
  errors_.emplace_back();
  update_errors(std::span(&k, 1));
  zero_.push_back(vanishes(k));
}

/// A sum is zero if nothing but rounding is left of its terms, other items by their operands.
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
  return std::ranges::all_of(operands, zero) || is_rounding(k);
}

namespace {

/// What cancels 30 digits of the largest term is suspicious; it is rounding if it is within the
/// error bound of values that agree to 38 digits when they are the same. (Tilts of 1e-16 leave
/// 1e-32 of sums that are no zeros.) The bound is that of the stand-ins, and as a part of the
/// largest term that of the numbers.
bool cancels(const Real& value, const Real& largest, double error) {
  if (largest.seen() == 0) {
    return value == 0;
  }
  const Digits part = Digits(1e-38 * error) / largest.seen();
  return Real::both(value, largest, [&](const Digits& x, const Digits& of) {
    return abs(x) <= of * Digits(1e-30) && abs(x) <= of * part;
  });
}

}  // namespace

bool SampleTable::is_rounding(int k) const {
  Sample largest;
  for (const Ref term : network_.operands(k)) {
    largest.first = larger(largest.first, sample(term).first);
    largest.second = larger(largest.second, sample(term).second);
  }
  return cancels(sample(k).first, largest.first, errors(k)[0]) &&
         cancels(sample(k).second, largest.second, errors(k)[1]);
}

}  // namespace treedyn::optimise
