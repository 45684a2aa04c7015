#include "emit/step_text.hpp"

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/run_time.hpp"

namespace treedyn::emit {

namespace {

constexpr std::size_t kLongestBrief = 80;

}  // namespace

std::string derived_parameter() {
  return fmt::format("const {}& {}", kDerivedParameters, derived_array().name);
}

std::string call(const program::Staged& staged, const StateText& state, const std::string& result) {
  Lines arguments = {state.q};
  for (const auto& [name, text] :
       {std::pair("qd", &state.qd), std::pair("t", &state.t), std::pair("lambda", &state.lambda)}) {
    if (has(staged.signature.inputs, name)) {
      arguments.push_back(*text);
    }
  }
  append_if(arguments, has(staged.signature.inputs, derived_array().name), kDerivedOfMotion);
  arguments.push_back(result);
  return fmt::format("{}({});", staged.signature.name, fmt::join(arguments, ", "));
}

Lines by_phase(const program::Stepper& stepper, const std::string& which,
               const std::function<Lines(const program::StepPhase&)>& lines_of) {
  if (!stepper.switches()) {
    return lines_of(stepper.phases.front());
  }
  Lines lines = {fmt::format("switch ({}) {{", which)};
  for (const program::StepPhase& phase : stepper.phases) {
    const Lines inner = lines_of(phase);
    if (!inner.empty()) {
      lines.push_back(fmt::format("  case phase::{}: {{", phase.identifier));
      append(lines, inner, "    ");
      append(lines, {"    break;", "  }"});
    }
  }
  append(lines, {"  default:", "    break;", "}"});
  return lines;
}

int first_event_of(const program::Stepper& stepper, const program::StepPhase& phase) {
  std::size_t count = 0;
  for (const program::StepPhase& other : stepper.phases) {
    if (&other == &phase) {
      break;
    }
    count += other.events.size();
  }
  return static_cast<int>(count);
}

std::string comment_of(const program::StepEvent& event) {
  return "// " + for_comment(event.brief, kLongestBrief);
}

}  // namespace treedyn::emit
