#include "emit/source.hpp"

#include <fmt/format.h>

#include "emit/header.hpp"
#include "emit/layout.hpp"
#include "emit/sincos.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

/// What follows the opening brace.
std::string block(const std::vector<std::string>& lines) {
  std::string result = "\n";
  for (const std::string& line : lines) {
    result += "  " + line + "\n";
  }
  return result + "}\n";
}

std::string whole_function(const program::Signature& signature, const Part& part) {
  return declaration("void " + signature.name, parameters(signature, part.uses), " noexcept {") +
         block(part.lines);
}

/// mass_matrix -> MassMatrixWorkspace
std::string workspace_type(const std::string& function) {
  std::string result;
  bool start = true;
  for (const char c : function) {
    if (c == '_') {
      start = true;
    } else {
      result += start && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
      start = false;
    }
  }
  return result + "Workspace";
}

std::string workspace(const std::string& type, const std::vector<std::string>& members) {
  std::string result = fmt::format("struct {} {{\n", type);
  for (const std::string& member : members) {
    result += fmt::format("  Scalar {};\n", member);
  }
  return result + "};\n";
}

/// The arrays that a part uses: of all `values` (one per array) those.
std::vector<std::string> chosen(const std::vector<std::string>& values, const Part& part) {
  std::vector<std::string> result;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (part.uses[k]) {
      result.push_back(values[k]);
    }
  }
  return result;
}

/// A function in parts: a workspace, the parts, and the function that calls them in order.
std::string split_function(const program::Signature& signature, const Body& body) {
  const std::string type = workspace_type(signature.name);
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  std::vector<bool> used(all.size(), false);
  std::vector<std::string> names;
  for (const auto* arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      names.push_back(array.name);
    }
  }
  std::string result = "namespace {\n";
  std::vector<std::string> calls;
  if (!body.workspace.empty()) {
    result += "\n" + workspace(type, body.workspace);
    calls.push_back(type + " w;");
  }
  for (std::size_t k = 0; k < body.parts.size(); ++k) {
    const Part& part = body.parts[k];
    const std::string name = fmt::format("{}_{}", signature.name, k + 1);
    std::vector<std::string> declared = chosen(parameters(signature, all), part);
    std::vector<std::string> passed = chosen(names, part);
    if (part.uses_workspace) {
      declared.push_back(type + "& w");
      passed.emplace_back("w");
    }
    result += "\n";
    result +=
        declaration("[[gnu::noinline]] void " + name, declared, " noexcept {") + block(part.lines);
    calls.push_back(fmt::format("{}({});", name, fmt::join(passed, ", ")));
    for (std::size_t array = 0; array < used.size(); ++array) {
      used[array] = used[array] || part.uses[array];
    }
  }
  return result + "\n}  // namespace\n\n" +
         declaration("void " + signature.name, parameters(signature, used), " noexcept {") +
         block(calls);
}

/// Where sin, cos and sqrt come from.
std::string mathematics(const Unit& unit) {
  program::Cost total;
  for (const program::Function& function : unit.functions) {
    const program::Cost cost = program::cost(function);
    total.cos += cost.cos;
    total.sin += cost.sin;
    total.sqrt += cost.sqrt;
  }
  std::string result;
  const bool library = !unit.target.builtin_sincos && unit.target.lanes == 1;
  result += library && total.cos > 0 ? "using std::cos;\n" : "";
  result += library && total.sin > 0 ? "using std::sin;\n" : "";
  result += total.sqrt > 0 ? "using std::sqrt;\n" : "";
  result = result.empty() ? result : "\n" + result;
  return !library && total.sin + total.cos > 0 ? result + sincos_text(unit.target) : result;
}

}  // namespace

std::string source_text(const Unit& unit, const std::vector<Body>& bodies) {
  std::string functions;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const program::Signature& signature = unit.functions[k].signature;
    functions += "\n";
    functions += bodies[k].parts.size() == 1 ? whole_function(signature, bodies[k].parts.front())
                                             : split_function(signature, bodies[k]);
  }
  return fill(template_text("model.cpp"), {{"name", unit.name},
                                           {"command", command_comment(unit.command)},
                                           {"using", mathematics(unit)},
                                           {"functions", functions}});
}

}  // namespace treedyn::emit
