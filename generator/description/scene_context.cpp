#include "description/scene_context.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"
#include "description/named_points.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {

namespace {

using model::Quantity;
using model::Variable;

/// A point of a link of the file. \param at  in the frame of this link
model::Point point_of_frame(const std::string& name, const model::Frame& frame, const Vector3& at) {
  return {name,
          to_identifier(name),
          frame.name,
          frame.link,
          frame.origin + frame.rotation * at,
          frame.rotation};
}

constexpr std::array<std::string_view, 6> kComponents = {"x", "y", "z", "vx", "vy", "vz"};

std::optional<Variable> component(std::string_view name) {
  const auto* const found = std::ranges::find(kComponents, name);
  if (found == kComponents.end()) {
    return std::nullopt;
  }
  const auto k = static_cast<int>(found - kComponents.begin());
  return Variable{k < 3 ? Quantity::kPointPosition : Quantity::kPointVelocity, k % 3};
}

bool same_place(const model::Point& a, const model::Point& b) {
  const Real scale = 1 + norm(a.at);
  return a.link == b.link && norm(a.at - b.at) <= Real("1e-30") * scale;
}

/// A parameter hides no variable of any expression.
void refuse_variable(const std::string& file, const Text& name, const std::string& what) {
  constexpr std::array<std::string_view, 5> kOthers = {"t", "q", "qd", "d", "v"};
  if (component(name.text) || std::ranges::find(kOthers, name.text) != kOthers.end()) {
    throw InputError(name.where.in(file),
                     what + " has the name of a variable of expressions; expected a new name");
  }
}

}  // namespace

void SceneContext::define(const Node& item, const std::string& what, bool run_time) {
  const auto number = [&](const Real& nominal) {
    std::vector<model::Parameter>& all = scene_.tree.parameters;
    all.push_back({model::kGround, model::ParameterKind::kScene, 0, item.key.text,
                   to_identifier(item.key.text), nominal});
    return at_run_time_(static_cast<int>(all.size()) - 1, nominal);
  };
  try {
    if (run_time && at_run_time_) {
      constants_.define_at_run_time(item.key.text, item.text, number);
    } else {
      constants_.define(item.key.text, item.text);
    }
  } catch (const TextError& problem) {
    const Place where = item.where.at(problem.offset());
    throw InputError(where.in(file_), fmt::format("{}: {}", what, problem.what()));
  }
}

void SceneContext::define_parameters(const Node* node, const std::vector<Text>& run_time) {
  std::vector<Text> missing = run_time;
  std::vector<std::string_view> names;
  for (const Node& item : node == nullptr ? std::vector<Node>{} : parameters(file_, *node)) {
    const std::string what = fmt::format("parameter '{}'", shown(item.key.text));
    refuse_variable(file_, item.key, what);
    const std::size_t at_run_time =
        std::erase_if(missing, [&](const Text& text) { return text.text == item.key.text; });
    define(item, what, at_run_time > 0);
    names.push_back(item.key.text);
  }
  if (!missing.empty()) {
    const Text& name = missing.front();
    throw InputError(name.where.in(file_),
                     fmt::format("runtime: there is no parameter '{}'{}; expected one of "
                                 "'parameters'",
                                 shown(name.text), did_you_mean(name.text, names)));
  }
}

std::optional<int> SceneContext::coordinate(std::string_view name) const {
  const model::Tree& tree = scene_.tree;
  for (int k = 0; k < tree.dof(); ++k) {
    if (tree.moved_by(k).joint.name == name) {
      return k;
    }
  }
  return std::nullopt;
}

int SceneContext::joint(const Fields& fields, const Text& name) const {
  const std::optional<int> found = coordinate(name.text);
  if (!found) {
    const model::Tree& tree = scene_.tree;
    std::vector<std::string_view> names;
    for (const int link : tree.coordinates) {
      names.push_back(tree.links[static_cast<std::size_t>(link)].joint.name);
    }
    fields.fail(name.where,
                fmt::format("joint '{}' is no joint of the model that moves by itself{}; expected "
                            "one of {}",
                            shown(name.text), did_you_mean(name.text, names), some_names(names)));
  }
  return *found;
}

int SceneContext::add(const Fields& fields, const Place& where, model::Point point) {
  for (const model::Point& other : scene_.points) {
    if (other.identifier == point.identifier) {
      fields.fail(where, fmt::format("point '{}' has the name of another; expected different names",
                                     shown(point.name)));
    }
  }
  scene_.points.push_back(std::move(point));
  return static_cast<int>(scene_.points.size()) - 1;
}

void SceneContext::define_points(const SceneFields& root) {
  const std::vector<Node>& nodes = root.list("points");
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const SceneFields point =
        fields(nodes[k], called("point", nodes[k], k), {"name", "link", "at"}).at_run_time();
    const Text name = point.name("name", "point");
    const Text link = point.text("link");
    const model::Frame* const frame = find_frame(scene_.tree, link.text);
    if (frame == nullptr) {
      point.fail(link.where, fmt::format("link '{}' is not in the model{}; expected one of {}",
                                         shown(link.text),
                                         did_you_mean(link.text, names_of(scene_.tree.frames)),
                                         some_names(names_of(scene_.tree.frames))));
    }
    model::Point defined = point_of_frame(name.text, *frame, point.vector_or("at", {}));
    if (const std::optional<model::Point> other = of_model(name.text);
        other && !same_place(*other, defined)) {
      point.fail(name.where, fmt::format("'{}' is another place of the model; expected a new name",
                                         shown(name.text)));
    }
    add(point, name.where, std::move(defined));
  }
}

/// A point of the model, or the origin of a link.
std::optional<model::Point> SceneContext::of_model(const std::string& name) const {
  if (const std::optional<int> found = index_of(scene_.tree.points, name)) {
    return scene_.tree.points[to_index(*found)];
  }
  const model::Frame* const frame = find_frame(scene_.tree, name);
  return frame == nullptr ? std::nullopt : std::optional(point_of_frame(name, *frame, {}));
}

int SceneContext::point(const SceneFields& fields, std::string_view key) {
  const Text name = fields.text(key);
  if (const std::optional<int> found = index_of(scene_.points, name.text)) {
    return *found;
  }
  if (std::optional<model::Point> point = of_model(name.text)) {
    return add(fields, name.where, std::move(*point));
  }
  std::vector<std::string_view> known = names_of(scene_.points);
  for (const auto& more : {names_of(scene_.tree.points), names_of(scene_.tree.frames)}) {
    known.insert(known.end(), more.begin(), more.end());
  }
  fields.fail(name.where,
              fmt::format("'{}' is neither a point of the scene or the model nor a link{}; "
                          "expected one of these, points are defined in 'points'",
                          shown(name.text), did_you_mean(name.text, known)));
}

int SceneContext::moving_point(const SceneFields& fields) {
  const int result = point(fields);
  if (scene_.points[static_cast<std::size_t>(result)].link == model::kGround) {
    const Text name = fields.text("point");
    fields.fail(name.where,
                fmt::format("'{}' is fixed to the ground, which nothing moves; expected a point of "
                            "a link that moves",
                            shown(name.text)));
  }
  return result;
}

expressions::VariableNames SceneContext::variables(Of kind, const SceneFields& fields) const {
  const auto find = [this, kind](std::string_view name,
                                 std::optional<std::string_view> index) -> std::optional<Variable> {
    if (index) {
      const bool of_state =
          (kind == Of::kState || kind == Of::kPoint) && (name == "q" || name == "qd");
      const std::optional<int> joint = of_state ? coordinate(*index) : std::nullopt;
      return joint ? std::optional(
                         Variable{name == "q" ? Quantity::kPosition : Quantity::kVelocity, *joint})
                   : std::nullopt;
    }
    if (kind == Of::kDepth) {
      return name == "d"   ? std::optional(Variable{Quantity::kDepth, 0})
             : name == "v" ? std::optional(Variable{Quantity::kNormalSpeed, 0})
                           : std::nullopt;
    }
    if (name == "t") {
      return Variable{Quantity::kTime, 0};
    }
    return kind == Of::kPoint ? component(name) : std::nullopt;
  };
  std::vector<std::string> known = {"t"};
  if (kind == Of::kState || kind == Of::kPoint) {
    for (const int link : scene_.tree.coordinates) {
      const std::string& joint = scene_.tree.links[static_cast<std::size_t>(link)].joint.name;
      known.push_back(fmt::format("q[{}]", joint));
      known.push_back(fmt::format("qd[{}]", joint));
    }
  }
  const bool run_time = fields.is_at_run_time();
  switch (kind) {
    case Of::kTime:
      return {find, ", t", known, run_time};
    case Of::kPoint:
      return {find, ", t, q[joint], qd[joint], x, y, z, vx, vy, vz", known, run_time};
    case Of::kDepth:
      return {find, ", d (depth), v (speed along the normal)", {}, run_time};
    case Of::kState:
      break;
  }
  return {find, ", t, q[joint], qd[joint]", known, run_time};
}

template <class Read>
auto SceneContext::guarded(const SceneFields& fields, const Node& node, const Read& read) const {
  try {
    return read(fields.scalar(node).text);
  } catch (const TextError& problem) {
    const Place where = node.where.at(problem.offset());
    fields.fail(where, fmt::format("{}: {}", described(node), problem.what()));
  }
}

model::Expression SceneContext::expression(const SceneFields& fields, const Node& node,
                                           Of kind) const {
  return guarded(fields, node, [&](const std::string& text) {
    return expressions::read_expression(constants_, text, variables(kind, fields));
  });
}

std::array<model::Expression, 3> SceneContext::motion(const SceneFields& fields,
                                                      const Node& node) const {
  return guarded(fields, node, [&](const std::string& text) {
    return expressions::read_motion(constants_, text, variables(Of::kTime, fields));
  });
}

}  // namespace treedyn::description
