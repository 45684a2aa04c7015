// The page of a simulation.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/simulate.hpp"
#include "common/transformed.hpp"
#include "emit/json.hpp"
#include "emit/template_file.hpp"
#include "model/effects.hpp"
#include "model/scene_facts.hpp"
#include "simulation/column_names.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

/// States that a page shows: more than a plot has pixels.
constexpr std::size_t kMostShownRows = 1200;

std::string bracketed(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ","));
}

/// Short numbers, enough for a picture.
template <class List>
std::string short_numbers(const List& values) {
  return bracketed(transformed(values, [&](double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
  }));
}

/// \param contacts  instead of those of the row, from this column on
std::string short_row(const simulation::Row& row, const std::vector<double>& contacts,
                      std::ptrdiff_t column) {
  std::vector<double> values = row.values;
  std::ranges::copy(contacts, values.begin() + column);
  std::vector<double> nodes;
  for (const Eigen::Vector3d& node : row.nodes) {
    nodes.insert(nodes.end(), {node[0], node[1], node[2]});
  }
  return fmt::format("[{:.9g},{},{},{}]", row.t, row.phase, short_numbers(values),
                     short_numbers(nodes));
}

/// At most kMostShownRows rows; those beside a change of phase and the last stay. Contact forces
/// are the largest since the row before.
std::string rows_json(const simulation::Recording& recording) {
  const std::vector<simulation::Row>& rows = recording.rows;
  const std::size_t every = (rows.size() + kMostShownRows - 1) / kMostShownRows;
  const auto column = std::ranges::find_if(
      recording.columns, [](const std::string& name) { return name.starts_with("F["); });
  std::vector<double> contacts;
  std::string result;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    simulation::keep_longer(contacts, rows[k].contacts);
    const bool edge = k + 1 == rows.size() || rows[k].phase != rows[k + 1].phase ||
                      (k > 0 && rows[k].phase != rows[k - 1].phase);
    if (edge || k % every == 0) {
      result += (result.empty() ? "" : ",\n") +
                short_row(rows[k], contacts, column - recording.columns.begin());
      contacts.clear();
    }
  }
  return result;
}

std::string events_json(const SimulateResult& result) {
  const std::vector<std::string> events =
      transformed(result.recording.events, [&](const simulation::EventRecord& event) {
        return emit::json_object({{"t", fmt::format("{:.9g}", event.time)},
                                  {"name", emit::json_string(event.name)},
                                  {"phase", emit::json_string(result.phase_name(event.phase))},
                                  {"then", emit::json_string(result.phase_name(event.then))}});
      });
  return bracketed(events);
}

std::string effects_of(const model::Scene& scene) {
  static constexpr std::array<std::string_view, 3> kToldElsewhere = {"gravity", "impact",
                                                                     "stabilisation"};
  std::vector<std::string> names;
  for (const model::EffectRow& effect : model::effects()) {
    const std::size_t count = model::entries_of(scene, effect.name);
    if (count > 0 && std::ranges::count(kToldElsewhere, effect.name) == 0) {
      names.push_back(count > 1 ? fmt::format("{} {}", count, effect.name)
                                : std::string(effect.name));
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string numbers_of(const model::Vector3& x) {
  return fmt::format("{:.6g}, {:.6g}, {:.6g}", static_cast<double>(x[0]), static_cast<double>(x[1]),
                     static_cast<double>(x[2]));
}

/// What keeps the constraints; a generated step projects nothing, but draws loops together.
std::string stabilisation_of(const SimulateResult& result) {
  const model::Scene& scene = result.scene;
  if (scene.constraints.empty() || scene.stepping.drift == model::Drift::kNone) {
    return "none";
  }
  if (scene.stepping.drift == model::Drift::kBaumgarte) {
    return "baumgarte";
  }
  if (!result.generated) {
    return "projection";
  }
  const auto loops = std::ranges::count_if(scene.constraints, [&](const model::Constraint& c) {
    return model::is_stabilised(scene, static_cast<int>(&c - scene.constraints.data()));
  });
  return loops == 0 ? "none" : fmt::format("baumgarte of {} closed loops", loops);
}

/// What ran, name and value.
std::string run_json(const SimulateResult& result) {
  const model::Scene& scene = result.scene;
  const model::Stepping& how = scene.stepping;
  const simulation::Recording& recording = result.recording;
  const bool adaptive = simulation::make_integrator(how.integrator)->error_order() > 0;
  std::vector<std::string> lines;
  const auto add = [&](const char* name, const std::string& value) {
    lines.push_back(fmt::format("[{}, {}]", emit::json_string(name), emit::json_string(value)));
  };
  add("model", scene.tree.name);
  if (result.generated) {
    add("motion",
        fmt::format("of the generated step in {}, --as-generated", result.generated->scalar));
  }
  add("integrator", how.integrator);
  add(adaptive ? "tolerance" : "step",
      adaptive ? fmt::format("{:.3g}", static_cast<double>(how.tolerance))
               : fmt::format("{:.6g} s", static_cast<double>(how.step)));
  add("stabilisation", stabilisation_of(result));
  add("gravity", numbers_of(scene.gravity) + " m/s^2");
  add("effects", effects_of(scene));
  add("steps", fmt::format("{} ({} rejected), {} evaluations", recording.cost.steps,
                           recording.cost.rejected, recording.cost.evaluations));
  add("energy without power", fmt::format("{:.2g} J at the end, at most {:.2g} of what had been "
                                          "exchanged, or of a fall by the robot's size",
                                          recording.energy_error, recording.energy_part));
  add("largest residual, drift",
      fmt::format("{:.2g}, {:.2g}", recording.residual, recording.drift));
  add("version", fmt::format("treedyn {}", kVersion));
  return bracketed(lines);
}

std::string short_vector_json(const model::Vector3& x) {
  return fmt::format("[{}]", numbers_of(x));
}

std::string planes_json(const model::Scene& scene) {
  std::vector<std::string> result;
  const auto add = [&](const model::Plane& plane) {
    const std::string text =
        emit::json_object({{"normal", short_vector_json(plane.normal)},
                           {"height", fmt::format("{:.6g}", static_cast<double>(plane.height))}});
    if (std::ranges::find(result, text) == result.end()) {
      result.push_back(text);
    }
  };
  for (const model::GroundContact& contact : scene.contacts) {
    add(contact.plane);
  }
  for (const model::Phase& phase : scene.phases) {
    for (const model::Event& event : phase.until) {
      if (event.kind == model::EventKind::kHeight) {
        add(event.plane);
      }
    }
  }
  return bracketed(result);
}

/// Where the forces on points act: the node of the figure, and columns with their directions.
class ForceList {
 public:
  ForceList(const model::Scene& scene, const std::vector<std::string>& columns)
      : scene_(scene), columns_(columns) {}

  std::string text() {
    std::size_t row = 0;
    const std::vector<std::string> names = simulation::reaction_names(scene_);
    for (const model::Constraint& c : scene_.constraints) {
      std::vector<std::pair<std::string, model::Vector3>> rows;
      for (std::size_t k = 0; k < c.rows(); ++k, ++row) {
        if (c.kind == model::ConstraintKind::kPoint) {
          rows.emplace_back(fmt::format("R[{}]", names[row]), c.directions[k]);
        }
      }
      add(c.point, rows);
    }
    // three columns a contact, whatever they are called
    const auto first = std::ranges::find_if(
        columns_, [](const std::string& name) { return name.starts_with("F["); });
    auto at = static_cast<std::size_t>(first - columns_.begin());
    for (const model::GroundContact& contact : scene_.contacts) {
      add(contact.point, {{columns_[at], {1, 0, 0}},
                          {columns_[at + 1], {0, 1, 0}},
                          {columns_[at + 2], {0, 0, 1}}});
      at += 3;
    }
    return bracketed(forces_);
  }

 private:
  void add(int point, const std::vector<std::pair<std::string, model::Vector3>>& rows) {
    const auto p = static_cast<std::size_t>(point);
    if (rows.empty() || scene_.points[p].link == model::kGround) {
      return;
    }
    std::vector<std::string> columns;
    std::vector<std::string> directions;
    for (const auto& [name, direction] : rows) {
      const auto at = std::ranges::find(columns_, name);
      columns.push_back(std::to_string(at - columns_.begin()));
      directions.push_back(short_vector_json(direction));
    }
    const auto before =
        std::count_if(scene_.points.begin(), scene_.points.begin() + point,
                      [](const model::Point& x) { return x.link != model::kGround; });
    forces_.push_back(emit::json_object({{"node", std::to_string(scene_.tree.size() + before)},
                                         {"columns", bracketed(columns)},
                                         {"directions", bracketed(directions)}}));
  }

  const model::Scene& scene_;
  const std::vector<std::string>& columns_;
  std::vector<std::string> forces_;
};

std::string bounds_json(const SimulateResult& result) {
  return fmt::format("[{{\"name\": \"warning\", \"value\": {}}}]", result.recording.drift_warning);
}

std::string units_json(const model::Scene& scene) {
  std::vector<std::pair<std::string, std::string>> members;
  for (const simulation::Column& column : simulation::columns_of(scene)) {
    members.emplace_back(column.name, emit::json_string(column.unit));
  }
  return emit::json_object(members);
}

/// What the page shows, as JSON that may stand inside a script element.
std::string report_data(const SimulateResult& result) {
  const simulation::Recording& recording = result.recording;
  const model::Scene& scene = result.scene;
  const std::vector<std::string> phases = transformed(scene.phases, &model::Phase::name);
  std::vector<std::string> lines;
  for (const auto& [a, b] : recording.figure.lines) {
    lines.push_back(fmt::format("[{},{}]", a, b));
  }
  const std::string text = fmt::format(
      "{{\"scene\": {}, \"dof\": {}, \"links\": {}, \"states\": {}, \"stopped\": {},\n"
      "\"run\": {},\n\"warnings\": {},\n\"events\": {},\n\"columns\": {},\n\"units\": {},\n"
      "\"phases\": {},\n\"names\": {},\n\"visible\": [{}],\n\"lines\": {},\n\"planes\": {},\n"
      "\"forces\": {},\n\"bounds\": {},\n\"rows\": [\n{}]}}",
      emit::json_string(scene.name), scene.tree.dof(), scene.tree.size(), recording.rows.size(),
      emit::json_string(recording.stopped), run_json(result),
      bracketed(emit::json_strings(warnings_of(result))), events_json(result),
      bracketed(emit::json_strings(recording.columns)), units_json(scene),
      bracketed(emit::json_strings(phases)), bracketed(emit::json_strings(recording.figure.names)),
      fmt::join(recording.figure.visible, ","), bracketed(lines), planes_json(scene),
      ForceList(scene, recording.columns).text(), bounds_json(result), rows_json(recording));
  std::string safe;
  for (const char c : text) {  // no name ends the script
    safe += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return safe;
}

}  // namespace

std::string report_text(const SimulateResult& result) {
  return emit::fill(emit::template_text("report.html"),
                    {{"scene", emit::html_text(result.scene.name)}, {"data", report_data(result)}});
}

}  // namespace treedyn
