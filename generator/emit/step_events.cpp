#include "emit/step_events.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "emit/layout.hpp"
#include "emit/run_time.hpp"
#include "emit/step_effects.hpp"
#include "emit/step_search.hpp"
#include "emit/step_text.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::Lasting;
using program::StepCause;
using program::StepEvent;
using program::Stepper;
using program::StepPhase;

namespace {

/// The text of what ends the phases of one scene.
class EventWriter {
 public:
  EventWriter(const Stepper& stepper, Scalar scalar)
      : stepper_(stepper), scalar_(scalar), guards_(stepper.most_guards()) {}

  [[nodiscard]] std::string functions() const;
  [[nodiscard]] std::string turns() const;

 private:
  [[nodiscard]] Lines motion() const;
  [[nodiscard]] Lines moment() const;
  [[nodiscard]] Lines advance() const;
  [[nodiscard]] std::string clocks() const;
  [[nodiscard]] Lines stuck_lines() const;
  [[nodiscard]] std::string beginnings() const;
  static std::string sticking(const std::string& effects);
  [[nodiscard]] bool goes_on() const;
  [[nodiscard]] Lines due_lines(const StepPhase& phase) const;
  [[nodiscard]] Lines clock_lines(const StepPhase& phase) const;
  [[nodiscard]] Lines turn_lines() const;
  [[nodiscard]] Lines begin_lines() const;
  [[nodiscard]] Lines end_lines() const;
  [[nodiscard]] bool counts() const { return stepper_.counted > 0; }

  const Stepper& stepper_;
  Scalar scalar_;
  int guards_;
};

Lines EventWriter::motion() const {
  Lines lines = {"const Scalar* tau;"};
  append_if(lines, stepper_.takes_time, "const Scalar* t;  // of the beginning of the step");
  append_if(lines, !stepper_.anchors.empty() || stepper_.takes_anchor,
            fmt::format("{}Scalar* anchor;", stepper_.anchors.empty() ? "const " : ""));
  append_if(lines, stepper_.takes_derived, fmt::format("const {}* derived;", kDerivedParameters));
  append_if(lines, stepper_.switches(), "int which;  // phase");
  append_if(lines, counts(),
            fmt::format("int steps;  // that the phase has lasted when the step begins{}",
                        stepper_.begun ? "" : "; -1: it begins at its end"));
  append_if(lines, stepper_.begun, "Scalar begun;  // s, before them");
  return lines;
}

Lines EventWriter::moment() const {
  Lines lines = {"Scalar at;  // s from the beginning of the step", "Scalar q[kDof];",
                 "Scalar qd[kDof];"};
  append_if(lines, stepper_.compensated, "Scalar rest[2 * kDof];  // lost by q and qd");
  append_if(lines, stepper_.rows > 0, fmt::format("Scalar lambda[{}];", stepper_.rows));
  append_if(lines, program::tells_reactions(stepper_),
            fmt::format("Scalar halfway[{}];  // of the way here: lambda", stepper_.rows));
  append_if(lines, guards_ > 0,
            fmt::format("Scalar guard[kGuards];  // below zero behind an event{}",
                        stepper_.most_approaches() > 0
                            ? fmt::format("; from {} on speeds along normals", guards_)
                            : ""));
  lines.emplace_back("int failed;");
  return lines;
}

Lines EventWriter::advance() const {
  Lines lines;
  Lines arguments = {"to.at - from.at"};
  append_if(arguments, stepper_.switches(), "motion.which");
  arguments.insert(arguments.end(), {"from.q", "from.qd"});
  if (stepper_.compensated) {
    append(lines, {"for (int i = 0; i < 2 * kDof; ++i) {", "  to.rest[i] = from.rest[i];", "}"});
    arguments.emplace_back("to.rest");
  }
  arguments.emplace_back("motion.tau");
  if (stepper_.takes_time) {
    lines.emplace_back("const Scalar t[1] = {motion.t[0] + from.at};");
    arguments.emplace_back("t");
  }
  append_if(arguments, stepper_.takes_anchor, "motion.anchor");
  append_if(arguments, stepper_.takes_derived, kDerivedOfMotion);
  arguments.insert(arguments.end(), {"to.q", "to.qd"});
  if (stepper_.rows > 0) {
    arguments.insert(arguments.end(), {"from.lambda", "to.lambda"});
  }
  append_if(arguments, program::tells_reactions(stepper_), "to.halfway");
  append_if(lines, stepper_.tells,
            fmt::format("treedyn_again({});", static_cast<int>(program::Repeated::kAdvance)));
  lines.push_back(call_text("to.failed = integrate", arguments));
  append(lines, stuck_lines());
  return lines;
}

Lines EventWriter::due_lines(const StepPhase& phase) const {
  Lines lines;
  int number = first_event_of(stepper_, phase);
  for (const StepEvent& event : phase.events) {
    if (event.cause == StepCause::kTime) {
      lines.push_back(
          fmt::format("if (!(at < {})) {{", lasted_text(stepper_, event.not_before, scalar_)));
      append(lines, {fmt::format("  return {};", number), "}"});
    }
    ++number;
  }
  return lines;
}

Lines EventWriter::clock_lines(const StepPhase& phase) const {
  Lines lines;
  for (const Lasting& lasting : program::clocks(phase)) {
    lines.push_back(
        fmt::format("next = earlier(at, {}, next);", lasted_text(stepper_, lasting, scalar_)));
  }
  return lines;
}

/// Joints that stick stay where they are, without rounding.
Lines EventWriter::stuck_lines() const {
  const auto is_free = [](const StepPhase& phase) {
    return phase.stuck.empty();
  };
  if (std::ranges::all_of(stepper_.phases, is_free)) {
    return {};
  }
  return by_phase(stepper_, "motion.which", [](const StepPhase& phase) {
    Lines lines;
    for (const int joint : phase.stuck) {
      append(lines, {fmt::format("to.q[{0}] = from.q[{0}];", joint),
                     fmt::format("to.qd[{}] = Scalar(0);", joint)});
    }
    return lines;
  });
}

bool EventWriter::goes_on() const {
  return std::ranges::any_of(stepper_.phases, [](const StepPhase& phase) {
    return std::ranges::any_of(phase.events, [](const StepEvent& event) { return event.goes_on; });
  });
}

/// What tells which events begin a phase of the scene.
std::string EventWriter::beginnings() const {
  if (!counts() || !goes_on()) {
    return {};
  }
  Lines begins;
  for (const StepPhase& phase : stepper_.phases) {
    for (const StepEvent& event : phase.events) {
      begins.emplace_back(event.goes_on ? "false" : "true");
    }
  }
  return fmt::format(
      "\n/// Events behind which a phase lasts anew: not those of sticking and slipping.\n"
      "constexpr bool kBegins[] = {{{}}};\n",
      fmt::join(begins, ", "));
}

/// What tells how joints slip.
/// \param effects  text of all effects of events
std::string EventWriter::sticking(const std::string& effects) {
  if (effects.find("way(") == std::string::npos) {
    return {};
  }
  return "\n/// How a joint slips: 0 it does not, 1 forth, 2 back.\n"
         "int way(Scalar speed) noexcept {\n"
         "  return speed > Scalar(0) ? 1 : speed < Scalar(0) ? 2 : 0;\n}\n";
}

/// What happens because time goes by.
std::string EventWriter::clocks() const {
  std::string result;
  if (stepper_.has_times()) {
    result += fmt::format(
        "\n/// An event that only waits for its time, and has; -1: none.\n"
        "int due(const Motion& motion, Scalar at) noexcept {{\n{}\n  return -1;\n}}\n",
        joined(by_phase(stepper_, "motion.which",
                        [&](const StepPhase& phase) { return due_lines(phase); }),
               "  "));
  }
  if (counts() && stepper_.cuts > 0) {
    result += fill(
        template_text("step_clocks.cpp"),
        {{"clocks", joined(by_phase(stepper_, "motion.which",
                                    [&](const StepPhase& phase) { return clock_lines(phase); }),
                           "  ")}});
  }
  return result;
}

std::string EventWriter::functions() const {
  Lines effects = effect_lines(stepper_, scalar_);
  for (const char* const argument : {"now", "motion"}) {
    if (!has_word(joined(effects, ""), argument)) {
      effects.insert(effects.begin(), fmt::format("static_cast<void>({});", argument));
    }
  }
  const std::string constant = guards_ > 0 ? fmt::format(
                                                 "/// Guards and approaches of a phase, at most.\n"
                                                 "constexpr int kGuards = {};\n",
                                                 guards_ + stepper_.most_approaches())
                                           : "";
  return fill(template_text("step_events.cpp"),
              {{"turns", std::to_string(stepper_.events)},
               {"type", type_name(scalar_)},
               {"step", literal(stepper_.step, scalar_)},
               {"guards", constant},
               {"motion", joined(motion(), "  ")},
               {"moment", joined(moment(), "  ")},
               {"advance", joined(advance(), "  ")},
               {"watch", guards_ > 0 ? search_text(stepper_, scalar_) : ""},
               {"clocks", clocks() + sticking(joined(effects, "")) + beginnings()},
               {"happen", joined(effects, "  ")}});
}

Lines EventWriter::turn_lines() const {
  const bool clocks = counts() && stepper_.cuts > 0;
  Lines inner = {"if (!(from.at < h)) {", "  break;", "}"};
  if (clocks) {
    append(inner, {"to.at = next_clock(motion, from.at);", "if (last && to.at < h) {",
                   "  failed |= status::event_missed;", "  to.at = h;", "}"});
  } else {
    inner.emplace_back("to.at = h;");
  }
  inner.emplace_back("advance(motion, from, to);");
  if (stepper_.rows > 0) {
    append(inner,
           {fmt::format("for (int i = 0; i < {} && !(from.at > Scalar(0)); ++i) {{", stepper_.rows),
            "  lambda[i] = from.lambda[i];", "}"});
  }
  append_if(
      inner, guards_ > 0,
      fmt::format("event = find_event(motion, from, to{});", stepper_.cuts > 0 ? ", last" : ""));
  append(inner, {"failed |= from.failed | to.failed;", "from = to;"});
  if (!stepper_.has_times()) {
    Lines lines = {"int event = -1;"};
    append(lines, inner);
    return lines;
  }
  Lines lines = {"int event = due(motion, from.at);", "if (event < 0 || last) {",
                 "  failed |= event < 0 || !(from.at < h) ? 0 : status::event_missed;",
                 "  event = -1;"};
  append(lines, inner, "  ");
  lines.emplace_back("}");
  return lines;
}

Lines EventWriter::begin_lines() const {
  Lines values = {"tau"};
  Lines lines;
  append_if(values, stepper_.takes_time, "t");
  if (!stepper_.anchors.empty()) {
    lines = {fmt::format("for (int i = 0; i < {}; ++i) {{",
                         stepper_.anchors.front().signature.outputs[0].size),
             "  anchor_next[i] = anchor[i];", "}"};
    values.emplace_back("anchor_next");
  } else if (stepper_.takes_anchor) {
    values.emplace_back("anchor");
  }
  append_if(values, stepper_.takes_derived, "&derived");
  append_if(values, stepper_.switches(), "phase[0]");
  append_if(values, counts(), "steps[0]");
  append_if(values, stepper_.begun, "begun[0]");
  lines.push_back(fmt::format("Motion motion = {{{}}};", fmt::join(values, ", ")));
  append(lines, {"Moment from = {};", "Moment to = {};"});
  if (stepper_.compensated) {
    append(lines, {"for (int i = 0; i < 2 * kDof; ++i) {", "  from.rest[i] = rest[i];", "}"});
  }
  append_if(lines, stepper_.begun, "bool changed = false;");
  return lines;
}

Lines EventWriter::end_lines() const {
  Lines lines;
  if (stepper_.compensated) {
    append(lines, {"for (int i = 0; i < 2 * kDof; ++i) {", "  rest_next[i] = from.rest[i];", "}"});
  }
  append_if(lines, stepper_.switches(), "phase_next[0] = motion.which;");
  if (stepper_.begun) {
    append(lines, {fmt::format("steps_next[0] = changed ? 0 : steps[0] < {0} ? steps[0] + 1 : {0};",
                               stepper_.counted),
                   "begun_next[0] = changed ? h + motion.begun : begun[0];",
                   "if (changed && !(begun_next[0] < h)) {  // a whole step",
                   "  steps_next[0] = 1;", "  begun_next[0] = Scalar(0);", "}"});
  } else if (counts()) {
    lines.push_back(fmt::format("steps_next[0] = motion.steps < {0} ? motion.steps + 1 : {0};",
                                stepper_.counted));
  }
  return lines;
}

std::string EventWriter::turns() const {
  Lines restart;
  if (stepper_.begun) {
    restart = {"changed = true;", "motion.steps = 0;", "motion.begun = -from.at;"};
  } else if (counts()) {
    restart = {"motion.steps = from.at < h ? 0 : -1;"};
  }
  if (counts() && goes_on()) {
    Lines lines = {"if (kBegins[event]) {"};
    append(lines, restart, "  ");
    lines.emplace_back("}");
    restart = lines;
  }
  if (stepper_.tells) {
    restart.insert(restart.begin(), "treedyn_event(event, static_cast<double>(from.at));");
  }
  return fill(template_text("step_turns.cpp"),
              {{"declaration", declaration(stepper_.signature, " noexcept {")},
               {"begin", joined(begin_lines(), "  ")},
               {"turn", joined(turn_lines(), "    ")},
               {"restart", joined(restart, "      ")},
               {"end", joined(end_lines(), "  ")}});
}

}  // namespace

std::string event_functions(const Stepper& stepper, Scalar scalar) {
  return EventWriter(stepper, scalar).functions();
}

std::string turns_text(const Stepper& stepper) {
  return EventWriter(stepper, Scalar::kDouble).turns();
}

}  // namespace treedyn::emit
