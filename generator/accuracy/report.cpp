#include "accuracy/report.hpp"

#include <cmath>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "emit/json.hpp"
#include "emit/template_file.hpp"

namespace treedyn::accuracy {

namespace {

const char* scalar_of(State state) { return state == State::kDouble ? "double" : "float"; }

const char* kept_of(State state) { return state == State::kCompensated ? "compensated" : "plain"; }

std::string error_text(const Outcome& outcome) {
  return outcome.failed() ? "failed" : fmt::format("{:.2e}", outcome.error());
}

/// What a factor of ten in the error costs from one outcome of the front to the next ones; empty
/// behind the last decade.
std::string next_decade(const Study& study, const std::vector<std::size_t>& front, std::size_t at,
                        const Core& core) {
  const Outcome& from = study.outcomes[front[at]];
  for (std::size_t k = at + 1; k < front.size(); ++k) {
    const Outcome& to = study.outcomes[front[k]];
    if (to.error() <= from.error() / 10) {
      return fmt::format("x {:.1f}", to.cycles_per_second(core) / from.cycles_per_second(core));
    }
  }
  return "-";
}

std::string front_text(const Study& study, const Core& core) {
  std::string text =
      fmt::format("\ncheapest settings on {} ({}):\n{:>12} {:>12} {:>12}  {:<36} {}\n", core.name,
                  core.brief, "error", "energy, J", "cycles/s", "setting", "next decade costs");
  const std::vector<std::size_t> front = pareto(study, core);
  for (std::size_t k = 0; k < front.size(); ++k) {
    const Outcome& outcome = study.outcomes[front[k]];
    text += fmt::format("{:>12.2e} {:>12.1e} {:>12.4g}  {:<36} {}\n", outcome.error(),
                        outcome.energy_error(), outcome.cycles_per_second(core),
                        text_of(outcome.setting), next_decade(study, front, k, core));
  }
  return text;
}

std::vector<std::string> integrators_of(const Study& study) {
  std::vector<std::string> names;
  for (const Outcome& outcome : study.outcomes) {
    if (names.empty() || names.back() != outcome.setting.integrator) {
      names.push_back(outcome.setting.integrator);
    }
  }
  return names;
}

std::string reference_text(const Reference& reference) {
  std::string text = fmt::format(
      "reference: {}, which differ by {:.1e}: errors above {:.1e} are known to a hundredth\n",
      reference.methods, reference.agreement, 100 * reference.uncertainty());
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
  std::string text = fmt::format(
      "{}: {} s, {} initial states (the scene's own and others within {:.1g} of each {})\n",
      study.scene, study.duration, study.states, study.spread,
      study.speeds_only ? "speed: loops have their place" : "coordinate and speed");
  text += reference_text(study.reference);
  for (const State state : kStates) {
    if (const std::optional<Floor> floor = floor_of(study, state)) {
      text += fmt::format("floor of {}: {:.2e} with {}\n", name_of(state), floor->error,
                          text_of(floor->setting));
    }
  }
  std::string last;
  for (const std::string& name : integrators_of(study)) {
    for (const State state : kStates) {
      const std::optional<double> order = fitted_order(study, state, name);
      const std::string line =
          order ? fmt::format("order of {} {}: {:.2f}\n", name_of(state), name, *order) : "";
      text += text.find(line) == std::string::npos ? line : "";
    }
  }
  return text;
}

/// A JSON array; null: not finite.
std::string numbers(const std::vector<double>& values) {
  std::vector<std::string> result;
  for (const double value : values) {
    result.push_back(std::isfinite(value) ? fmt::format("{}", value) : "null");
  }
  return fmt::format("[{}]", fmt::join(result, ", "));
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
    text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                        name_of(outcome.setting.state), html(outcome.setting.integrator),
                        outcome.setting.step, error_text(outcome),
                        outcome.failed() ? "" : fmt::format("{:.1e}", outcome.energy_error()),
                        outcome.step_cost.total());
    for (const Core* core : on) {
      text += fmt::format("<td>{:.4g}</td>", outcome.cycles_per_second(*core));
    }
    text += "</tr>\n";
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

std::string report_csv(const Study& study) {
  std::string text =
      "scalar,state,integrator,step,error,least_error,energy_error,status,add,mul,div,sqrt,sin,cos";
  for (const Core& core : cores()) {
    text += fmt::format(",cycles_per_second_{}", core.name);
  }
  text += "\r\n";
  for (const Outcome& outcome : study.outcomes) {
    const program::Cost& cost = outcome.step_cost;
    const bool failed = outcome.failed();
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", scalar_of(outcome.setting.state),
                    kept_of(outcome.setting.state), outcome.setting.integrator,
                    outcome.setting.step, failed ? "failed" : fmt::format("{}", outcome.error()),
                    failed ? "failed" : fmt::format("{}", outcome.least()),
                    failed ? "failed" : fmt::format("{}", outcome.energy_error()), outcome.status,
                    cost.add, cost.mul, cost.div, cost.sqrt, cost.sin, cost.cos);
    for (const Core& core : cores()) {
      text += fmt::format(",{:.6g}", outcome.cycles_per_second(core));
    }
    text += "\r\n";
  }
  return text;
}

std::string report_json(const Study& study) {
  std::vector<std::string> rows;
  for (const Outcome& outcome : study.outcomes) {
    std::vector<std::pair<std::string, std::string>> members = {
        {"scalar", fmt::format("\"{}\"", scalar_of(outcome.setting.state))},
        {"state", fmt::format("\"{}\"", kept_of(outcome.setting.state))},
        {"integrator", emit::json_string(outcome.setting.integrator)},
        {"step", fmt::format("{}", outcome.setting.step)},
        {"errors", numbers(outcome.joint_errors)},
        {"energy_errors", numbers(outcome.energy_errors)},
        {"status", fmt::format("{}", outcome.status)},
        {"operations", fmt::format("{}", outcome.step_cost.total())}};
    for (const Core& core : cores()) {
      members.emplace_back(fmt::format("cycles_per_second_{}", core.name),
                           fmt::format("{:.6g}", outcome.cycles_per_second(core)));
    }
    rows.push_back(emit::json_object(members));
  }
  return fmt::format(
      "{{\n  \"scene\": {},\n  \"duration\": {},\n  \"states\": {},\n  \"spread\": {},\n  "
      "\"reference_agreement\": {:.3g},\n  \"check_difference\": {:.3g},\n  \"settings\": "
      "{}\n}}\n",
      emit::json_string(study.scene), study.duration, study.states, study.spread,
      study.reference.agreement, study.reference.check_difference, emit::json_lines(rows, 4));
}

std::string report_page(const Study& study, const std::vector<const Core*>& on) {
  std::string charts = step_chart(study);
  std::string heads;
  for (const Core* core : on) {
    charts += work_chart(study, *core);
    heads += fmt::format("<th>cycles/s {}</th>", core->name);
  }
  return emit::fill(emit::template_text("accuracy.html"), {{"title", html(study.scene)},
                                                           {"facts", html(report_text(study, on))},
                                                           {"charts", charts},
                                                           {"heads", heads},
                                                           {"rows", html_rows(study, on)}});
}

std::string settings_text(const Setting& setting) {
  return fmt::format("scalar = \"{}\"\nintegrator = \"{}\"\nstep = {}\nstate = \"{}\"\n",
                     scalar_of(setting.state), setting.integrator, setting.step,
                     kept_of(setting.state));
}

std::string choice_text(const Study& study, const Core& core, double target) {
  const std::optional<std::size_t> chosen = cheapest(study, core, target);
  if (!chosen) {
    const Outcome& best = study.outcomes[most_accurate(study)];
    const double unknown = study.reference.uncertainty();
    return fmt::format("{:.3g} is out of reach: the smallest error is {:.2e}, with {}{}\n", target,
                       best.error(), text_of(best.setting),
                       best.error() > target
                           ? ""
                           : fmt::format("; the reference is uncertain by {:.2e}", unknown));
  }
  const Outcome& outcome = study.outcomes[*chosen];
  const double cycles = outcome.cycles_per_second(core);
  const std::string in_period = study.rate ? fmt::format(", {:.4g} in each period of {} Hz",
                                                         cycles / *study.rate, *study.rate)
                                           : "";
  return fmt::format(
      "{:.3g} on {}: {}, error {:.2e} (over {} initial states {:.1e} to {:.1e}), {} operations a "
      "step, {:.4g} "
      "cycles for a second of motion{}\n",
      target, core.name, text_of(outcome.setting), outcome.error(), study.states, outcome.least(),
      outcome.error(), outcome.step_cost.total(), cycles, in_period);
}

}  // namespace treedyn::accuracy
