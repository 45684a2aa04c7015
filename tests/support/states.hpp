// Random and special inputs, the same on every machine.
#pragma once

#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace treedyn::support {

/// Numbers between -1 and 1 from a fixed seed; every number is exact in float too.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 40U) / 8388608.0 - 1.0; }
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

/// Coordinates: zeros, all pi/2, all -pi/2, a mixture of both, large angles, then random ones in
/// [-pi, pi]. All exact in float.
inline std::vector<std::vector<double>> positions(std::size_t dof, std::size_t count,
                                                  std::uint64_t seed) {
  const double right = static_cast<double>(std::numbers::pi_v<float> / 2);
  Random random(seed);
  std::vector<std::vector<double>> result{std::vector<double>(dof, 0.0),
                                          std::vector<double>(dof, right),
                                          std::vector<double>(dof, -right)};
  std::vector<double> mixture(dof);
  for (double& x : mixture) {
    x = random() < 0 ? -right : right;
  }
  result.push_back(mixture);
  result.push_back(random.list(dof, 100));
  result.push_back(random.list(dof, 10000));
  while (result.size() < count) {
    result.push_back(random.list(dof, std::numbers::pi));
  }
  return result;
}

}  // namespace treedyn::support
