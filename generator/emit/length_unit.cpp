#include "emit/length_unit.hpp"

#include <set>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/literal.hpp"
#include "emit/names.hpp"

namespace treedyn::emit {

namespace {

constexpr std::size_t kLongestJointName = 60;

std::set<std::string> symbols_of(const program::Function& function) {
  std::set<std::string> symbols;
  for (const program::Ref k : program::reachable(function.graph, function.outputs)) {
    for (const program::Ref value : {k, -k}) {
      const char* const symbol = function.graph.hint(value).symbol;
      symbols.insert(symbol == nullptr ? "" : symbol);
    }
  }
  return symbols;
}

std::string joint_name(const model::Tree& tree, int link) {
  return link == model::kGround ? std::string("the base")
                                : for_comment(tree.links[static_cast<std::size_t>(link)].joint.name,
                                              kLongestJointName);
}

}  // namespace

// Angles, their speeds and accelerations (omega, alpha, Omega), moments (M, u) and inertias (I, E)
// know no length, as those of joints are masses times squared lengths and keep their unit.
std::string unit_in(const std::string& symbol) {
  return symbol == "s"                       ? "L"
         : symbol == "a" || symbol == "zeta" ? "L/s^2"
         : symbol == "F"                     ? "N m/L"
         : symbol == "h"                     ? "kg m^2/L"
                                             : "";
}

std::string unit_comment(const program::Function& function, const model::Tree& tree) {
  if (function.unit.link < 0) {
    return {};
  }
  const model::Link& link = tree.links[static_cast<std::size_t>(function.unit.link)];
  std::string named;
  for (const std::string& symbol : symbols_of(function)) {
    if (const std::string unit = unit_in(symbol); !unit.empty()) {
      named += fmt::format("{}{}_ in {}", named.empty() ? "vectors " : ", ", symbol, unit);
    }
  }
  return wrapped(fmt::format("Lengths inside are in units of L, a distance between {} and {}:",
                             joint_name(tree, link.father), joint_name(tree, function.unit.link)),
                 "// ") +
         fmt::format("//   L = {} m\n", literal(function.unit.metres, Scalar::kDouble)) +
         wrapped(fmt::format("Names: {}{}all others are of values in SI units; numbered ones (t_) "
                             "by what they are made of. Arguments and results are in SI units.",
                             named, named.empty() ? "" : "; "),
                 "// ");
}

std::string unit_json(const program::Function& function) {
  return function.unit.link < 0
             ? std::string()
             : fmt::format(",\n     \"unit_of_length\": {}", decimal(function.unit.metres));
}

}  // namespace treedyn::emit
