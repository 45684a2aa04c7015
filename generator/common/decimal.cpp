#include "common/decimal.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/identifier.hpp"

namespace treedyn {

namespace {

/// Twice the digits of Real: powers of ten up to 1e144 are exact, quotients round once.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                           boost::multiprecision::et_off>;

constexpr int kLargestExponent = 300;  // |x| <= 1e300 prints as a finite double
constexpr int kUsedDigits = 90;        // of the significant digits; the rest is below 50 digits

/// A decimal taken apart: (-1)^negative * 0.d1 d2 .. dn * 10^exponent, d1 not 0 (no digits: zero).
struct Parts {
  bool negative = false;
  std::string digits;
  long exponent = 0;
  long last_place = 0;  ///< power of ten of the last digit written
  bool valid = false;
};

/// The exponent after 'e', saturated: what is larger is out of range anyway.
bool read_exponent(std::string_view text, long& exponent) {
  bool negative = false;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  if (text.empty() || !std::ranges::all_of(text, is_digit)) {
    return false;
  }
  for (const char c : text) {
    exponent = std::min(exponent * 10 + (c - '0'), 1'000'000'000L);
  }
  exponent = negative ? -exponent : exponent;
  return true;
}

/// Digits before and after the point into `parts`; false if there is no digit or another character.
bool read_digits(std::string_view mantissa, Parts& parts) {
  const std::size_t point = mantissa.find('.');
  const std::string_view whole = mantissa.substr(0, point);
  const std::string_view fraction =
      point == std::string_view::npos ? std::string_view{} : mantissa.substr(point + 1);
  parts.digits = std::string(whole) + std::string(fraction);
  if (parts.digits.empty() || !std::ranges::all_of(parts.digits, is_digit)) {
    return false;
  }
  const std::size_t leading = std::min(parts.digits.find_first_not_of('0'), parts.digits.size());
  parts.exponent = static_cast<long>(whole.size()) - static_cast<long>(leading);
  parts.last_place = -static_cast<long>(fraction.size());
  parts.digits.erase(0, leading);
  return true;
}

Parts take_apart(std::string_view text) {
  Parts parts;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    parts.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  const std::size_t e = text.find_first_of("eE");
  long exponent = 0;
  if (e != std::string_view::npos && !read_exponent(text.substr(e + 1), exponent)) {
    return parts;
  }
  if (!read_digits(text.substr(0, e), parts)) {
    return parts;
  }
  parts.exponent += exponent;
  parts.last_place += exponent;
  parts.valid = true;
  return parts;
}

/// 10^n by squaring; exact for |n| <= 144.
Wide power_of_ten(long n) {
  Wide result = 1;
  Wide base = 10;
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) {
      result *= base;
    }
    base *= base;
  }
  return result;
}

/// mantissa * 10^exponent, one rounding wherever the power is exact.
Wide scaled(const Wide& mantissa, long exponent) {
  return exponent < 0 ? Wide(mantissa / power_of_ten(-exponent))
                      : Wide(mantissa * power_of_ten(exponent));
}

/// The largest is 0.1 * 10^301 itself.
bool is_in_range(const Parts& parts) {
  const bool is_largest = parts.exponent == kLargestExponent + 1 && parts.digits.front() == '1' &&
                          parts.digits.find_first_not_of('0', 1) == std::string::npos;
  return parts.exponent > -kLargestExponent && (parts.exponent <= kLargestExponent || is_largest);
}

Real value_of(const Parts& parts) {
  const std::size_t used = std::min<std::size_t>(parts.digits.size(), kUsedDigits);
  Wide mantissa = 0;
  for (std::size_t k = 0; k < used; ++k) {
    mantissa = mantissa * 10 + (parts.digits[k] - '0');
  }
  const Wide value = scaled(mantissa, parts.exponent - static_cast<long>(used));
  return Real(parts.negative ? Wide(-value) : value);
}

}  // namespace

Decimal read_decimal(std::string_view text) {
  if (text.size() > kMaxDecimalLength) {
    return {0, DecimalError::kTooLong};
  }
  const Parts parts = take_apart(text);
  if (!parts.valid) {
    return {0, DecimalError::kSyntax};
  }
  if (parts.digits.empty()) {
    return {};
  }
  if (!is_in_range(parts)) {
    return {0, DecimalError::kOutOfRange};
  }
  return {value_of(parts), DecimalError::kNone};
}

Real half_unit_of_last_digit(std::string_view text) {
  const long place = std::clamp(take_apart(text).last_place, -2000L, 400L);
  return Real(scaled(Wide(0.5), place));
}

std::string describe(DecimalError error, std::string_view text) {
  switch (error) {
    case DecimalError::kTooLong:
      return fmt::format("number of {} characters is too long; expected at most {}", text.size(),
                         kMaxDecimalLength);
    case DecimalError::kOutOfRange:
      return fmt::format("{} is out of range; expected 0 or a magnitude from 1e-300 to 1e300",
                         shown(text));
    default:
      return fmt::format("'{}' is not a number; expected a decimal such as 0.25 or -1.5e-3",
                         shown(text));
  }
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMostShown = 60;
  std::string result;
  for (const char c : text.substr(0, kMostShown)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte > 0x7e ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text.size() > kMostShown ? result + "..." : result;
}

}  // namespace treedyn
