#include "emit/source.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "emit/header.hpp"
#include "emit/layout.hpp"
#include "emit/limb_text.hpp"
#include "emit/parts.hpp"
#include "emit/sincos.hpp"
#include "emit/staged.hpp"
#include "emit/stepper.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

std::string whole_function(const program::Signature& signature, const Part& part) {
  return declaration("void " + signature.name, parameters(signature, part.uses), " noexcept {") +
         block(part.lines);
}

/// A function in parts: a workspace, the parts, and the function that calls them in order.
std::string split_function(const program::Signature& signature, const Body& body) {
  const SplitText text = split_text(signature, body);
  std::vector<std::string> calls = text.calls;
  if (!text.declaration.empty()) {
    calls.insert(calls.begin(), text.declaration);
  }
  return "namespace {\n" + text.parts + "\n}  // namespace\n\n" +
         declaration("void " + signature.name, parameters(signature, text.used), " noexcept {") +
         block(calls);
}

/// Where sin, cos and sqrt come from.
std::string mathematics(const Unit& unit) {
  program::Cost total;
  for (const program::Function& function : unit.functions) {
    const program::Cost cost = program::cost(function);
    total.cos += cost.cos;
    total.sin += cost.sin;
    total.sqrt += cost.sqrt;
  }
  for (const program::Staged& staged : unit.staged) {
    total = total + program::worst_cost(staged);
  }
  for (const program::Stepper& stepper : unit.steppers) {
    total = total + program::worst_step_cost(stepper);
  }
  std::string result;
  const bool library = !unit.target.builtin_sincos && unit.target.lanes == 1;
  result += library && total.cos > 0 ? "using std::cos;\n" : "";
  const bool raises =
      std::any_of(unit.staged.begin(), unit.staged.end(),
                  [](const program::Staged& staged) { return program::worst_powers(staged) > 0; });
  result += raises ? "using std::pow;\n" : "";
  result += library && total.sin > 0 ? "using std::sin;\n" : "";
  result += total.sqrt > 0 ? "using std::sqrt;\n" : "";
  result = result.empty() ? result : '\n' + result;
  return !library && total.sin + total.cos > 0 ? result + sincos_text(unit.target) : result;
}

}  // namespace

std::string source_text(const Unit& unit, const std::vector<Body>& bodies) {
  std::string functions;
  for (std::size_t k = 0; k < unit.functions.size(); ++k) {
    const program::Signature& signature = unit.functions[k].signature;
    functions += "\n";
    if (unit.functions[k].limb_code) {
      functions += limb_text(unit.functions[k], vocabulary(*unit.tree), unit.target);
      continue;
    }
    functions += bodies[k].parts.size() == 1 ? whole_function(signature, bodies[k].parts.front())
                                             : split_function(signature, bodies[k]);
  }
  const std::vector<Body> staged(
      bodies.begin() + static_cast<std::ptrdiff_t>(unit.functions.size()), bodies.end());
  const Vocabulary words = vocabulary(*unit.tree);
  functions += staged_text(unit.staged, staged, words, unit.target);
  for (const program::Stepper& stepper : unit.steppers) {
    functions += '\n' + stepper_text(stepper, words, unit.target);
  }
  return fill(template_text("model.cpp"), {{"name", unit.name},
                                           {"command", command_comment(unit.command)},
                                           {"digest", kNoDigest},
                                           {"using", mathematics(unit)},
                                           {"functions", functions}});
}

}  // namespace treedyn::emit
