#include "description/numbers.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

[[noreturn]] void rethrow(const RawTree& raw, const Text& text, const std::string& what,
                          const TextError& problem) {
  const Place where = text.where.at(problem.offset());
  throw InputError(location(raw, where), fmt::format("{}: {}", what, problem.what()));
}

}  // namespace

bool is_xacro(const std::string& text) {
  return text.find("${") != std::string::npos || text.find("$(") != std::string::npos;
}

std::string of_xacro(const std::string& text) {
  return fmt::format("{} is of xacro; expected the URDF that it makes: xacro FILE > robot.urdf",
                     text);
}

NumberReader::NumberReader(const RawTree& raw) : raw_(raw) {
  for (const RawParameter& parameter : raw.parameters) {
    try {
      constants_.define(parameter.name.text, parameter.value.text);
    } catch (const TextError& problem) {
      rethrow(raw, parameter.value, fmt::format("parameter '{}'", shown(parameter.name.text)),
              problem);
    }
  }
}

Real NumberReader::number(const Text& text, const std::string& what) const {
  const Decimal decimal = read_decimal(text.text);
  if (decimal) {
    return decimal.value;
  }
  if (raw_.format == Format::kUrdf && is_xacro(text.text)) {
    throw InputError(location(raw_, text.where),
                     fmt::format("{}: {}", what, of_xacro(fmt::format("'{}'", shown(text.text)))));
  }
  if (decimal.error != DecimalError::kSyntax || raw_.format == Format::kUrdf) {
    throw InputError(location(raw_, text.where),
                     fmt::format("{}: {}", what, describe(decimal.error, text.text)));
  }
  try {
    return constants_.evaluate(text.text);
  } catch (const TextError& problem) {
    rethrow(raw_, text, what, problem);
  }
}

template <std::size_t size>
std::array<Real, size> NumberReader::list(const Numbers& numbers, const std::string& what) const {
  for (const Text& text : numbers.values) {
    if (raw_.format == Format::kUrdf && is_xacro(text.text)) {
      static_cast<void>(number(text, what));  // says so: a space in it divides its words
    }
  }
  if (numbers.values.size() != size) {
    throw InputError(location(raw_, numbers.where),
                     fmt::format("{} has {} number{}; expected {}", what, numbers.values.size(),
                                 numbers.values.size() == 1 ? "" : "s", size));
  }
  std::array<Real, size> result;
  std::ranges::transform(numbers.values, result.begin(),
                         [&](const Text& text) { return number(text, what); });
  return result;
}

model::Vector3 NumberReader::vector(const std::optional<Numbers>& numbers,
                                    const std::string& what) const {
  return numbers ? list<3>(*numbers, what) : model::Vector3{};
}

model::Matrix3 NumberReader::matrix(const Numbers& numbers, const std::string& what) const {
  return list<9>(numbers, what);
}

model::Matrix3 NumberReader::tensor(const Numbers& numbers, const std::string& what) const {
  const std::array<Real, 6> i = list<6>(numbers, what);
  return {i[0], i[1], i[2], i[1], i[3], i[4], i[2], i[4], i[5]};
}

Real NumberReader::rounding(const Text& text, const Real& scale) {
  const bool plain_zero = text.text == "0" || text.text == "-0";
  if (plain_zero || !read_decimal(text.text)) {
    return 0;
  }
  return std::min(half_unit_of_last_digit(text.text), Real(scale / 1000));
}

}  // namespace treedyn::description
