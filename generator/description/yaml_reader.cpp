#include "description/yaml_reader.hpp"

#include <fmt/format.h>

#include "description/fields.hpp"

namespace treedyn::description {

namespace {

RawLimits read_limits(const std::string& file, const Node& node, const std::string& what) {
  const Fields fields(file, node, what + ": limits", {"lower", "upper", "velocity", "effort"});
  return {fields.optional_text("lower"), fields.optional_text("upper"),
          fields.optional_text("velocity"), fields.optional_text("effort")};
}

void read_rotation(const std::string& file, const Node& node, const std::string& what,
                   RawPose& pose) {
  const Fields fields(file, node, what + ": rotation", {"rpy", "matrix"});
  pose.rpy = fields.numbers("rpy");
  pose.matrix = fields.numbers("matrix");
  if (pose.rpy.has_value() == pose.matrix.has_value()) {
    fields.fail(node.where, fmt::format("has {}; expected either rpy or matrix",
                                        pose.rpy ? "both rpy and matrix" : "no entry"));
  }
}

RawJoint read_joint(const std::string& file, const Node& node, const Text& link,
                    const std::string& of_link) {
  const std::string what = called(of_link + ": joint", node, 0);
  const Fields fields(file, node, what, {"name", "type", "axis", "offset", "rotation", "limits"});
  RawJoint joint;
  joint.name = fields.optional_text("name").value_or(Text{link.text, node.where});
  joint.type = fields.text("type");
  joint.son = link;
  joint.where = node.where;
  joint.axis = fields.numbers("axis");
  joint.pose.xyz = fields.numbers("offset");
  if (const Node* const rotation = fields.find("rotation")) {
    read_rotation(file, *rotation, what, joint.pose);
  }
  if (const Node* const limits = fields.find("limits")) {
    joint.limits = read_limits(file, *limits, what);
  }
  return joint;
}

void read_link(const Node& node, std::size_t index, RawTree& raw) {
  const std::string what = called("link", node, index);
  const Fields fields(raw.file, node, what,
                      {"name", "father", "joint", "mass", "com", "inertia", "runtime"});
  RawLink link{fields.text("name"), std::nullopt, node.where};
  RawJoint joint = read_joint(raw.file, fields.get("joint"), link.name, what);
  joint.father = fields.text("father");
  if (fields.find("mass") != nullptr) {
    link.inertia = RawInertia{fields.text("mass"), {}, fields.numbers("inertia"), node.where};
    link.inertia->pose.xyz = fields.numbers("com");
  } else if (const Node* const lone =
                 fields.find("com") != nullptr ? fields.find("com") : fields.find("inertia")) {
    fields.fail(lone->key.where,
                fmt::format("'{}' without a mass; expected mass too", lone->key.text));
  }
  for (const Node& item : fields.list("runtime")) {
    raw.runtime.push_back({link.name, fields.scalar(item)});
  }
  raw.links.push_back(std::move(link));
  raw.joints.push_back(std::move(joint));
}

void read_point(const Node& node, std::size_t index, RawTree& raw) {
  const Fields fields(raw.file, node, called("point", node, index),
                      {"name", "link", "at", "runtime"});
  raw.points.push_back({fields.text("name"), fields.text("link"), fields.numbers("at")});
  for (const Node& item : fields.list("runtime")) {
    raw.runtime.push_back({raw.points.back().name, fields.scalar(item), true});
  }
}

/// A scene where a model belongs is a slip that deserves better words than an unknown key.
void refuse_scene(const Node& root, const std::string& file) {
  if (const Node* const scene = find(root, "scene")) {
    throw InputError(scene->key.where.in(file),
                     "is a scene; expected a tree description; generate, check, outputs and info "
                     "take it as --scene");
  }
}

}  // namespace

RawTree read_yaml(const std::string& text, const std::string& file) {
  const Node root = parse_yaml_node(text, file);
  refuse_scene(root, file);
  RawTree raw;
  raw.format = Format::kYaml;
  raw.file = file;
  const Fields fields(raw.file, root, "tree description",
                      {"name", "parameters", "links", "points", "equations", "runtime"});
  raw.name = fields.text("name");
  if (const Node* const node = fields.find("parameters")) {
    for (const Node& item : parameters(raw.file, *node)) {
      raw.parameters.push_back({item.key, {item.text, item.where}});
    }
  }
  const std::vector<Node>& links = fields.sequence(fields.get("links"));
  for (std::size_t k = 0; k < links.size(); ++k) {
    read_link(links[k], k, raw);
  }
  for (const Node& item : fields.list("runtime")) {
    raw.runtime.push_back({{}, fields.scalar(item)});
  }
  const std::vector<Node>& points = fields.list("points");
  for (std::size_t k = 0; k < points.size(); ++k) {
    read_point(points[k], k, raw);
  }
  return raw;
}

}  // namespace treedyn::description
