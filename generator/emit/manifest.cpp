#include "emit/manifest.hpp"

#include <fmt/format.h>

#include "common/index.hpp"
#include "emit/header.hpp"
#include "emit/json.hpp"
#include "emit/length_unit.hpp"
#include "emit/run_time.hpp"
#include "emit/sincos.hpp"

namespace treedyn::emit {

namespace {

std::string joint_json(const model::Tree& tree, int k) {
  const model::Joint& joint = tree.moved_by(k).joint;
  const bool revolute = joint.turns();
  return json_object({{"name", json_string(joint.name)},
                      {"identifier", json_string(joint.identifier)},
                      {"index", std::to_string(k)},
                      {"type", revolute ? "\"revolute\"" : "\"prismatic\""},
                      {"father", std::to_string(father_coordinate(tree, k))},
                      {"unit", revolute ? "\"rad\"" : "\"m\""}});
}

std::string joints_json(const model::Tree& tree) {
  std::vector<std::string> joints;
  for (int k = 0; k < tree.dof(); ++k) {
    joints.push_back(joint_json(tree, k));
  }
  return json_lines(joints, 4);
}

/// The joints that have no element of q; nothing without such.
std::string mimics_json(const model::Tree& tree) {
  std::vector<std::string> mimics;
  for (int i = 0; i < tree.size(); ++i) {
    const model::Drive& drive = tree.drives[to_index(i)];
    if (tree.is_mimic(i)) {
      mimics.push_back(json_object({{"name", json_string(tree.links[to_index(i)].joint.name)},
                                    {"index", std::to_string(drive.coordinate)},
                                    {"multiplier", decimal(drive.multiplier)},
                                    {"offset", decimal(drive.offset)}}));
    }
  }
  return mimics.empty() ? "" : fmt::format(",\n  \"mimics\": {}", json_lines(mimics, 4));
}

std::string points_json(const std::vector<model::Point>& points) {
  std::vector<std::string> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    result.push_back(json_object({{"name", json_string(points[k].name)},
                                  {"identifier", json_string(points[k].identifier)},
                                  {"index", std::to_string(k)},
                                  {"link", json_string(points[k].link_name)}}));
  }
  return json_lines(result, 4);
}

std::string arrays_json(const std::vector<program::Array>& arrays) {
  std::vector<std::string> result;
  for (const program::Array& array : arrays) {
    std::vector<std::pair<std::string, std::string>> fields = {{"name", json_string(array.name)},
                                                               {"size", std::to_string(array.size)},
                                                               {"unit", json_string(array.unit)}};
    if (array.rows > 0) {
      fields.emplace_back("rows", std::to_string(array.rows));
      fields.emplace_back("columns", std::to_string(array.columns));
    }
    if (!array.type.empty()) {
      fields.emplace_back("type", json_string(array.type));
    }
    if (array.integer) {
      fields.emplace_back("type", json_string("int"));
    }
    result.push_back(json_object(fields));
  }
  return json_list(result);
}

/// What a status says: "int" and its bits.
std::string status_json(const program::Signature& signature) {
  return signature.status ? " \"returns\": \"status\"," : "";
}

/// \param cost  the operations, and what else the manifest says of them, as JSON
std::string function_json(const program::Signature& signature, const Body& body,
                          const std::string& cost) {
  return fmt::format(
      "{{\"name\": {}, \"equation\": {},\n     \"inputs\": {},\n     \"outputs\": {},\n"
      "    {} \"operations\": {},\n     \"statements\": {}, \"structural_zeros\": {}}}",
      json_string(signature.name), json_string(signature.equation), arrays_json(signature.inputs),
      arrays_json(signature.outputs), status_json(signature), cost, body.statements,
      body.structural_zeros);
}

/// What rounding costs with the passes that were used, rounded up, and which were not.
std::string rounding_json(const program::Rounding& rounding) {
  if (rounding.amplification == 0) {
    return "";
  }
  std::string result = fmt::format(",\n     \"rounding\": {}",
                                   with_point(fmt::format("{:.2g}", rounding.amplification)));
  if (!rounding.left_out.empty()) {
    result += fmt::format(", \"rounding_without\": {}", json_list(json_strings(rounding.left_out)));
  }
  return result;
}

/// Errors that were measured, if they were asked for.
std::string errors_json(const Unit& unit, const std::string& function) {
  const auto found = unit.errors.find(function);
  return found == unit.errors.end() ? "" : fmt::format(",\n     \"errors\": {}", found->second);
}

/// Operations of the path that regular states take, and of the dearest call.
std::string staged_cost(const program::Staged& staged) {
  std::string result = operations_json(program::cost(staged));
  for (const program::RowSolve& solve : staged.solves) {
    result += fmt::format(",\n     \"rows\": {}, \"rank\": {}",
                          json_list(json_strings(staged.signature.rows)), solve.rank);
  }
  for (const program::Staged& contact : staged.contacts) {
    result += fmt::format(",\n     \"{}\": {}", contact.signature.name,
                          operations_json(program::cost(contact)));
  }
  if (const int powers = program::worst_powers(staged); powers > 0) {
    result += fmt::format(",\n     \"worst_case_pow\": {}", powers);
  }
  return fmt::format("{},\n     \"worst_case\": {}{}", result,
                     operations_json(program::worst_cost(staged)),
                     rounding_json(staged.function.rounding));
}

std::string stepper_cost(const program::Stepper& stepper) {
  std::string result =
      operations_json(program::step_cost(stepper)) +
      fmt::format(",\n     \"integrator\": {}, \"step\": {}, \"cuts\": {}, \"state\": {}",
                  json_string(stepper.integrator), decimal(stepper.step), stepper.cuts,
                  json_string(stepper.compensated ? "compensated" : "plain"));
  std::vector<std::string> phases;
  for (std::size_t k = 0; stepper.switches() && k < stepper.phases.size(); ++k) {
    const program::StepPhase& phase = stepper.phases[k];
    phases.push_back(
        json_object({{"name", json_string(phase.identifier)},
                     {"index", std::to_string(k)},
                     {"operations", operations_json(program::step_cost(stepper, phase))}}));
  }
  if (!phases.empty()) {
    result += fmt::format(",\n     \"phases\": {}", json_lines(phases, 7));
  }
  return fmt::format("{},\n     \"worst_case\": {}", result,
                     operations_json(program::worst_step_cost(stepper)));
}

/// The processor that the files are for, if they are for one.
std::string processor_json(const Unit& unit) {
  if (!unit.processor) {
    return "";
  }
  std::vector<std::pair<std::string, std::string>> cycles;
  for (const auto& [name, of_call] : unit.processor->cycles) {
    cycles.emplace_back(name, cycles_text(of_call));
  }
  return fmt::format(",\n  \"processor\": {}",
                     json_object({{"name", json_string(unit.processor->brief)},
                                  {"flags", json_string(unit.processor->flags)},
                                  {"cycles", json_object(cycles)}}));
}

/// Where sines and cosines are numbers, if they are those of the source.
std::string sincos_json(const Unit& unit) {
  return has_sincos(unit) ? fmt::format(",\n  \"sincos\": {}", sincos_range(unit.target)) : "";
}

}  // namespace

std::string operations_json(const program::Cost& cost) {
  return json_object({{"add", std::to_string(cost.add)},
                      {"mul", std::to_string(cost.mul)},
                      {"div", std::to_string(cost.div)},
                      {"sqrt", std::to_string(cost.sqrt)},
                      {"sin", std::to_string(cost.sin)},
                      {"cos", std::to_string(cost.cos)}});
}

std::string manifest_text(const Unit& unit, const std::vector<Body>& bodies) {
  std::vector<std::string> functions;
  const std::size_t plain = unit.functions.size();
  for (std::size_t k = 0; k < plain; ++k) {
    const program::Function& function = unit.functions[k];
    functions.push_back(function_json(function.signature, bodies[k],
                                      operations_json(program::cost(function)) +
                                          rounding_json(function.rounding) + unit_json(function) +
                                          errors_json(unit, function.signature.name)));
  }
  for (std::size_t k = 0; k < unit.checked.size(); ++k) {
    const Checked& checked = unit.checked[k];
    functions.push_back(
        function_json(checked.signature, bodies[plain + k],
                      operations_json(cost(checked)) + rounding_json(checked.function.rounding)));
  }
  const std::size_t others = plain + unit.checked.size();
  for (std::size_t k = others; k < bodies.size(); ++k) {
    const program::Staged& staged = unit.staged[k - others];
    functions.push_back(function_json(staged.signature, bodies[k], staged_cost(staged)));
  }
  for (const program::Stepper& stepper : unit.steppers) {
    functions.push_back(function_json(stepper.signature, {}, stepper_cost(stepper)));
  }
  return fmt::format(
      "{{\n  \"name\": {},\n  \"tool\": {},\n  \"model\": {},\n  \"options\": {},\n"
      "  \"dof\": {},\n  \"joints\": {}{},\n  \"points\": {}{},\n  \"functions\": {}\n}}\n",
      json_string(unit.name), json_string(unit.tool),
      json_object(
          {{"file", json_string(unit.model_file)}, {"sha256", json_string(unit.model_sha256)}}),
      json_object(unit.options) + sincos_json(unit) + processor_json(unit), unit.tree->dof(),
      joints_json(*unit.tree), mimics_json(*unit.tree), points_json(unit.points),
      parameters_json(*unit.tree, unit.gravity), json_lines(functions, 4));
}

}  // namespace treedyn::emit
