// Values that could be had from other values with fewer operations, whatever the expressions look
// like.
#pragma once

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// Whether values that need no quotient may come to need one: of functions that share some values
/// kApart keeps those that divide by nothing good for zeros.
enum class Quotients { kAnywhere, kApart };

/// The bound of rounding errors of a value may grow by this factor.
inline constexpr double kMostAmplification = 16;

/// Replaces values that are zero, equal to another value, a multiple of one, or the sum,
/// difference or product of two others, where that saves operations; the same for two terms of a
/// sum or two factors of a product: identities that no rule of
/// algebra is needed for, s^2 + c^2 = 1 among them.
///
/// Values are compared with 50 digits at two pseudo-random points (see `fingerprint`); what agrees
/// to 38 digits at both is taken as identical. Sums that would cancel digits are not used. Pairs
/// of values are tried in networks of up to some thousand items, O(n^2 log n); the rest is
/// O(n log n).
/// \param[in,out] network  normalised before, not afterwards
/// \param amplification  kMostAmplification, or less where that would cost an output its accuracy
/// \return the number of replacements
int resubstitute(Network& network, Quotients quotients = Quotients::kAnywhere,
                 double amplification = kMostAmplification);

}  // namespace treedyn::optimise
