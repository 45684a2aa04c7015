// Numbers of any kind, beside them sums of joint angles: what a program computes before it takes
// their sines.
#pragma once

#include <cstdlib>
#include <map>
#include <utility>

#include "program/graph.hpp"

namespace treedyn::support {

/// A number, or a sum of joint angles.
///
/// Number: a field with to_int(Number) for integers.
template <class Number>
struct Turning {
  Turning() = default;
  explicit Turning(Number number) : value(std::move(number)) {}
  explicit Turning(int number) : value(number) {}

  static Turning angle(int joint) {
    Turning result(0);
    result.turns[joint] = 1;
    return result;
  }

  Number value;
  std::map<int, int> turns;  ///< joint -> how often its angle

  friend Turning operator+(Turning a, const Turning& b) {
    a.value = a.value + b.value;
    for (const auto& [joint, times] : b.turns) {
      a.turns[joint] += times;
    }
    return a;
  }
  /// \pre one of them is no angle, an integer if the other is one
  friend Turning operator*(const Turning& a, const Turning& b) {
    Turning result(a.value * b.value);
    const bool first = !a.turns.empty();
    if (first || !b.turns.empty()) {
      result.turns = first ? a.turns : b.turns;
      for (auto& [joint, times] : result.turns) {
        times *= to_int(first ? b.value : a.value);
      }
    }
    return result;
  }
  friend Turning operator/(const Turning& a, const Turning& b) {
    return Turning(a.value / b.value);
  }
  friend Turning operator-(const Turning& a) { return Turning(-1) * a; }
};

/// cos or sin of a sum of angles, by addition theorems.
/// \param sines, cosines  of the joints
template <class Number, class Sines, class Cosines>
Turning<Number> trigonometric(program::Kind kind, const Turning<Number>& angle, const Sines& sines,
                              const Cosines& cosines) {
  Number c(1);
  Number s(0);
  for (const auto& [joint, times] : angle.turns) {
    const Number sine(times < 0 ? -sines(joint) : sines(joint));
    const Number cosine(cosines(joint));
    for (int n = 0; n < std::abs(times); ++n) {
      const Number old = c;
      c = c * cosine - s * sine;
      s = s * cosine + old * sine;
    }
  }
  return Turning<Number>(kind == program::Kind::kSin ? s : c);
}

}  // namespace treedyn::support
