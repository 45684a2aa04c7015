// Decimal numbers as files write them, read without a locale and with limits.
#pragma once

#include <string>
#include <string_view>

#include "common/real.hpp"

namespace treedyn {

/// Longest decimal that is read, in characters.
inline constexpr std::size_t kMaxDecimalLength = 1000;

/// Why a text is not a number that treedyn accepts.
enum class DecimalError { kNone, kSyntax, kTooLong, kOutOfRange };

struct Decimal {
  Real value = 0;
  DecimalError error = DecimalError::kNone;
  [[nodiscard]] explicit operator bool() const { return error == DecimalError::kNone; }
};

/// Reads `[+-] digits [. digits] [e [+-] digits]`, one digit at least, nothing before or after.
///
/// The value is that of the decimal rounded to 50 digits. Magnitudes from 1e-300 to 1e300 and zero
/// are accepted. Constant time in the exponent, linear in the length.
Decimal read_decimal(std::string_view text);

/// Half a unit of the last digit written: 5e-4 for "0.123", 50 for "12e2". \pre `read_decimal`
/// accepts `text`.
Real half_unit_of_last_digit(std::string_view text);

/// "is not a number; expected ..." and the like: the end of a message about `text`.
std::string describe(DecimalError error, std::string_view text);

/// `text` as an error message shows it: shortened, control characters and bytes beyond ASCII
/// escaped.
std::string shown(std::string_view text);

}  // namespace treedyn
