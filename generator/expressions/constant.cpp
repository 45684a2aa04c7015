#include "expressions/constant.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "expressions/constant_table.hpp"
#include "expressions/exact.hpp"

namespace treedyn::expressions {

Constants::Constants() : table_(std::make_unique<Table>()) {}
Constants::~Constants() = default;
Constants::Constants(Constants&&) noexcept = default;
Constants& Constants::operator=(Constants&&) noexcept = default;

void Constants::define(const std::string& name, std::string_view text) {
  const bool identifier = !name.empty() && is_letter(name.front()) &&
                          std::all_of(name.begin(), name.end(), is_word_byte);
  if (!identifier) {
    throw ConstantError(
        0,
        fmt::format("parameter name '{}' is no word; expected letters, digits and _", shown(name)));
  }
  if (name == "pi" || find_function(name) != nullptr || table_->names.count(name) > 0) {
    throw ConstantError(0, fmt::format("parameter name '{}' is taken; expected a new name", name));
  }
  table_->names.emplace(name, parse(text, table_->names));
}

Real Constants::evaluate(std::string_view text) const {
  const Exact exact = parse(text, table_->names);
  const Precision precision;
  const Real value = to_real(exact.value);
  if (value != 0 && (abs(value) > Real("1e300") || abs(value) < Real("1e-300"))) {
    throw ConstantError(0, describe(DecimalError::kOutOfRange, text));
  }
  return value;
}

}  // namespace treedyn::expressions
