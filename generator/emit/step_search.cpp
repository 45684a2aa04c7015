#include "emit/step_search.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/step_text.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::StepCause;
using program::StepEvent;
using program::Stepper;
using program::StepPhase;

namespace {

const char* const kMotion = "const Motion& motion";
const char* const kUnusedMotion = "const Motion& /*motion*/";

/// The text of what finds the events of one scene.
class SearchWriter {
 public:
  SearchWriter(const Stepper& stepper, Scalar scalar)
      : stepper_(stepper), scalar_(scalar), guards_(stepper.most_guards()) {}

  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] Lines look() const;
  [[nodiscard]] std::string approach() const;
  [[nodiscard]] std::string first_event() const;
  [[nodiscard]] std::string beginning() const;
  [[nodiscard]] Lines event_lines(const StepEvent& event, int number) const;
  [[nodiscard]] std::string cut() const;
  [[nodiscard]] bool looks_halfway() const;
  [[nodiscard]] Lines between() const;
  [[nodiscard]] std::string dips() const;
  [[nodiscard]] Lines choice_lines(const std::string& to) const;
  [[nodiscard]] Lines found_lines() const;
  /// What rounding leaves of the rest of a force, as a part of the force.
  [[nodiscard]] Real roundings() const {
    return ldexp(Real(1), scalar_ == Scalar::kFloat ? -19 : -48);
  }
  [[nodiscard]] bool looks_at_time() const {
    return std::ranges::any_of(stepper_.phases, [](const StepPhase& phase) {
      return !phase.guards.empty() && program::takes_time(phase.guards.front());
    });
  }

  const Stepper& stepper_;
  Scalar scalar_;
  int guards_;
};

Lines SearchWriter::look() const {
  Lines lines = by_phase(stepper_, "motion.which", [](const StepPhase& phase) {
    if (phase.guards.empty()) {
      return Lines{};
    }
    const program::Staged& guards = phase.guards.front();
    Lines inner;
    append_if(inner, program::takes_time(guards), "const Scalar t[1] = {motion.t[0] + now.at};");
    inner.push_back(call(guards, {"now.q", "now.qd", "t", "now.lambda"}, "now.guard"));
    inner.push_back(
        fmt::format("return below_zero({}, now);", guards.signature.outputs.front().size));
    return inner;
  });
  if (stepper_.switches()) {  // a return stands for every break
    lines.erase(std::remove(lines.begin(), lines.end(), "    break;"), lines.end());
    lines.insert(lines.end() - 1, "    break;");
    lines.emplace_back("return false;");
  }
  return lines;
}

std::string SearchWriter::approach() const {
  if (stepper_.most_approaches() == 0) {
    return {};
  }
  const Lines lines = by_phase(stepper_, "motion.which", [&](const StepPhase& phase) {
    return phase.approaches.empty()
               ? Lines{}
               : Lines{call(phase.approaches.front(), {"now.q", "now.qd", "", ""},
                            fmt::format("now.guard + {}", guards_))};
  });
  return fmt::format(
      "\n/// The speeds along the normals.\nvoid approach({}, Moment& now) noexcept {{\n{}\n}}\n",
      stepper_.switches() ? kMotion : kUnusedMotion, joined(lines, "  "));
}

/// Notes the event if it has happened.
Lines SearchWriter::event_lines(const StepEvent& event, int number) const {
  const int approach = guards_ + event.approach;
  std::string condition = fmt::format("to.guard[{}] < Scalar(0)", event.guard);
  std::string part = fmt::format("chord(from.guard[{0}], to.guard[{0}])", event.guard);
  Lines inner;
  if (event.cause == StepCause::kCross) {
    // a joint that runs against the way that its friction has stops, whatever was before
    condition += event.outcome.stops >= 0
                     ? ""
                     : fmt::format(" && !(from.guard[{}] < Scalar(0))", event.guard);
  } else if (event.cause == StepCause::kFall || event.cause == StepCause::kLand) {
    condition +=
        event.cause == StepCause::kFall
            ? fmt::format(" && to.guard[{}] < Scalar(0)", approach)
            : fmt::format(
                  " &&\n    (!(from.guard[{0}] < Scalar(0)) || {2}from.guard[{1}], to.guard[{1}]))",
                  event.guard, approach,
                  event.stops_point ? fmt::format("falls_now(from.guard[{}], ", event.guard)
                                    : "begins_to_fall(");
    inner.push_back(fmt::format("const int k = from.guard[{0}] < Scalar(0) ? {1} : {0};",
                                event.guard, approach));
    part = "chord(from.guard[k], to.guard[k])";
    if (event.cause == StepCause::kLand) {
      inner.push_back(
          fmt::format("const bool held = falls_from_plane(from.guard[{0}], "
                      "to.guard[{0}], from.guard[{1}], to.guard[{1}]);",
                      event.guard, approach));
      part = fmt::format("held ? Scalar(-1) : {}", part);
    }
  } else {
    const std::string least =
        event.holds > 0 ? literal(-roundings() * event.holds, scalar_) : "Scalar(0)";
    condition = fmt::format("to.guard[{0}] < {1} || from.guard[{0}] < {1}", event.guard, least);
  }
  inner.push_back(fmt::format("note({}, {}, first, part);", number, part));
  const std::size_t line = condition.find('\n');
  Lines lines = {
      fmt::format("if ({}{}", condition.substr(0, line), line == std::string::npos ? ") {" : "")};
  if (line != std::string::npos) {
    lines.push_back(condition.substr(line + 1) + ") {");
  }
  append(lines, inner, "  ");
  lines.emplace_back("}");
  if (event.not_before.none()) {
    lines.insert(lines.begin(), comment_of(event));
    return lines;
  }
  Lines timed = {comment_of(event),
                 fmt::format("if (!({}.at < {})) {{", stepper_.cuts > 0 ? "from" : "to",
                             lasted_text(stepper_, event.not_before, scalar_))};
  append(timed, lines, "  ");
  timed.emplace_back("}");
  return timed;
}

/// What tells that a point begins to fall.
std::string SearchWriter::beginning() const {
  bool lands = false;
  bool stops = false;
  for (const StepPhase& phase : stepper_.phases) {
    for (const StepEvent& event : phase.events) {
      lands = lands || event.cause == StepCause::kLand;
      stops = stops || (event.cause == StepCause::kLand && event.stops_point);
    }
  }
  const auto filled = [&](const char* file, const char* slot, const Real& value) {
    return fill(template_text(file),
                {{"type", type_name(scalar_)}, {slot, literal(value, scalar_)}});
  };
  return (lands ? filled("step_falls.cpp", "part", Real(1) / 65536) : "") +
         (stops ? filled("step_falls_now.cpp", "just", Real("0.03125")) : "");
}

std::string SearchWriter::first_event() const {
  bool timed = stepper_.switches();
  const Lines lines = by_phase(stepper_, "motion.which", [&](const StepPhase& phase) {
    Lines inner;
    int number = first_event_of(stepper_, phase);
    for (const StepEvent& event : phase.events) {
      if (event.cause != StepCause::kTime) {
        timed = timed || !event.not_before.none();
        append(inner, event_lines(event, number));
      }
      ++number;
    }
    return inner;
  });
  return declaration("int first_event",
                     {timed ? kMotion : kUnusedMotion, "const Moment& from", "const Moment& to",
                      "Scalar& part"},
                     " noexcept {") +
         "\n  int first = -1;\n" + joined(lines, "  ") + "\n  return first;\n}\n";
}

std::string SearchWriter::cut() const {
  if (stepper_.cuts == 0) {
    return {};
  }
  const bool single = scalar_ == Scalar::kFloat;
  const bool loses = stepper_.cuts > 2;
  return fill(
      template_text("step_cut.cpp"),
      {{"cuts", std::to_string(stepper_.cuts)},
       {"type", type_name(scalar_)},
       {"further", literal(Real("0.0625"), scalar_)},
       {"beyond", literal(ldexp(Real(1), single ? -12 : -32), scalar_)},
       {"more", literal(Real(single ? 64 : 1024), scalar_)},
       {"still", literal(ldexp(Real(1), single ? -6 : -14), scalar_)},
       {"lost", loses ? "/// A last correction beyond this part of h has not found the event.\n"
                        "constexpr " +
                            type_name(scalar_) + " kLost = " + literal(Real("0.25"), scalar_) +
                            ";\nconstexpr " + type_name(scalar_) +
                            " kLate = " + literal(Real("0.75"), scalar_) + ";"
                      : ""},
       {"begin", loses ? "  bool lost = false;" : ""},
       {"is_lost", loses ? "      lost = lost || way > kLost * h;" : ""},
       {"end", loses ? "  lost = lost || (!behind && !(to.at < h) && low.at < kLate * h);\n"
                       "  to.failed |= lost ? status::event_missed : 0;"
                     : ""},
       {"one_half", literal(Real("0.5"), scalar_)},
       {"approach_now", stepper_.most_approaches() > 0 ? "    approach(motion, now);" : ""}});
}

bool SearchWriter::looks_halfway() const {
  return std::ranges::any_of(stepper_.phases, [&](const StepPhase& phase) {
    return !program::dipping(stepper_, phase).empty();
  });
}

/// The state halfway: by cubics through positions and velocities at both ends; of Euler's steps,
/// whose positions do not follow the velocities, by the parabola of its shorter steps.
Lines SearchWriter::between() const {
  Lines others;
  bool speed = false;
  for (const StepPhase& phase : stepper_.phases) {
    speed = speed || phase.guards_speed;
    append_if(others, program::dipping(stepper_, phase).empty(),
              fmt::format("motion.which == phase::{}", phase.identifier));
  }
  Lines lines;
  if (!others.empty()) {
    append(lines, {fmt::format("if ({}) {{", fmt::join(others, " || ")), "  return false;", "}"});
  }
  const auto number = [&](const char* value) {
    return literal(Real(value), scalar_);
  };
  const bool euler = stepper_.method == StepMethod::kSemiImplicitEuler;
  append(lines, {"const Scalar time = to.at - from.at;",
                 fmt::format("low.at = from.at + {} * time;", number("0.5"))});
  lines.push_back(fmt::format("const Scalar bend = {} * time;", number(euler ? "0.25" : "0.125")));
  append_if(lines, speed && !euler, fmt::format("const Scalar rate = {} / time;", number("1.5")));
  lines.emplace_back("for (int i = 0; i < kDof; ++i) {");
  lines.push_back(
      euler
          ? fmt::format("  low.q[i] = ({} * from.q[i] + {} * to.q[i]) + bend * from.qd[i];",
                        number("0.75"), number("0.25"))
          : fmt::format("  low.q[i] = {} * (from.q[i] + to.q[i]) + bend * (from.qd[i] - to.qd[i]);",
                        number("0.5")));
  append_if(lines, speed,
            euler ? fmt::format("  low.qd[i] = {} * (from.qd[i] + to.qd[i]);", number("0.5"))
                  : fmt::format("  low.qd[i] =\n        rate * (to.q[i] - from.q[i]) - {} * "
                                "(from.qd[i] + to.qd[i]);",
                                number("0.25")));
  lines.emplace_back("}");
  if (program::tells_reactions(stepper_)) {
    append(lines, {fmt::format("for (int i = 0; i < {}; ++i) {{", stepper_.rows),
                   "  low.lambda[i] = to.halfway[i];", "}"});
  }
  return lines;
}

std::string SearchWriter::dips() const {
  if (!looks_halfway()) {
    return {};
  }
  const Lines each = by_phase(stepper_, "motion.which", [&](const StepPhase& phase) {
    Lines lines;
    for (const int guard : program::dipping(stepper_, phase)) {
      lines.push_back(
          fmt::format("dip(from.guard[{0}], low.guard[{0}], to.guard[{0}], least);", guard));
    }
    return lines;
  });
  return fill(template_text("step_dips.cpp"), {{"three", literal(Real(3), scalar_)},
                                               {"eight", literal(Real(8), scalar_)},
                                               {"one_half", literal(Real("0.5"), scalar_)},
                                               {"nearly", literal(Real("0.9375"), scalar_)},
                                               {"between", joined(between(), "  ")},
                                               {"each", joined(each, "  ")}});
}

/// The choice among the events between `from` and another moment.
Lines SearchWriter::choice_lines(const std::string& to) const {
  Lines lines;
  if (stepper_.most_approaches() > 0) {
    lines = {"  approach(motion, from);", fmt::format("  approach(motion, {});", to)};
  }
  lines.push_back(fmt::format("  event = first_event(motion, from, {}, part);", to));
  return lines;
}

Lines SearchWriter::found_lines() const {
  const bool cuts = stepper_.cuts > 0;
  Lines lines = {"int event = -1;", "if (behind || before) {"};
  append(lines, choice_lines("to"));
  lines.emplace_back("}");
  if (!cuts) {
    append(lines,
           {"if (event >= 0) {", "  to.failed |= status::event_late;", "  return event;", "}"});
  }
  if (looks_halfway()) {
    append(lines, {"Moment low = {};", "if (event < 0 && dips(motion, from, to, low)) {"});
    append(lines, choice_lines("low"));
    append(lines, cuts ? Lines{"  if (event >= 0 && !last) {", "    to = low;", "  }", "}"}
                       : Lines{"  to.failed |= event < 0 ? 0 : status::event_missed;", "}"});
  }
  append(lines,
         cuts ? Lines{"if (event < 0 || last) {", "  return event;", "}", "if (part < Scalar(0)) {",
                      "  to = from;", "  return event;", "}", "return cut(motion, from, to);"}
              : Lines{"return -1;"});
  return lines;
}

std::string SearchWriter::text() const {
  const bool cuts = stepper_.cuts > 0;
  const bool needs_motion = stepper_.switches() || looks_at_time() || stepper_.takes_derived;
  return fill(template_text("step_search.cpp"),
              {{"motion_for_look", needs_motion ? kMotion : kUnusedMotion},
               {"look", joined(look(), "  ")},
               {"approach", approach() + beginning()},
               {"first_event", first_event()},
               {"cut", cut() + dips()},
               {"becomes", cuts ? "It has\n/// just happened at `to`, unless the turn is the last."
                                : "`to` is\n/// the end of the step."},
               {"last", cuts ? ", bool last" : ""},
               {"found", joined(found_lines(), "  ")}});
}

}  // namespace

std::string search_text(const Stepper& stepper, Scalar scalar) {
  return SearchWriter(stepper, scalar).text();
}

std::string lasted_text(const Stepper& stepper, const program::Lasting& lasting, Scalar scalar) {
  std::string text = fmt::format("Scalar({} - motion.steps) * h", lasting.steps);
  if (lasting.rest == 0) {
    return text + (stepper.begun ? " - motion.begun" : "");
  }
  const std::string rest = literal(lasting.rest, scalar);
  return text + (stepper.begun ? fmt::format(" + ({} - motion.begun)", rest) : " + " + rest);
}

}  // namespace treedyn::emit
