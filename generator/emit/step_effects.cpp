#include "emit/step_effects.hpp"

#include <fmt/format.h>

namespace treedyn::emit {

using program::Renewal;
using program::StepCause;
using program::StepEvent;
using program::StepOutcome;
using program::Stepper;
using program::StepPhase;

namespace {

const char* const kTime = "const Scalar t[1] = {motion.t[0] + now.at};";

class EffectWriter {
 public:
  EffectWriter(const Stepper& stepper, Scalar scalar)
      : stepper_(stepper), scalar_(scalar), dof_(stepper.signature.inputs.front().size) {}

  [[nodiscard]] Lines lines() const;

 private:
  [[nodiscard]] Lines event_lines(const StepPhase& phase, const StepEvent& event) const;
  [[nodiscard]] Lines sticking_lines(const StepEvent& event) const;
  [[nodiscard]] std::string ways_text(const std::string& qd) const;
  [[nodiscard]] Lines next_phase(const StepOutcome& outcome) const;
  [[nodiscard]] Lines renewal_lines(const std::vector<Renewal>& renewals) const;
  [[nodiscard]] Lines rest_lines(const StepPhase& phase, const StepEvent& event) const;
  [[nodiscard]] Lines plane_lines(const StepPhase& phase, const StepEvent& event) const;
  [[nodiscard]] std::string derived() const {
    return stepper_.takes_derived ? fmt::format(", {}", kDerivedOfMotion) : std::string();
  }
  [[nodiscard]] bool needs_time(const StepPhase& phase, const StepEvent& event) const;

  const Stepper& stepper_;
  Scalar scalar_;
  int dof_;
};

Lines EffectWriter::next_phase(const StepOutcome& outcome) const {
  if (!stepper_.switches()) {
    return {};
  }
  return {fmt::format("motion.which = phase::{};",
                      stepper_.phases[static_cast<std::size_t>(outcome.then)].identifier)};
}

Lines EffectWriter::renewal_lines(const std::vector<Renewal>& renewals) const {
  if (renewals.empty()) {
    return {};
  }
  Lines lines = {call(stepper_.anchors.front(), {"now.q", "", "t", ""}, "anchor")};
  for (const Renewal& renewal : renewals) {
    lines.push_back(fmt::format("for (int i = {}; i < {}; ++i) {{", renewal.first,
                                renewal.first + renewal.size));
    append(lines, {"  motion.anchor[i] = anchor[i];", "}"});
  }
  return lines;
}

/// Back to where the point met the plane: the part of its way since then that the rows oppose.
Lines EffectWriter::plane_lines(const StepPhase& phase, const StepEvent& event) const {
  Lines lines = {
      call(phase.guards.front(), {"now.q", "now.qd", "t", "now.lambda"}, "now.guard"),
      call(phase.approaches.front(), {"now.q", "now.qd", "", ""}, "approach"),
      fmt::format("const Scalar late = now.guard[{}] / approach[{}];", event.guard, event.approach),
      "if (late > Scalar(0) && late < h) {",
      "  Scalar way[kDof];",
      "  for (int i = 0; i < kDof; ++i) {",
      "    way[i] = late * now.qd[i];",
      "  }",
      fmt::format("  {}(now.q, way{}, qd_plus, P);", event.rest->impact, derived()),
      "  for (int i = 0; i < kDof; ++i) {",
      "    now.q[i] = now.q[i] + (qd_plus[i] - way[i]);",
      "  }",
      "}"};
  return lines;
}

/// A rebound is rest if it is slow or a step would take it back.
Lines EffectWriter::rest_lines(const StepPhase& phase, const StepEvent& event) const {
  const std::string speed = fmt::format("approach[{}]", event.approach);
  Lines lines = {
      fmt::format("Scalar approach[{}];", phase.approaches.front().signature.outputs[0].size),
      call(phase.approaches.front(), {"now.q", "qd_plus", "", ""}, "approach"),
      fmt::format("bool rests = {} < {};", speed, literal(event.rest_below, scalar_)),
      "if (!rests) {",
      "  Moment flight = now;",
      "  Moment ahead = {};",
      "  ahead.at = now.at + h;",
      "  for (int i = 0; i < kDof; ++i) {",
      "    flight.qd[i] = qd_plus[i];",
      "  }"};
  if (stepper_.sticking.empty()) {
    lines.emplace_back("  advance(motion, flight, ahead);");
  } else {
    append(lines,
           {"Motion free = motion;",
            fmt::format("free.which = motion.which{};", ways_text("flight.qd")),
            "advance(free, flight, ahead);"},
           "  ");
  }
  append(lines, {"  " + call(phase.approaches.front(), {"ahead.q", "ahead.qd", "", ""}, "approach"),
                 fmt::format("  rests = {} < Scalar(0);", speed), "}", "if (rests) {"});
  if (event.cause == StepCause::kFall) {
    append(lines, plane_lines(phase, event), "  ");
  }
  lines.push_back(
      fmt::format("  failed |= {}(now.q, now.qd{}, qd_plus, P);", event.rest->impact, derived()));
  append(lines, next_phase(*event.rest), "  ");
  append(lines, renewal_lines(event.rest->renewals), "  ");
  lines.emplace_back("}");
  return lines;
}

bool EffectWriter::needs_time(const StepPhase& phase, const StepEvent& event) const {
  const bool renews =
      !event.outcome.renewals.empty() || (event.rest && !event.rest->renewals.empty());
  return (renews && program::takes_time(stepper_.anchors.front())) ||
         (event.rest && event.cause == StepCause::kFall &&
          program::takes_time(phase.guards.front()));
}

/// Which joints stick or slip behind an event that is not one of them.
Lines EffectWriter::sticking_lines(const StepEvent& event) const {
  if (event.outcome.stops >= 0) {
    return {fmt::format("now.qd[{}] = Scalar(0);", event.outcome.stops)};
  }
  if (event.goes_on || stepper_.sticking.empty()) {
    return {};
  }
  return {fmt::format("motion.which = motion.which{};", ways_text("now.qd"))};
}

/// What joints that stick or slip add to the phase in which all of them stick.
std::string EffectWriter::ways_text(const std::string& qd) const {
  std::string ways;
  int place = 1;
  for (const int joint : stepper_.sticking) {
    ways +=
        fmt::format(" + {}way({}[{}])", place > 1 ? fmt::format("{} * ", place) : "", qd, joint);
    place *= 3;
  }
  return ways;
}

Lines EffectWriter::event_lines(const StepPhase& phase, const StepEvent& event) const {
  Lines lines = next_phase(event.outcome);
  append_if(lines, needs_time(phase, event), kTime);
  if (!event.outcome.renewals.empty() || (event.rest && !event.rest->renewals.empty())) {
    lines.push_back(
        fmt::format("Scalar anchor[{}];", stepper_.anchors.front().signature.outputs[0].size));
  }
  append(lines, renewal_lines(event.outcome.renewals));
  if (event.outcome.impact.empty()) {
    append(lines, sticking_lines(event));
    return lines;
  }
  lines.push_back(fmt::format("Scalar qd_plus[{}];", dof_));
  lines.push_back(fmt::format("Scalar P[{}];", event.outcome.impulses));
  lines.push_back(
      fmt::format("failed |= {}(now.q, now.qd{}, qd_plus, P);", event.outcome.impact, derived()));
  if (event.rest) {
    append(lines, rest_lines(phase, event));
  }
  append(lines, {"for (int i = 0; i < kDof; ++i) {", "  now.qd[i] = qd_plus[i];"});
  append_if(lines, stepper_.compensated, "  now.rest[kDof + i] = Scalar(0);");
  lines.emplace_back("}");
  append(lines, sticking_lines(event));
  return lines;
}

Lines EffectWriter::lines() const {
  Lines lines = {"int failed = 0;", "switch (event) {"};
  int number = 0;
  for (const StepPhase& phase : stepper_.phases) {
    for (const StepEvent& event : phase.events) {
      lines.push_back(fmt::format("  case {}: {{  {}", number, comment_of(event)));
      append(lines, event_lines(phase, event), "    ");
      append(lines, {"    break;", "  }"});
      ++number;
    }
  }
  append(lines, {"  default:", "    break;", "}", "return failed;"});
  return lines;
}

}  // namespace

Lines effect_lines(const Stepper& stepper, Scalar scalar) {
  return EffectWriter(stepper, scalar).lines();
}

}  // namespace treedyn::emit
