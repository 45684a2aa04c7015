#include "emit/header.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "emit/doc.hpp"
#include "emit/layout.hpp"
#include "emit/names.hpp"
#include "emit/run_time.hpp"
#include "emit/self_test.hpp"
#include "emit/shell.hpp"
#include "emit/sincos.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

std::string joint_table(const model::Tree& tree) {
  std::vector<std::vector<std::string>> rows = {{"joint", "link", "index", "type", "unit"}};
  for (int k = 0; k < tree.dof(); ++k) {
    const model::Link& link = tree.moved_by(k);
    const bool revolute = link.joint.turns();
    rows.push_back({for_comment(link.joint.name, kLongestCell),
                    for_comment(link.name, kLongestCell), std::to_string(k),
                    revolute ? "revolute" : "prismatic", revolute ? "rad" : "m"});
  }
  return table(rows, "// ");
}

/// The joints that have no element of q; empty without such.
std::string mimic_table(const model::Tree& tree) {
  std::vector<std::vector<std::string>> rows = {{"mimic joint", "is at (rad or m)"}};
  for (int i = 0; i < tree.size(); ++i) {
    const model::Drive& drive = tree.drives[static_cast<std::size_t>(i)];
    if (tree.is_mimic(i)) {
      rows.push_back({for_comment(tree.links[static_cast<std::size_t>(i)].joint.name, kLongestCell),
                      fmt::format("{:.6g} q[{}] {} {:.6g}", drive.multiplier.convert_to<double>(),
                                  drive.coordinate, drive.offset < 0 ? "-" : "+",
                                  abs(drive.offset).convert_to<double>())});
    }
  }
  return rows.size() == 1 ? "" : "//\n" + table(rows, "// ");
}

std::string point_table(const model::Tree& tree, const std::vector<model::Point>& points) {
  if (points.empty()) {
    return {};
  }
  std::vector<std::vector<std::string>> rows = {{"point", "link", "index", "at (link frame, m)"}};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const model::Point& point = points[k];
    const model::Vector3 at = model::place_in_frame(tree, point);
    rows.push_back({for_comment(point.name, kLongestCell),
                    for_comment(point.link_name, kLongestCell), std::to_string(k),
                    fmt::format("{:.6g}, {:.6g}, {:.6g}", at[0].convert_to<double>(),
                                at[1].convert_to<double>(), at[2].convert_to<double>())});
  }
  return "//\n" + table(rows, "// ");
}

/// `constexpr int name = value;`, broken where clang-format breaks what is too long.
std::string index_constant(const std::string& name, std::size_t value) {
  const std::size_t type = std::string_view("constexpr int ").size();
  const std::size_t number = std::to_string(value).size() + 1;
  const bool fits = type + name.size() + 3 + number <= kColumns;
  const bool breaks_after_type = type + name.size() + 2 > kColumns;
  const bool breaks_after_equal =
      !fits && (!breaks_after_type || name.size() + 7 + number > kColumns);
  return fmt::format("constexpr int{}{} ={}{};\n", breaks_after_type ? "\n    " : " ", name,
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
    result.push_back(tree.moved_by(k).joint.identifier);
  }
  return result;
}

std::vector<std::string> point_identifiers(const std::vector<model::Point>& points) {
  return transformed(points, &model::Point::identifier);
}

std::string scalar_declaration(const Target& target) {
  const std::string type = type_name(target.scalar);
  if (target.lanes == 1) {
    return fmt::format("/// The only floating-point type in use.\nusing Scalar = {};\n", type);
  }
  return fmt::format(
      "/// States that are computed at once.\n"
      "constexpr int kLanes = {0};\n"
      "/// One value of every state, the only floating-point type in use: value[lane] is that of a "
      "state.\n"
      "/// For a processor with vectors of this size (-march), or with -Wno-psabi.\n"
      "using Scalar [[gnu::vector_size(kLanes * sizeof({1}))]] = {1};\n",
      target.lanes, type);
}

/// `constexpr int name[] = {...};`, as many numbers a line as fit.
std::string index_table(const std::string& name, const std::vector<int>& values) {
  std::string result = fmt::format("constexpr int {}[{}] = {{", name, values.size());
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

/// Where the values of packed matrices belong; nothing if all are dense.
std::string packing_tables(const Unit& unit) {
  std::string result;
  for (const PackedMatrix& matrix : unit.packed) {
    const std::string& name = matrix.constants;
    const char* const zeros =
        matrix.packing.is_zero
            ? "all entries are zero in every state, one is kept, as arrays have at least one"
            : "other entries are zero in every state";
    result += "\n" +
              wrapped(fmt::format("Value k of {} is entry ({}Row[k], {}Column[k]){}; {}.",
                                  matrix.what, name, name,
                                  matrix.packing.mirrored ? " and its mirror image" : "", zeros),
                      "/// ") +
              fmt::format("constexpr int {}Nonzeros = {};\n", name, matrix.packing.size()) +
              index_table(name + "Row", matrix.packing.row) +
              index_table(name + "Column", matrix.packing.column);
  }
  return result;
}

/// " The base frame is the ground's; gravity in it is 0, 0, -9.81 m/s^2."
std::string base_text(const Unit& unit) {
  const auto& g = unit.gravity;
  const bool given = std::ranges::any_of(unit.tree->parameters, [](const model::Parameter& p) {
    return p.quantity == model::ParameterKind::kGravity;
  });
  const std::string pulls = given ? "; gravity in it is an argument"
                            : g == model::Vector3{}
                                ? ""
                                : fmt::format("; gravity in it is {}, {}, {} m/s^2", decimal(g[0]),
                                              decimal(g[1]), decimal(g[2]));
  return fmt::format(" The base frame is the ground's{}.", pulls);
}

std::string arrays_comment(const Unit& unit) {
  const bool reacts = !unit.staged.empty();
  const char* const packed = unit.packed.empty() ? "" : ", but for those with tables of places";
  return wrapped(
      fmt::format("Arrays are dense{}, matrices row-major; SI units and radians, a|b by joints "
                  "that are revolute|prismatic{}.{} Equations have the numbers of treedyn's "
                  "EQUATIONS.md. Outputs are written completely and must not overlap inputs. "
                  "Nothing is allocated, thrown or kept between calls.{}",
                  packed, reacts ? ", by reactions that are forces|moments" : "", base_text(unit),
                  has_sincos(unit) ? " " + sincos_comment(unit.target) : ""),
      "// ");
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

/// What functions that return a status return.
std::string status_bits(const Unit& unit) {
  if (unit.checked.empty() && unit.staged.empty() && unit.steppers.empty()) {
    return {};
  }
  const bool checked = !unit.checked.empty();
  const bool pivots =
      checked || std::ranges::any_of(unit.staged, [](const program::Staged& staged) {
        return !staged.pivots.empty();
      });
  return fmt::format(
      R"(
/// Bits of the int that functions return; 0: all is right.
namespace status {{
/// Rows depend on each other more than they do where the constraints hold: a singular position.
{}constexpr int rank_lost = 1;
/// A row's wanted acceleration (or velocity, or joint force) cannot be had beside the others', or
/// more rows are independent than where the scene's rows hold.
constexpr int row_given_up = 2;
/// An iteration did not get there.
constexpr int no_convergence = 4;
/// An event may have been passed over.
constexpr int event_missed = 8;
/// A result{} is infinite or not a number.
constexpr int not_a_number = 16;
/// What an event waits for is not a number.
constexpr int guard_undefined = 32;
/// An event was taken at the end of the step in which it happened: `cuts` is 0.
constexpr int event_late = 64;
/// Beside a position without accelerations a joint turned by more than half a radian at once.
constexpr int turned_far = 128;
}}  // namespace status
)",
      pivots ? "/// Or a pivot of A is not above zero, or all its digits are lost.\n" : "",
      checked ? ", or an argument of a checked function," : "");
}

/// "/// About 4400 cycles on a Cortex-M4F."; nothing if the files are for any processor.
std::string cycles_doc(const Unit& unit, const program::Signature& signature) {
  if (!unit.processor) {
    return "";
  }
  const auto found = std::ranges::find(unit.processor->cycles, signature.name,
                                       &std::pair<std::string, double>::first);
  return found == unit.processor->cycles.end()
             ? ""
             : wrapped(fmt::format("About {} cycles on a {}.", cycles_text(found->second),
                                   unit.processor->brief),
                       "/// ");
}

/// How to compile the files; nothing if they are for any processor.
std::string processor_comment(const Unit& unit) {
  return unit.processor
             ? wrapped(fmt::format("For a {}: {}", unit.processor->brief, unit.processor->flags),
                       "// ", 4)
             : "";
}

std::string declarations(const Unit& unit) {
  std::string result;
  const auto add = [&](const auto& function) {
    result += '\n' + doc(function) + cycles_doc(unit, function.signature) +
              declaration(function.signature, " noexcept;") + "\n";
  };
  std::ranges::for_each(unit.functions, add);
  result += unit.self_test ? self_test_declaration(unit) : "";
  std::ranges::for_each(unit.checked, add);
  std::ranges::for_each(unit.staged, add);
  std::ranges::for_each(unit.steppers, add);
  return result;
}

/// The length of a step, without line feed.
std::string step_constant(const Unit& unit) {
  return unit.steppers.empty()
             ? ""
             : fmt::format("/// Time that `step` takes, s.\nconstexpr {} kStep = {};",
                           type_name(unit.target.scalar),
                           literal(unit.steppers.front().step, unit.target.scalar));
}

}  // namespace

std::string command_comment(const std::vector<std::string>& command) {
  return wrapped(shell_comment(command), "//   ", 4);
}

int father_coordinate(const model::Tree& tree, int k) {
  int link = tree.moved_by(k).father;
  while (link != model::kGround && tree.drives[static_cast<std::size_t>(link)].coordinate == k) {
    link = tree.links[static_cast<std::size_t>(link)].father;
  }
  return link == model::kGround ? -1 : tree.drives[static_cast<std::size_t>(link)].coordinate;
}

std::string header_text(const Unit& unit) {
  const model::Tree& tree = *unit.tree;
  return fill(template_text("model.hpp"),
              {{"name", unit.name},
               {"space", unit.space()},
               {"model", for_comment(tree.name, kLongestCell * 2)},
               {"command", command_comment(unit.command) + processor_comment(unit)},
               {"joints", joint_table(tree) + mimic_table(tree)},
               {"points", point_table(*unit.tree, unit.points)},
               {"scalar", scalar_declaration(unit.target)},
               {"dof", std::to_string(tree.dof())},
               {"point_count", std::to_string(unit.points.size())},
               {"step", step_constant(unit)},
               {"digest", kNoDigest},
               {"joint_indices", index_namespace("joint", joint_identifiers(tree))},
               {"point_indices", index_namespace("point", point_identifiers(unit.points))},
               {"phase_indices", index_namespace("phase", phase_identifiers(unit.steppers))},
               {"status", status_bits(unit)},
               {"packing", packing_tables(unit) + parameter_types(unit)},
               {"arrays", arrays_comment(unit)},
               {"functions", declarations(unit)}});
}

}  // namespace treedyn::emit
