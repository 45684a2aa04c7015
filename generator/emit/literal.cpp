#include "emit/literal.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace treedyn::emit {

namespace {

/// The digits of `rounded`, which is `value` in the scalar type.
template <class T>
std::string digits(const Real& value, T rounded, Scalar scalar) {
  if (!std::isfinite(rounded)) {
    throw std::range_error(fmt::format(
        "the constant {:.6g}, made of numbers of the model and of its equations, is too large for "
        "{}; expected smaller ones{}",
        value.convert_to<long double>(), type_name(scalar),
        scalar == Scalar::kFloat ? " or --scalar double" : ""));
  }
  return with_point(scalar == Scalar::kExtended ? fmt::format("{:.20e}", rounded)
                                                : fmt::format("{}", rounded));
}

}  // namespace

std::string with_point(const std::string& number) {
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string type_name(Scalar scalar) {
  return scalar == Scalar::kFloat ? "float" : scalar == Scalar::kDouble ? "double" : "long double";
}

std::string literal(const Real& value, Scalar scalar) {
  switch (scalar) {
    case Scalar::kFloat:
      return digits(value, value.convert_to<float>(), scalar) + "f";
    case Scalar::kDouble:
      return digits(value, value.convert_to<double>(), scalar);
    case Scalar::kExtended:
      return digits(value, value.convert_to<long double>(), scalar) + "L";
  }
  return {};
}

int literal_width(const Real& value, Scalar scalar) {
  constexpr std::string_view kLongestDouble = "1.2345678901234567e-300";
  constexpr std::string_view kLongestFloat = "1.23456789e-30f";
  constexpr std::string_view kLongestExtended = "1.23456789012345678901e-300L";
  const auto longest = (scalar == Scalar::kFloat    ? kLongestFloat
                        : scalar == Scalar::kDouble ? kLongestDouble
                                                    : kLongestExtended)
                           .size();
  const bool of_structure = !value.has_stand_in();
  return static_cast<int>(of_structure ? literal(value, scalar).size() : longest);
}

bool rounds_to_one(const Real& value, Scalar scalar) {
  switch (scalar) {
    case Scalar::kFloat:
      return value.convert_to<float>() == 1;
    case Scalar::kDouble:
      return value.convert_to<double>() == 1;
    case Scalar::kExtended:
      return value.convert_to<long double>() == 1;
  }
  return false;
}

std::string decimal(const Real& value) { return fmt::format("{}", value.convert_to<double>()); }

}  // namespace treedyn::emit
