#include "emit/source.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "emit/header.hpp"
#include "emit/length_unit.hpp"
#include "emit/limb_text.hpp"
#include "emit/parts.hpp"
#include "emit/self_test.hpp"
#include "emit/sincos.hpp"
#include "emit/staged_text.hpp"
#include "emit/step_function.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

constexpr const char* kOrderComment =
    ",\n// and would put statements into another order, which keeps more values on the stack";

/// A function, behind its parts; with a call of the function of its zeros, if there is one.
std::string plain_text(const program::Signature& signature, const Body& body) {
  WholeText text = whole_text(signature, signature.name, body);
  if (const ZerosText zeros = zeros_text(signature, body); !zeros.call.empty()) {
    text.lines.push_back(zeros.call);
    unite(text.used, body.zeros.uses);
  }
  return definition(text.parts, signature, text.used, text.lines);
}

bool raises_to_powers(const Unit& unit) {
  return std::ranges::any_of(
      unit.staged, [](const program::Staged& staged) { return program::worst_powers(staged) > 0; });
}

/// Some of its functions judge results.
bool tells_no_numbers(const Unit& unit) {
  return unit.self_test || !unit.checked.empty() || !unit.staged.empty() || !unit.steppers.empty();
}

/// Where sin, cos and sqrt come from.
std::string mathematics(const Unit& unit, const std::string& functions) {
  const program::Cost total = total_cost(unit);
  const bool library = unit.target.takes_libm();
  std::string result;
  result += library && total.cos > 0 ? "using std::cos;\n" : "";
  result += raises_to_powers(unit) ? "using std::pow;\n" : "";
  result += library && total.sin > 0 ? "using std::sin;\n" : "";
  result += total.sqrt > 0 ? "using std::sqrt;\n" : "";
  result = result.empty() ? result : '\n' + result;
  result += tells_no_numbers(unit) ? fmt::format("\n{}", template_text("finite_math.cpp")) : "";
  const bool numbers = std::ranges::any_of(unit.functions, [&](const program::Function& function) {
    const program::Cost cost = program::cost(function);
    return cost.sin + cost.cos > 0 && !has_angles_of_limbs_alone(function, unit.target);
  });
  const bool others = !unit.checked.empty() || !unit.staged.empty() || !unit.steppers.empty();
  if (has_sincos(unit)) {
    result += sincos_text(unit.target, functions, numbers || others);
  } else if (std::ranges::any_of(unit.steppers, &program::Stepper::compensated)) {
    result += '\n' + order_of_sums(unit.target.scalar,
                                   "a compensated state is what sums round away: not for "
                                   "-ffast-math or x87; --state plain is");
    result.pop_back();  // functions begin with an empty line
  }
  return result + limb_vectors(unit.functions, unit.target, functions);
}

/// The zeros of functions that have many, in functions that stand before what tells g++ not to
/// store neighbours at once.
std::string zeros_of(const Unit& unit, const std::vector<Body>& bodies) {
  std::string functions;
  for (std::size_t k = 0; k < unit.functions.size(); ++k) {
    const std::string zeros = zeros_text(unit.functions[k].signature, bodies[k]).function;
    functions += zeros.empty() ? "" : '\n' + zeros;
  }
  return functions.empty()
             ? ""
             : fmt::format(
                   "\n// Zeros, where compilers may store neighbours at once.\nnamespace "
                   "{{\n{}\n}}  // namespace\n",
                   functions);
}

constexpr const char* kLiterals =
    "static_assert(sizeof(1.0) == sizeof(double), \"not for -fsingle-precision-constant\");";

/// <cmath>, for what is used of it: the functions above, and what scene functions take.
std::string includes(const Unit& unit) {
  const bool scene = !unit.staged.empty() || !unit.steppers.empty();
  const program::Cost total = total_cost(unit);
  const bool trigonometric = unit.target.takes_libm() && total.sin + total.cos > 0;
  std::string result = scene || trigonometric || total.sqrt > 0 ? "#include <cmath>\n" : "";
  return result.empty() ? result : result + '\n';
}

}  // namespace

std::string source_text(const Unit& unit, const std::vector<Body>& bodies,
                        const Vocabulary& words) {
  std::string functions;
  for (std::size_t k = 0; k < unit.functions.size(); ++k) {
    functions += "\n" + unit_comment(unit.functions[k], *unit.tree);
    if (unit.functions[k].limb_code) {
      Target target = unit.target;
      target.zeros_apart = !bodies[k].zeros.lines.empty();
      functions += limb_text(unit.functions[k], words, target);
      continue;
    }
    functions += plain_text(unit.functions[k].signature, bodies[k]);
  }
  functions += unit.self_test ? self_test_text(unit) : "";
  if (!unit.checked.empty() || !unit.staged.empty()) {
    functions += check_text(unit.target);
  }
  const std::size_t plain = unit.functions.size();
  for (std::size_t k = 0; k < unit.checked.size(); ++k) {
    functions += '\n' + checked_text(unit.checked[k], bodies[plain + k], unit.target);
  }
  const std::vector<Body> staged(
      bodies.begin() + static_cast<std::ptrdiff_t>(plain + unit.checked.size()), bodies.end());
  functions += staged_text(unit.staged, staged, words, unit.target);
  for (const program::Stepper& stepper : unit.steppers) {
    functions += '\n' + stepper_text(stepper, words, unit.target);
  }
  const std::string constants =
      words.constants ? words.constants->table(words, unit.target.scalar) : "";
  const bool in_order = unit.processor && unit.processor->in_order;
  const bool wide = unit.target.scalar == Scalar::kDouble;
  return fill(template_text("model.cpp"), {{"name", unit.name},
                                           {"space", unit.space()},
                                           {"command", command_comment(unit.command)},
                                           {"digest", kNoDigest},
                                           {"includes", includes(unit)},
                                           {"literals", wide ? kLiterals : ""},
                                           {"zeros", zeros_of(unit, bodies)},
                                           {"order_comment", in_order ? kOrderComment : ""},
                                           {"order", in_order ? ", \"no-schedule-insns\"" : ""},
                                           {"using", mathematics(unit, functions)},
                                           {"constants", constants},
                                           {"functions", functions}});
}

}  // namespace treedyn::emit
