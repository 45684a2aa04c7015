#include "accuracy/report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "emit/template_file.hpp"

namespace treedyn::accuracy {

namespace {

/// The error that the study is about, and behind it the others.
std::vector<Error> chosen_first(const Study& study) {
  std::vector<Error> result = errors_of(study);
  const auto chosen = std::find(result.begin(), result.end(), study.error);
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

std::string front_text(const Study& study, const Core& core) {
  const std::vector<Error> errors = chosen_first(study);
  const std::string name(core.name);
  const std::vector<std::string> measured = measured_cores(study);
  const bool sized = std::find(measured.begin(), measured.end(), name) != measured.end();
  std::string text = fmt::format("\ncheapest settings on {} ({}):\n", core.name, core.brief);
  for (const Error error : errors) {
    text += fmt::format("{:>12} ", row_of(error).head);
  }
  const std::vector<std::size_t> front = pareto(study, core);
  std::size_t width = 7;
  for (const std::size_t k : front) {
    width = std::max(width, text_of(study.outcomes[k].setting).size());
  }
  text += fmt::format("{:>12}{}  {:<{}} {}\n", "cycles/s",
                      sized ? fmt::format(" {:>7} {:>7}", "flash", "stack") : "", "setting", width,
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
    text += fmt::format("  {:<{}} {}\n", text_of(outcome.setting), width,
                        next_decade(study, front, k, core));
  }
  return text;
}

std::vector<std::string> methods_of(const Study& study) {
  std::vector<std::string> names;
  for (const Outcome& outcome : study.outcomes) {
    const std::string name = method_of(outcome.setting);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  }
  return names;
}

std::string reference_text(const Study& study) {
  const Reference& reference = study.reference;
  std::string text = fmt::format(
      "reference: {}, which differ by {:.1e}: errors above {:.1e} are known to a hundredth\n",
      reference.methods, reference.agreement, 100 * reference.uncertainty());
  if (study.error != Error::kJoints) {
    const auto own = reference.differences.find(study.error);
    const double difference = own == reference.differences.end() ? 0 : own->second;
    text += fmt::format("pictures and targets: largest {}", row_of(study.error).text);
    text += difference > 0 ? fmt::format("; of it they differ by {:.1e}\n", difference) : "\n";
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

std::string facts_text(const Study& study) {
  std::string text = fmt::format("{}: {:.6g} s, ", study.scene, study.duration);
  text += study.states == 1
              ? "the scene's own initial state\n"
              : fmt::format(
                    "{} initial states (the scene's own and others within {:.1g} of each {})\n",
                    study.states, study.spread,
                    study.speeds_only ? "speed: loops have their place" : "coordinate and speed");
  text += reference_text(study);
  for (const State state : kStates) {
    if (const std::optional<Floor> floor = floor_of(study, state)) {
      text += fmt::format("floor of {}: {:.2e} with {}\n", name_of(state), floor->error,
                          text_of(floor->setting));
    }
  }
  if (const std::optional<Floor> floor = event_floor(study)) {
    text += fmt::format("floor of events at the end of a step: {:.2e} with {}\n", floor->error,
                        text_of(floor->setting));
  }
  for (const StepLimit& limit : study.stability) {
    text += fmt::format("stability limit of {} where the scene begins: {:.3g} s\n",
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

std::string html(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

std::string html_rows(const Study& study, const std::vector<const Core*>& on) {
  std::string text;
  for (const Outcome& outcome : study.outcomes) {
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", name_of(outcome.setting.state),
                        html(method_of(outcome.setting)), outcome.setting.step);
    const char* const instead = outcome.failed() ? "failed" : nullptr;
    for (const Error error : chosen_first(study)) {
      text += fmt::format("<td>{}</td>",
                          instead ? instead : fmt::format("{:.2e}", outcome.error(error)));
    }
    text += fmt::format("<td>{}</td>", outcome.step_cost.total());
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
  return emit::fill(emit::template_text("accuracy.html"), {{"title", html(study.scene)},
                                                           {"facts", html(report_text(study, on))},
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
                                : fmt::format("; the reference is uncertain by {:.2e}", unknown));
}

}  // namespace

std::string choice_text(const Study& study, const Core& core, double target) {
  const std::optional<std::size_t> chosen = cheapest(study, core, target);
  if (!chosen) {
    return refusal_text(study, core, target);
  }
  const Outcome& outcome = study.outcomes[*chosen];
  const double cycles = outcome.cycles_per_second(core);
  const std::string over_states =
      study.states == 1 ? ""
                        : fmt::format(" (over {} initial states {:.1e} to {:.1e})", study.states,
                                      outcome.least(study.error), outcome.error(study.error));
  const std::string in_period = study.rate ? fmt::format(", {:.4g} in each period of {} Hz",
                                                         cycles / *study.rate, *study.rate)
                                           : "";
  return fmt::format(
      "{:.3g} on {}{}: {}, error {:.2e}{}, {} operations a step, {:.4g} cycles for a second of "
      "motion{}{}\n",
      target, core.name, limits_text(study.limits), text_of(outcome.setting),
      outcome.error(study.error), over_states, outcome.step_cost.total(), cycles, in_period,
      size_text(outcome, core));
}

}  // namespace treedyn::accuracy
