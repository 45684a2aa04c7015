#include "accuracy/report.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "emit/template_file.hpp"

namespace treedyn::accuracy {

namespace {

/// The error that the study is about, and behind it the others.
std::vector<Error> chosen_first(const Study& study) {
  std::vector<Error> result = errors_of(study);
  const auto chosen = std::ranges::find(result, study.error);
  if (chosen != result.end()) {
    std::rotate(result.begin(), chosen, chosen + 1);
  }
  return result;
}

/// Cores for which sizes are known.
std::vector<std::string> measured_cores(const Study& study) {
  std::vector<std::string> result;
  for (const Core& core : cores()) {
    const std::string name(core.name);
    if (!study.outcomes.empty() && study.outcomes.front().sizes.contains(name)) {
      result.push_back(name);
    }
  }
  return result;
}

/// What a factor of ten in the error costs from one outcome of the front to the next ones; empty
/// behind the last decade.
std::string next_decade(const Study& study, const std::vector<std::size_t>& front, std::size_t at,
                        const Core& core) {
  const Outcome& from = study.outcomes[front[at]];
  for (std::size_t k = at + 1; k < front.size(); ++k) {
    const Outcome& to = study.outcomes[front[k]];
    if (to.error(study.error) <= from.error(study.error) / 10) {
      return fmt::format("x {:.1f}", to.cycles_per_second(core) / from.cycles_per_second(core));
    }
  }
  return "-";
}

/// The least wall time for a second of motion; 0: not measured.
double fastest_time(const Study& study) {
  const auto fastest = std::ranges::min_element(study.outcomes, {}, &Outcome::time);
  return fastest == study.outcomes.end() ? 0 : fastest->time;
}

/// What contraction to fused multiply-adds makes of the cycles of a front; nothing where it makes
/// nothing.
std::string contraction_text(const Study& study, const std::vector<std::size_t>& front,
                             const Core& core) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const std::size_t k : front) {
    const Outcome& outcome = study.outcomes[k];
    const double factor = outcome.cycles_per_second(core, true) / outcome.cycles_per_second(core);
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  return !(most > 0) || (least > 0.995 && most < 1.005)
             ? ""
             : fmt::format(
                   "with contraction (-ffp-contract=fast; rounds otherwise): {:.2f} to {:.2f} "
                   "times these cycles\n",
                   least, most);
}

std::string front_text(const Study& study, const Core& core) {
  const std::vector<Error> errors = chosen_first(study);
  const std::string name(core.name);
  const std::vector<std::string> measured = measured_cores(study);
  const bool sized = std::ranges::find(measured, name) != measured.end();
  std::string text = fmt::format("\ncheapest settings on {} ({}):\n", core.name, core.brief);
  for (const Error error : errors) {
    text += fmt::format("{:>12} ", row_of(error).head);
  }
  const std::vector<std::size_t> front = pareto(study, core);
  std::size_t width = 7;
  for (const std::size_t k : front) {
    width = std::max(width, text_of(study.outcomes[k].setting).size());
  }
  const double fastest = fastest_time(study);
  text += fmt::format("{:>12}{}{}  {:<{}} {}\n", "cycles/s",
                      sized ? fmt::format(" {:>7} {:>7}", "flash", "stack") : "",
                      fastest > 0 ? fmt::format(" {:>8}", "time") : "", "setting", width,
                      "next decade costs");
  for (std::size_t k = 0; k < front.size(); ++k) {
    const Outcome& outcome = study.outcomes[front[k]];
    for (const Error error : errors) {
      text += error == study.error ? fmt::format("{:>12.2e} ", outcome.error(error))
                                   : fmt::format("{:>12.1e} ", outcome.error(error));
    }
    text += fmt::format("{:>12.4g}", outcome.cycles_per_second(core));
    if (sized) {
      const Size& size = outcome.sizes.at(name);
      text += fmt::format(" {:>7} {:>7}", size.flash, size.stack);
    }
    text += fastest > 0 ? fmt::format(" x {:<6.3g}", outcome.time / fastest) : "";
    text += fmt::format("  {:<{}} {}\n", text_of(outcome.setting), width,
                        next_decade(study, front, k, core));
  }
  return text + contraction_text(study, front, core);
}

std::vector<std::string> methods_of(const Study& study) {
  std::vector<std::string> names;
  for (const Outcome& outcome : study.outcomes) {
    const std::string name = method_of(outcome.setting);
    if (std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  }
  return names;
}

std::string reference_text(const Study& study) {
  const Reference& reference = study.reference;
  std::string text = fmt::format(
      "reference: {}, which differ by {:.1e}: {}errors above {:.1e} are known to a hundredth\n",
      reference.methods, reference.agreement,
      reference.uncertainty() > reference.agreement ? "with the check below " : "",
      100 * reference.uncertainty());
  if (study.error != Error::kJoints) {
    const auto own = reference.differences.find(study.error);
    const double difference = own == reference.differences.end() ? 0 : own->second;
    text += fmt::format("pictures and targets: largest {}", row_of(study.error).text);
    text += difference > 0
                ? fmt::format(
                      "; of it they differ by {:.1e}: above {:.1e} it is known to a hundredth\n",
                      difference, 100 * study.reference.uncertainty(study.error))
                : "\n";
  }
  if (reference.check.empty()) {
    return text + "check: none, simulate does not get through\n";
  }
  text += fmt::format("check: {} differs by {:.1e}", reference.check, reference.check_difference);
  if (reference.refuted()) {
    text +=
        fmt::format(", though it is known to {:.1e}: one of them is wrong", reference.check_error);
  }
  return text + "\n";
}

/// The initial states.
std::string band_text(const Study& study) {
  if (study.states == 1) {
    return "the scene's own initial state";
  }
  return fmt::format(
      "{} initial states: the scene's own and others whose {} differ by up to {:.3g} of their "
      "size, that of those below 0.1 taken as 0.1",
      study.states,
      study.speeds_only ? "speeds (loops have their place)" : "coordinates and speeds",
      study.spread);
}

/// Of any step, the first not counted.
long most_parts(const Study& study) {
  long most = 0;
  for (const Outcome& outcome : study.outcomes) {
    for (const PhaseSteps& phase : outcome.phases) {
      if (phase.kinds() > 0) {
        most = std::max(most, phase.count.most[static_cast<std::size_t>(program::Repeated::kPart)]);
      }
    }
  }
  return most;
}

std::string facts_text(const Study& study) {
  std::string text =
      fmt::format("{}: {:.6g} s, {}\n", study.scene, study.duration, band_text(study));
  text += reference_text(study);
  for (const Sensitive& state : sensitive_states(study)) {
    text += fmt::format(
        "initial state {} is sensitive: in {} of {} settings it is off by over a hundred times the "
        "median of all, most with {}: {:.1e} to {:.1e}\n",
        state.state, state.settings, study.outcomes.size(), text_of(state.worst), state.error,
        state.median);
  }
  for (const State state : kStates) {
    if (const std::optional<Floor> floor = floor_of(study, state)) {
      text += fmt::format("{} of {}: {:.2e} with {}\n",
                          floor->is_reached ? "floor" : "smallest error, of the shortest step,",
                          name_of(state), floor->error, text_of(floor->setting));
    }
  }
  if (const std::optional<Floor> floor = event_floor(study)) {
    text += fmt::format("floor of events at the end of a step: {:.2e} with {}\n", floor->error,
                        text_of(floor->setting));
  }
  if (const long parts = most_parts(study); parts > 0) {
    text += fmt::format(
        "steps are done in up to {} parts, stepping: {{parts: N}} bounds them: all cost\n",
        parts + 1);
  }
  for (const StepLimit& limit : study.stability) {
    text += fmt::format("stability limit of {}, the least along the motion: {:.3g} s\n",
                        limit.integrator, limit.step);
  }
  for (const std::string& name : methods_of(study)) {
    for (const State state : kStates) {
      const std::optional<double> order = fitted_order(study, state, name);
      const std::string line =
          order ? fmt::format("order of {} {}: {:.2f}\n", name_of(state), name, *order) : "";
      text += text.find(line) == std::string::npos ? line : "";
    }
  }
  return text;
}

std::string html_rows(const Study& study, const std::vector<const Core*>& on) {
  std::string text;
  for (const Outcome& outcome : study.outcomes) {
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", name_of(outcome.setting.state),
                        emit::html_text(method_of(outcome.setting)), outcome.setting.step);
    const char* const instead = outcome.failed() ? "failed" : nullptr;
    for (const Error error : chosen_first(study)) {
      text += fmt::format("<td>{}</td>",
                          instead ? instead : fmt::format("{:.2e}", outcome.error(error)));
    }
    text += fmt::format("<td>{}</td>", outcome.step_cost().total());
    for (const Core* core : on) {
      text += fmt::format("<td>{:.4g}</td>", outcome.cycles_per_second(*core));
    }
    for (const std::string& core : measured_cores(study)) {
      const Size& size = outcome.sizes.at(core);
      text += fmt::format("<td>{}</td><td>{}</td>", size.flash, size.stack);
    }
    text += "</tr>\n";
  }
  return text;
}

std::string html_heads(const Study& study, const std::vector<const Core*>& on) {
  std::string text;
  for (const Error error : chosen_first(study)) {
    text += fmt::format("<th>{}</th>", row_of(error).head);
  }
  text += "<th>operations a step</th>";
  for (const Core* core : on) {
    text += fmt::format("<th>cycles/s {}</th>", core->name);
  }
  for (const std::string& core : measured_cores(study)) {
    text += fmt::format("<th>flash {0}</th><th>stack {0}</th>", core);
  }
  return text;
}

}  // namespace

std::string report_text(const Study& study, const std::vector<const Core*>& on) {
  std::string text = facts_text(study);
  for (const Core* core : on) {
    text += front_text(study, *core);
  }
  return text;
}

std::string report_page(const Study& study, const std::vector<const Core*>& on) {
  std::string charts = step_chart(study);
  for (const Core* core : on) {
    charts += work_chart(study, *core);
  }
  return emit::fill(emit::template_text("accuracy.html"),
                    {{"title", emit::html_text(study.scene)},
                     {"facts", emit::html_text(report_text(study, on))},
                     {"charts", charts},
                     {"heads", html_heads(study, on)},
                     {"rows", html_rows(study, on)}});
}

namespace {

/// Limits and what a setting takes: "2140 bytes of flash, 312 of stack".
std::string limits_text(const Limits& limits) {
  const std::string flash = limits.flash ? fmt::format(" {} bytes of flash", *limits.flash) : "";
  const std::string stack = limits.stack ? fmt::format(" {} bytes of stack", *limits.stack) : "";
  return flash.empty() && stack.empty()
             ? ""
             : fmt::format(" within{}{}{}", flash, flash.empty() || stack.empty() ? "" : " and",
                           stack);
}

std::string size_text(const Outcome& outcome, const Core& core) {
  const auto size = outcome.sizes.find(std::string(core.name));
  return size == outcome.sizes.end() ? ""
                                     : fmt::format(", {} bytes of flash, {} of stack",
                                                   size->second.flash, size->second.stack);
}

/// What is reachable instead.
std::string refusal_text(const Study& study, const Core& core, double target) {
  const std::string limits = limits_text(study.limits);
  const std::string head =
      fmt::format("{:.3g}{} is out of reach: ", target,
                  limits.empty() ? "" : fmt::format(" on {}{}", core.name, limits));
  const std::optional<std::size_t> found = most_accurate(study, core);
  if (!found) {
    return head + "no setting keeps the limits and gets through\n";
  }
  const Outcome& best = study.outcomes[*found];
  const double unknown = study.reference.uncertainty(study.error);
  return head + fmt::format("the smallest error is {:.2e}, with {}{}{}\n", best.error(study.error),
                            text_of(best.setting), size_text(best, core),
                            best.error(study.error) > target
                                ? ""
                                : fmt::format("; 19 of 20 other initial states are expected below "
                                              "{:.2e}, and the reference is uncertain by {:.2e}",
                                              best.expected(study.error), unknown));
}

/// How much more than float at its best it costs, where float does not do.
std::string factor_text(const Study& study, const Core& core, const Outcome& chosen,
                        double target) {
  std::optional<Floor> best = floor_of(study, State::kFloat);
  if (const auto other = floor_of(study, State::kCompensated);
      other && (!best || other->error < best->error)) {
    best = other;
  }
  if (chosen.setting.state != State::kDouble || !best) {
    return "";
  }
  const auto of_float = std::ranges::find(study.outcomes, best->setting, &Outcome::setting);
  return fmt::format(", {:.3g} times those of {}, whose {:.1e} is the best of float{}",
                     chosen.cycles_per_second(core) / of_float->cycles_per_second(core),
                     text_of(best->setting), best->error,
                     best->error > target
                         ? ""
                         : fmt::format(" ({:.1e} for 19 of 20 other initial states)",
                                       of_float->expected(study.error)));
}

}  // namespace

std::string choice_text(const Study& study, const Core& core, double target) {
  const std::optional<std::size_t> chosen = cheapest(study, core, target);
  if (!chosen) {
    return refusal_text(study, core, target);
  }
  const Outcome& outcome = study.outcomes[*chosen];
  const double cycles = outcome.cycles_per_second(core);
  const std::string in_period = study.rate ? fmt::format(", {:.4g} in each period of {} Hz",
                                                         cycles / *study.rate, *study.rate)
                                           : "";
  const std::string in_dearest =
      study.rate && outcome.phases.size() > 1
          ? fmt::format(", {:.4g} in the dearest phase",
                        outcome.most_cycles(core) / outcome.setting.step / *study.rate)
          : "";
  const std::string others = study.states == 1
                                 ? ""
                                 : fmt::format(
                                       " (over {} initial states {:.1e} to {:.1e}; 19 of 20 others "
                                       "are expected below {:.1e})",
                                       study.states, outcome.least(study.error),
                                       outcome.error(study.error), outcome.expected(study.error));
  return fmt::format(
      "{:.3g} on {}{}: {}, error {:.2e}{}, {} operations a step, {:.4g} cycles for a second of "
      "motion{}{}{}\n",
      target, core.name, limits_text(study.limits), text_of(outcome.setting),
      outcome.error(study.error), others, outcome.step_cost().total(), cycles,
      in_period + in_dearest, factor_text(study, core, outcome, target), size_text(outcome, core));
}

}  // namespace treedyn::accuracy
