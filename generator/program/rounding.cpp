#include "program/rounding.hpp"

#include <bit>
#include <cstdint>
#include <functional>
#include <type_traits>

#include "common/transformed.hpp"
#include "program/fingerprint.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

namespace {

constexpr int kStates = 8;
/// Inputs are up to so large: most of a turn.
constexpr double kLargestInput = 3;

/// The values of all nodes at a pseudo-random state, with 50 digits, in double.
std::vector<double> values_at(const Function& function, int state) {
  const std::vector<Digits> exact = node_values<Digits>(
      function.graph, function.outputs,
      [state](int array, int element) {
        return Digits(kLargestInput * sample_input(array, element, state));
      },
      [](Kind kind, const Digits& a) { return elementary_of_any(kind, Real(a)).digits(); });
  return transformed(exact, [](const Digits& x) { return static_cast<double>(x); });
}

/// Error bounds of the outputs.
template <class Target>
std::vector<double> errors_at(const Function& function, const std::vector<double>& values) {
  using Value = Rounded<double, Target>;
  const Graph& graph = function.graph;
  std::vector<double> errors(graph.size(), 0);
  const auto of = [&](Ref a) {
    const auto k = node_index(a);
    return Value(a < 0 ? -values[k] : values[k], errors[k]);
  };
  for (const Ref k : reachable(graph, function.outputs)) {
    const Node& node = graph.node(k);
    errors[static_cast<std::size_t>(k)] =
        [&] {
          switch (node.kind) {
            case Kind::kConstant:
            case Kind::kInput:
              break;
            case Kind::kAdd:
              return of(node.a) + of(node.b);
            case Kind::kMultiply:
              return of(node.a) * of(node.b);
            case Kind::kDivide:
              return of(node.a) / of(node.b);
            case Kind::kSin:
            case Kind::kCos:
            case Kind::kSqrt:
              return Value::function(node.kind, of(node.a), values[static_cast<std::size_t>(k)]);
          }
          return Value(values[static_cast<std::size_t>(k)]);
        }()
            .error;
  }
  return transformed(function.outputs,
                     [&](const Ref output) { return errors[node_index(output)]; });
}

/// Sums of the error bounds of the outputs over all states.
template <class Target>
std::vector<double> summed_errors(const Function& function,
                                  const std::vector<std::vector<double>>& values) {
  std::vector<double> sums(function.outputs.size(), 0);
  for (const std::vector<double>& at_state : values) {
    const std::vector<double> errors = errors_at<Target>(function, at_state);
    std::ranges::transform(sums, errors, sums.begin(), std::plus());
  }
  return sums;
}

/// Of the largest bound, or half of what one output's own bound grows by. Nothing exceeds an
/// infinite bound.
double largest_quotient(const std::vector<double>& errors, const std::vector<double>& before) {
  double own = 0;
  double largest = 0;
  double largest_before = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (errors[k] > 0 && std::isfinite(before[k])) {
      own = std::max(own, errors[k] / before[k]);
      largest = std::max(largest, errors[k]);
      largest_before = std::max(largest_before, before[k]);
    }
  }
  return largest == 0 ? 0 : std::max(own / 2, largest / largest_before);
}

}  // namespace

double amplification(const Function& function, const Function& before) {
  std::vector<std::vector<double>> ours;
  std::vector<std::vector<double>> theirs;
  for (int state = 1; state <= kStates; ++state) {
    ours.push_back(values_at(function, state));
    theirs.push_back(values_at(before, state));
  }
  return std::max(
      largest_quotient(summed_errors<double>(function, ours),
                       summed_errors<double>(before, theirs)),
      largest_quotient(summed_errors<float>(function, ours), summed_errors<float>(before, theirs)));
}

namespace {

/// The same bits on every machine: sines of float and double are rounded from 50 digits.
template <class Scalar>
Scalar rounded_elementary(Kind kind, const Scalar& x) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    return static_cast<Scalar>(elementary_of_any(kind, Digits(x)));
  } else {
    return elementary_of_any(kind, x);
  }
}

/// At the state that float has.
template <class Scalar>
Scalar input_at(int array, int element, int state) {
  return Scalar(static_cast<float>(kLargestInput * sample_input(array, element, state)));
}

template <class Scalar>
std::vector<Scalar> results_at(const Function& function, int state) {
  return outputs_of(function, node_values<Scalar>(
                                  function.graph, function.outputs,
                                  [state](int array, int element) {
                                    return input_at<Scalar>(array, element, state);
                                  },
                                  rounded_elementary<Scalar>));
}

/// A number half of whose operations are off by a last digit more, up or down by chance: so may
/// fused ones be, those of another order, and sines that are not rounded from more digits.
template <class Scalar>
struct Nudged {
  Scalar value = 0;
  std::uint64_t seed = 0;  ///< of chance; 0: of a constant

  Nudged() = default;
  Nudged(Scalar the_value, std::uint64_t the_seed) : value(the_value), seed(the_seed) {}
  explicit Nudged(int constant) : value(static_cast<Scalar>(constant)) {}
  explicit Nudged(const Real& constant) : value(static_cast<Scalar>(constant)) {}

  static Nudged rounded(Scalar value, std::uint64_t seed) {
    const std::uint64_t chance = seed == 0 ? 0 : scramble(scramble(bits(value)) ^ seed) % 4;
    const Scalar far = std::numeric_limits<Scalar>::infinity();
    return {chance == 1   ? std::nextafter(value, far)
            : chance == 2 ? std::nextafter(value, -far)
                          : value,
            seed};
  }
  Nudged operator-() const { return {-value, seed}; }
  friend Nudged operator+(const Nudged& a, const Nudged& b) {
    return rounded(a.value + b.value, std::max(a.seed, b.seed));
  }
  friend Nudged operator*(const Nudged& a, const Nudged& b) {
    return rounded(a.value * b.value, std::max(a.seed, b.seed));
  }
  friend Nudged operator/(const Nudged& a, const Nudged& b) {
    return rounded(a.value / b.value, std::max(a.seed, b.seed));
  }

 private:
  static std::uint64_t bits(Scalar value) {
    return std::bit_cast<std::uint64_t>(static_cast<double>(value));
  }
};

template <class Scalar>
std::vector<Scalar> nudged_at(const Function& function, int state, std::uint64_t seed) {
  using Value = Nudged<Scalar>;
  const std::vector<Value> results =
      outputs_of(function, node_values<Value>(
                               function.graph, function.outputs,
                               [&](int array, int element) {
                                 return Value(input_at<Scalar>(array, element, state), seed);
                               },
                               [](Kind kind, const Value& x) {
                                 return Value::rounded(rounded_elementary(kind, x.value), x.seed);
                               }));
  return transformed(results, [](const Value& x) { return x.value; });
}

}  // namespace

bool same_results(const Function& function, const Function& other) {
  constexpr int kCompared = 2;
  for (int state = 1; state <= kCompared; ++state) {
    const std::vector<Digits> ours = results_at<Digits>(function, state);
    const std::vector<Digits> theirs = results_at<Digits>(other, state);
    Digits largest = 0;
    for (const Digits& value : theirs) {
      largest = std::max(largest, Digits(abs(value)));
    }
    const Digits tolerance = largest * Digits("1e-30");
    if (!std::ranges::equal(ours, theirs, [&](const Digits& a, const Digits& b) {
          return abs(a - b) <= tolerance;  // no NaN is
        })) {
      return false;
    }
  }
  return true;
}

double float_error(const Function& function) {
  double worst = 0;
  for (int state = 1; state <= kStates; ++state) {
    const std::vector<Digits> exact = results_at<Digits>(function, state);
    const std::vector<float> results = results_at<float>(function, state);
    double error = 0;
    double size = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const auto value = static_cast<double>(exact[k]);
      const double off = std::abs(static_cast<double>(results[k]) - value);
      size = std::max(size, std::abs(value));
      error = off <= error ? error : off;  // that of a NaN is one
    }
    const double part = error == 0 ? 0 : error / size;
    worst = std::isfinite(part) ? std::max(worst, part) : std::numeric_limits<double>::infinity();
  }
  return worst;
}

namespace {

/// Appends the elements of every array of a state.
void append_by_array(const std::vector<Array>& arrays, const std::vector<double>& values,
                     std::vector<std::vector<double>>& result) {
  result.resize(arrays.size());
  auto at = values.begin();
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    result[k].insert(result[k].end(), at, at + arrays[k].size);
    at += arrays[k].size;
  }
}

std::vector<double> inputs_at(const Function& function, int state) {
  std::vector<double> result;
  for (std::size_t k = 0; k < function.signature.inputs.size(); ++k) {
    for (int element = 0; element < function.signature.inputs[k].size; ++element) {
      result.push_back(input_at<double>(static_cast<int>(k), element, state));
    }
  }
  return result;
}

template <class Scalar>
std::vector<double> in_double(const std::vector<Scalar>& values) {
  return transformed(values, [](const Scalar& x) { return static_cast<double>(x); });
}

/// Raises the bound of each array to the largest error of its elements.
void raise(const std::vector<Array>& arrays, const std::vector<double>& results,
           const std::vector<double>& exact, std::vector<double>& bounds) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    for (int i = 0; i < arrays[k].size; ++i, ++at) {
      bounds[k] = std::max(bounds[k], std::abs(results[at] - exact[at]));
    }
  }
}

}  // namespace

KnownAnswers known_answers(const Function& function, int states, bool single) {
  constexpr double kMargin = 2;
  constexpr std::uint64_t kSamples = 8;
  const double unit = (single ? static_cast<double>(std::numeric_limits<float>::epsilon())
                              : std::numeric_limits<double>::epsilon()) /
                      2;
  const auto& outputs = function.signature.outputs;
  KnownAnswers result;
  result.bounds.assign(outputs.size(), 0);
  for (int state = 1; state <= states; ++state) {
    append_by_array(function.signature.inputs, inputs_at(function, state), result.inputs);
    const std::vector<double> exact = in_double(results_at<Real>(function, state));
    append_by_array(outputs, exact, result.outputs);
    for (std::uint64_t seed = 1; seed <= kSamples; ++seed) {
      const std::vector<double> results = single
                                              ? in_double(nudged_at<float>(function, state, seed))
                                              : in_double(nudged_at<double>(function, state, seed));
      raise(outputs, results, exact, result.bounds);
    }
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    double size = 0;
    for (const double value : result.outputs[k]) {
      size = std::max(size, std::abs(value));
    }
    result.bounds[k] = kMargin * (result.bounds[k] + 4 * unit * size);
  }
  return result;
}

}  // namespace treedyn::program
