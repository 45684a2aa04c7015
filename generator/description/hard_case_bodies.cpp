#include "description/hard_case_bodies.hpp"

#include <set>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"
#include "description/scene_fields.hpp"

namespace treedyn::description {

namespace {

/// Nine numbers of three rows.
Numbers rows_of(const SceneFields& fields, const Node& node) {
  Numbers result{{}, node.where};
  for (const Node& row : fields.sequence(node)) {
    const Numbers numbers = fields.numbers(row);
    result.values.insert(result.values.end(), numbers.values.begin(), numbers.values.end());
  }
  if (node.items.size() != 3 || result.values.size() != 9) {
    fields.fail(node.where, fmt::format("'{}' has {} rows with {} entries; expected 3 rows of 3",
                                        node.key.text, node.items.size(), result.values.size()));
  }
  return result;
}

/// ixx ixy ixz iyy iyz izz of a symmetric matrix.
Numbers upper_half(const SceneFields& fields, const Node& node) {
  const Numbers all = rows_of(fields, node);
  for (const auto& [upper, lower] : {std::pair(1, 3), std::pair(2, 6), std::pair(5, 7)}) {
    const Text& a = all.values[to_index(upper)];
    const Text& b = all.values[to_index(lower)];
    if (read_decimal(a.text).value != read_decimal(b.text).value) {
      fields.fail(b.where, fmt::format("'{}' is not symmetric, {} differs from {}; expected equal "
                                       "entries",
                                       node.key.text, b.text, a.text));
    }
  }
  Numbers result{{}, node.where};
  for (const std::size_t k : {0U, 1U, 2U, 4U, 5U, 8U}) {
    result.values.push_back(all.values[k]);
  }
  return result;
}

/// The names of the file if they are different identifiers of links, else "body_1", ..
std::vector<std::string> body_names(const std::vector<Node>& bodies) {
  std::vector<std::string> names;
  std::set<std::string> identifiers;
  for (const Node& body : bodies) {
    for (const Node& item : body.items) {
      if (item.key.text == "name" && !item.text.empty() && item.text != "ground" &&
          identifiers.insert(to_identifier(item.text)).second) {
        names.push_back(item.text);
      }
    }
  }
  if (names.size() != bodies.size()) {
    names.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      names.push_back(fmt::format("body_{}", k + 1));
    }
  }
  return names;
}

void read_body(const std::string& file, const Node& node, std::size_t index,
               const std::vector<std::string>& names, RawTree& raw) {
  const SceneFields fields(
      file, node, called("body", node, index),
      {"name", "father", "joint", "axis", "offset", "R0", "mass", "com", "inertia"});
  const int father = fields.integer("father", 0, static_cast<int>(index));
  RawLink link{{names[index], node.where}, std::nullopt, node.where};
  link.inertia =
      RawInertia{fields.text("mass"), {}, upper_half(fields, fields.get("inertia")), node.where};
  link.inertia->pose.xyz = fields.numbers(fields.get("com"));
  RawJoint joint;
  joint.name = joint.son = link.name;
  joint.type = fields.text("joint");
  if (joint.type.text != "revolute" && joint.type.text != "prismatic") {
    fields.fail(joint.type.where, fmt::format("joint '{}' is unknown; expected revolute or "
                                              "prismatic",
                                              joint.type.text));
  }
  joint.father = {father == 0 ? "ground" : names[to_index(father - 1)], fields.get("father").where};
  joint.where = node.where;
  joint.axis = fields.numbers(fields.get("axis"));
  joint.pose.xyz = fields.numbers(fields.get("offset"));
  joint.pose.matrix = rows_of(fields, fields.get("R0"));
  raw.links.push_back(std::move(link));
  raw.joints.push_back(std::move(joint));
}

}  // namespace

RawTree read_bodies(const std::string& file, const Node& model, const std::string& name) {
  const SceneFields fields(file, model, "model", {"bodies"});
  const std::vector<Node>& bodies = fields.sequence(fields.get("bodies"));
  if (bodies.empty()) {
    fields.fail(model.where, "has no body; expected at least one");
  }
  RawTree raw;
  raw.format = Format::kYaml;
  raw.file = file;
  raw.name = {name, model.where};
  const std::vector<std::string> names = body_names(bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    read_body(file, bodies[k], k, names, raw);
  }
  return raw;
}

}  // namespace treedyn::description
