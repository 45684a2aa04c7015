#include "emit/step_function.hpp"

#include <vector>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/parts.hpp"
#include "emit/staged_text.hpp"
#include "emit/step_events.hpp"
#include "emit/step_integrate.hpp"
#include "emit/step_text.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::Stepper;
using program::StepPhase;

namespace {

/// The dynamics of one phase: the call, and zeros for the reactions that it does not have.
std::vector<std::string> dynamics_lines(const Stepper& stepper, const StepPhase& phase) {
  std::vector<std::string> arguments = {"q", "qd", "tau"};
  append_if(arguments, phase.takes_time, "t");
  append_if(arguments, phase.takes_anchor, "anchor");
  append_if(arguments, stepper.takes_derived, "derived");
  arguments.emplace_back("qdd");
  append_if(arguments, phase.rows > 0, "lambda");
  std::vector<std::string> lines = {
      call_text("const int failed = " + phase.dynamics, arguments, 4)};
  for (int k = phase.rows; k < stepper.rows; ++k) {
    lines.push_back(fmt::format("lambda[{}] = Scalar(0);", k));
  }
  return lines;
}

/// Calls the dynamics of the phase that acts, of no other.
std::string dispatch(const Stepper& stepper) {
  const int n = stepper.signature.inputs.front().size;
  std::vector<std::string> parameters = {"int which", fmt::format("const Scalar q[{}]", n),
                                         fmt::format("const Scalar qd[{}]", n),
                                         fmt::format("const Scalar tau[{}]", n)};
  for (const program::Array& array : stepper.signature.inputs) {
    const bool is_time = array.name == "t";
    if (is_time || array.name == "anchor") {
      const bool used = std::ranges::any_of(stepper.phases, [&](const StepPhase& phase) {
        return is_time ? phase.takes_time : phase.takes_anchor;
      });
      parameters.push_back(fmt::format("const Scalar {}{}{}[{}]", used ? "" : "/*", array.name,
                                       used ? "" : "*/", array.size));
    }
  }
  append_if(parameters, stepper.takes_derived, derived_parameter());
  parameters.push_back(fmt::format("Scalar qdd[{}]", n));
  append_if(parameters, stepper.rows > 0, fmt::format("Scalar lambda[{}]", stepper.rows));
  std::vector<std::string> lines = {"switch (which) {"};
  for (const StepPhase& phase : stepper.phases) {
    lines.push_back(fmt::format("  case phase::{}: {{", phase.identifier));
    append(lines, dynamics_lines(stepper, phase), "    ");
    append(lines, {"    return failed;", "  }"});
  }
  append(lines, {"  default:", "    break;", "}", "const Scalar none = Scalar(0) / (q[0] - q[0]);",
                 fmt::format("for (int i = 0; i < {}; ++i) {{", n), "  qdd[i] = none;", "}"});
  if (stepper.rows > 0) {
    append(lines, {fmt::format("for (int i = 0; i < {}; ++i) {{", stepper.rows),
                   "  lambda[i] = none;", "}"});
  }
  lines.emplace_back("return status::not_a_number;");
  return "\n/// Accelerations and reactions in a phase; not a number in none.\n" +
         declaration("int dynamics_in", parameters, " noexcept {") + block(lines);
}

/// What only `step` calls.
std::string local_text(const Stepper& stepper, const Vocabulary& words, const Target& target) {
  std::string result;
  for (const StepPhase& phase : stepper.phases) {
    result += local_functions(phase.guards, words, target);
    result += local_functions(phase.approaches, words, target);
  }
  result += local_functions(stepper.anchors, words, target);
  result += stepper.switches() ? dispatch(stepper) : "";
  if (stepper.compensated) {
    result += template_text("step_add.cpp");
  }
  if (stepper.method == StepMethod::kSdirk2) {
    result += sdirk2_stages(stepper, target.scalar);
  }
  if (stepper.any_length()) {
    result += "\n/// One step of length h of a phase.\n" +
              integration(stepper, Form::kIntegrate, target.scalar);
  }
  if (!stepper.turning.empty()) {
    result += parts_text(stepper, target.scalar);
  }
  if (stepper.ends()) {
    result += event_functions(stepper, target.scalar);
  }
  return result.empty() ? result : "namespace {\n" + result + "\n}  // namespace\n\n";
}

}  // namespace

std::string stepper_text(const Stepper& stepper, const Vocabulary& words, const Target& target) {
  const std::string told =
      stepper.tells ? "extern \"C\" void treedyn_event(int event, double at);\n\n" : "";
  return told + local_text(stepper, words, target) +
         (stepper.ends()         ? turns_text(stepper)
          : stepper.any_length() ? step_of_parts(stepper, target.scalar)
                                 : integration(stepper, Form::kStep, target.scalar));
}

}  // namespace treedyn::emit
