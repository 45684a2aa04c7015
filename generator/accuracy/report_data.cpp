// A study for programs: CSV, JSON and settings.

#include <fmt/format.h>

#include "accuracy/report.hpp"
#include "common/transformed.hpp"
#include "emit/json.hpp"

namespace treedyn::accuracy {

namespace {

const char* scalar_of(State state) { return state == State::kDouble ? "double" : "float"; }

const char* kept_of(State state) { return state == State::kCompensated ? "compensated" : "plain"; }

/// Columns of all errors, empty where the scene has none.
std::string csv_errors(const Outcome& outcome) {
  std::string text;
  for (const ErrorRow& row : kErrors) {
    const auto add = [&](double value) {
      text += outcome.failed() ? ",failed" : fmt::format(",{}", value);
    };
    if (!outcome.has(row.error)) {
      text += ",";
      continue;
    }
    add(outcome.error(row.error));
    if (row.error == Error::kJoints) {
      add(outcome.failed() ? 0 : outcome.least());
    }
  }
  return text;
}

std::string csv_sizes(const Outcome& outcome) {
  std::string text;
  for (const Core& core : cores()) {
    const auto size = outcome.sizes.find(std::string(core.name));
    if (core.has_flash()) {
      text += size == outcome.sizes.end()
                  ? ",,"
                  : fmt::format(",{},{}", size->second.flash, size->second.stack);
    }
  }
  return text;
}

std::string csv_head() {
  std::string text =
      "scalar,state,integrator,step,sincos,forward_dynamics,stabilisation,cuts,without";
  for (const ErrorRow& row : kErrors) {
    text += fmt::format(",{}{}", row.column, row.error == Error::kJoints ? ",least_error" : "");
  }
  text += ",status,add,mul,div,sqrt,sin,cos";
  for (const Core& core : cores()) {
    text += fmt::format(",cycles_per_second_{}", core.name);
  }
  for (const Core& core : cores()) {
    text += core.has_flash() ? fmt::format(",flash_{0},stack_{0}", core.name) : "";
  }
  text += ",fused";
  for (const Core& core : cores()) {
    text += fmt::format(",contracted_{}", core.name);
  }
  return text;
}

using Members = std::vector<std::pair<std::string, std::string>>;

/// A choice of a step in JSON.
Members setting_members(const Setting& setting) {
  const Variant& variant = setting.variant;
  const auto text = [](const std::string& word) {
    return emit::json_string(word);
  };
  return {{"scalar", text(scalar_of(setting.state))},
          {"state", text(kept_of(setting.state))},
          {"integrator", text(setting.integrator)},
          {"step", fmt::format("{}", setting.step)},
          {"sincos", text(variant.sincos)},
          {"forward_dynamics", text(variant.forward_dynamics)},
          {"stabilisation", text(variant.stabilisation)},
          {"cuts", text(variant.cuts)},
          {"without", text(variant.without)}};
}

/// All that came of it.
Members outcome_members(const Outcome& outcome) {
  Members members = setting_members(outcome.setting);
  for (const auto& [error, values] : outcome.errors) {
    members.emplace_back(fmt::format("{}s", row_of(error).column), emit::json_numbers(values));
  }
  members.emplace_back("status", fmt::format("{}", outcome.status));
  members.emplace_back("operations", fmt::format("{}", outcome.step_cost().total()));
  for (const Core& core : cores()) {
    members.emplace_back(fmt::format("cycles_per_second_{}", core.name),
                         fmt::format("{:.6g}", outcome.cycles_per_second(core)));
    members.emplace_back(fmt::format("contracted_{}", core.name),
                         fmt::format("{:.6g}", outcome.cycles_per_second(core, true)));
  }
  for (const auto& [core, size] : outcome.sizes) {
    members.emplace_back("flash_" + core, fmt::format("{}", size.flash));
    members.emplace_back("stack_" + core, fmt::format("{}", size.stack));
  }
  return members;
}

}  // namespace

std::string report_csv(const Study& study) {
  std::string text = csv_head() + "\n";
  for (const Outcome& outcome : study.outcomes) {
    const program::Cost cost = outcome.step_cost();
    const Setting& setting = outcome.setting;
    const Variant& variant = setting.variant;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{}{},{},{},{},{},{},{},{}", scalar_of(setting.state),
                    kept_of(setting.state), setting.integrator, setting.step, variant.sincos,
                    variant.forward_dynamics, variant.stabilisation, variant.cuts, variant.without,
                    csv_errors(outcome), outcome.status, cost.add, cost.mul, cost.div, cost.sqrt,
                    cost.sin, cost.cos);
    for (const Core& core : cores()) {
      text += fmt::format(",{:.6g}", outcome.cycles_per_second(core));
    }
    text += csv_sizes(outcome) + fmt::format(",{}", cost.fused);
    for (const Core& core : cores()) {
      text += fmt::format(",{:.6g}", outcome.cycles_per_second(core, true));
    }
    text += "\n";
  }
  return text;
}

std::string report_json(const Study& study) {
  const std::vector<std::string> rows = transformed(study.outcomes, [&](const Outcome& outcome) {
    return emit::json_object(outcome_members(outcome));
  });
  Members differences;
  for (const auto& [error, difference] : study.reference.differences) {
    differences.emplace_back(row_of(error).name, fmt::format("{:.3g}", difference));
  }
  Members limits;
  for (const StepLimit& limit : study.stability) {
    limits.emplace_back(limit.integrator, fmt::format("{:.3g}", limit.step));
  }
  return fmt::format(
      "{{\n  \"scene\": {},\n  \"duration\": {},\n  \"states\": {},\n  \"spread\": {},\n  "
      "\"error\": \"{}\",\n  \"points\": {},\n  \"reference_agreement\": {:.3g},\n  "
      "\"reference_differences\": {},\n  \"check_difference\": {:.3g},\n  \"stability_limits\": "
      "{},\n  \"settings\": {}\n}}\n",
      emit::json_string(study.scene), study.duration, study.states, study.spread,
      row_of(study.error).name, emit::json_list(emit::json_strings(study.points)),
      study.reference.agreement, emit::json_object(differences), study.reference.check_difference,
      emit::json_object(limits), emit::json_lines(rows, 4));
}

std::string settings_text(const Study& study, const Setting& setting) {
  const Variant& variant = setting.variant;
  const Variant usual;
  std::string text = fmt::format(
      "scalar = \"{}\"\nintegrator = \"{}\"\nstep = {}\nstate = \"{}\"\nsincos = \"{}\"\n",
      scalar_of(setting.state), setting.integrator, setting.step, kept_of(setting.state),
      variant.sincos);
  if (variant.forward_dynamics != usual.forward_dynamics) {
    text += fmt::format("forward-dynamics = \"{}\"\n", variant.forward_dynamics);
  }
  text += fmt::format("cuts = {}\n",
                      variant.cuts == usual.cuts ? std::to_string(study.cuts) : variant.cuts);
  text += "layout = \"dense\"  # of A where it is asked for; step stores none\n";
  if (variant.stabilisation != usual.stabilisation) {
    text += fmt::format("# and in the scene, effects: {{stabilisation: {{method: {}}}}}\n",
                        variant.stabilisation);
  }
  if (variant.without != usual.without) {
    text += fmt::format("# and in the scene, use: {{{}: off}}\n", variant.without);
  }
  return text;
}

}  // namespace treedyn::accuracy
