#include "emit/checked.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/parts.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

std::string lost(const std::string& condition) {
  return fmt::format("failed |= {} ? status::rank_lost : 0;", condition);
}

/// What the tests say, and whether all arguments, pivots and results are numbers.
std::vector<std::string> return_lines(const Checked& checked) {
  std::vector<std::string> lines;
  const auto note = [&](const program::Array& array) {
    lines.push_back(fmt::format("failed |= check({}, {});", array.name, array.size));
  };
  std::ranges::for_each(checked.signature.inputs, note);
  std::ranges::for_each(checked.function.signature.outputs, note);
  lines.emplace_back("return failed;");
  return lines;
}

std::vector<std::string> local_arrays(const Checked& checked) {
  std::vector<std::string> lines;
  const auto& outputs = checked.function.signature.outputs;
  for (std::size_t k = checked.signature.outputs.size(); k < outputs.size(); ++k) {
    lines.push_back(fmt::format("Scalar {}[{}];", outputs[k].name, outputs[k].size));
  }
  return lines;
}

}  // namespace

double pivot_rounding(int size, Scalar scalar) {
  const double epsilon = scalar == Scalar::kFloat
                             ? static_cast<double>(std::numeric_limits<float>::epsilon())
                             : std::numeric_limits<double>::epsilon();
  return 4 * std::max(size, 2) * epsilon;
}

std::string short_literal(double value, const Target& target) {
  const double least = target.scalar == Scalar::kFloat ? 1e-36 : 1e-290;
  return literal(Real(fmt::format("{:.1e}", std::max(value, least))), target.scalar);
}

std::vector<std::string> pivot_tests(const std::vector<program::Pivot>& pivots, int dof,
                                     const Target& target) {
  const double share = pivot_rounding(dof, target.scalar);
  std::vector<std::string> lines;
  int whole = 0;
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    const program::Pivot& pivot = pivots[k];
    const std::string value = fmt::format("{}[{}]", program::kPivotArray, k);
    const std::string least = short_literal(share * pivot.size, target);
    lines.push_back(lost(pivot.positive ? fmt::format("{} < {}", value, least)
                                        : fmt::format("{0} < {1} && {0} > -{1}", value, least)));
    if (pivot.whole != 0) {
      lines.push_back(lost(fmt::format("{} < {} * {}[{}]", value, short_literal(share, target),
                                       program::kWholeArray, whole++)));
    }
  }
  return lines;
}

Checked checked_sibling(const program::Function& function, std::vector<program::Pivot> pivots) {
  Checked result{function.signature, function, std::move(pivots)};
  result.signature.name += "_checked";
  result.signature.brief = fmt::format("As {}, the same bits, and whether they can be trusted.",
                                       function.signature.name);
  result.signature.status = true;
  result.function.signature = result.signature;
  program::show_pivots(result.function, result.pivots);
  return result;
}

program::Cost cost(const Checked& checked) {
  return program::cost(checked.function) + program::test_cost(checked.pivots);
}

std::string checked_text(const Checked& checked, const Body& body, const Target& target) {
  const program::Signature& inner = checked.function.signature;
  const WholeText text = whole_text(inner, inner.name, body);
  std::vector<std::string> lines = local_arrays(checked);
  append(lines, text.lines);
  lines.emplace_back("int failed = 0;");
  append(lines, pivot_tests(checked.pivots, checked.signature.inputs.front().size, target));
  append(lines, return_lines(checked));
  return definition(text.parts, checked.signature, all_arrays(checked.signature), lines);
}

std::string check_text(const Target& target) {
  const bool single = target.scalar == Scalar::kFloat;
  return unnamed(fill(template_text("check.cpp"),
                      {{"type", type_name(target.scalar)},
                       {"largest", single ? "3.40282347e38f" : "1.7976931348623157e308"}}));
}

}  // namespace treedyn::emit
