// The number type of everything before the printer.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace treedyn {

/// A real number with 50 significant decimal digits, computed in software: the same bits on every
/// machine, compiler and locale. Decimals, pi and roots of a model file enter with 50 digits and
/// stay so until `emit/literal` prints them; a cancellation of exact zeros is recognised by
/// `negligible`.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

/// pi with 50 digits.
const Real& pi();

/// True if `value` is what rounding at 50 digits leaves of a cancellation among terms of size
/// `scale`.
inline bool negligible(const Real& value, const Real& scale) {
  return abs(value) <= scale * Real(1e-40);
}

}  // namespace treedyn
