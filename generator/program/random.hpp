// Numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace treedyn::program {

/// The finaliser of splitmix64: a bijection that leaves no pattern.
constexpr std::uint64_t scramble(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

/// A counter, scrambled.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() { return scramble(state_++); }
  /// In [0, bound). \pre bound > 0
  int below(int bound) { return static_cast<int>(next() % static_cast<std::uint64_t>(bound)); }
  /// In [-1, 1).
  double symmetric() {
    return static_cast<double>(static_cast<std::int64_t>(next())) / 9223372036854775808.0;
  }

 private:
  std::uint64_t state_;
};

/// Orders equally good choices: by `key`, or at random if `seed` is not zero.
constexpr std::uint64_t tie(std::uint64_t key, std::uint64_t seed) {
  return seed == 0 ? key : scramble(key ^ seed);
}

}  // namespace treedyn::program
