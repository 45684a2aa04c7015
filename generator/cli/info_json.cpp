#include <fmt/format.h>

#include "cli/info.hpp"
#include "cli/model_facts.hpp"
#include "cli/prices.hpp"
#include "common/transformed.hpp"
#include "emit/header.hpp"
#include "emit/json.hpp"
#include "emit/manifest.hpp"
#include "emit/run_time.hpp"

namespace treedyn {

namespace {

using emit::json_list;
using emit::json_object;
using emit::json_string;

std::string vector_json(const model::Vector3& v) {
  return json_list({emit::decimal(v[0]), emit::decimal(v[1]), emit::decimal(v[2])});
}

std::vector<std::string> joints_json(const Model& model) {
  std::vector<std::string> result;
  for (int k = 0; k < model.tree.dof(); ++k) {
    const model::Link& link = model.tree.moved_by(k);
    result.push_back(
        json_object({{"name", json_string(link.joint.name)},
                     {"identifier", json_string(link.joint.identifier)},
                     {"index", std::to_string(k)},
                     {"type", json_string(link.joint.turns() ? "revolute" : "prismatic")},
                     {"father", std::to_string(emit::father_coordinate(model.tree, k))},
                     {"link", json_string(link.name)},
                     {"mass", emit::decimal(link.inertia.mass)}}));
  }
  return result;
}

std::vector<std::string> links_json(const model::Tree& tree) {
  std::vector<std::string> result;
  const std::vector<std::string> matrix = reachability_rows(tree);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const model::Link& link = tree.links[i];
    const model::Drive& drive = tree.drives[i];
    result.push_back(json_object({{"name", json_string(link.name)},
                                  {"father", std::to_string(link.father)},
                                  {"mass", emit::decimal(link.inertia.mass)},
                                  {"com", vector_json(link.inertia.com)},
                                  {"coordinate", std::to_string(drive.coordinate)},
                                  {"multiplier", emit::decimal(drive.multiplier)},
                                  {"offset", emit::decimal(drive.offset)},
                                  {"D", json_string(matrix[i])}}));
  }
  return result;
}

std::vector<std::string> points_json(const Model& model) {
  return transformed(model.points, [&](const model::Point& point) {
    return json_object({{"name", json_string(point.name)},
                        {"identifier", json_string(point.identifier)},
                        {"link", json_string(point.link_name)},
                        {"at", vector_json(model::place_in_frame(model.tree, point))}});
  });
}

std::vector<std::string> snaps_json(const model::Tree& tree) {
  return transformed(tree.snaps, [&](const model::Snap& snap) {
    return json_object({{"line", std::to_string(snap.where.line)},
                        {"column", std::to_string(snap.where.column)},
                        {"what", json_string(snap.what)},
                        {"from", json_string(snap.from)},
                        {"to", json_string(snap.to)},
                        {"change", emit::decimal(snap.change)}});
  });
}

std::vector<std::string> dissipations_json(const model::Tree& tree) {
  return transformed(tree.dissipations, [&](const model::Dissipation& of) {
    return json_object({{"line", std::to_string(of.where.line)},
                        {"column", std::to_string(of.where.column)},
                        {"joint", json_string(of.joint)},
                        {"damping", json_string(of.damping)},
                        {"friction", json_string(of.friction)}});
  });
}

/// \param key  what the prices are of
std::string prices_json(const char* key, const std::vector<Price>& prices) {
  return emit::json_lines(
      transformed(prices,
                  [&](const Price& price) {
                    return json_object({{key, json_string(price.of)},
                                        {"function", json_string(price.function)},
                                        {"with", emit::operations_json(price.with)},
                                        {"without", emit::operations_json(price.without)}});
                  }),
      4);
}

/// Nothing without run-time parameters.
std::string parameters_json(const Model& model, const Request& request,
                            const program::Programs& programs) {
  if (!programs.update) {
    return {};
  }
  return emit::parameters_json(model.tree, decided_request(model, request).gravity) +
         fmt::format(",\n  \"parameter_prices\": {}",
                     prices_json("declared", parameter_prices(model, request, programs)));
}

std::vector<std::string> functions_json(const Model& model, const Request& request,
                                        const program::Programs& programs) {
  return transformed(priced(model, request, programs), [&](const Priced& function) {
    return json_object({{"name", json_string(function.signature.name)},
                        {"equation", json_string(function.signature.equation)},
                        {"values", std::to_string(function.values())},
                        {"operations", emit::operations_json(function.cost)},
                        {"fused", std::to_string(function.cost.fused)}});
  });
}

}  // namespace

std::string info_json(const Model& model, const Request& request,
                      const program::Programs& programs) {
  const bool axes = decided_request(model, request).read.base == description::Base::kAxes;
  return fmt::format(
      "{{\n  \"name\": {},\n  \"base\": {},\n  \"dof\": {},\n  \"mass\": {},\n  \"joints\": {},\n"
      "  \"links\": {},\n  \"points\": {},\n  \"snapped\": {},\n  \"dissipations\": {},\n  "
      "\"functions\": {}{}{}\n}}\n",
      json_string(model.tree.name), json_string(axes ? "axes" : "fixed"), model.tree.dof(),
      emit::decimal(total_mass(model.tree)), emit::json_lines(joints_json(model), 4),
      emit::json_lines(links_json(model.tree), 4), emit::json_lines(points_json(model), 4),
      emit::json_lines(snaps_json(model.tree), 4),
      emit::json_lines(dissipations_json(model.tree), 4),
      emit::json_lines(functions_json(model, request, programs), 4),
      parameters_json(model, request, programs),
      model.scene ? fmt::format(",\n  \"prices\": {}",
                                prices_json("effect", effect_prices(model, request, programs)))
                  : "");
}

}  // namespace treedyn
