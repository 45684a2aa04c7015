#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "accuracy/function_errors.hpp"
#include "common/decimal.hpp"
#include "emit/json.hpp"
#include "emit/manifest.hpp"

namespace treedyn::accuracy {

namespace {

using Cells = std::vector<std::string>;

/// "1.2e-07 A[7] #12"
Cells worst_cells(const Worst& worst, const char* format) {
  if (worst.output.empty()) {
    return {"0", "", ""};
  }
  return {fmt::format(fmt::runtime(format), worst.error), worst.output,
          fmt::format("#{}", worst.state)};
}

/// So that printing this many digits makes it no smaller.
double rounded_up(double bound, int digits) {
  if (!(bound > 0) || !std::isfinite(bound)) {
    return bound;
  }
  const double unit = std::pow(10, std::floor(std::log10(bound)) + 1 - digits);
  return unit * std::ceil(bound / unit);
}

/// "1.9e-06 16x"; running bounds in brackets.
std::string bound_cell(const Bound& bound) {
  const std::string error =
      std::isfinite(bound.error) ? fmt::format("{:.2g}", rounded_up(bound.error, 2)) : "none";
  const double times = bound.error / bound.sampled;
  return fmt::format("{}{}", bound.obstacle.empty() ? error : fmt::format("({})", error),
                     !std::isfinite(times) ? ""
                     : times < 10          ? fmt::format(" {:.1f}x", times)
                                           : fmt::format(" {:.0f}x", times));
}

/// Operations and pairs of sine and cosine, then both errors and the bound.
Cells cells_of(const Measured& measured) {
  const program::Cost& cost = measured.cost;
  Cells result = {fmt::format("{} + {}", cost.total(), cost.angles)};
  for (const Cells& more : {worst_cells(measured.errors.scaled, "{:.2g}"),
                            worst_cells(measured.errors.ulps, "{:.3g}")}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  result.push_back(bound_cell(measured.bound));
  return result;
}

Cells numbers_of(const FunctionRow& row) {
  Cells result = cells_of(row.in_float);
  const Cells in_double = cells_of(row.in_double);
  result.insert(result.end(), in_double.begin(), in_double.end());
  return result;
}

/// Columns two spaces apart; the last cell of shorter rows is a sentence.
std::string table(const std::vector<Cells>& rows) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const Cells& row : rows) {
    for (std::size_t k = 0; row.size() == width.size() && k < row.size(); ++k) {
      width[k] = std::max(width[k], row[k].size());
    }
  }
  std::string result;
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t k = 0; row.size() == width.size() && k < row.size(); ++k) {
      line += fmt::format("  {:{}}", row[k], width[k]);
    }
    if (row.size() < width.size()) {
      line = fmt::format("  {:{}}  {}", row.front(), width.front(), row.back());
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + "\n";
  }
  return result;
}

/// The rows of one function; options that change nothing share the line of the default.
std::vector<Cells> cells_of_function(const std::vector<FunctionRow>& rows,
                                     const std::string& function) {
  std::vector<Cells> result;
  std::vector<std::string> same;
  Cells first;
  for (const FunctionRow& row : rows) {
    if (row.function != function) {
      continue;
    }
    const Cells numbers = numbers_of(row);
    if (numbers == first) {
      same.push_back(row.option);
      continue;
    }
    first = first.empty() ? numbers : first;
    result.push_back({result.empty() ? function : "", row.option});
    result.back().insert(result.back().end(), numbers.begin(), numbers.end());
  }
  if (!same.empty()) {
    result.push_back({"", fmt::format("as the first: {}", fmt::join(same, ", "))});
  }
  return result;
}

std::string number_json(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "null";
}

/// No error has no place; an infinite one is null.
std::string worst_json(const Worst& worst) {
  const bool none = worst.output.empty();
  return emit::json_object({{"error", number_json(worst.error)},
                            {"output", none ? "null" : emit::json_string(worst.output)},
                            {"state", none ? "null" : std::to_string(worst.state)}});
}

std::string bound_json(const Bound& bound) {
  return emit::json_object(
      {{"kind", emit::json_string(bound.obstacle.empty() ? "proven" : "running")},
       {"error", number_json(rounded_up(bound.error, 3))},
       {"output", bound.output.empty() ? "null" : emit::json_string(bound.output)},
       {"sampled", number_json(bound.sampled)},
       {"assumed", emit::json_string(bound.assumed)},
       {"obstacle", emit::json_string(bound.obstacle)}});
}

std::string measured_json(const Measured& measured) {
  return emit::json_object({{"scaled", worst_json(measured.errors.scaled)},
                            {"ulp", worst_json(measured.errors.ulps)},
                            {"bound", bound_json(measured.bound)},
                            {"operations", emit::operations_json(measured.cost)}});
}

/// Why there is no bound over the ranges, or what was taken for them; "": neither.
std::string reason(const Bound& bound) {
  if (!bound.obstacle.empty()) {
    return fmt::format("{}, because {} as far as intervals tell",
                       std::isfinite(bound.error) ? "running" : "none", bound.obstacle);
  }
  if (!bound.assumed.empty()) {
    return fmt::format("proven for the ranges taken of {}, which have no limits", bound.assumed);
  }
  return "";
}

/// The reasons of a row, one line for both scalars where they agree; of an option behind the first
/// one only obstacles that were not `said` of the function.
std::string reasons_text(const FunctionRow& row, bool is_first, std::set<std::string>& said) {
  const auto unsaid = [&](const char* scalar, const Bound& bound) {
    const std::string why = is_first || !bound.obstacle.empty() ? reason(bound) : "";
    return said.insert(row.function + scalar + why).second ? why : "";
  };
  const std::string of = is_first ? row.function : row.function + " " + row.option;
  const std::string in_float = unsaid(" in float", row.in_float.bound);
  const std::string in_double = unsaid(" in double", row.in_double.bound);
  const auto line = [&](const char* scalar, const std::string& why) {
    return why.empty() ? "" : fmt::format("  {}{}: {}\n", of, scalar, why);
  };
  return in_float == in_double ? line("", in_float)
                               : line(" in float", in_float) + line(" in double", in_double);
}

/// What the bounds of the first rows hold for, and where there is none over the ranges.
std::string bounds_text(const FunctionStudy& study) {
  std::string text =
      "\nbounds of the error over all ranges of the arguments, proven with intervals on the "
      "operations; of the scale where\nevery argument is at the end of its range (16x: the largest "
      "error in the states, of that scale); (running): of the state\nof the largest error alone\n";
  std::set<std::string> seen;
  std::set<std::string> said;
  for (const FunctionRow& row : study.rows) {
    text += reasons_text(row, seen.insert(row.function).second, said);
  }
  return text;
}

}  // namespace

std::string functions_text(const FunctionStudy& study) {
  std::vector<Cells> rows = {
      {"", "", "float:", "largest", "", "", "largest", "", "", "", "double:", "largest", "", "",
       "largest", "", "", ""},
      {"function", "option", "operations", "error/scale", "of", "state", "error/ulp", "of", "state",
       "bound/scale", "operations", "error/scale", "of", "state", "error/ulp", "of", "state",
       "bound/scale"}};
  std::vector<std::string> seen;
  for (const FunctionRow& row : study.rows) {
    if (std::ranges::find(seen, row.function) == seen.end()) {
      seen.push_back(row.function);
      const std::vector<Cells> more = cells_of_function(study.rows, row.function);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  std::string text = fmt::format(
      "errors of {} in {} pseudo-random states, against the block equations with 50 digits\n"
      "scale: sum of the magnitudes of the terms of the equation; operations: add + mul + div, "
      "and pairs of sine and cosine\n",
      shown(study.model), study.states);
  text += study.missing.empty() ? "" : study.missing + "\n";
  text += "\n" + table(rows) + bounds_text(study) +
          "\nstates of the largest errors of the first rows\n";
  for (const FunctionStudy::Named& named : study.named) {
    std::vector<std::string> values;
    for (const auto& [name, list] : named.values) {
      values.push_back(fmt::format("{} = {}", name, list));
    }
    text += fmt::format("  {} #{}: {}\n", named.function, named.state, fmt::join(values, ", "));
  }
  return text;
}

std::string errors_json(const Measured& measured) {
  return emit::json_object({{"scaled", worst_json(measured.errors.scaled)},
                            {"ulp", worst_json(measured.errors.ulps)},
                            {"bound", bound_json(measured.bound)}});
}

std::string functions_json(const FunctionStudy& study) {
  std::vector<std::string> rows;
  for (const FunctionRow& row : study.rows) {
    rows.push_back(emit::json_object({{"function", emit::json_string(row.function)},
                                      {"option", emit::json_string(row.option)},
                                      {"float", measured_json(row.in_float)},
                                      {"double", measured_json(row.in_double)}}));
  }
  std::vector<std::string> named;
  for (const FunctionStudy::Named& state : study.named) {
    named.push_back(emit::json_object({{"function", emit::json_string(state.function)},
                                       {"state", std::to_string(state.state)},
                                       {"values", emit::json_object(state.values)}}));
  }
  return fmt::format(
      "{{\n  \"name\": {},\n  \"states\": {},\n  \"missing_limits\": {},\n  \"rows\": {},\n"
      "  \"named_states\": {}\n}}\n",
      emit::json_string(study.model), study.states, emit::json_string(study.missing),
      emit::json_lines(rows, 4), emit::json_lines(named, 4));
}

}  // namespace treedyn::accuracy
