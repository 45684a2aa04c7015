#include "cli/numeric.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/template_file.hpp"
#include "system/compiler.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace fs = std::filesystem;

namespace {

/// A function that fills the inputs, calls and prints.
std::string probe(const std::string& space, const program::Signature& signature) {
  std::string result = fmt::format("\nvoid probe_{}() {{\n", signature.name);
  std::vector<std::string> names;
  for (const program::Array& array : signature.inputs) {
    result += fmt::format("  Scalar {}[{}];\n  ::fill({}, {});\n", array.name, array.size,
                          array.name, array.size);
    names.push_back(array.name);
  }
  std::string printing;
  for (const program::Array& array : signature.outputs) {
    result += fmt::format("  Scalar {}[{}];\n", array.name, array.size);
    printing += fmt::format("  ::print(\"{}\", {}, {});\n", signature.name, array.name, array.size);
    names.push_back(array.name);
  }
  return result + fmt::format("  {}::{}({});\n{}}}\n", space, signature.name,
                              fmt::join(names, ", "), printing);
}

/// A program that prints the values of the given functions of a namespace at fixed states.
std::string driver_text(const std::string& name, const std::string& space,
                        const std::vector<program::Signature>& functions) {
  std::string probes;
  std::string calls;
  for (const program::Signature& signature : functions) {
    probes += probe(space, signature);
    calls += fmt::format("    probe_{}();\n", signature.name);
  }
  return emit::fill(emit::template_text("numeric.cpp"),
                    {{"name", name}, {"space", space}, {"probes", probes}, {"calls", calls}});
}

using NamedValues = std::map<std::string, std::vector<double>>;

/// The values of the functions in `folder`; empty if something does not compile or run.
NamedValues values_of(std::vector<std::string> command, const std::string& name,
                      const std::string& space, const fs::path& folder,
                      const std::vector<program::Signature>& functions) {
  const TemporaryFolder scratch;
  const std::string driver = scratch.file("driver.cpp");
  const std::string program = scratch.file("driver");
  const std::string printed = scratch.file("values");
  write_files({{driver, driver_text(name, space, functions)}});
  command.insert(command.end(), {"-std=c++11", "-O1", "-I", fs::absolute(folder).string(), driver,
                                 fs::absolute(folder / (name + ".cpp")).string(), "-o", program});
  if (!succeeds(command, printed) || !succeeds({program}, printed)) {
    return {};
  }
  NamedValues result;
  std::istringstream lines(read_file(printed).value_or(""));
  for (std::string function, number; lines >> function >> number;) {
    double value = std::nan("");
    std::from_chars(number.data(), number.data() + number.size(), value);
    result[function].push_back(value);
  }
  return result;
}

std::string distance_line(const std::string& function, const std::vector<double>& old_values,
                          const std::vector<double>& new_values) {
  double distance = 0;
  double largest = 0;
  for (std::size_t k = 0; k < std::min(old_values.size(), new_values.size()); ++k) {
    const double difference = std::abs(old_values[k] - new_values[k]);
    distance = difference > distance || std::isnan(difference) ? difference : distance;
    largest = std::max(largest, std::abs(new_values[k]));
  }
  return fmt::format("numeric: {}: largest distance {:.3g}, largest value {:.3g}\n", function,
                     distance, largest);
}

/// Of functions of the model and equations of users.
std::vector<program::Signature> signatures_of(const Model& model) {
  const auto points = static_cast<int>(model.points.size());
  std::vector<program::Signature> result;
  for (const std::string& name : model.functions) {
    result.push_back(formulate::signature(name, model.tree.dof(), points));
  }
  for (const auto& equation : model.equations) {
    result.push_back(signature_of(*equation, model.tree.dof(), points));
  }
  return result;
}

}  // namespace

std::string numeric_report(const Model& model, const Request& request,
                           const std::vector<emit::File>& files, const std::string& folder) {
  const TemporaryFolder fresh;
  std::vector<std::string> compiler = find_compiler(fresh.file("version"));
  if (compiler.empty()) {
    return "numeric: no C++ compiler found ($CXX, c++, g++, clang++)\n";
  }
  if (!request.section.empty()) {
    compiler.push_back(fmt::format("-D{}=", request.section));
  }
  const std::string space = request.space.value_or(model.name);
  for (const emit::File& file : files) {
    write_files({{fresh.file(file.name), file.text}});
  }
  const fs::path present = fs::path(folder) / (model.name + ".hpp");
  std::error_code ignored;
  const std::string header =
      fs::is_regular_file(present, ignored) ? read_file(present.string()).value_or("") : "";
  if (!header.empty() && header.find(fmt::format("namespace {} {{", space)) == std::string::npos) {
    return fmt::format("numeric: the old files have another namespace than {}\n", space);
  }
  std::vector<program::Signature> common;
  std::string report;
  for (const program::Signature& signature : signatures_of(model)) {
    // equal text, equal signature
    if (header.find(emit::declaration(signature, " noexcept;")) != std::string::npos) {
      common.push_back(signature);
    } else {
      const bool other = header.find(fmt::format("void {}(", signature.name)) != std::string::npos;
      report += fmt::format("numeric: {}: {} in the old files\n", signature.name,
                            other ? "has other arguments" : "not");
    }
  }
  const NamedValues old_values = values_of(compiler, model.name, space, folder, common);
  const NamedValues new_values = values_of(compiler, model.name, space, fresh.path(), common);
  for (const program::Signature& signature : common) {
    report += old_values.contains(signature.name) && new_values.contains(signature.name)
                  ? distance_line(signature.name, old_values.at(signature.name),
                                  new_values.at(signature.name))
                  : fmt::format("numeric: {}: the old files do not compile, or are not all there\n",
                                signature.name);
  }
  for (const std::string& name : model.scene_functions) {
    report += fmt::format("numeric: {}: a function of a scene, not compared\n", name);
  }
  if (model.scene && model.scene_functions.empty()) {
    report += "numeric: functions of the scene are not compared\n";
  }
  if (request.checked) {
    report += "numeric: functions that return a status are not compared\n";
  }
  return report;
}

}  // namespace treedyn
