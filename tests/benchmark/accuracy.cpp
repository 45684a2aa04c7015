#include "benchmark/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/engine.hpp"
#include "oracle/from_tree.hpp"
#include "program/interpret.hpp"
#include "support/states.hpp"

namespace treedyn::benchmark {

namespace {

using oracle::largest;

const model::Vector3 kGravity{Real(0), Real(0), Real("-9.81")};

template <class T>
std::vector<T> converted(const std::vector<double>& values) {
  std::vector<T> result;
  for (const double value : values) {
    result.push_back(static_cast<T>(value));
  }
  return result;
}

/// Random numbers that float holds exactly.
class States {
 public:
  States(const model::Tree& tree, std::uint64_t seed)
      : size_(static_cast<std::size_t>(tree.dof())), random_(seed) {
    for (std::size_t i = 0; i < size_; ++i) {
      const auto link = static_cast<std::size_t>(tree.coordinates[i]);
      if (tree.links[link].joint.identifier == "base_ry") {
        pitch_ = i;
      }
    }
  }

  /// Values of all arguments by name.
  support::Sample operator()(Region region, std::size_t index) {
    return {{"q", position(region, index)},
            {"qd", random_.list(size_)},
            {"qdd", random_.list(size_)},
            {"tau", random_.list(size_)}};
  }

 private:
  std::vector<double> position(Region region, std::size_t index) {
    switch (region) {
      case Region::kUsual:
        return random_.list(size_,
                            index % 5 == 0 ? std::pow(10.0, -decade(index, 6)) : std::numbers::pi);
      case Region::kSingular:
        return singular(index);
      case Region::kLarge:
        break;
    }
    return random_.list(size_, 100);
  }

  std::vector<double> singular(std::size_t index) {
    const double distance = std::pow(10.0, -decade(index, 6));
    std::vector<double> q = random_.list(size_, std::numbers::pi);
    for (std::size_t i = 0; i < size_; ++i) {
      if (i == pitch_ || pitch_ == size_max || index % 2 == 0) {
        q[i] = near_right_angle(q[i], distance, i == pitch_);
      }
    }
    return q;
  }

  /// The next multiple of pi/2 (an odd one if asked for), up to `distance` off.
  double near_right_angle(double angle, double distance, bool odd) {
    constexpr double kRight = std::numbers::pi / 2;
    const double multiple =
        odd ? 2 * std::floor(angle / (2 * kRight)) + 1 : std::round(angle / kRight);
    return static_cast<double>(static_cast<float>(multiple * kRight + distance * random_()));
  }

  static double decade(std::size_t index, std::size_t count) {
    return 1 + static_cast<double>(index / 5 % count);
  }

  static constexpr std::size_t size_max = static_cast<std::size_t>(-1);
  std::size_t size_;
  std::size_t pitch_ = size_max;  ///< joint of the pitch of a base on axes
  support::Random random_;
};

template <class T>
std::vector<T> run(const program::Function& function, const support::Sample& sample) {
  std::vector<std::vector<T>> arrays;
  std::vector<std::span<const T>> inputs;
  for (const program::Array& array : function.signature.inputs) {
    arrays.push_back(converted<T>(sample.at(array.name)));
  }
  inputs.assign(arrays.begin(), arrays.end());
  return program::interpret<T>(function, inputs);
}

template <class T>
Real distance(const std::vector<T>& x, const std::vector<Real>& y) {
  Real result = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    result = std::max(result, Real(abs(Real(x[k]) - y[k])));
  }
  return result;
}

double quotient(const Real& error, const Real& scale) {
  return static_cast<double>(scale == 0 ? error : error / scale);
}

/// The exact output and the scales of errors.
struct Exact {
  std::vector<Real> y;
  std::vector<double> scales;  ///< of every entry
  Real size;
  Real steepness;
};

/// The values of all arguments in the order of the signature.
template <class T>
std::vector<std::vector<T>> arguments(const program::Signature& signature,
                                      const support::Sample& sample) {
  std::vector<std::vector<T>> result;
  for (const program::Array& array : signature.inputs) {
    result.push_back(converted<T>(sample.at(array.name)));
  }
  return result;
}

/// The output for every input changed by a relative `step` up or down.
std::vector<Real> shifted(const program::Function& function, const support::Sample& sample,
                          const Real& step, support::Random& sign) {
  std::vector<std::vector<Real>> arrays;
  for (const program::Array& array : function.signature.inputs) {
    arrays.push_back(converted<Real>(sample.at(array.name)));
    for (Real& x : arrays.back()) {
      x *= sign() < 0 ? Real(1 - step) : Real(1 + step);
    }
  }
  return program::interpret<Real>(function, {arrays.begin(), arrays.end()});
}

/// \param scales  double gives them
Exact exact(const program::Function& function, engine::Engine<double>& scales,
            const support::Sample& sample, support::Random& sign) {
  const Real step("1e-15");
  const program::Signature& signature = function.signature;
  Exact result{run<Real>(function, sample),
               scales.scales(signature.name, arguments<double>(signature, sample)), 0, 0};
  result.size = largest(result.y);
  for (int turn = 0; turn < 2; ++turn) {
    const Real change = distance(shifted(function, sample, step, sign), result.y);
    result.steepness = std::max(result.steepness, Real(change / step));
  }
  return result;
}

template <class T>
void note(const std::vector<T>& x, const Exact& exact, std::size_t region, Errors& errors) {
  double& scaled = errors.scaled[region];
  double& conditioned = errors.conditioned[region];
  for (std::size_t k = 0; k < x.size(); ++k) {
    scaled = std::max(scaled, quotient(abs(Real(x[k]) - exact.y[k]), exact.scales[k]));
  }
  conditioned = std::max(conditioned, quotient(distance(x, exact.y), exact.size + exact.steepness));
}

void expect_equations(engine::Engine<Real>& engine, const program::Function& function,
                      const support::Sample& sample, const std::vector<Real>& y) {
  const std::vector<Real> expected =
      engine.evaluate(function.signature.name, arguments<Real>(function.signature, sample));
  // 50 digits less 12 for A near a singular position and 8 for the growth of rounding.
  if (quotient(distance(y, expected), largest(expected)) > 1e-30) {
    throw std::runtime_error(
        fmt::format("{}: the program is not the equations", function.signature.name));
  }
}

}  // namespace

std::vector<Formulation> formulations_by_pass() {
  using formulate::Pass;
  std::vector<Formulation> result{{"all passes", {}}, {"without sums", {Pass::kSums}}};
  Formulation none{"no pass", {}};
  for (const formulate::PassInfo& info : formulate::passes()) {
    none.without.push_back(info.pass);
    if (info.pass != Pass::kSums) {
      result.push_back({fmt::format("without sums, {}", info.name), {Pass::kSums, info.pass}, 1});
    }
  }
  none.with = 1;
  result.push_back(none);
  return result;
}

std::vector<Formulation> formulations_of_forward_dynamics() {
  return {{"factor", {}, 0, formulate::ForwardDynamics::kFactor},
          {"articulated", {}, 0, formulate::ForwardDynamics::kArticulated}};
}

std::vector<Accuracy> accuracy(const Subject& subject, const std::string& name,
                               const std::vector<Formulation>& formulations) {
  std::vector<program::Function> functions;
  std::vector<Accuracy> rows;
  for (const Formulation& formulation : formulations) {
    formulate::Options options;
    options.gravity = kGravity;
    options.effort = subject.effort;
    options.forward_dynamics = formulation.forward_dynamics;
    options.without = formulation.without;
    functions.push_back(formulate::formulated(subject.tree, name, options));
    rows.push_back(
        {subject.name, name, formulation, program::cost(functions.back()).total(), {}, {}});
  }
  engine::Engine<Real> engine(subject.tree, {}, kGravity);
  engine::Engine<double> scales(subject.tree, {}, kGravity);
  for (std::size_t region = 0; region < kRegions.size(); ++region) {
    States states(subject.tree, 7 + region);
    support::Random sign(11);
    for (std::size_t index = 0; index < subject.states; ++index) {
      const support::Sample sample = states(static_cast<Region>(region), index);
      const Exact truth = exact(functions.back(), scales, sample, sign);
      if (index % 50 == 0) {
        expect_equations(engine, functions.back(), sample, truth.y);
      }
      for (std::size_t k = 0; k < rows.size(); ++k) {
        note(run<double>(functions[k], sample), truth, region, rows[k].in_double);
        note(run<float>(functions[k], sample), truth, region, rows[k].in_float);
      }
    }
  }
  return rows;
}

Errors factors(const Errors& a, const Errors& b, double floor) {
  const auto factor = [floor](double x, double y) {
    return x <= floor ? 1 : x / std::max(y, floor);
  };
  Errors result{};
  for (std::size_t k = 0; k < kRegions.size(); ++k) {
    result.scaled[k] = factor(a.scaled[k], b.scaled[k]);
    result.conditioned[k] = factor(a.conditioned[k], b.conditioned[k]);
  }
  return result;
}

}  // namespace treedyn::benchmark
