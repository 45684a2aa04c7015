// Exact rational numbers behind 50 digits.
#pragma once

#include <optional>

#include <ginac/ginac.h>

#include "common/real.hpp"

namespace treedyn::expansion {

/// The rational number with a denominator below 10^20 that agrees with `value` in 45 digits, if any
/// (continued fraction).
std::optional<GiNaC::numeric> nearby_rational(const Real& value);

/// Exactly `value`, a binary fraction.
GiNaC::numeric binary_fraction(const Real& value);

}  // namespace treedyn::expansion
