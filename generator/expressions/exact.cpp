#include "expressions/exact.hpp"

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>
#include <string>

#include "common/error.hpp"
#include "common/text_error.hpp"

namespace treedyn::expressions {

namespace {

constexpr int kDigits = 100;                  // of an evaluation; 50 are kept
const char* const kVanishing = "1e-80";       // smaller results are exact zeros
constexpr long kLargestExponent = 1000;       // of an intermediate result
const char* const kLargestAngle = "1000000";  // of sin, cos and tan: keeps 50 digits

bool any_angle(const Real& x) { return abs(x) <= Real(kLargestAngle); }
bool regular_angle(const Real& x) { return any_angle(x) && abs(cos(x)) > Real("1e-40"); }
bool anything(const Real&) { return true; }
bool not_negative(const Real& x) { return x >= 0; }
bool at_most_one(const Real& x) { return abs(x) <= 1; }

GiNaC::ex apply_sqrt(const GiNaC::ex& x) { return GiNaC::sqrt(x); }
GiNaC::ex apply_sin(const GiNaC::ex& x) { return GiNaC::sin(x); }
GiNaC::ex apply_cos(const GiNaC::ex& x) { return GiNaC::cos(x); }
GiNaC::ex apply_tan(const GiNaC::ex& x) { return GiNaC::sin(x) / GiNaC::cos(x); }
GiNaC::ex apply_asin(const GiNaC::ex& x) { return GiNaC::asin(x); }
GiNaC::ex apply_acos(const GiNaC::ex& x) { return GiNaC::acos(x); }
GiNaC::ex apply_atan(const GiNaC::ex& x) { return GiNaC::atan(x); }

constexpr std::array<FunctionRow, 7> kFunctions = {{
    {"sqrt", apply_sqrt, not_negative, "an argument that is not negative", true},
    {"sin", apply_sin, any_angle, "an angle of at most 1e6", true},
    {"cos", apply_cos, any_angle, "an angle of at most 1e6", true},
    {"tan", apply_tan, regular_angle, "an angle of at most 1e6 that is no odd multiple of pi/2",
     true},
    {"asin", apply_asin, at_most_one, "an argument from -1 to 1", false},
    {"acos", apply_acos, at_most_one, "an argument from -1 to 1", false},
    {"atan", apply_atan, anything, "", false},
}};

}  // namespace

Precision::Precision() : before_(static_cast<long>(GiNaC::Digits)) { GiNaC::Digits = kDigits; }

Real to_real(const GiNaC::ex& value) {
  const GiNaC::ex number = value.evalf();
  TREEDYN_EXPECT(GiNaC::is_a<GiNaC::numeric>(number));
  TREEDYN_EXPECT(GiNaC::ex_to<GiNaC::numeric>(number).is_real());
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  const std::string digits = text.str();
  const std::size_t e = digits.find('E');
  const long exponent = e == std::string::npos ? 0 : std::stol(digits.substr(e + 1));
  if (exponent > kLargestExponent) {
    throw TextError(0, "value is out of range; expected 0 or a magnitude from 1e-300 to 1e300");
  }
  const Real result = exponent < -kLargestExponent ? Real(0) : Real(digits);
  return abs(result) < Real(kVanishing) ? Real(0) : result;
}

GiNaC::ex tidied(const GiNaC::ex& value) {
  const Real x = to_real(value);
  for (const int k : {-1, 0, 1}) {
    if (x == k) {
      return k;
    }
  }
  return value;
}

GiNaC::ex exact_decimal(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  long power = e < text.size() ? std::stol(std::string(text.substr(e + 1))) : 0;
  std::string digits(text.substr(0, e));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    power -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return GiNaC::numeric(digits.c_str()) * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(power));
}

std::span<const FunctionRow> functions() { return kFunctions; }

const FunctionRow* find_function(std::string_view name) {
  const auto* const row = std::ranges::find(kFunctions, name, &FunctionRow::name);
  return row == kFunctions.end() ? nullptr : row;
}

}  // namespace treedyn::expressions
