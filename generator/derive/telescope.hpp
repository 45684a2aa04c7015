// R5, telescoping: D δ = g if δ_i = g_i - g_f(i), proven by GiNaC.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "derive/value.hpp"

namespace treedyn::derive {

/// For δ = Σ factor Λ(a)Λ(b) with a, b among w, ω = D w and ω_f = N w: w, if
/// δ = Λ(ω)² - Λ(ω_f)² identically. The candidate is what is left of δ for ω_f = 0; that it
/// telescopes is a polynomial identity in w and ω_f, which is expanded, once for terms alike.
std::optional<int> telescopes(const Values& values,
                              const std::vector<std::pair<Ratio, int>>& terms);

}  // namespace treedyn::derive
