#include "description/scene_yaml.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/identifiers.hpp"
#include "description/phase_fields.hpp"
#include "description/read.hpp"
#include "description/scene_context.hpp"
#include "description/scene_effects.hpp"

namespace treedyn::description {

namespace {

Keys root_keys() {
  return {"scene",   "model",    "base",     "parameters", "runtime",
          "points",  "effects",  "use",      "phases",     "start_phase",
          "initial", "duration", "stepping", "actuated",   "rank_tolerance"};
}

Base base_of(const Fields& root) {
  const Text base = root.optional_text("base").value_or(Text{"fixed", {}});
  if (base.text != "fixed" && base.text != "axes") {
    root.fail(base.where,
              fmt::format("base '{}' is unknown; expected fixed or axes", shown(base.text)));
  }
  return base.text == "axes" ? Base::kAxes : Base::kFixed;
}

/// The model's file, beside the scene's unless the path is absolute.
std::string model_path(const Fields& root, const std::string& file) {
  const std::filesystem::path model = root.text("model").text;
  if (model == "-") {
    root.fail(root.get("model").where, "the model is standard input; expected a file");
  }
  return (std::filesystem::path(file).parent_path() / model).lexically_normal().string();
}

/// Values by the names of joints; what is not named is zero.
std::vector<Real> by_joint(const SceneContext& context, const SceneFields& initial,
                           std::string_view key, const Node* node, std::size_t dof) {
  std::vector<Real> result(dof, Real(0));
  if (node == nullptr) {
    return result;
  }
  if (node->kind != NodeKind::kMapping) {
    initial.fail(node->where, fmt::format("'{}' is no mapping; expected joint: value", key));
  }
  for (const Node& item : node->items) {
    const int joint = context.joint(initial, item.key);
    result[static_cast<std::size_t>(joint)] = initial.number_of(item);
  }
  return result;
}

void read_initial(const SceneContext& context, const SceneFields& root, model::Scene& scene) {
  const auto dof = static_cast<std::size_t>(scene.tree.dof());
  scene.q0.assign(dof, Real(0));
  scene.qd0.assign(dof, Real(0));
  if (const Node* const node = root.find("initial")) {
    const SceneFields initial = context.fields(*node, "initial", {"q", "qd", "t"}).nominal();
    scene.q0 = by_joint(context, initial, "q", initial.find("q"), dof);
    scene.qd0 = by_joint(context, initial, "qd", initial.find("qd"), dof);
    scene.t0 = initial.number_or("t", 0);
  }
}

void read_stepping(const SceneContext& context, const SceneFields& root, model::Scene& scene) {
  const Node* const node = root.find("stepping");
  if (node == nullptr) {
    return;
  }
  const SceneFields fields = context.fields(
      *node, "stepping",
      {"integrator", "step", "tolerance", "output_step", "cuts", "events", "parts", "state"});
  model::Stepping& stepping = scene.stepping;
  if (const std::optional<Text> name = fields.optional_text("integrator")) {
    stepping.integrator = name->text;
    stepping.where = name->where.in(fields.file());
  }
  const auto positive = [&](const char* key, Real& value) {
    value = fields.find(key) == nullptr ? value : fields.positive(key);
  };
  positive("step", stepping.step);
  const auto count = [&](const char* key, int least, int most, int& value) {
    value = fields.find(key) == nullptr ? value : fields.integer(key, least, most);
  };
  count("cuts", 0, model::kMostCuts, stepping.cuts);
  count("events", 1, model::kMostCuts, stepping.events);
  count("parts", 1, model::kMostParts, stepping.parts);
  if (const std::optional<Text> state = fields.optional_text("state")) {
    if (state->text != "plain" && state->text != "compensated") {
      throw InputError(state->where.in(fields.file()),
                       fmt::format("stepping: state {} is unknown; expected plain or compensated",
                                   shown(state->text)));
    }
    stepping.compensated = state->text == "compensated";
  }
  positive("tolerance", stepping.tolerance);
  positive("output_step", stepping.output_step);
}

/// The joints whose forces constrained inverse dynamics may choose, each once.
void read_actuated(const SceneContext& context, const SceneFields& root, model::Scene& scene) {
  if (root.find("actuated") == nullptr) {
    return;
  }
  scene.actuated.emplace();
  for (const Node& item : root.list("actuated")) {
    const Text name = root.scalar(item);
    const int joint = context.joint(root, name);
    std::vector<int>& joints = *scene.actuated;
    if (std::ranges::find(joints, joint) != joints.end()) {
      root.fail(name.where, fmt::format("joint '{}' is actuated twice; expected every joint once",
                                        shown(name.text)));
    }
    joints.push_back(joint);
  }
}

/// What the model declares as known at run time only, where it is a matter of the scene too.
void read_model_parameters(const SceneFields& root, bool at_run_time, model::Tree& tree) {
  for (const model::Parameter& parameter : tree.parameters) {
    if (parameter.quantity == model::ParameterKind::kGravity) {
      root.fail(root.get("model").where,
                fmt::format("the model declares '{}' as known at run time only, which is a matter "
                            "of the scene; expected parameters of the scene in its 'gravity'",
                            shown(parameter.declared)));
    }
  }
  if (!at_run_time) {
    tree.parameters.clear();
  }
}

/// The names of parameters that are known at run time only, each once.
std::vector<Text> read_runtime(const SceneFields& root) {
  std::vector<Text> result;
  for (const Node& item : root.list("runtime")) {
    const Text name = root.scalar(item);
    if (std::ranges::find(result, name.text, &Text::text) != result.end()) {
      root.fail(name.where, fmt::format("runtime: parameter '{}' stands there twice; expected "
                                        "every one once",
                                        shown(name.text)));
    }
    result.push_back(name);
  }
  return result;
}

/// Their fields have different names.
void check_names(const std::vector<Text>& run_time, const std::string& file,
                 const model::Tree& tree) {
  std::vector<Named> names;
  for (const model::Parameter& parameter : tree.parameters) {
    const auto found = std::ranges::find(run_time, parameter.declared, &Text::text);
    names.push_back({parameter.declared, parameter.identifier,
                     found == run_time.end() ? Location{file, 0, 0} : found->where.in(file)});
  }
  check_identifiers(names, "run-time parameter");
}

}  // namespace

model::Scene read_scene_yaml(const Node& node, const std::string& file,
                             const TextReader& model_text, const AtRunTime& at_run_time) {
  model::Scene scene;
  SceneContext context(file, scene, at_run_time);
  // parameters come first: every other number may use them
  const SceneFields root = context.fields(node, "scene", root_keys());
  scene.name = root.name("scene", "scene").text;
  scene.tree_file = model_path(root, file);
  scene.tree = parse_model(model_text(scene.tree_file), scene.tree_file, {.base = base_of(root)});
  scene.declares_parameters = !scene.tree.parameters.empty() || !root.list("runtime").empty();
  read_model_parameters(root, static_cast<bool>(at_run_time), scene.tree);
  if (scene.tree.dof() == 0) {
    root.fail(root.get("model").where, "the model has no moving joint; expected at least one");
  }
  const std::vector<Text> run_time = read_runtime(root);
  context.define_parameters(root.find("parameters"), run_time);
  check_names(run_time, file, scene.tree);
  context.define_points(root);
  const SceneEffects effects(context, root);
  read_phases(context, effects, root);
  read_initial(context, root, scene);
  scene.duration = root.nominal().positive("duration");
  read_stepping(context, root, scene);
  read_actuated(context, root, scene);
  if (root.find("rank_tolerance") != nullptr) {
    scene.rank_tolerance = root.positive("rank_tolerance");
    if (scene.rank_tolerance >= 1) {
      root.fail(root.get("rank_tolerance").where,
                "'rank_tolerance' leaves no row; expected a part of a row's own size, below 1");
    }
  }
  return scene;
}

}  // namespace treedyn::description
