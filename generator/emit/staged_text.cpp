#include "emit/staged_text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "common/index.hpp"
#include "emit/checked.hpp"
#include "emit/layout.hpp"
#include "emit/parts.hpp"
#include "emit/template_file.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

using program::RowSolve;
using program::Staged;

namespace {

using Solves = std::vector<RowSolve>;

/// Every solve once, in order of first use.
Solves solves_of(const std::vector<Staged>& functions) {
  Solves result;
  for (const Staged& staged : functions) {
    for (const RowSolve& solve : staged.solves) {
      if (std::ranges::find(result, solve) == result.end()) {
        result.push_back(solve);
      }
    }
  }
  return result;
}

/// solve_rows_6; of several with six rows solve_rows_6, solve_rows_6_2, ...
std::string name_of(const RowSolve& solve, const Solves& all, const std::string& stem) {
  int same = 0;
  for (const RowSolve& other : all) {
    same += other.rows == solve.rows ? 1 : 0;
    if (other == solve) {
      break;
    }
  }
  const std::string name = fmt::format("{}_{}", stem, solve.rows);
  return same > 1 ? fmt::format("{}_{}", name, same) : name;
}

std::string parameter_list(const RowSolve& solve) {
  return fmt::format("const Scalar K[{}], const Scalar b[{}], Scalar x[{}]",
                     solve.rows * (solve.rows + 1) / 2, solve.rows, solve.rows);
}

/// Below this part of what it ordinarily is a pivot is lost to steps. Beside a singular position a
/// row of length s, the root of the part, asks for eps/s more acceleration than it should, and a
/// step that passes there for that times its own growth. Of 160 motions (40 lengths of steps of rk4
/// on four mechanisms) 13 left their branch with 3e-5, one with 1e-4, none with 2e-4 to 5e-4.
double lost(const RowSolve& solve, Scalar scalar) {
  return solve.passes && scalar == Scalar::kFloat ? 5e-4 : 0;
}

/// Part that a pivot has to exceed of what rounding makes it uncertain by; 0 if a tolerance is
/// given.
double rounding(const RowSolve& solve, Scalar scalar) {
  return solve.tolerance > 0 ? 0 : pivot_rounding(solve.rows, scalar);
}

/// Multiple of its own diagonal entry that a pivot has to exceed.
double tolerance(const RowSolve& solve, Scalar scalar) {
  return solve.tolerance > 0 ? solve.tolerance
                             : std::max(rounding(solve, scalar), lost(solve, scalar) * solve.least);
}

/// Multiple of its row's size that a diagonal entry has to exceed; a row's length is its root.
double vanishing(const RowSolve& solve, const Target& target) {
  const double rounded = target.scalar == Scalar::kFloat ? 1e-9 : 1e-14;
  return std::max(solve.tolerance > 0 ? solve.tolerance : lost(solve, target.scalar), rounded);
}

/// Pivot k is safe. It is v^T K v, v = (-w, 1) with w = K^-1 k of the rows before: entries that are
/// off by e sqrt(K_ii K_jj) make it off by (k + 1) e times the sum of v_i^2 K_ii. With ones on the
/// diagonal this is below 1 + 1 / (least eigenvalue) < 1 + 2.72 / (product of the pivots before):
/// the 4 of pivot_rounding makes up for what K_kk / product lacks of that.
std::string pivot_test(const RowSolve& solve, std::size_t k, const Target& target) {
  const std::size_t diagonal = k * (k + 3) / 2;
  const double vanished = vanishing(solve, target) * solve.sizes[k];
  std::string result = fmt::format("K[{}] > {}", diagonal, short_literal(vanished, target));
  const auto add = [&](double share, const std::string& whole) {
    result += fmt::format(" && d[{}] > {} * {}", k, short_literal(share, target), whole);
  };
  const double rounded = rounding(solve, target.scalar);
  if (k == 1 || (k > 1 && (rounded == 0 || is_measured_twice(solve, target.scalar)))) {
    add(tolerance(solve, target.scalar), fmt::format("K[{}]", diagonal));
  }
  if (k > 1 && rounded > 0) {
    add(rounded, fmt::format("{}[{}]", program::kWholeArray, k - 2));
  }
  return result;
}

/// The unrolled elimination, which gives up at the first pivot that may be zero.
std::string regular_text(const RowSolve& solve, const std::string& name, const Target& target) {
  const program::Function function = program::regular_solve(solve);
  const Body text = body(function, {}, target,
                         [](int array, int element) { return array == 2 ? element + 1 : 0; });
  const auto test = [&](int stage) {
    return Lines{fmt::format("if (!({})) {{", pivot_test(solve, to_index(stage - 1), target)),
                 "  return false;", "}"};
  };
  Lines lines = {fmt::format("Scalar d[{}];", solve.rows)};
  append_if(lines, solve.rows > 2,
            fmt::format("Scalar {}[{}];", program::kWholeArray, solve.rows - 2));
  const WholeText whole = whole_text(function.signature, name + "_part", text, test);
  append(lines, whole.lines);
  lines.push_back("return true;");
  return whole.parts +
         fmt::format(
             "\n/// K x = b; false if K (lower half, row by row) is not safely positive definite.\n"
             "bool {}({}) noexcept {{",
             name, parameter_list(solve)) +
         block(lines);
}

/// The path for dependent rows; weights are the inverse sizes of the rows.
std::vector<std::string> deficient_lines(const RowSolve& solve, const Target& target) {
  std::vector<std::string> weights;
  for (const double size : solve.sizes) {
    weights.push_back(short_literal(size > 0 ? 1 / size : 1, target));
  }
  std::string list = wrapped(fmt::format("{}}};", fmt::join(weights, ", ")), "      ");
  list.pop_back();
  return {fmt::format("static constexpr {} weights[] = {{\n{}", type_name(target.scalar), list),
          declaration(fmt::format("return solve_deficient_{}", solve.rows),
                      {std::to_string(solve.rank), "weights",
                       short_literal(tolerance(solve, target.scalar), target),
                       short_literal(rounding(solve, target.scalar), target),
                       short_literal(vanishing(solve, target), target), "K", "b", "x"},
                      ";")};
}

std::string solve_text(const RowSolve& solve, const Solves& all, const Target& target) {
  const std::string name = name_of(solve, all, "solve_rows");
  const std::string head = fmt::format("\nint {}({}) noexcept {{", name, parameter_list(solve));
  std::vector<std::string> lines = deficient_lines(solve, target);
  if (!solve.regular()) {
    return head + block(lines);
  }
  const std::string regular = name_of(solve, all, "solve_regular");
  lines.insert(lines.begin(), {fmt::format("if ({}(K, b, x)) {{", regular), "  return 0;", "}"});
  return regular_text(solve, regular, target) + head + block(lines);
}

/// The path for dependent rows of one number of rows.
std::string deficient_text(int rows, const Target& target) {
  const bool single = target.scalar == Scalar::kFloat;
  const std::string type = type_name(target.scalar);
  return fill(
      template_text("solve_rows.cpp"),
      {{"declaration", declaration(fmt::format("[[gnu::noinline]] int solve_deficient_{}", rows),
                                   {"int expected", fmt::format("const {}* weights", type),
                                    type + " tolerance", type + " rounding", type + " vanishing",
                                    "const Scalar* K", "const Scalar* b", "Scalar* x"},
                                   " noexcept {")},
       {"rows", std::to_string(rows)},
       {"doubt", short_literal(std::sqrt(pivot_rounding(rows, target.scalar)), target)},
       {"independent", short_literal(program::kIndependent, target)},
       {"given_up", single ? "0.01f" : "0.01"},
       {"rounding", single ? "1e-5f" : "1e-13"},
       {"given_up_least", single ? "1e-3f" : "1e-6"}});
}

std::string solvers_text(const Solves& all, const Target& target) {
  std::string result;
  std::set<int> done;
  for (const RowSolve& solve : all) {
    result += done.insert(solve.rows).second ? deficient_text(solve.rows, target) : "";
    result += solve_text(solve, all, target);
  }
  return unnamed(result);
}

/// Declarations of the arrays that callers do not see.
std::vector<std::string> local_arrays(const Staged& staged) {
  const program::Signature& inner = staged.function.signature;
  std::vector<std::string> lines;
  for (const auto* arrays : {&inner.outputs, &inner.inputs}) {
    for (const program::Array& array : *arrays) {
      const bool twice = arrays == &inner.inputs && has(inner.outputs, array.name);
      if (!twice && !has(staged.signature.inputs, array.name) &&
          !has(staged.signature.outputs, array.name)) {
        lines.push_back(fmt::format("Scalar {}[{}];", array.name, array.size));
      }
    }
  }
  if (!staged.contacts.empty()) {
    lines.push_back("for (int i = 0; i < kDof; ++i) {");
    const char* const first = has(staged.signature.inputs, "tau") ? "tau[i]" : "Scalar(0)";
    lines.push_back(fmt::format("  {}[i] = {};", program::kForceArray, first));
    lines.push_back("}");
  }
  return lines;
}

std::vector<std::string> press_lines(const Staged& staged) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < staged.contacts.size(); ++k) {
    std::vector<std::string> passed;
    const program::Signature& signature = staged.contacts[k].signature;
    std::ranges::transform(signature.arrays(), std::back_inserter(passed), &program::Array::name);
    lines.push_back(fmt::format("if (!({}[{}] <= Scalar(0))) {{", program::kDepthArray, k));
    append_if(lines, staged.tells,
              fmt::format("  treedyn_again({});",
                          static_cast<std::size_t>(program::Repeated::kPress) + k));
    lines.push_back(fmt::format("  {}({});", signature.name, fmt::join(passed, ", ")));
    lines.push_back("}");
  }
  return lines;
}

/// Nothing presses: every output is zero.
std::vector<std::string> return_lines(const Staged& staged) {
  std::vector<std::string> lines = {
      fmt::format("if ({}[0] <= Scalar(0)) {{", program::kDepthArray)};
  for (const program::Array& array : staged.signature.outputs) {
    for (int k = 0; k < array.size; ++k) {
      lines.push_back(fmt::format("  {}[{}] = Scalar(0);", array.name, k));
    }
  }
  lines.insert(lines.end(), {staged.signature.status ? "  return 0;" : "  return;", "}"});
  return lines;
}

/// What the solver says, and whether all results are numbers.
std::string return_line(const Staged& staged) {
  std::vector<std::string> parts;
  append_if(parts, !staged.solves.empty() || !staged.pivots.empty(), "failed");
  for (const program::Array& array : staged.signature.outputs) {
    parts.push_back(fmt::format("check({}, {})", array.name, array.size));
  }
  return fmt::format("return {};", fmt::join(parts, " | "));
}

/// What stands before stage `level`.
std::vector<std::string> between(const Staged& staged, std::size_t level, const Solves& all,
                                 const Target& target) {
  switch (staged.gates[level - 1]) {
    case program::Gate::kPress:
      return press_lines(staged);
    case program::Gate::kReturn:
      return return_lines(staged);
    case program::Gate::kClamp:
      return {fmt::format("{0}[0] = {1}[0] < Scalar(0) ? Scalar(0) : {1}[0];",
                          program::kNormalArray, program::kLawArray)};
    case program::Gate::kPower:
      return {fmt::format("{}[0] = pow({}[{}], {});", program::kPowerArray, program::kDepthArray,
                          staged.power.depth, literal(staged.power.exponent, target.scalar))};
    case program::Gate::kSolve:
      break;
  }
  return {fmt::format("{}int failed = {}({}, {}, {});", staged.pivots.empty() ? "const " : "",
                      name_of(staged.solves.front(), all, "solve_rows"), program::kMatrixArray,
                      program::kRightArray, program::kMultiplierArray)};
}

/// The solution of rows that no value behind takes is asked for all the same: it tells a status. A
/// contact that presses on what no joint moves has a law and nothing behind it.
void append_unused_gates(const Staged& staged, std::size_t stages_done, const Solves& all,
                         const Target& target, std::vector<std::string>& lines) {
  for (std::size_t level = stages_done + 1; level <= staged.gates.size(); ++level) {
    if (staged.gates[level - 1] == program::Gate::kSolve) {
      append(lines, between(staged, level, all, target));
    } else if (staged.gates[level - 1] == program::Gate::kClamp) {
      append(lines, {fmt::format("(void){};", program::kLawArray),
                     fmt::format("(void){};", program::kNormalArray)});
    }
  }
}

/// Of the public arrays those that some statement touches.
std::vector<bool> used_arguments(const Staged& staged, const std::vector<bool>& used) {
  std::vector<bool> result;
  const program::Signature& inner = staged.function.signature;
  const auto is_used = [&](const std::string& name, const std::vector<program::Array>& arrays,
                           std::size_t first) {
    for (std::size_t k = 0; k < arrays.size(); ++k) {
      if (arrays[k].name == name) {
        return static_cast<bool>(used[first + k]);
      }
    }
    return false;
  };
  for (const program::Array& array : staged.signature.inputs) {
    const bool passed_on = !staged.contacts.empty() && (array.name == "q" || array.name == "qd" ||
                                                        array.name == "tau" || !array.type.empty());
    const bool raised = array.name == program::kDepthArray && program::worst_powers(staged) > 0;
    result.push_back(passed_on || raised || is_used(array.name, inner.inputs, 0));
  }
  for (const program::Array& array : staged.signature.outputs) {
    result.push_back(is_used(array.name, inner.outputs, inner.inputs.size()));
  }
  return result;
}

std::string function_text(const Staged& staged, const Vocabulary& words, const Body& text,
                          const Solves& all, const Target& target) {
  const auto stem = words.stems.find(staged.signature.name);
  const WholeText whole = whole_text(
      staged.function.signature, stem == words.stems.end() ? staged.signature.name : stem->second,
      text, [&](int stage) { return between(staged, to_index(stage), all, target); });
  std::vector<std::string> lines = local_arrays(staged);
  append(lines, whole.lines);
  append_unused_gates(staged, to_index(whole.stages), all, target, lines);
  if (!staged.pivots.empty()) {
    append_if(lines, staged.solves.empty(), "int failed = 0;");
    append(lines, pivot_tests(staged.pivots, staged.signature.inputs.front().size, target));
  }
  append_if(lines, staged.signature.status, return_line(staged));
  return definition(whole.parts, staged.signature, used_arguments(staged, whole.used), lines);
}

/// The functions that closed contacts call, each once, without namespace.
std::string contacts_text(const std::vector<Staged>& functions, const Vocabulary& words,
                          const Target& target) {
  std::string result;
  std::set<std::string> done;
  for (const Staged& staged : functions) {
    for (const Staged& contact : staged.contacts) {
      if (done.insert(contact.signature.name).second) {
        result +=
            '\n' + function_text(contact, words, staged_body(contact, words, target), {}, target);
      }
    }
  }
  return unnamed(result);
}

}  // namespace

bool is_measured_twice(const RowSolve& solve, Scalar scalar) {
  const double rounded = rounding(solve, scalar);
  return rounded > 0 && tolerance(solve, scalar) > rounded;
}

Body staged_body(const Staged& staged, const Vocabulary& words, const Target& target) {
  return body(staged.function, words, target,
              [&](int array, int) { return staged.levels[to_index(array)]; });
}

std::string local_functions(const std::vector<Staged>& functions, const Vocabulary& words,
                            const Target& target) {
  std::string result;
  for (const Staged& staged : functions) {
    result += '\n' + function_text(staged, words, staged_body(staged, words, target), {}, target);
  }
  return result;
}

std::string staged_text(const std::vector<Staged>& functions, const std::vector<Body>& bodies,
                        const Vocabulary& words, const Target& target) {
  const Solves all = solves_of(functions);
  const bool tells =
      std::ranges::any_of(functions, [](const Staged& staged) { return staged.tells; });
  std::string result = (tells ? "extern \"C\" void treedyn_again(int what);\n" : "") +
                       solvers_text(all, target) + contacts_text(functions, words, target);
  for (std::size_t k = 0; k < functions.size(); ++k) {
    result += "\n";
    result += function_text(functions[k], words, bodies[k], all, target);
  }
  return result;
}

}  // namespace treedyn::emit
