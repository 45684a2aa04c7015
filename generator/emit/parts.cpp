#include "emit/parts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/taken_names.hpp"

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

std::vector<std::string> names_of_arrays(const program::Signature& signature) {
  std::vector<std::string> names;
  for (const auto* arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      names.push_back(array.name);
    }
  }
  return names;
}

std::string part_head(const std::string& name) { return "[[gnu::noinline]] void " + name; }

std::string call_of(const std::string& name, const std::vector<std::string>& passed) {
  return declaration("  " + name, passed, ";").substr(2);
}

}  // namespace

std::string block(const std::vector<std::string>& lines) {
  std::string result = "\n";
  for (const std::string& line : lines) {
    result += "  " + line + "\n";
  }
  return result + "}\n";
}

void unite(std::vector<bool>& uses, const std::vector<bool>& more) {
  for (std::size_t array = 0; array < uses.size(); ++array) {
    uses[array] = uses[array] || more[array];
  }
}

SplitText split_text(const program::Signature& signature, const std::string& stem,
                     const Body& body) {
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  const std::vector<std::string> names = names_of_arrays(signature);
  SplitText text;
  text.used.assign(all.size(), false);
  const std::string workspace =
      fmt::format("{} {}[{}]", body.number, body.workspace_name, body.workspace);
  if (body.workspace > 0) {
    text.declaration = workspace + ";";
  }
  for (std::size_t k = 0; k < body.parts.size(); ++k) {
    const Part& part = body.parts[k];
    const std::string name = fmt::format("{}_{}", stem, k + 1);
    std::vector<std::string> declared = chosen(parameters(signature, all), names, part);
    std::vector<std::string> passed = chosen(names, names, part);
    if (part.uses_workspace) {
      declared.push_back(workspace);
      passed.push_back(body.workspace_name);
    }
    text.parts += "\n";
    text.parts += declaration(part_head(name), declared, " noexcept {") + block(part.lines);
    text.calls.push_back(call_of(name, passed));
    unite(text.used, part.uses);
  }
  return text;
}

std::map<std::string, std::string> stems_of_parts(const std::set<std::string>& names) {
  std::set<std::string> taken = names;
  std::map<std::string, std::string> stems;
  for (const std::string& name : names) {
    std::string stem = name;
    const auto is_in_use = [&](const std::string& other) {
      return is_part_of(other, stem) || (other == stem && stem != name);
    };
    while (std::ranges::any_of(taken, is_in_use)) {
      stem += "_part";
    }
    taken.insert(stem);
    stems.emplace(name, stem);
  }
  return stems;
}

ZerosText zeros_text(const program::Signature& signature, const Body& body) {
  if (body.zeros.lines.empty()) {
    return {};
  }
  const std::vector<bool> all(body.zeros.uses.size(), true);
  const std::vector<std::string> names = names_of_arrays(signature);
  const std::string name = signature.name + "_0";
  const std::vector<std::string> declared = chosen(parameters(signature, all), names, body.zeros);
  return {declaration(part_head(name), declared, " noexcept {") + block(body.zeros.lines),
          call_of(name, chosen(names, names, body.zeros))};
}

}  // namespace treedyn::emit
