#include "emit/run_time.hpp"

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "emit/json.hpp"
#include "emit/layout.hpp"
#include "emit/named_constants.hpp"
#include "emit/names.hpp"
#include "model/parameters.hpp"

namespace treedyn::emit {

namespace {

/// Of all fields: none may have its name.
constexpr std::string_view kTheirType = "Scalar";
constexpr std::size_t kLongestMeaning = 1000;
/// With `p.` in front two of them fit into a statement.
constexpr std::size_t kLongestField = 25;

/// The fields of `derived`, those of one unit and source under one comment.
std::string derived_fields(const Unit& unit) {
  if (unit.derived.empty()) {
    return "  Scalar value[1];  // none is needed\n";
  }
  std::string result;
  std::string before;
  for (const DescribedNumber& number : described(unit.derived, vocabulary(*unit.tree))) {
    if (number.source != before && !number.source.empty()) {
      result += wrapped(number.source, "  /// ", 4);
    }
    before = number.source;
    result += fmt::format("  Scalar {};\n", number.name);
  }
  return result;
}

std::string fields(const Unit& unit) {
  std::string result;
  std::size_t k = 0;
  const std::vector<std::string> names = field_names(*unit.tree);
  for (const model::Parameter& parameter : unit.tree->parameters) {
    const std::string unit_text = model::unit(parameter);
    result += wrapped(for_comment(model::meaning(*unit.tree, parameter), kLongestMeaning) +
                          (unit_text.empty() ? "" : ", " + unit_text),
                      "  /// ");
    result += fmt::format("  Scalar {};\n", names[k++]);
  }
  return result;
}

/// One value a line, not aligned: a changed model changes one line.
std::string nominal_values(const Unit& unit) {
  std::string result;
  std::size_t k = 0;
  const std::vector<std::string> names = field_names(*unit.tree);
  for (const model::Parameter& parameter : unit.tree->parameters) {
    const Real value = model::nominal(*unit.tree, unit.gravity, parameter);
    result += fmt::format("    {},  // {}\n", literal(value, unit.target.scalar), names[k++]);
  }
  return result;
}

}  // namespace

std::vector<std::string> field_names(const model::Tree& tree) {
  std::vector<std::string> identifiers;
  for (const model::Parameter& parameter : tree.parameters) {
    identifiers.push_back(parameter.identifier + (parameter.identifier == kTheirType ? "_" : ""));
  }
  return shortened(identifiers, kLongestField);
}

program::Array parameters_array(const model::Tree& tree) {
  program::Array result{"p", static_cast<int>(tree.parameters.size()), ""};
  result.type = kParameters;
  result.fields = field_names(tree);
  return result;
}

program::Array derived_array() {
  program::Array result{"derived", 0, ""};
  result.type = kDerivedParameters;
  return result;
}

std::vector<std::string> derived_names(const std::vector<Real>& numbers, const model::Tree& tree) {
  return transformed(described(numbers, vocabulary(tree)),
                     [](const DescribedNumber& number) { return number.name; });
}

std::string parameter_types(const Unit& unit) {
  if (unit.tree->parameters.empty()) {
    return {};
  }
  return fmt::format(
      "\n/// Numbers that are known at run time only, in SI units and the frames of the links.\n"
      "struct {0} {{\n{1}}};\n"
      "/// Nominal: of the model and its scene.\n"
      "constexpr {0} {2} = {{\n{3}}};\n"
      "/// What functions need of them: made by {4}, outside the loop that calls these.\n"
      "struct {5} {{\n{6}}};\n",
      kParameters, fields(unit), kNominal, nominal_values(unit), kUpdate, kDerivedParameters,
      derived_fields(unit));
}

std::string parameters_json(const model::Tree& tree, const model::Vector3& gravity) {
  if (tree.parameters.empty()) {
    return {};
  }
  std::vector<std::string> rows;
  std::size_t k = 0;
  const std::vector<std::string> names = field_names(tree);
  for (const model::Parameter& parameter : tree.parameters) {
    rows.push_back(
        json_object({{"field", json_string(names[k++])},
                     {"declared", json_string(parameter.declared)},
                     {"link", json_string(model::link_name(tree, parameter))},
                     {"unit", json_string(model::unit(parameter))},
                     {"nominal", with_point(decimal(model::nominal(tree, gravity, parameter)))}}));
  }
  return fmt::format(",\n  \"parameters\": {}", json_lines(rows, 4));
}

}  // namespace treedyn::emit
