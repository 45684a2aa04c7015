#include "accuracy/bounds.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "emit/sincos.hpp"

namespace treedyn::accuracy {

namespace {

using program::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kEverything{-kInfinity, kInfinity};
constexpr Interval kOne{1, 1};
/// More than what summing the parts of a bound in double loses.
constexpr double kSlack = 1 + 0x1p-30;

/// The largest power of two that is not larger.
double power_below(double size) {
  return size > 0 && size < kInfinity ? std::ldexp(1.0, std::ilogb(size)) : size;
}

}  // namespace

OutputError::Limits OutputError::limits_of(const Arithmetic& how) {
  const bool single = how.scalar == emit::Scalar::kFloat;
  const double unit = single ? 0x1p-24 : 0x1p-53;
  const emit::StatedSines stated = emit::stated_sines(how.scalar);
  const bool libm = how.sincos == emit::Sincos::kLibm;
  return {unit, single ? 0x1p-126 : 0x1p-1022, single ? 0x1p127 : 0x1p1023,
          libm ? 2 * unit : stated.error, libm ? 1e9 : stated.range};
}

OutputError::OutputError(const program::Function& function, program::Ref output,
                         const Arithmetic& how)
    : limits_(limits_of(how)),
      steps_(bound_steps(function, output, how.scalar)),
      values_(steps_.size()),
      slopes_(steps_.size()),
      noises_(steps_.size()) {}

std::set<int> OutputError::inputs() const {
  std::set<int> result;
  for (const BoundStep& step : steps_) {
    if (step.kind == Kind::kInput) {
      result.insert(step.a);
    }
  }
  return result;
}

std::set<int> OutputError::inputs_as_they_are() const {
  std::set<int> result;
  const auto note = [&](int k) {
    const BoundStep& of = steps_[to_index(k)];
    if (of.kind == Kind::kInput) {
      result.insert(of.a);
    }
  };
  for (const BoundStep& step : steps_) {
    if (step.kind == Kind::kConstant || step.kind == Kind::kInput || step.kind == Kind::kSin ||
        step.kind == Kind::kCos) {
      continue;
    }
    note(step.a);
    if (step.b >= 0) {
      note(step.b);
    }
  }
  note(static_cast<int>(steps_.size()) - 1);
  return result;
}

/// c x + s y for numbers not larger than `x` and `y`, c and s with their errors: the root of
/// c^2 + s^2 is at most 1 + 2 errors.
Interval OutputError::turned(double x, double y) const {
  const Interval size =
      sqrt(square({0, x}) + square({0, y})) * outwards(1, 1 + 2 * limits_.sine_error);
  return {-size.high, size.high};
}

Interval OutputError::sum(const BoundStep& of) const {
  const Interval result = a(of) + b(of);
  if (!of.turn) {
    return result;
  }
  const auto first = to_index(of.a);
  const auto second = to_index(of.b);
  const double noise = above(noises_[first] + noises_[second]);  // of the products
  return intersection(
      result,
      around(turned(value(steps_[first].other).size(), value(steps_[second].other).size()), noise));
}

Interval OutputError::wave(const BoundStep& of) const {
  const Interval x = a(of);
  return x.size() > limits_.sine_range ? kEverything : of.kind == Kind::kSin ? sin(x) : cos(x);
}

/// What the operation would give without rounding, of operands with their errors.
Interval OutputError::exact(const BoundStep& of, const Box& box) const {
  switch (of.kind) {
    case Kind::kConstant:
      return of.constant;
    case Kind::kInput:
      return box[to_index(of.a)];
    case Kind::kAdd:
      return sum(of);
    case Kind::kMultiply:
      return of.a == of.b ? square(a(of)) : a(of) * b(of);
    case Kind::kDivide:
      return a(of) / b(of);
    case Kind::kSqrt:
      return a(of).low > 0 ? sqrt(a(of)) : kEverything;
    case Kind::kSin:
    case Kind::kCos:
      break;
  }
  return wave(of);
}

double OutputError::noise(const BoundStep& of, const Interval& exact) const {
  switch (of.kind) {
    case Kind::kConstant:
      return of.literal;
    case Kind::kInput:
      return 0;
    case Kind::kSin:
    case Kind::kCos:
      return limits_.sine_error;
    default:
      return exact.size() > limits_.largest ? kInfinity
             : of.exact                     ? limits_.least
                        : limits_.unit * power_below(exact.size()) + limits_.least;
  }
}

void OutputError::note_obstacle(const BoundStep& of, const Interval& exact) {
  if (exact.size() <= limits_.largest || !obstacle_.empty()) {
    return;
  }
  const bool wave = of.kind == Kind::kSin || of.kind == Kind::kCos;
  obstacle_ = of.kind == Kind::kDivide && b(of).contains(0) ? "a divisor may be zero"
              : of.kind == Kind::kSqrt && a(of).low <= 0    ? "what a root is drawn of may be zero"
              : wave ? "an angle may leave the range of the sines"
                     : "a value may overflow";
}

void OutputError::forward(const Box& box) {
  obstacle_.clear();
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Interval range = exact(steps_[k], box);
    note_obstacle(steps_[k], range);
    noises_[k] = noise(steps_[k], range);
    values_[k] = noises_[k] == 0 ? range : around(range, noises_[k]);
  }
}

/// What a product with a sine or cosine passes to its other factor.
Interval OutputError::passed(int product) const {
  const BoundStep& of = steps_[to_index(product)];
  const Interval result = slopes_[to_index(product)] * value(of.other == of.a ? of.b : of.a);
  return of.minus_a != of.minus_b ? -result : result;
}

void OutputError::backward(std::size_t k) {
  const BoundStep& of = steps_[k];
  for (const auto& [cosine, sine] : of.pairs) {
    const Interval turn = turned(slopes_[to_index(cosine)].size(), slopes_[to_index(sine)].size());
    slopes_[k] = slopes_[k] + intersection(passed(cosine) + passed(sine), turn);
  }
  const auto pass = [&](int to, bool minus, const Interval& factor) {
    if (!(of.paired && of.other == to)) {
      Interval& slope = slopes_[to_index(to)];
      slope = slope + (minus ? -(slopes_[k] * factor) : slopes_[k] * factor);
    }
  };
  switch (of.kind) {
    case Kind::kConstant:
    case Kind::kInput:
      break;
    case Kind::kAdd:
      pass(of.a, of.minus_a, kOne);
      pass(of.b, of.minus_b, kOne);
      break;
    case Kind::kMultiply:
      pass(of.a, of.minus_a, b(of));
      pass(of.b, of.minus_b, a(of));
      break;
    case Kind::kDivide:
      pass(of.a, of.minus_a, kOne / b(of));
      pass(of.b, !of.minus_b, a(of) / b(of) / b(of));
      break;
    case Kind::kSqrt:
      pass(of.a, of.minus_a, Interval{0.5, 0.5} / sqrt(a(of)));
      break;
    case Kind::kSin:
      pass(of.a, of.minus_a, cos(a(of)));
      break;
    case Kind::kCos:
      pass(of.a, !of.minus_a, sin(a(of)));
      break;
  }
}

double OutputError::operator()(const Box& box) {
  forward(box);
  if (!obstacle_.empty()) {
    return kInfinity;
  }
  std::ranges::fill(slopes_, Interval{});
  slopes_.back() = kOne;
  double bound = 0;
  for (std::size_t k = steps_.size(); k-- > 0;) {
    backward(k);
    bound += noises_[k] == 0 ? 0 : slopes_[k].size() * noises_[k];
  }
  if (!(bound < kInfinity)) {
    obstacle_ = "a value may overflow";
    return kInfinity;
  }
  return bound * kSlack;
}

}  // namespace treedyn::accuracy
