// Keys of expressions: equal for equal values whatever the order of operations, otherwise different
// (with a probability that counts).
#pragma once

#include <bit>

#include "program/graph.hpp"
#include "program/random.hpp"

namespace treedyn::program::residue {

/// A residue modulo the prime 2^61 - 1.
using Key = std::uint64_t;
inline constexpr Key kPrime = (Key{1} << 61U) - 1;

inline Key key_of(double value) { return scramble(std::bit_cast<Key>(value)) % kPrime; }
inline Key key_of(int a, int b) {
  return scramble(scramble(static_cast<Key>(a)) + static_cast<Key>(b)) % kPrime;
}

inline Key sum(Key a, Key b) { return (a + b) % kPrime; }
inline Key negative(Key a) { return a == 0 ? 0 : kPrime - a; }
inline Key product(Key a, Key b) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<Key>(static_cast<Wide>(a) * b % kPrime);
}
/// 1 / a; 0 for 0 (Fermat: a^(p - 2)).
inline Key inverse(Key a) {
  Key result = 1;
  for (Key exponent = kPrime - 2; exponent > 0; exponent /= 2) {
    result = exponent % 2 == 1 ? product(result, a) : result;
    a = product(a, a);
  }
  return result;
}

/// Even and odd functions of a key that nothing simple maps to each other; `kind` tells them apart.
inline Key even(Key a, Kind kind) {
  return scramble(product(a, a) + (static_cast<Key>(kind) << 61U)) % kPrime;
}
inline Key odd(Key a, Kind kind) { return product(a, even(a, kind)); }
/// A function that is neither.
inline Key image(Key a, Kind kind) { return even(sum(a, scramble(a) % kPrime), kind); }

}  // namespace treedyn::program::residue
