// A scalar type for block::Evaluation: polynomials that are always expanded and reduced.
#pragma once

#include <Eigen/Core>
#include <ginac/ginac.h>

#include "expansion/ring.hpp"

namespace treedyn::expansion {

/// An element of a ring in normal form; numbers belong to every ring.
class Expanded {
 public:
  Expanded() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): Eigen and `block` write numbers as scalars
  Expanded(int value) : value_(value) {}
  Expanded(const Ring& ring, const GiNaC::ex& value);

  [[nodiscard]] const GiNaC::ex& value() const { return value_; }
  [[nodiscard]] bool is_zero() const { return value_.is_zero(); }

  Expanded& operator+=(const Expanded& other);
  Expanded& operator-=(const Expanded& other);
  Expanded& operator*=(const Expanded& other);
  /// \pre `other` is a number.
  Expanded& operator/=(const Expanded& other);

  friend Expanded operator+(Expanded a, const Expanded& b) { return a += b; }
  friend Expanded operator-(Expanded a, const Expanded& b) { return a -= b; }
  friend Expanded operator*(Expanded a, const Expanded& b) { return a *= b; }
  friend Expanded operator/(Expanded a, const Expanded& b) { return a /= b; }
  friend Expanded operator-(const Expanded& a) { return Expanded(-1) * a; }
  friend bool operator==(const Expanded& a, const Expanded& b) {
    return a.value_.is_equal(b.value_);
  }

 private:
  const Ring* ring_ = nullptr;
  GiNaC::ex value_ = 0;
};

}  // namespace treedyn::expansion

namespace Eigen {

template <>
struct NumTraits<treedyn::expansion::Expanded> : GenericNumTraits<treedyn::expansion::Expanded> {
  using Real = treedyn::expansion::Expanded;
  using NonInteger = treedyn::expansion::Expanded;
  using Nested = treedyn::expansion::Expanded;
  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 10,
    AddCost = 100,
    MulCost = 1000
  };
  // NOLINTEND(readability-identifier-naming)
};

}  // namespace Eigen
