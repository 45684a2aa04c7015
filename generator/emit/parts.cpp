#include "emit/parts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/transformed.hpp"
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
  return transformed(signature.arrays(), &program::Array::name);
}

std::string part_head(const std::string& name) { return "[[gnu::noinline]] void " + name; }

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

std::string definition(const std::string& parts, const program::Signature& signature,
                       const std::vector<bool>& uses, const std::vector<std::string>& lines) {
  return (parts.empty() ? "" : unnamed(parts).substr(1) + '\n') +
         declaration(signature, uses, " noexcept {") + block(lines);
}

std::string unnamed(const std::string& functions) {
  return functions.empty() ? "" : "\nnamespace {\n" + functions + "\n}  // namespace\n";
}

WholeText whole_text(const program::Signature& signature, const std::string& stem, const Body& body,
                     const std::function<Lines(int)>& before) {
  const std::vector<bool> all = all_arrays(signature);
  WholeText text;
  const auto begin_stages = [&](int level) {
    while (text.stages < level) {
      append(text.lines, before(++text.stages));
    }
  };
  if (body.parts.size() == 1) {
    const Part& part = body.parts.front();
    for (std::size_t at = 0; at < part.lines.size(); ++at) {
      begin_stages(static_cast<int>(
          std::ranges::count_if(body.stages, [&](std::size_t begin) { return begin <= at; })));
      text.lines.push_back(part.lines[at]);
    }
    text.used = part.uses;
    return text;
  }
  const std::vector<std::string> names = names_of_arrays(signature);
  const std::string workspace =
      fmt::format("{} {}[{}]", body.number, body.workspace_name, body.workspace);
  if (body.workspace > 0) {
    text.lines.push_back(workspace + ";");
  }
  text.used.assign(all.size(), false);
  for (std::size_t k = 0; k < body.parts.size(); ++k) {
    const Part& part = body.parts[k];
    begin_stages(part.level);
    const std::string name = fmt::format("{}_{}", stem, k + 1);
    std::vector<std::string> declared = chosen(parameters(signature, all), names, part);
    std::vector<std::string> passed = chosen(names, names, part);
    if (part.uses_workspace) {
      declared.push_back(workspace);
      passed.push_back(body.workspace_name);
    }
    text.parts += '\n' + declaration(part_head(name), declared, " noexcept {") + block(part.lines);
    text.lines.push_back(call_text(name, passed));
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
  const std::vector<std::string> names = names_of_arrays(signature);
  const std::string name = signature.name + "_0";
  const std::vector<std::string> declared =
      chosen(parameters(signature, all_arrays(signature)), names, body.zeros);
  return {declaration(part_head(name), declared, " noexcept {") + block(body.zeros.lines),
          call_text(name, chosen(names, names, body.zeros))};
}

}  // namespace treedyn::emit
