#include "cli/dump.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "equations/table.hpp"
#include "expansion/equations_text.hpp"
#include "formulate/scene_names.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

template <std::size_t n>
std::string numbers(const std::array<Real, n>& values) {
  std::string result;
  for (const Real& value : values) {
    result += fmt::format(" {}", value.str(20));
  }
  return result;
}

std::string model_text(const model::Tree& tree) {
  std::string result = fmt::format("tree {}\n", tree.identifier);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const model::Link& link = tree.links[i];
    result += fmt::format(
        "link {} {} father {} joint {} {}\n  axis{}\n  offset{}\n  rotation{}\n  mass {}\n"
        "  com{}\n  inertia{}\n  coordinate {} * {} + {}\n",
        i, link.name, link.father, link.joint.identifier,
        link.joint.turns() ? "revolute" : "prismatic", numbers(link.joint.axis),
        numbers(link.joint.offset), numbers(link.joint.rotation), link.inertia.mass.str(20),
        numbers(link.inertia.com), numbers(link.inertia.about_com), tree.drives[i].coordinate,
        tree.drives[i].multiplier.str(20), tree.drives[i].offset.str(20));
  }
  return result;
}

/// By kind.
constexpr std::array<const char*, 8> kKinds = {"constant", "input", "add", "mul",
                                               "div",      "sin",   "cos", "sqrt"};
static_assert(kKinds.size() == static_cast<std::size_t>(program::Kind::kSqrt) + 1);

/// One value a line: number, operation, operands; a minus sign is part of the use.
std::string program_text(const program::Function& function) {
  const program::Graph& graph = function.graph;
  std::string result = fmt::format("function {}\n", function.signature.name);
  for (const program::Ref k : program::reachable(graph, function.outputs)) {
    const program::Node& node = graph.node(k);
    result += fmt::format("  {} = {}", k, kKinds[static_cast<std::size_t>(node.kind)]);
    if (node.kind == program::Kind::kConstant) {
      result += " " + graph.value(k).str(20);
    } else if (node.kind == program::Kind::kInput) {
      result += fmt::format(" {}[{}]", function.signature.inputs[to_index(node.a)].name, node.b);
    }
    program::for_each_operand(node,
                              [&](program::Ref operand) { result += fmt::format(" {}", operand); });
    result += "\n";
  }
  return result + fmt::format("  outputs {}\n", fmt::join(function.outputs, " "));
}

/// True for what leaves block equations, and is of the scene.
bool is_derived(const model::Scene& scene, const equations::SceneFunctionInfo& info) {
  const std::string_view name = info.name;
  return !info.equations.empty() &&
         (name == "constrained_dynamics" ||
          (name == "impact" ? !formulate::impacts_of(scene).empty() : !scene.constraints.empty()));
}

/// The functions that are written and have a derivation.
std::vector<std::string> derived_functions(const Model& model) {
  std::vector<std::string> result;
  std::ranges::copy_if(model.functions, std::back_inserter(result), [](const std::string& name) {
    return equations::find_solved(name) != nullptr;
  });
  for (const auto& equation : model.equations) {
    result.push_back(equation->equation.name);
  }
  if (!model.scene) {
    return result;
  }
  const std::vector<std::string>& wanted = model.scene_functions;
  for (const equations::SceneFunctionInfo& info : equations::scene_function_infos()) {
    const bool is_wanted =
        wanted.empty() || std::ranges::find(wanted, std::string(info.name)) != wanted.end();
    if (is_wanted && is_derived(*model.scene, info)) {
      result.emplace_back(info.name);
    }
  }
  return result;
}

}  // namespace

std::string equations_text(const Model& model, const Request& request) {
  expansion::DumpOptions options;
  for (const std::string& name : model.functions) {
    if (equations::find(name) != nullptr) {
      options.functions.push_back(name);
    }
  }
  return expansion::dump(model.tree, model.points, decided_request(model, request).gravity,
                         options);
}

const std::vector<std::string>& stages() {
  static const std::vector<std::string> names = {"model", "equations", "derive", "program", "emit"};
  return names;
}

std::string dump(const Request& request, const std::string& stage) {
  const Model model = read(request);
  if (stage == "model") {
    return model_text(model.tree);
  }
  if (stage == "equations") {
    return equations_text(model, request);
  }
  if (stage == "derive") {
    std::string text;
    for (const std::string& name : derived_functions(model)) {
      text += derivation_text(model, request, name) + "\n";
    }
    return text;
  }
  program::Programs programs = formulate_model(model, request, [](const std::string&) {});
  separate_parameters(model, request, programs);
  std::string result;
  if (stage == "program") {
    result += programs.update ? program_text(*programs.update) : "";
    for (const program::Function& function : programs.functions) {
      result += program_text(function);
    }
    for (const program::Staged& staged : programs.staged) {
      result += program_text(staged.function);
    }
    return result;
  }
  for (const emit::File& file : emit_files(model, request, programs)) {
    result += file.text;
  }
  return result;
}

}  // namespace treedyn
