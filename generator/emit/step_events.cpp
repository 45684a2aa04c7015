#include "emit/step_events.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "emit/layout.hpp"

namespace treedyn::emit {

using program::Renewal;
using program::Staged;
using program::StepEvent;
using program::StepOutcome;
using program::Stepper;
using program::StepPhase;

namespace {

using Lines = std::vector<std::string>;

void append(Lines& lines, const Lines& more, const std::string& indentation = "") {
  for (const std::string& line : more) {
    lines.push_back(indentation + line);
  }
}

bool has_input(const Staged& staged, const std::string& name) {
  return std::any_of(staged.signature.inputs.begin(), staged.signature.inputs.end(),
                     [&](const program::Array& array) { return array.name == name; });
}

/// The text of the events of one scene.
class EventWriter {
 public:
  EventWriter(const Stepper& stepper, Scalar scalar)
      : stepper_(stepper),
        scalar_(scalar),
        dof_(stepper.signature.inputs.front().size),
        counts_(stepper.counted > 0) {}

  [[nodiscard]] Lines lines() const;

 private:
  /// A call of a local function at the end of the step, or at its beginning.
  [[nodiscard]] std::string call(const Staged& staged, const std::string& q, const std::string& qd,
                                 const std::string& t, const std::string& result) const;
  [[nodiscard]] Lines phase_lines(const StepPhase& phase) const;
  [[nodiscard]] Lines event_lines(const StepPhase& phase, const StepEvent& event) const;
  [[nodiscard]] Lines effect_lines(const StepPhase& phase, const StepEvent& event) const;
  [[nodiscard]] Lines next_phase(const StepOutcome& outcome) const;
  [[nodiscard]] Lines strike(const StepOutcome& outcome) const;
  [[nodiscard]] static Lines renewal_lines(const std::vector<Renewal>& renewals);
  [[nodiscard]] std::string t_next() const { return stepper_.needs_end_time() ? "t_next" : ""; }

  const Stepper& stepper_;
  Scalar scalar_;
  int dof_;
  bool counts_;
};

std::string EventWriter::call(const Staged& staged, const std::string& q, const std::string& qd,
                              const std::string& t, const std::string& result) const {
  std::vector<std::string> arguments = {q};
  if (!qd.empty()) {
    arguments.push_back(qd);
  }
  if (has_input(staged, "t")) {
    arguments.push_back(t);
  }
  if (has_input(staged, "lambda")) {
    arguments.emplace_back("lambda");
  }
  arguments.push_back(result);
  return fmt::format("{}({});", staged.signature.name, fmt::join(arguments, ", "));
}

Lines EventWriter::next_phase(const StepOutcome& outcome) const {
  Lines lines;
  if (stepper_.switches()) {
    lines.push_back(
        fmt::format("phase_next[0] = phase::{};",
                    stepper_.phases[static_cast<std::size_t>(outcome.then)].identifier));
  }
  return lines;
}

Lines EventWriter::strike(const StepOutcome& outcome) const {
  return {fmt::format("failed |= {}(q_next, qd_next, qd_plus, P);", outcome.impact)};
}

Lines EventWriter::renewal_lines(const std::vector<Renewal>& renewals) {
  Lines lines;
  for (const Renewal& renewal : renewals) {
    lines.push_back(fmt::format("for (int i = {}; i < {}; ++i) {{", renewal.first,
                                renewal.first + renewal.size));
    lines.emplace_back("  anchor_next[i] = anchor_now[i];");
    lines.emplace_back("}");
  }
  return lines;
}

/// The impact, the next phase and its anchors.
Lines EventWriter::effect_lines(const StepPhase& phase, const StepEvent& event) const {
  Lines lines = next_phase(event.outcome);
  if (counts_) {
    lines.emplace_back("steps_next[0] = 0;");
  }
  const bool renews =
      !event.outcome.renewals.empty() || (event.rest && !event.rest->renewals.empty());
  if (renews) {
    const Staged& anchors = stepper_.anchors.front();
    lines.push_back(fmt::format("Scalar anchor_now[{}];", anchors.signature.outputs[0].size));
    lines.push_back(call(anchors, "q_next", "", "t_next", "anchor_now"));
    append(lines, renewal_lines(event.outcome.renewals));
  }
  if (!event.outcome.impact.empty()) {
    lines.push_back(fmt::format("Scalar qd_plus[{}];", dof_));
    lines.push_back(fmt::format("Scalar P[{}];", event.outcome.impulses));
    append(lines, strike(event.outcome));
  }
  if (event.rest) {
    lines.push_back(call(phase.approaches.front(), "q_next", "qd_plus", "", "approach"));
    lines.push_back(fmt::format("if (approach[{}] < {}) {{", event.approach,
                                literal(event.rest_below, scalar_)));
    append(lines, strike(*event.rest), "  ");
    append(lines, next_phase(*event.rest), "  ");
    append(lines, renewal_lines(event.rest->renewals), "  ");
    lines.emplace_back("}");
  }
  if (!event.outcome.impact.empty()) {
    append(lines, {"for (int i = 0; i < kDof; ++i) {", "  qd_next[i] = qd_plus[i];", "}"});
  }
  lines.emplace_back("return failed | check(q_next, kDof) | check(qd_next, kDof);");
  return lines;
}

/// Conditions from the cheapest to the dearest.
Lines EventWriter::event_lines(const StepPhase& phase, const StepEvent& event) const {
  std::vector<std::string> conditions;
  if (event.not_before > 0) {
    conditions.push_back(fmt::format("steps_next[0] >= {}", event.not_before));
  }
  if (event.guard >= 0) {
    conditions.push_back(fmt::format("guard[{}] < Scalar(0)", event.guard));
  }
  Lines inner;
  if (event.approach >= 0 && event.crosses) {  // for the rest behind the impact
    const int size = phase.approaches.front().signature.outputs[0].size;
    inner.push_back(fmt::format("Scalar approach[{}];", size));
  }
  append(inner, effect_lines(phase, event));
  const auto wrap = [&](const Lines& before, const std::string& condition) {
    Lines lines = before;
    lines.push_back(fmt::format("if ({}) {{", condition));
    append(lines, inner, "  ");
    lines.emplace_back("}");
    inner = lines;
  };
  if (event.approach >= 0 && !event.crosses) {
    wrap({fmt::format("Scalar approach[{}];", phase.approaches.front().signature.outputs[0].size),
          call(phase.approaches.front(), "q_next", "qd_next", "", "approach")},
         fmt::format("approach[{}] < Scalar(0)", event.approach));
  }
  if (event.crosses) {
    wrap({fmt::format("Scalar before[{}];", phase.guards.front().signature.outputs[0].size),
          call(phase.guards.front(), "q", "qd", "t", "before")},
         fmt::format("!(before[{}] < Scalar(0))", event.guard));
  }
  wrap({}, fmt::format("{}", fmt::join(conditions, " && ")));
  return inner;
}

Lines EventWriter::phase_lines(const StepPhase& phase) const {
  Lines lines;
  if (!phase.guards.empty()) {
    const Staged& guards = phase.guards.front();
    lines.push_back(fmt::format("Scalar guard[{}];", guards.signature.outputs[0].size));
    lines.push_back(call(guards, "q_next", "qd_next", t_next(), "guard"));
  }
  for (const StepEvent& event : phase.events) {
    append(lines, event_lines(phase, event));
  }
  return lines;
}

Lines EventWriter::lines() const {
  Lines lines;
  if (stepper_.needs_end_time()) {
    lines.push_back(
        fmt::format("const Scalar t_next[1] = {{t[0] + {}}};", literal(stepper_.step, scalar_)));
  }
  if (counts_) {
    lines.push_back(
        fmt::format("steps_next[0] = steps[0] < {0} ? steps[0] + 1 : {0};", stepper_.counted));
  }
  if (!stepper_.anchors.empty()) {
    lines.push_back(fmt::format("for (int i = 0; i < {}; ++i) {{",
                                stepper_.anchors.front().signature.outputs[0].size));
    append(lines, {"  anchor_next[i] = anchor[i];", "}"});
  }
  if (!stepper_.switches()) {
    append(lines, phase_lines(stepper_.phases.front()));
    return lines;
  }
  append(lines, {"phase_next[0] = phase[0];", "switch (phase[0]) {"});
  for (const StepPhase& phase : stepper_.phases) {
    if (!phase.events.empty()) {
      lines.push_back(fmt::format("  case phase::{}: {{", phase.identifier));
      append(lines, phase_lines(phase), "    ");
      append(lines, {"    break;", "  }"});
    }
  }
  append(lines, {"  default:", "    break;", "}"});
  return lines;
}

}  // namespace

std::string events_text(const Stepper& stepper, Scalar scalar) {
  const bool ends = std::any_of(stepper.phases.begin(), stepper.phases.end(),
                                [](const StepPhase& phase) { return !phase.events.empty(); });
  std::string result;
  const Lines lines = ends ? EventWriter(stepper, scalar).lines() : Lines{};
  for (const std::string& line : lines) {
    result += (result.empty() ? "  " : "\n  ") + line;
  }
  return result;
}

}  // namespace treedyn::emit
