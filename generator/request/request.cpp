#include "request/request.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/shell.hpp"

namespace treedyn {

namespace {

const Request kDefaults;

std::string list_of(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

std::string gravity_text(const model::Vector3& g) {
  return fmt::format("{},{},{}", emit::decimal(g[0]), emit::decimal(g[1]), emit::decimal(g[2]));
}

std::string forward_dynamics_text(formulate::ForwardDynamics choice) {
  return std::string(formulate::kForwardDynamics[static_cast<std::size_t>(choice)]);
}

std::string base_text(description::Base base) {
  return base == description::Base::kAxes ? "axes" : "fixed";
}

std::string mimic_text(description::Mimic mimic) {
  return mimic == description::Mimic::kIndependent ? "independent" : "reduce";
}

/// The names of the passes that are switched off, in order.
std::vector<std::string> names_without(const Request& request) {
  std::vector<std::string> names;
  for (const formulate::PassInfo& info : formulate::passes()) {
    if (std::ranges::find(request.without, info.pass) != request.without.end()) {
      names.emplace_back(info.name);
    }
  }
  return names;
}

/// What the command line says of the step, instead of the scene: options and values.
std::vector<std::pair<const char*, std::string>> step_options(const StepChoice& choice) {
  std::vector<std::pair<const char*, std::string>> result;
  if (choice.integrator) {
    result.emplace_back("--integrator", *choice.integrator);
  }
  if (choice.step) {
    result.emplace_back("--step", emit::decimal(*choice.step));
  }
  if (choice.cuts) {
    result.emplace_back("--cuts", std::to_string(*choice.cuts));
  }
  if (choice.compensated) {
    result.emplace_back("--state", *choice.compensated ? "compensated" : "plain");
  }
  return result;
}

std::string sincos_word(const emit::Target& target) {
  return target.takes_libm() ? "libm" : target.takes_vectors() ? "vector" : "pair";
}

std::string in_quotes(const std::string& text) { return fmt::format("\"{}\"", text); }

}  // namespace

bool has_late_sines(const std::string& core) { return !core.empty() && core != "host"; }

bool room_for_vectors(const Request& request) {
  const emit::Target& target = request.target;
  return target.sincos == emit::Sincos::kPair && target.lanes == 1 &&
         target.trigonometry == program::Trigonometry::kEarly &&
         request.language == emit::Language::kCpp &&
         request.section.empty();  // g++ before 14 takes no section for templates
}

const char* sharing_option(const Request& request) {
  return request.target.limb_lanes ? "--limb-lanes" : "--share-limbs";
}

std::vector<std::pair<std::string, std::string>> manifest_options(const Request& request) {
  std::vector<std::pair<std::string, std::string>> options = {
      {"scalar", in_quotes(emit::type_name(request.target.scalar))},
      {"lanes", std::to_string(request.target.lanes)},
      {"sincos", in_quotes(sincos_word(request.target))},
      {"layout", in_quotes(request.target.packed ? "packed" : "dense")},
      {"base", in_quotes(base_text(request.read.base))},
      {"gravity", fmt::format("[{}]", gravity_text(request.gravity))},
      {"snap", emit::decimal(request.read.snap)},
      {"mimic", in_quotes(mimic_text(request.read.mimic))},
      {"effort", std::to_string(request.effort)},
      {"forward_dynamics", in_quotes(forward_dynamics_text(request.forward_dynamics))},
      {"without", in_quotes(list_of(names_without(request)))}};
  const auto add = [&](bool given, const char* option, const std::string& value) {
    if (given) {
      options.emplace_back(option, value);
    }
  };
  const auto add_word = [&](const char* option, const std::string& word) {
    add(!word.empty(), option, in_quotes(word));
  };
  add_word("trig", request.target.trigonometry == program::Trigonometry::kLate ? "late" : "");
  add_word("core", request.core);
  add_word("language", request.language == emit::Language::kC99 ? "c99" : "");
  add_word("namespace", request.space.value_or(""));
  add_word("prefix", request.prefix.value_or(""));
  add_word("section", request.section);
  add_word("units", request.metres ? "si" : "");
  add(request.share_limbs, request.target.limb_lanes ? "limb_lanes" : "share_limbs", "true");
  add(request.self_test, "self_test", "true");
  add(request.checked, "checked", "true");
  add(request.accuracy_samples > 0, "accuracy_samples", std::to_string(request.accuracy_samples));
  return options;
}

std::vector<std::string> generate_command(const Request& request, Paths paths) {
  std::vector<std::string> result = {"treedyn", "generate"};
  const auto add = [&](bool given, const char* option, const std::string& value) {
    if (given) {
      result.insert(result.end(), {option, value});
    }
  };
  const auto named = [&](const std::string& file) {
    return paths == Paths::kAsGiven ? file : std::filesystem::path(file).filename().string();
  };
  emit::append_if(result, request.scene.has_value(), "--scene");
  result.push_back(named(request.scene.value_or(request.model)));
  add(request.name.has_value(), "--name", request.name.value_or(""));
  add(request.language == emit::Language::kC99, "--language", "c99");
  add(request.space.has_value(), "--namespace", request.space.value_or(""));
  add(request.prefix.has_value(), "--prefix", request.prefix.value_or(""));
  add(!request.section.empty(), "--section", request.section);
  add(!request.scene && request.read.base != kDefaults.read.base, "--base",
      base_text(request.read.base));
  add(request.target.scalar != kDefaults.target.scalar, "--scalar",
      emit::type_name(request.target.scalar));
  add(request.target.lanes != kDefaults.target.lanes, "--lanes",
      std::to_string(request.target.lanes));
  add(request.target.takes_libm() || request.target.vectors != room_for_vectors(request),
      "--sincos", sincos_word(request.target));
  add(!request.core.empty(), "--core", request.core);
  const bool late = request.target.trigonometry == program::Trigonometry::kLate;
  add(late != has_late_sines(request.core), "--trig", late ? "late" : "early");
  add(request.target.packed, "--layout", "packed");
  add(!request.functions.empty(), "--functions", list_of(request.functions));
  for (const std::string& file : request.equations) {
    add(true, "--equations", named(file));
  }
  add(request.points.has_value(), "--points", request.points.value_or(""));
  add(request.gravity != kDefaults.gravity, "--gravity", gravity_text(request.gravity));
  add(request.read.snap != kDefaults.read.snap, "--snap", emit::decimal(request.read.snap));
  add(request.read.mimic != kDefaults.read.mimic, "--mimic", mimic_text(request.read.mimic));
  add(!request.read.runtime.empty(), "--runtime", list_of(request.read.runtime));
  add(request.effort != kDefaults.effort, "--effort", std::to_string(request.effort));
  add(request.forward_dynamics != kDefaults.forward_dynamics, "--forward-dynamics",
      forward_dynamics_text(request.forward_dynamics));
  add(request.metres, "--units", "si");
  add(!request.without.empty(), "--without", list_of(names_without(request)));
  add(request.accuracy_samples > 0, "--accuracy-samples", std::to_string(request.accuracy_samples));
  for (const auto& [option, value] : step_options(request.stepping)) {
    add(true, option, value);
  }
  emit::append_if(result, request.share_limbs, sharing_option(request));
  emit::append_if(result, request.self_test, "--self-test");
  emit::append_if(result, request.checked, "--checked");
  return result;
}

std::string update_command(const Request& request, const std::string& folder) {
  std::vector<std::string> words = generate_command(request, Paths::kAsGiven);
  words.insert(words.end(), {"-o", folder});
  return emit::shell_line(words);
}

namespace {

/// A path as make and ninja read it: backslashes count only in front of what needs one.
std::string make_word(const std::string& path) {
  std::string result;
  std::size_t backslashes = 0;
  for (const char c : path) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\t') {
      throw InputError({path, 0, 0},
                       "has a control character, which no dependency file can hold; "
                       "expected another path, or no --depfile");
    }
    const bool escaped = c == ' ' || c == '\t' || c == '#' || c == ':';
    result += escaped ? std::string(backslashes + 1, '\\') : c == '$' ? "$" : "";
    result += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return result;
}

/// False of a path that make reads as something else in front of a colon: a pattern, a variable.
bool can_be_target(const std::string& path) {
  return path.find_first_of("%=;&") == std::string::npos && !path.ends_with('\\');
}

}  // namespace

std::string depfile_text(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs) {
  const auto words = [](const std::vector<std::string>& paths, const char* before) {
    std::string result;
    for (const std::string& path : paths) {
      result += (result.empty() ? before : " ") + make_word(path);
    }
    return result;
  };
  std::string result = fmt::format("{}:{}\n", words(outputs, ""), words(inputs, " "));
  for (const std::string& input : inputs) {
    if (can_be_target(input)) {
      result += make_word(input) + ":\n";
    }
  }
  return result;
}

}  // namespace treedyn
