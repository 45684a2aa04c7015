// The results of a simulation as text.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "cli/simulate.hpp"
#include "emit/json.hpp"
#include "emit/template_file.hpp"

namespace treedyn {

namespace {

/// A field in quotes if it needs them.
std::string csv_field(const std::string& text) {
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

/// JSON has no word for what is not finite.
std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

template <class List>
std::string json_numbers(const List& values) {
  std::string result;
  for (const double value : values) {
    result += (result.empty() ? "" : ", ") + json_number(value);
  }
  return "[" + result + "]";
}

std::string json_strings(const std::vector<std::string>& values) {
  std::string result;
  for (const std::string& value : values) {
    result += (result.empty() ? "" : ", ") + emit::json_string(value);
  }
  return "[" + result + "]";
}

const std::string& phase_name(const SimulateResult& result, int phase) {
  return result.scene.phases[static_cast<std::size_t>(phase)].name;
}

std::string event_json(const SimulateResult& result, const simulation::EventRecord& event) {
  return emit::json_object({{"t", json_number(event.time)},
                            {"phase", emit::json_string(phase_name(result, event.phase))},
                            {"q", json_numbers(event.q)},
                            {"qd_before", json_numbers(event.qd_before)},
                            {"qd_after", json_numbers(event.qd_after)},
                            {"impulse", json_numbers(event.impulse)}});
}

std::string row_json(const SimulateResult& result, const simulation::Row& row) {
  std::string text =
      fmt::format("[{}, {}", json_number(row.t), emit::json_string(phase_name(result, row.phase)));
  for (const double value : row.values) {
    text += ", " + json_number(value);
  }
  return text + "]";
}

/// Short numbers, enough for a picture.
template <class List>
std::string short_numbers(const List& values) {
  std::string result;
  for (const double value : values) {
    result += result.empty() ? "" : ",";
    result += std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
  }
  return "[" + result + "]";
}

std::string short_row(const simulation::Row& row) {
  std::vector<double> nodes;
  for (const Eigen::Vector3d& node : row.nodes) {
    nodes.insert(nodes.end(), {node[0], node[1], node[2]});
  }
  return fmt::format("[{:.9g},{},{},{}]", row.t, row.phase, short_numbers(row.values),
                     short_numbers(nodes));
}

/// What the page shows, as JSON that may stand inside a script element.
std::string report_data(const SimulateResult& result) {
  const simulation::Recording& recording = result.recording;
  std::vector<std::string> phases;
  for (const model::Phase& phase : result.scene.phases) {
    phases.push_back(phase.name);
  }
  std::string lines;
  for (const auto& [a, b] : recording.figure.lines) {
    lines += fmt::format("{}[{},{}]", lines.empty() ? "" : ",", a, b);
  }
  std::string rows;
  for (const simulation::Row& row : recording.rows) {
    rows += (rows.empty() ? "" : ",\n") + short_row(row);
  }
  const std::string text = fmt::format(
      "{{\"scene\": {}, \"dof\": {}, \"links\": {}, \"stopped\": {},\n\"columns\": {},\n"
      "\"phases\": {},\n\"names\": {},\n\"lines\": [{}],\n\"rows\": [\n{}]}}",
      emit::json_string(result.scene.name), result.scene.tree.dof(), result.scene.tree.size(),
      emit::json_string(recording.stopped), json_strings(recording.columns), json_strings(phases),
      json_strings(recording.figure.names), lines, rows);
  std::string safe;
  for (const char c : text) {  // no name ends the script
    safe += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return safe;
}

std::string html_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string csv_text(const SimulateResult& result) {
  std::string text = "t,phase";
  for (const std::string& column : result.recording.columns) {
    text += ',' + csv_field(column);
  }
  text += "\n";
  for (const simulation::Row& row : result.recording.rows) {
    text += fmt::format("{},{}", row.t, csv_field(phase_name(result, row.phase)));
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
  std::vector<std::string> rows;
  for (const simulation::Row& row : result.recording.rows) {
    rows.push_back(row_json(result, row));
  }
  std::vector<std::string> events;
  for (const simulation::EventRecord& event : result.recording.events) {
    events.push_back(event_json(result, event));
  }
  return fmt::format(
      "{{\n  \"scene\": {},\n  \"model\": {},\n  \"integrator\": {},\n  \"steps\": {},\n"
      "  \"stopped\": {},\n  \"columns\": {},\n  \"events\": {},\n  \"rows\": {}\n}}\n",
      emit::json_string(result.scene.name), emit::json_string(result.scene.tree.name),
      emit::json_string(result.scene.stepping.integrator), result.recording.steps,
      emit::json_string(result.recording.stopped), json_strings(columns),
      emit::json_lines(events, 4), emit::json_lines(rows, 4));
}

std::string report_text(const SimulateResult& result) {
  return emit::fill(emit::template_text("report.html"),
                    {{"scene", html_text(result.scene.name)}, {"data", report_data(result)}});
}

}  // namespace treedyn
