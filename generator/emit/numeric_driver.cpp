#include "emit/numeric_driver.hpp"

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

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

}  // namespace

std::string declaration_text(const program::Signature& signature) {
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  return declaration(returned(signature), parameters(signature, all), " noexcept;");
}

std::string numeric_driver(const std::string& name, const std::string& space,
                           const std::vector<program::Signature>& functions) {
  std::string probes;
  std::string calls;
  for (const program::Signature& signature : functions) {
    probes += probe(space, signature);
    calls += fmt::format("    probe_{}();\n", signature.name);
  }
  return fill(template_text("numeric.cpp"),
              {{"name", name}, {"space", space}, {"probes", probes}, {"calls", calls}});
}

}  // namespace treedyn::emit
