#include "description/equation_list.hpp"

#include <utility>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/fields.hpp"
#include "expressions/constant.hpp"

namespace treedyn::description {
namespace {

using Parameters = std::vector<std::pair<std::string, Real>>;

model::InputText read_input(const std::string& file, const Node& node, std::size_t index) {
  const Fields fields(file, node, called("input", node, index), {"name", "per", "size"});
  model::InputText input;
  const Text name = fields.text("name");
  input.name = name.text;
  input.where = name.where.in(file);
  if (const auto per = fields.optional_text("per")) {
    input.per = per->text;
    if (per->text != "link" && per->text != "point") {
      fields.fail(per->where, fmt::format("per '{}'; expected link or point", shown(per->text)));
    }
  }
  if (const auto size = fields.optional_text("size")) {
    if (size->text != "1" && size->text != "3") {
      fields.fail(size->where, fmt::format("size '{}'; expected 1 or 3", shown(size->text)));
    }
    input.size = size->text == "3" ? 3 : 1;
  }
  return input;
}

model::EquationText read_equation(const std::string& file, const Node& node, std::size_t index,
                                  const Parameters& parameters) {
  const Fields fields(file, node, called("equation", node, index),
                      {"name", "value", "doc", "inputs"});
  model::EquationText equation;
  const Text name = fields.text("name");
  const Text value = fields.text("value");
  equation.name = name.text;
  equation.where = name.where.in(file);
  equation.value = value.text;
  equation.value_at = [file, where = value.where](std::size_t offset) {
    return where.at(offset).in(file);
  };
  equation.parameters = parameters;
  if (const auto doc = fields.optional_text("doc")) {
    equation.doc = doc->text;
    if (doc->text.find('\n') != std::string::npos) {
      fields.fail(doc->where, "doc has several lines; expected one");
    }
  }
  const std::vector<Node>& inputs = fields.list("inputs");
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    equation.inputs.push_back(read_input(file, inputs[k], k));
  }
  return equation;
}

/// Parameters of the file with their values. The tree's reader has refused wrong ones already.
Parameters read_parameters(const std::string& file, const Node& node) {
  expressions::Constants constants;
  Parameters result;
  for (const Node& item : parameters(file, node)) {
    try {
      constants.define(item.key.text, item.text);
      result.emplace_back(item.key.text, constants.evaluate(item.key.text));
    } catch (const TextError& problem) {
      throw InputError(item.where.at(problem.offset()).in(file),
                       fmt::format("parameter '{}': {}", shown(item.key.text), problem.what()));
    }
  }
  return result;
}

std::vector<model::EquationText> read_all(const Node& root, const std::string& file) {
  const Node* const equations = find(root, "equations");
  if (equations == nullptr) {
    return {};
  }
  if (equations->kind != NodeKind::kSequence) {
    throw InputError(equations->where.in(file), "equations: is no list; expected one");
  }
  const Node* const parameters = find(root, "parameters");
  const Parameters values =
      parameters == nullptr ? Parameters{} : read_parameters(file, *parameters);
  std::vector<model::EquationText> result;
  for (std::size_t k = 0; k < equations->items.size(); ++k) {
    result.push_back(read_equation(file, equations->items[k], k, values));
  }
  return result;
}

}  // namespace

std::vector<model::EquationText> equations_of_tree(const std::string& text,
                                                   const std::string& file) {
  return read_all(parse_yaml_node(text, file), file);
}

std::vector<model::EquationText> equations_of_file(const std::string& text,
                                                   const std::string& file) {
  const Node root = parse_yaml_node(text, file, "equations");
  const Fields fields(file, root, "file of equations", {"equations", "parameters"});
  static_cast<void>(fields.get("equations"));  // it has to be there
  return read_all(root, file);
}

}  // namespace treedyn::description
