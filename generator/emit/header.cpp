#include "emit/header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/names.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

constexpr std::size_t kLongestCell = 32;

const model::Link& link_of(const model::Tree& tree, int coordinate) {
  const auto k = static_cast<std::size_t>(coordinate);
  return tree.links[static_cast<std::size_t>(tree.coordinates[k])];
}

/// Rows of a table as comment lines, columns two spaces apart.
std::string comment_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      width[k] = std::max(width[k], row[k].size());
    }
  }
  std::string result;
  for (const auto& row : rows) {
    std::string line = "// ";
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += fmt::format("  {:{}}", row[k], k + 1 < row.size() ? width[k] : 0);
    }
    result += line + "\n";
  }
  return result;
}

std::string joint_table(const model::Tree& tree) {
  std::vector<std::vector<std::string>> rows = {{"joint", "link", "index", "type", "unit"}};
  for (int k = 0; k < tree.dof(); ++k) {
    const model::Link& link = link_of(tree, k);
    const bool revolute = link.joint.type == model::JointType::kRevolute;
    rows.push_back({for_comment(link.joint.name, kLongestCell),
                    for_comment(link.name, kLongestCell), std::to_string(k),
                    revolute ? "revolute" : "prismatic", revolute ? "rad" : "m"});
  }
  return comment_table(rows);
}

std::string point_table(const std::vector<model::Point>& points) {
  if (points.empty()) {
    return {};
  }
  std::vector<std::vector<std::string>> rows = {{"point", "link", "index", "at (link frame, m)"}};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const model::Point& point = points[k];
    rows.push_back(
        {for_comment(point.name, kLongestCell), for_comment(point.link_name, kLongestCell),
         std::to_string(k),
         fmt::format("{:.6g}, {:.6g}, {:.6g}", point.at[0].convert_to<double>(),
                     point.at[1].convert_to<double>(), point.at[2].convert_to<double>())});
  }
  return "//\n" + comment_table(rows);
}

/// `inline constexpr int name = value;`, broken where clang-format breaks what is too long.
std::string index_constant(const std::string& name, std::size_t value) {
  const std::size_t type = std::string_view("inline constexpr int ").size();
  const std::size_t number = std::to_string(value).size() + 1;
  const bool fits = type + name.size() + 3 + number <= kColumns;
  const bool breaks_after_type = type + name.size() + 2 > kColumns;
  const bool breaks_after_equal =
      !fits && (!breaks_after_type || name.size() + 7 + number > kColumns);
  return fmt::format("inline constexpr int{}{} ={}{};\n", breaks_after_type ? "\n    " : " ", name,
                     !breaks_after_equal ? " "
                     : breaks_after_type ? "\n        "
                                         : "\n    ",
                     value);
}

/// `namespace joint { ... }` with one constant a name; nothing without names.
std::string index_namespace(const std::string& name, const std::vector<std::string>& identifiers) {
  if (identifiers.empty()) {
    return {};
  }
  std::string result = fmt::format("\n/// Index of every {}.\nnamespace {} {{\n", name, name);
  for (std::size_t k = 0; k < identifiers.size(); ++k) {
    result += index_constant(identifiers[k], k);
  }
  return result + fmt::format("}}  // namespace {}\n", name);
}

std::vector<std::string> joint_identifiers(const model::Tree& tree) {
  std::vector<std::string> result;
  for (int k = 0; k < tree.dof(); ++k) {
    result.push_back(link_of(tree, k).joint.identifier);
  }
  return result;
}

std::vector<std::string> point_identifiers(const std::vector<model::Point>& points) {
  std::vector<std::string> result;
  for (const model::Point& point : points) {
    result.push_back(point.identifier);
  }
  return result;
}

std::string array_doc(const program::Array& array, bool output, std::size_t name_width) {
  const std::string unit = array.unit.empty() ? "" : fmt::format(", {}", array.unit);
  return wrapped(
      fmt::format("{}{}", array.size, unit),
      fmt::format("/// \\param{} {:{}}  ", output ? "[out]" : "     ", array.name, name_width));
}

/// What it does and its arguments.
std::string signature_doc(const program::Signature& signature) {
  std::size_t name_width = 0;
  for (const auto* arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      name_width = std::max(name_width, array.name.size());
    }
  }
  std::string result = wrapped(signature.brief, "/// ") + "///\n";
  for (const program::Array& array : signature.inputs) {
    result += array_doc(array, false, name_width);
  }
  for (const program::Array& array : signature.outputs) {
    result += array_doc(array, true, name_width);
  }
  return result;
}

std::string function_doc(const program::Function& function) {
  const program::Signature& signature = function.signature;
  return signature_doc(signature) +
         wrapped(fmt::format("Equation {}. Cost: {}.{}", signature.equation,
                             cost_text(program::cost(function)),
                             function.limb_code ? " Equal limbs share code." : ""),
                 "/// ");
}

/// Why lambda is not unique. Where drives are sought, an equation stands for a joint without one.
std::string rank_text(const program::Staged& staged, const program::RowSolve& solve) {
  const bool drives = staged.signature.outputs.front().name == "tau";
  return fmt::format("{} {} {} rank {}: lambda is of least norm.",
                     drives ? "The equations of the" : "The", solve.rows,
                     drives ? "joints without a drive have" : "rows have", solve.rank);
}

/// The rows of lambda, the cost of the regular path and the bound.
std::string staged_doc(const program::Staged& staged) {
  std::string result = signature_doc(staged.signature);
  for (std::size_t k = 0; k < staged.rows.size(); ++k) {
    const std::string text = for_comment(staged.rows[k], kLongestCell * 2);
    result += wrapped(fmt::format("Row {}: {}", k, text), "/// ", 4);
  }
  for (const std::string& anchor : staged.anchors) {
    result += wrapped(for_comment(anchor, kLongestCell * 3), "/// ", 4);
  }
  for (const program::RowSolve& solve : staged.solves) {
    result += solve.regular() ? "" : wrapped(rank_text(staged, solve), "/// ");
  }
  for (const program::Staged& contact : staged.contacts) {
    const char* const power = program::worst_powers(contact) > 0 ? ", 1 pow" : "";
    result += wrapped(fmt::format("A closed contact ({}) adds {}{}.", contact.signature.name,
                                  cost_text(program::cost(contact)), power),
                      "/// ");
  }
  return result + wrapped(fmt::format("Equation {}. Cost: {}. Never more than {}.",
                                      staged.signature.equation, cost_text(program::cost(staged)),
                                      cost_text(program::worst_cost(staged))),
                          "/// ");
}

std::string scalar_declaration(const Target& target) {
  const std::string type = type_name(target.scalar);
  if (target.lanes == 1) {
    return fmt::format("/// The only floating-point type in use.\nusing Scalar = {};\n", type);
  }
  return fmt::format(
      "/// States that are computed at once.\n"
      "inline constexpr int kLanes = {0};\n"
      "/// One value of every state, the only floating-point type in use: value[lane] is that of a "
      "state.\n"
      "/// For a processor with vectors of this size (-march), or with -Wno-psabi.\n"
      "using Scalar [[gnu::vector_size(kLanes * sizeof({1}))]] = {1};\n",
      target.lanes, type);
}

/// `inline constexpr int name[] = {...};`, as many numbers a line as fit.
std::string index_table(const std::string& name, const std::vector<int>& values) {
  std::string result = fmt::format("inline constexpr int {}[{}] = {{", name, values.size());
  std::string line;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string cell = fmt::format("{}{}", values[k], k + 1 < values.size() ? "," : "");
    if (line.size() + cell.size() + 5 > kColumns) {
      result += "\n   " + line;
      line.clear();
    }
    line += " " + cell;
  }
  return result + "\n   " + line + "};\n";
}

/// Where the values of a packed A belong; nothing if A is dense.
std::string packing_tables(const Unit& unit) {
  if (!unit.target.packed) {
    return {};
  }
  return fmt::format(
             "\n/// Value k of A is entry (kMassMatrixRow[k], kMassMatrixColumn[k]) and its mirror "
             "image;\n/// other entries are zero in every state.\n"
             "inline constexpr int kMassMatrixNonzeros = {};\n",
             unit.packing.size()) +
         index_table("kMassMatrixRow", unit.packing.row) +
         index_table("kMassMatrixColumn", unit.packing.column);
}

std::string arrays_comment(const Target& target) {
  return wrapped(
      fmt::format("Arrays are dense{}, matrices row-major; SI units and radians. Outputs "
                  "are written completely and must not overlap inputs. Nothing is "
                  "allocated, thrown or kept between calls.",
                  target.packed ? ", A excepted" : ""),
      "// ");
}

std::string method_text(program::StepMethod method) {
  switch (method) {
    case program::StepMethod::kRk4:
      return "Runge-Kutta of order 4";
    case program::StepMethod::kDopri5:
      return "Dormand and Prince of order 5";
    case program::StepMethod::kSdirk2:
      return "two implicit stages, of order 2 and L-stable (Alexander 1977)";
    case program::StepMethod::kSemiImplicitEuler:
      break;
  }
  return "semi-implicit Euler";
}

/// "phase left: touch_down of right_foot, from step 40: impact_left, then right"
std::string event_text(const program::Stepper& stepper, const program::StepPhase& phase,
                       const program::StepEvent& event) {
  const auto outcome = [&](const program::StepOutcome& result) {
    return fmt::format("{}{}", result.impact.empty() ? "" : result.impact + ", then ",
                       stepper.phases[static_cast<std::size_t>(result.then)].identifier);
  };
  const std::string after =
      event.not_before > 0 ? fmt::format(" from step {}", event.not_before) : "";
  const std::string rest = event.rest ? fmt::format("; slower than {} m/s: {}",
                                                    decimal(event.rest_below), outcome(*event.rest))
                                      : "";
  return fmt::format("Phase {}: {}{}: {}{}", phase.identifier,
                     for_comment(event.brief, kLongestCell * 2), after, outcome(event.outcome),
                     rest);
}

/// What the events do, and how late.
std::string events_doc(const program::Stepper& stepper) {
  std::string result;
  for (const program::StepPhase& phase : stepper.phases) {
    for (const program::StepEvent& event : phase.events) {
      result += wrapped(event_text(stepper, phase, event), "/// ", 4);
    }
  }
  if (result.empty()) {
    return result;
  }
  const std::string begins =
      stepper.switches() ? fmt::format(" The scene begins in {}.", stepper.first) : "";
  return result + wrapped(
                      "Events are looked at where the step ends, in this order; the first that has "
                      "happened counts and is taken there, up to a step late: behind an event the "
                      "error is that of order 1, whatever the method. Reactions are those at the "
                      "beginning of the step." +
                          begins,
                      "/// ");
}

/// The method, its step and what a step costs.
std::string stepper_doc(const program::Stepper& stepper) {
  const bool iterates = stepper.method == program::StepMethod::kSdirk2;
  const std::string where =
      stepper.switches() ? fmt::format(" in phase {}", stepper.phases.front().identifier) : "";
  const std::string with =
      iterates ? fmt::format(" with {} Newton steps a stage", program::kUsualNewtonSteps) : "";
  const std::string fails =
      iterates ? " Not a number where the iteration does not converge: the step is too long." : "";
  return signature_doc(stepper.signature) + events_doc(stepper) +
         wrapped(fmt::format("By {}, {} s.{} Cost{}{}: {}. Never more than {}.",
                             method_text(stepper.method), decimal(stepper.step), fails, where, with,
                             cost_text(program::step_cost(stepper)),
                             cost_text(program::worst_step_cost(stepper))),
                 "/// ");
}

std::vector<std::string> phase_identifiers(const std::vector<program::Stepper>& steppers) {
  std::vector<std::string> result;
  for (const program::Stepper& stepper : steppers) {
    for (const program::StepPhase& phase : stepper.phases) {
      if (stepper.switches()) {
        result.push_back(phase.identifier);
      }
    }
  }
  return result;
}

std::string prototype(const program::Signature& signature) {
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  return declaration("void " + signature.name, parameters(signature, all), " noexcept;") + "\n";
}

std::string declarations(const Unit& unit) {
  std::string result;
  for (const program::Function& function : unit.functions) {
    result += '\n' + function_doc(function) + prototype(function.signature);
  }
  for (const program::Staged& staged : unit.staged) {
    result += '\n' + staged_doc(staged) + prototype(staged.signature);
  }
  for (const program::Stepper& stepper : unit.steppers) {
    result += '\n' + stepper_doc(stepper) + prototype(stepper.signature);
  }
  return result;
}

bool is_plain(char c) {
  constexpr std::string_view kPlain = "_-.,:=/+%@";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kPlain.find(c) != std::string_view::npos;
}

/// `word` for a shell: as it is, in quotes, or with octal escapes if it holds anything that could
/// end a comment or a line.
std::string quoted(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
    return word;
  }
  const bool simple = std::all_of(word.begin(), word.end(),
                                  [](char c) { return is_plain(c) || c == ' ' || c == '('; });
  if (simple) {
    return "'" + word + "'";
  }
  std::string result = "$'";
  for (const char c : word) {
    result += is_plain(c) || c == ' ' ? std::string(1, c)
                                      : fmt::format("\\{:03o}", static_cast<std::uint8_t>(c));
  }
  return result + "'";
}

}  // namespace

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    line += quoted(word);
  }
  return line;
}

std::string command_comment(const std::vector<std::string>& command) {
  return wrapped(shell_line(command), "//   ", 4);
}

int father_coordinate(const model::Tree& tree, int k) {
  int link = link_of(tree, k).father;
  while (link != model::kGround) {
    const auto found = std::find(tree.coordinates.begin(), tree.coordinates.end(), link);
    if (found != tree.coordinates.end()) {
      return static_cast<int>(found - tree.coordinates.begin());
    }
    link = tree.links[static_cast<std::size_t>(link)].father;
  }
  return -1;
}

std::string header_text(const Unit& unit) {
  const model::Tree& tree = *unit.tree;
  return fill(template_text("model.hpp"),
              {{"name", unit.name},
               {"model", for_comment(tree.name, kLongestCell * 2)},
               {"command", command_comment(unit.command)},
               {"joints", joint_table(tree)},
               {"points", point_table(unit.points)},
               {"scalar", scalar_declaration(unit.target)},
               {"dof", std::to_string(tree.dof())},
               {"point_count", std::to_string(unit.points.size())},
               {"joint_indices", index_namespace("joint", joint_identifiers(tree))},
               {"point_indices", index_namespace("point", point_identifiers(unit.points))},
               {"phase_indices", index_namespace("phase", phase_identifiers(unit.steppers))},
               {"packing", packing_tables(unit)},
               {"arrays", arrays_comment(unit.target)},
               {"functions", declarations(unit)}});
}

}  // namespace treedyn::emit
