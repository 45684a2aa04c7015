#include "accuracy/function_errors.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/index.hpp"
#include "emit/literal.hpp"
#include "program/ones.hpp"

namespace treedyn::accuracy {

namespace {

/// Values below this part of their scale are zeros to the reference.
constexpr double kZero = 1e-30;

template <class T>
T elementary(program::Kind kind, T x, emit::Sincos sincos) {
  if (kind == program::Kind::kSqrt) {
    return std::sqrt(x);
  }
  if (sincos == emit::Sincos::kPair) {
    const emit::SineCosine<T> both = emit::sine_cosine(x);
    return kind == program::Kind::kSin ? both.sine : both.cosine;
  }
  if (!std::isfinite(x)) {
    return std::numeric_limits<T>::quiet_NaN();
  }
  return (kind == program::Kind::kSin ? sin(Real(x)) : cos(Real(x))).template convert_to<T>();
}

/// The distance of numbers of type T beside a value.
template <class T>
double unit_in_last_place(double value) {
  const int exponent = std::max(std::ilogb(value), std::numeric_limits<T>::min_exponent - 1);
  return std::ldexp(1.0, exponent - std::numeric_limits<T>::digits + 1);
}

/// Every element at the end of its range that is farther from zero.
Inputs ends(const program::Signature& signature, const std::vector<Interval>& ranges) {
  Inputs result;
  auto range = ranges.begin();
  for (const program::Array& array : signature.inputs) {
    result.emplace_back();
    for (int i = 0; i < array.size; ++i, ++range) {
      result.back().push_back(-range->low > range->high ? range->low : range->high);
    }
  }
  return result;
}

/// A value and its error as parts of something; no error is none of nothing.
double part(double error, double of) { return error == 0 ? 0 : error / of; }

template <class T>
class Meter {
 public:
  explicit Meter(const program::Function& function)
      : function_(function), largest_(function.outputs.size(), 0) {}

  void note(const std::vector<T>& values, const engine::Exact& exact, int state) {
    TREEDYN_EXPECT(values.size() == exact.values.size() && values.size() == exact.scales.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Real& y = exact.values[k];
      const double error = std::isfinite(values[k]) ? static_cast<double>(abs(Real(values[k]) - y))
                                                    : std::numeric_limits<double>::infinity();
      const auto size = std::abs(static_cast<double>(y));
      largest_[k] = std::max(largest_[k], error);
      keep(part(error, exact.scales[k]), k, state, errors_.scaled);
      if (size > kZero * exact.scales[k]) {
        keep(error / unit_in_last_place<T>(size), k, state, errors_.ulps);
      }
    }
  }
  [[nodiscard]] const Errors& errors() const { return errors_; }
  [[nodiscard]] const std::vector<double>& largest() const { return largest_; }

 private:
  void keep(double error, std::size_t k, int state, Worst& worst) const {
    if (error > worst.error) {
      worst = {error, output_name(function_.signature, k), state};
    }
  }

  const program::Function& function_;
  Errors errors_;
  std::vector<double> largest_;
};

template <class T>
Measured measured_in(const program::Function& function, const Arithmetic& how, const Truth& truth) {
  const program::Function in_scalar = program::without_ones(
      function, [&](const Real& value) { return emit::rounds_to_one(value, how.scalar); });
  Meter<T> meter(in_scalar);
  for (std::size_t k = 0; k < truth.inputs.size(); ++k) {
    meter.note(executed<T>(in_scalar, truth.inputs[k], how.sincos), truth.exact[k],
               static_cast<int>(k));
  }
  return {meter.errors(), program::cost(in_scalar), meter.largest()};
}

}  // namespace

std::string output_name(const program::Signature& signature, std::size_t k) {
  for (const program::Array& array : signature.outputs) {
    const auto size = to_index(array.size);
    if (k < size) {
      return fmt::format("{}[{}]", array.name, k);
    }
    k -= size;
  }
  return "";
}

Truth truth_of(const program::Signature& signature, const States& states, int count,
               const std::function<engine::Exact(const Inputs&)>& reference) {
  Truth result;
  result.ranges = states.ranges(signature);
  result.scales = reference(ends(signature, result.ranges)).scales;
  result.assumed = [states, signature](const Dependence& on) {
    return states.assumed(signature, on);
  };
  for (int k = 0; k < count; ++k) {
    result.inputs.push_back(states(signature, k));
    result.exact.push_back(reference(result.inputs.back()));
  }
  return result;
}

template <class T>
std::vector<T> executed(const program::Function& function, const Inputs& inputs,
                        emit::Sincos sincos) {
  const std::vector<T> values = program::node_values<T>(
      function.graph, function.outputs,
      [&](int array, int element) {
        return static_cast<T>(inputs[to_index(array)][to_index(element)]);
      },
      [sincos](program::Kind kind, const T& x) { return elementary<T>(kind, x, sincos); });
  std::vector<T> outputs;
  outputs.reserve(function.outputs.size());
  for (const program::Ref output : function.outputs) {
    const T& value = values[program::node_index(output)];
    outputs.push_back(output < 0 ? -value : value);
  }
  return outputs;
}

template std::vector<float> executed(const program::Function&, const Inputs&, emit::Sincos);
template std::vector<double> executed(const program::Function&, const Inputs&, emit::Sincos);

Measured measured(const program::Function& function, const Arithmetic& how, const Truth& truth) {
  return how.scalar == emit::Scalar::kFloat ? measured_in<float>(function, how, truth)
                                            : measured_in<double>(function, how, truth);
}

}  // namespace treedyn::accuracy
