// The results of a simulation as text.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "cli/simulate.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "emit/json.hpp"
#include "simulation/column_names.hpp"

namespace treedyn {

namespace {

/// A change of the initial state that is worth a warning, m, rad or their rates.
constexpr double kMoved = 1e-6;

/// A field in quotes if it needs them. What a spreadsheet would take for a formula (=1+1, +1, -1,
/// @a) begins with an apostrophe.
std::string csv_field(const std::string& name) {
  const bool formula = name.find_first_of("=+-@\t") == 0;
  std::string text = (formula ? "'" : "") + name;
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string result = "\"";
  for (const char c : text) {
    result += c;
    result += c == '"' ? "\"" : "";
  }
  return result + "\"";
}

using emit::json_number;
using emit::json_numbers;

std::string event_json(const SimulateResult& result, const simulation::EventRecord& event) {
  return emit::json_object({{"t", json_number(event.time)},
                            {"phase", emit::json_string(result.phase_name(event.phase))},
                            {"event", emit::json_string(event.name)},
                            {"q", json_numbers(event.q)},
                            {"qd_before", json_numbers(event.qd_before)},
                            {"qd_after", json_numbers(event.qd_after)},
                            {"impulse", json_numbers(event.impulse)}});
}

double seconds_for_a_second(const SimulateResult& result) {
  const double motion = result.recording.rows.back().t - static_cast<double>(result.scene.t0);
  return result.seconds.value_or(0) / std::max(motion, 1e-300);
}

std::string notice_json(const simulation::Notice& notice) {
  return emit::json_object({{"kind", emit::json_string(notice.kind)},
                            {"name", emit::json_string(notice.name)},
                            {"t", json_number(notice.time)},
                            {"value", json_number(notice.value)},
                            {"bound", json_number(notice.bound)},
                            {"worst", json_number(notice.worst)},
                            {"worst_t", json_number(notice.worst_time)},
                            {"unit", emit::json_string(notice.unit)},
                            {"text", emit::json_string(simulation::to_string(notice))}});
}

/// What has moved most: tables begin with q and qd.
simulation::Column column_of(const model::Scene& scene, const simulation::Move& move) {
  return simulation::columns_of(scene)[to_index(move.place)];
}

std::string warnings_json(const SimulateResult& result) {
  std::vector<std::string> lines;
  for (const simulation::Move& move : result.moved) {
    if (const std::optional<std::string> text = warning_of_move(result.scene, move)) {
      const simulation::Column column = column_of(result.scene, move);
      lines.push_back(emit::json_object({{"kind", "\"initial\""},
                                         {"name", emit::json_string(column.name)},
                                         {"t", json_number(static_cast<double>(result.scene.t0))},
                                         {"value", json_number(move.size)},
                                         {"bound", json_number(kMoved)},
                                         {"unit", emit::json_string(column.unit)},
                                         {"text", emit::json_string(*text)}}));
    }
  }
  for (const simulation::Notice& notice : result.recording.notices) {
    lines.push_back(notice_json(notice));
  }
  return emit::json_lines(lines, 4);
}

/// Wall time changes from run to run: only where it is asked for.
std::string cost_json(const SimulateResult& result) {
  const simulation::Cost& cost = result.recording.cost;
  std::vector<std::pair<std::string, std::string>> members = {
      {"evaluations", std::to_string(cost.evaluations)},
      {"rejected_steps", std::to_string(cost.rejected)}};
  if (result.generated) {
    members.emplace_back("operations", std::to_string(result.generated->operations));
  } else if (result.operations) {
    members.emplace_back("operations_of_terms", std::to_string(*result.operations));
  }
  if (result.seconds) {
    members.emplace_back("seconds_for_a_second", json_number(seconds_for_a_second(result)));
  }
  return emit::json_object(members);
}

std::string kept_json(const SimulateResult& result) {
  const simulation::Recording& recording = result.recording;
  return emit::json_object({{"unexplained_energy", json_number(recording.energy_error)},
                            {"unexplained_energy_part", json_number(recording.energy_part)},
                            {"largest_residual", json_number(recording.residual)},
                            {"largest_drift", json_number(recording.drift)}});
}

/// null: none found.
std::string stable_json(const SimulateResult& result) {
  std::vector<std::pair<std::string, std::string>> members;
  for (const simulation::StabilityLimit& limit : result.stability.limits) {
    members.emplace_back(limit.integrator, limit.step ? json_number(*limit.step) : "null");
  }
  return emit::json_object(members);
}

std::string row_json(const SimulateResult& result, const simulation::Row& row) {
  std::vector<std::string> values = {json_number(row.t),
                                     emit::json_string(result.phase_name(row.phase))};
  std::ranges::transform(row.values, std::back_inserter(values), json_number);
  return emit::json_list(values);
}

/// Forces and reactions are not counted, as they are no straight-line code.
std::string operations_text(const SimulateResult& result) {
  const auto evaluations = static_cast<double>(result.recording.cost.evaluations);
  if (result.generated) {
    return fmt::format(", {:.3g} operations in all, without those of events",
                       static_cast<double>(result.generated->operations));
  }
  if (!result.operations) {
    return "";
  }
  return *result.operations == 0
             ? "; what they take of the tree (A, B + G, points) is constant"
             : fmt::format(
                   "; what they take of the tree (A, B + G, points): {} operations each, {:.3g} in "
                   "all",
                   *result.operations, static_cast<double>(*result.operations) * evaluations);
}

}  // namespace

std::optional<std::string> warning_of_move(const model::Scene& scene,
                                           const simulation::Move& move) {
  if (!(move.size > kMoved)) {
    return std::nullopt;
  }
  const simulation::Column column = column_of(scene, move);
  return fmt::format("the initial state was moved by {:.2g} {} ({}) onto the constraints",
                     move.size, column.unit, column.name);
}

std::vector<std::string> warnings_of(const SimulateResult& result) {
  std::vector<std::string> lines;
  for (const simulation::Move& move : result.moved) {
    if (std::optional<std::string> line = warning_of_move(result.scene, move)) {
      lines.push_back(*std::move(line));
    }
  }
  for (const simulation::Notice& notice : result.recording.notices) {
    lines.push_back(simulation::to_string(notice));
  }
  for (const Warning& warning : result.warnings) {
    lines.push_back(warning.message);
  }
  return lines;
}

std::vector<std::string> facts_of(const SimulateResult& result) {
  const simulation::Recording& recording = result.recording;
  std::vector<std::string> lines = {
      fmt::format("{} steps, {} states, {} events; {} steps rejected", recording.cost.steps,
                  recording.rows.size(), recording.events.size(), recording.cost.rejected),
      fmt::format("{} evaluations of the dynamics{}", recording.cost.evaluations,
                  operations_text(result)),
      fmt::format(
          "energy that no force explains: {:.3g} J at the end, at most {:.3g} of what the motion "
          "had exchanged, or of a fall by the robot's size; largest residual {:.3g}, drift {:.3g}",
          recording.energy_error, recording.energy_part, recording.residual, recording.drift)};
  for (const simulation::StabilityLimit& limit : result.stability.limits) {
    lines.push_back(limit.step ? fmt::format("{} is stable up to steps of {:.3g} s here",
                                             limit.integrator, *limit.step)
                               : fmt::format("no limit of {} found here", limit.integrator));
  }
  if (result.seconds) {
    lines.push_back(
        fmt::format("{:.3g} s of computing for a second of motion", seconds_for_a_second(result)));
  }
  return lines;
}

std::string csv_text(const SimulateResult& result) {
  std::string text = "t,phase";
  for (const std::string& column : result.recording.columns) {
    text += ',' + csv_field(column);
  }
  text += "\n";
  for (const simulation::Row& row : result.recording.rows) {
    text += fmt::format("{},{}", row.t, csv_field(result.phase_name(row.phase)));
    for (const double value : row.values) {
      text += fmt::format(",{}", value);
    }
    text += "\n";
  }
  return text;
}

std::string json_text(const SimulateResult& result) {
  std::vector<std::string> columns = {"t", "phase"};
  columns.insert(columns.end(), result.recording.columns.begin(), result.recording.columns.end());
  const std::vector<std::string> rows = transformed(
      result.recording.rows, [&](const simulation::Row& row) { return row_json(result, row); });
  const std::vector<std::string> events =
      transformed(result.recording.events,
                  [&](const simulation::EventRecord& event) { return event_json(result, event); });
  std::vector<std::string> statuses;
  for (const StatusRecord& status : result.statuses) {
    statuses.push_back(emit::json_object({{"name", emit::json_string(status_names(status.bit))},
                                          {"first", json_number(status.first)},
                                          {"steps", std::to_string(status.count)}}));
  }
  return fmt::format(
      "{{\n  \"scene\": {},\n  \"model\": {},\n  \"integrator\": {}, \"as_generated\": {},\n  "
      "\"steps\": {},\n"
      "  \"stopped\": {},\n  \"warnings\": {},\n  \"statuses\": {},\n  \"cost\": {},\n  \"kept\": "
      "{},\n"
      "  \"stable_steps\": {},\n  \"columns\": {},\n  \"events\": {},\n  \"rows\": {}\n}}\n",
      emit::json_string(result.scene.name), emit::json_string(result.scene.tree.name),
      emit::json_string(result.scene.stepping.integrator),
      result.generated ? emit::json_string(result.generated->scalar) : "null",
      result.recording.cost.steps, emit::json_string(result.recording.stopped),
      warnings_json(result), emit::json_lines(statuses, 4), cost_json(result), kept_json(result),
      stable_json(result), emit::json_list(emit::json_strings(columns)),
      emit::json_lines(events, 4), emit::json_lines(rows, 4));
}

}  // namespace treedyn
