#include "emit/parts.hpp"

#include <fmt/format.h>

#include "emit/layout.hpp"

namespace treedyn::emit {

namespace {

/// The arrays that a part uses: of all `values` (one per array) those. An input that is an output
/// too counts as output.
std::vector<std::string> chosen(const std::vector<std::string>& values,
                                const std::vector<std::string>& names, const Part& part) {
  std::vector<std::string> result;
  for (std::size_t k = 0; k < values.size(); ++k) {
    bool again = false;
    for (std::size_t later = k + 1; later < names.size(); ++later) {
      again |= part.uses[later] && names[later] == names[k];
    }
    if (part.uses[k] && !again) {
      result.push_back(values[k]);
    }
  }
  return result;
}

}  // namespace

std::string block(const std::vector<std::string>& lines) {
  std::string result = "\n";
  for (const std::string& line : lines) {
    result += "  " + line + "\n";
  }
  return result + "}\n";
}

SplitText split_text(const program::Signature& signature, const Body& body) {
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  std::vector<std::string> names;
  for (const auto* arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      names.push_back(array.name);
    }
  }
  SplitText text;
  text.used.assign(all.size(), false);
  const std::string workspace = fmt::format("{} w[{}]", body.number, body.workspace);
  if (body.workspace > 0) {
    text.declaration = workspace + ";";
  }
  for (std::size_t k = 0; k < body.parts.size(); ++k) {
    const Part& part = body.parts[k];
    const std::string name = fmt::format("{}_{}", signature.name, k + 1);
    std::vector<std::string> declared = chosen(parameters(signature, all), names, part);
    std::vector<std::string> passed = chosen(names, names, part);
    if (part.uses_workspace) {
      declared.push_back(workspace);
      passed.emplace_back("w");
    }
    text.parts += "\n";
    text.parts +=
        declaration("[[gnu::noinline]] void " + name, declared, " noexcept {") + block(part.lines);
    text.calls.push_back(declaration("  " + name, passed, ";").substr(2));
    for (std::size_t array = 0; array < text.used.size(); ++array) {
      text.used[array] = text.used[array] || part.uses[array];
    }
  }
  return text;
}

}  // namespace treedyn::emit
