// Uniform random numbers, the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace treedyn::support {

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high].
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace treedyn::support
