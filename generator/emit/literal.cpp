#include "emit/literal.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace treedyn::emit {

namespace {

template <class T>
std::string digits(const Real& value) {
  const T rounded = value.convert_to<T>();
  if (!std::isfinite(rounded)) {
    throw std::range_error(fmt::format("the constant {:.6g} is too large for {}",
                                       value.convert_to<long double>(),
                                       sizeof(T) == sizeof(float) ? "float" : "double"));
  }
  std::string text = fmt::format("{}", rounded);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

}  // namespace

std::string type_name(Scalar scalar) { return scalar == Scalar::kFloat ? "float" : "double"; }

std::string literal(const Real& value, Scalar scalar) {
  return scalar == Scalar::kFloat ? digits<float>(value) + "f" : digits<double>(value);
}

int literal_width(const Real& value, Scalar scalar) {
  constexpr std::string_view kLongestDouble = "1.2345678901234567e-300";
  constexpr std::string_view kLongestFloat = "1.23456789e-30f";
  const auto longest = (scalar == Scalar::kFloat ? kLongestFloat : kLongestDouble).size();
  const bool of_structure = value.digits() == value.seen();
  return static_cast<int>(of_structure ? literal(value, scalar).size() : longest);
}

bool rounds_to_one(const Real& value, Scalar scalar) {
  return scalar == Scalar::kFloat ? value.convert_to<float>() == 1.0F
                                  : value.convert_to<double>() == 1.0;
}

std::string decimal(const Real& value) { return fmt::format("{}", value.convert_to<double>()); }

}  // namespace treedyn::emit
