#include "expressions/constant.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "expressions/exact.hpp"
#include "expressions/parser.hpp"
#include "expressions/read_expression.hpp"

namespace treedyn::expressions {

Constants::Constants() : table_(std::make_unique<Table>()) {}
Constants::~Constants() = default;
Constants::Constants(Constants&&) noexcept = default;
Constants& Constants::operator=(Constants&&) noexcept = default;

void Constants::check_name(const std::string& name) const {
  const bool identifier =
      !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, is_word_byte);
  if (!identifier) {
    throw TextError(0, fmt::format("parameter name '{}' is no word; expected letters, digits and _",
                                   shown(name)));
  }
  if (name == "pi" || find_function(name) != nullptr || table_->names.count(name) > 0) {
    throw TextError(0, fmt::format("parameter name '{}' is taken; expected a new name", name));
  }
}

void Constants::define(const std::string& name, std::string_view text) {
  check_name(name);
  table_->names.emplace(name, parse(text, table_->names));
}

void Constants::define_at_run_time(const std::string& name, std::string_view text,
                                   const std::function<Real(const Real&)>& number) {
  check_name(name);
  const Table::AtRunTime& added = table_->at_run_time.emplace_back(
      Table::AtRunTime{name, GiNaC::realsymbol(), number(evaluate(text))});
  table_->names.emplace(name, Exact{added.symbol, 1});
}

Real Constants::evaluate(std::string_view text, bool run_time) const {
  const Exact exact = parse(text, table_->names);
  if (!is_constant(exact.value)) {
    return read_expression(*this, text, {[](auto, auto) { return std::nullopt; }, "", {}, run_time})
        .value();
  }
  const Precision precision;
  Real value = to_real(exact.value);
  if (value != 0 && (abs(value) > Real("1e300") || abs(value) < Real("1e-300"))) {
    throw TextError(0, describe(DecimalError::kOutOfRange, text));
  }
  return value;
}

}  // namespace treedyn::expressions
