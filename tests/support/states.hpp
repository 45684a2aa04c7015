// Random and special inputs, the same on every machine.
#pragma once

#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace treedyn::support {

/// Numbers from a fixed seed; those between -1 and 1 are exact in float too.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 40U) / 8388608.0 - 1.0; }
  /// In [low, high], of double.
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  std::vector<double> list(std::size_t size, double scale = 1) {
    std::vector<double> result(size);
    for (double& x : result) {
      x = static_cast<double>(static_cast<float>(scale * (*this)()));
    }
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

/// Values for every argument of INTERFACE.md 3 by its name: q, qd, qdd, tau, f, n, b.
using Sample = std::map<std::string, std::vector<double>>;

/// Samples with the coordinates zero, all pi/2, all -pi/2, a mixture of both, large (up to 1e2 and
/// 1e4), then random in [-pi, pi]; the rest random in [-1, 1], zero in the first. All exact in
/// float.
inline std::vector<Sample> samples(std::size_t dof, std::size_t points, std::size_t count,
                                   std::uint64_t seed) {
  const double right = static_cast<double>(std::numbers::pi_v<float> / 2);
  Random random(seed);
  std::vector<double> mixture(dof);
  for (double& x : mixture) {
    x = random() < 0 ? -right : right;
  }
  std::vector<std::vector<double>> positions{std::vector<double>(dof, 0.0),
                                             std::vector<double>(dof, right),
                                             std::vector<double>(dof, -right),
                                             mixture,
                                             random.list(dof, 100),
                                             random.list(dof, 10000)};
  std::vector<Sample> result;
  for (std::size_t k = 0; k < count; ++k) {
    const double scale = k == 0 ? 0 : 1;
    result.push_back(
        {{"q", k < positions.size() ? positions[k] : random.list(dof, std::numbers::pi)},
         {"qd", random.list(dof, scale)},
         {"qdd", random.list(dof, scale)},
         {"tau", random.list(dof, scale)},
         {"b", random.list(dof, scale)},
         {"f", random.list(3 * points, scale)},
         {"n", random.list(3 * points, scale)}});
  }
  return result;
}

/// The values of the named arguments, in order.
inline std::vector<std::vector<double>> arguments(const Sample& sample,
                                                  const std::vector<std::string>& names) {
  std::vector<std::vector<double>> result;
  for (const std::string& name : names) {
    result.push_back(sample.at(name));
  }
  return result;
}

}  // namespace treedyn::support
