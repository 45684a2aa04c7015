#include "cli/command_line.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/dump.hpp"
#include "cli/generation_options.hpp"
#include "cli/pages.hpp"
#include "cli/scene_commands.hpp"
#include "cli/settings_file.hpp"
#include "common/decimal.hpp"
#include "equations/scene_table.hpp"
#include "model/scene_facts.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

CLI::App* add_output_command(CLI::App& app, const char* name, const char* what, Settings& settings,
                             const char* folder = "folder of the files") {
  CLI::App* command = app.add_subcommand(name, what);
  add_generation(*command, settings.request);
  add_talk(*command, settings);
  command->add_option("-o,--output", settings.output, folder)->type_name("DIR");
  return command;
}

void require_output(const Settings& settings) {
  if (settings.output.empty()) {
    throw CLI::RequiredError("-o DIR");
  }
  const Request& request = settings.request;
  const bool other = request.language == emit::Language::kC99 || request.target.packed;
  if (settings.numeric && (request.target.lanes > 1 || other)) {
    throw CLI::ValidationError("--numeric",
                               "compares functions of one state, in C++, with dense matrices; "
                               "expected --lanes 1, no --language c99, no --layout packed");
  }
}

/// Reports that would drop another one, or have no JSON, refuse it.
void add_info(CLI::App& app, Settings& settings) {
  CLI::App* info = app.add_subcommand("info", "joints, D, masses, snapped constants, costs");
  add_generation(*info, settings.request);
  add_talk(*info, settings);
  CLI::Option* const json =
      info->add_flag("--json", settings.json, "as JSON: all, --accuracy, --base-parameters");
  CLI::Option* const passes =
      info->add_flag("--passes", settings.passes, "operations of every function, pass by pass")
          ->excludes(json);
  CLI::Option* const errors =
      info->add_flag("--accuracy", settings.errors,
                     "largest errors of every function in float and double beside its operations, "
                     "option by option")
          ->excludes(passes);
  CLI::Option* const derivation =
      info->add_option("--derivation", settings.derivation,
                       "how the code of a function comes about: equation, rules, recursion, cost")
          ->type_name("FUNCTION")
          ->excludes(json)
          ->excludes(passes)
          ->excludes(errors);
  info->add_flag("--base-parameters", settings.base_parameters,
                 "what of masses, first moments and inertias motions and joint forces can tell")
      ->excludes(passes)
      ->excludes(errors)
      ->excludes(derivation);
}

void add_commands(CLI::App& app, Settings& settings) {
  CLI::App* generate =
      add_output_command(app, "generate", "write NAME.hpp, NAME.cpp and NAME.json into a folder",
                         settings, "folder of the files; created if missing");
  CLI::Option* const depfile =
      generate->add_option("--depfile", settings.depfile, "also write a Make-style dependency file")
          ->type_name("FILE");
  CLI::Option* const stamp =
      generate
          ->add_option("--stamp", settings.stamp,
                       "also write this empty file, at every run: what Make waits for, as "
                       "unchanged files keep their time")
          ->type_name("FILE");
  generate
      ->add_option("--dump", settings.dump, "print what leaves a stage instead of writing files")
      ->excludes(depfile)
      ->excludes(stamp)
      ->check(one_of(stages()))
      ->type_name(fmt::format("{}", fmt::join(stages(), "|")));
  CLI::App* check = add_output_command(
      app, "check", "compare a folder with what generate would write; 1 if it differs", settings);
  check->add_flag("--numeric", settings.numeric,
                  "compile old and new functions and compare values");
  add_output_command(app, "outputs", "print the paths that generate would write", settings);

  add_info(app, settings);

  CLI::App* vet = app.add_subcommand("vet", "report what looks wrong in a model");
  add_model(*vet, settings.request);
  add_talk(*vet, settings);
  vet->add_option("--error-format", settings.error_format, "default text")
      ->check(one_of({"text", "gcc", "json"}))
      ->type_name("text|gcc|json");

  add_simulate(app, settings);
  add_accuracy(app, settings);

  CLI::App* list = app.add_subcommand("list", "names that other commands accept");
  add_talk(*list, settings);
  list->add_option("WHAT", settings.list_of, "what is named")
      ->required()
      ->check(one_of({"functions", "effects", "integrators"}))
      ->type_name("functions|effects|integrators");

  CLI::App* pages = app.add_subcommand("pages", "what packages of treedyn install");
  add_talk(*pages, settings);
  pages->add_option("WHAT", settings.list_of, "the manual page, or completion for bash")
      ->required()
      ->check(one_of({"man", "bash"}))
      ->type_name("man|bash");
}

void refuse(bool wrong, const std::string& what) {
  if (wrong) {
    throw CLI::ParseError(what, kUsage);
  }
}

/// The command of that name; null for an option. CLI11 takes an unknown command for a positional
/// argument and says less.
const CLI::App* find_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) {
      return command;
    }
    names.push_back(command->get_name());
  }
  refuse(!word.empty() && word.front() != '-',
         fmt::format("there is no command {}; expected one of {}", shown(word),
                     fmt::join(names, ", ")));
  return nullptr;
}

/// `--stamp=$NOTHING`: CLI11 would take the next word for the value.
void refuse_empty_values(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    refuse(word.starts_with("--") && word.find('=') + 1 == word.size(),
           fmt::format("{} has no value; expected one behind it", shown(word)));
  }
}

/// Standard input is read once: as MODEL or scene, or as a file that an option names.
void refuse_standard_input_twice(const std::vector<std::string>& words) {
  static const std::set<std::string> kReading = {"--scene", "--equations", "--settings"};
  static const std::set<std::string> kInputs = {"--scene=-", "--equations=-", "--settings=-"};
  int count = 0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool is_input = words[k] == "-" && (k == 0 || !words[k - 1].starts_with('-') ||
                                              kReading.contains(words[k - 1]));
    count += is_input || kInputs.contains(words[k]) ? 1 : 0;
  }
  refuse(count > 1, fmt::format("standard input (-) is read {} times; expected it once", count));
}

/// Where the option stands that CLI11 complains of, the first that it names; null: not in a
/// settings file.
const Location* place_of(const std::map<std::string, Location>& places, const std::string& what) {
  const std::size_t begin = what.find("--");
  const std::size_t size = std::min(what.find_first_of(",: ", begin), what.size()) - begin;
  const auto place =
      begin == std::string::npos ? places.end() : places.find(what.substr(begin, size));
  return place == places.end() ? nullptr : &place->second;
}

/// What a scene says itself; its base may stand beside a MODEL, which has to be the scene's.
void refuse_options_of_scene(const CLI::App& command, const Request& request) {
  for (const char* const option : {"--snap", "--mimic"}) {
    refuse(command.count(option) > 0,
           fmt::format("{}: goes with no scene, which takes its model with the default", option));
  }
  std::vector<std::string> options = {"--points", "--gravity"};
  if (request.model.empty()) {
    options.emplace_back("--base");
  }
  for (const std::string& option : options) {
    refuse(command.count(option) > 0,
           fmt::format("{}: is a matter of the scene; expected --scene without it", option));
  }
}

/// A model or a scene, and only what goes with a scene.
void require_model_or_scene(const CLI::App& command, const Settings& settings) {
  const Request& request = settings.request;
  refuse(request.model.empty() && !request.scene,
         "MODEL is required; expected a model or --scene FILE");
  const StepChoice& step = request.stepping;
  const char* const of_step = step.integrator    ? "integrator"
                              : step.step        ? "step"
                              : step.cuts        ? "cuts"
                              : step.compensated ? "state"
                                                 : "";
  refuse(!request.scene && *of_step != 0,
         fmt::format("--{}: is of the step of a scene; expected --scene FILE", of_step));
  const bool lanes = request.target.lanes > 1;
  refuse(request.share_limbs && (request.scene || lanes),
         fmt::format("{}: functions of a scene and of several states at once have no shared limbs; "
                     "expected a MODEL and 1 lane",
                     sharing_option(request)));
  refuse((request.target.limb_lanes || lanes) && request.target.sincos == emit::Sincos::kLibm,
         fmt::format("--{}lanes: <cmath> has no sines of vectors; expected no --sincos libm",
                     lanes ? "" : "limb-"));
  refuse(request.checked && (request.share_limbs || lanes),
         fmt::format(
             "--checked: a status is that of one state and of code that is not shared; expected no "
             "{} and 1 lane",
             sharing_option(request)));
  if (request.scene) {
    refuse(lanes, "--lanes: functions of a scene branch; expected 1 lane");
    refuse_options_of_scene(command, request);
  }
}

/// What no step can do, whatever the scene says.
void require_generated_step(const Settings& settings) {
  const StepChoice& step = settings.request.stepping;
  refuse(step.compensated.value_or(false) && step.integrator == "sdirk2",
         "--state: sdirk2 keeps no compensated state; expected plain, or --integrator rk4, "
         "dopri5-fixed or semi-implicit-euler");
  const std::vector<std::string> known = model::step_method_names();
  const std::string integrator = settings.simulation.integrator.value_or(known.front());
  refuse(settings.simulation.as_generated && std::ranges::find(known, integrator) == known.end(),
         fmt::format("--integrator: {} is not for generated code; expected {}, or no "
                     "--as-generated",
                     integrator, fmt::join(known, ", ")));
  refuse(settings.simulation.as_generated && settings.simulation.tolerance,
         "--tolerance: generated steps have a fixed length; expected --step, or no --as-generated");
}

/// What the language and the functions have words for.
void require_words_of_language(const Request& request) {
  const bool c = request.language == emit::Language::kC99;
  const bool lanes = request.target.lanes > 1;
  refuse(
      c && (request.share_limbs || lanes),
      fmt::format("--language c99: has no lanes and no code that limbs share; expected no {} and "
                  "1 lane",
                  sharing_option(request)));
  refuse(c && request.space, "--namespace: C has none; expected --prefix");
  refuse(!c && request.prefix, "--prefix: is that of --language c99; expected --namespace");
  refuse(request.self_test && lanes, "--self-test: tests functions of one state; expected 1 lane");
}

/// Functions of a scene need one.
void require_scene_of_functions(const Request& request) {
  const auto of_scene = std::ranges::find_if(request.functions, equations::is_scene_function);
  if (of_scene != request.functions.end()) {
    refuse(
        !request.scene,
        fmt::format("--functions: {} is a function of a scene; expected --scene FILE", *of_scene));
  }
}

/// Passes are shown of functions of a model, beside a scene too.
void require_functions_of_passes(const Settings& settings) {
  const Request& request = settings.request;
  refuse(
      settings.passes && request.scene &&
          std::ranges::all_of(request.functions, equations::is_scene_function),
      "--passes: functions of a scene have no table of passes; expected --functions of its model");
}

/// `info --equations` without a file shows the block equations.
void split_equations(const CLI::App& app, Settings& settings) {
  std::vector<std::string>& files = settings.request.equations;
  const bool is_info = app.got_subcommand("info");
  if (is_info && files.size() == 1 && settings.request.model.empty() && !settings.request.scene) {
    std::swap(settings.request.model, files.front());
  }
  settings.equations = std::erase(files, "") > 0;
  if (settings.equations && !is_info) {
    throw CLI::ValidationError("--equations", "expected a FILE");
  }
  const bool other = settings.json || settings.passes || settings.errors ||
                     settings.base_parameters || !settings.derivation.empty();
  if (settings.equations && other) {
    throw CLI::ValidationError(
        "--equations",
        "without a FILE shows the block equations, as text and alone; expected no "
        "--json, --passes, --accuracy, --derivation or --base-parameters");
  }
}

void require_options(const CLI::App& app, Settings& settings) {
  split_equations(app, settings);
  tidy_study(settings.accuracy);
  require_generated_step(settings);
  const auto generation = {"generate", "check", "outputs", "info"};
  if (std::ranges::any_of(generation, [&](const char* name) { return app.got_subcommand(name); })) {
    require_model_or_scene(*app.get_subcommands().front(), settings);
    require_words_of_language(settings.request);
    settle_vectors(settings.request);
    require_scene_of_functions(settings.request);
    require_functions_of_passes(settings);
  }
  refuse(app.got_subcommand("info") && settings.request.accuracy_samples > 0 && !settings.errors,
         "--accuracy-samples: is a number of states; expected --accuracy");
  if (settings.simulation.report && settings.simulation.output.empty()) {
    throw CLI::RequiredError("--report: -o DIR");
  }
  const bool writes = app.got_subcommand("generate") && settings.dump.empty();
  if (writes || app.got_subcommand("check") || app.got_subcommand("outputs")) {
    require_output(settings);
  }
}

/// The command without `--plan FILE`.
std::vector<std::string> without_plan(const std::string& program,
                                      const std::vector<std::string>& words) {
  std::vector<std::string> result{program};
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "--plan") {
      ++k;
    } else if (!words[k].starts_with("--plan=")) {
      result.push_back(words[k]);
    }
  }
  return result;
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
  CommandLine result;
  CLI::App app("Flat C++ functions for the dynamics of tree-structured robots.", "treedyn");
  app.set_version_flag("--version", fmt::format("treedyn {}", kVersion));
  app.require_subcommand(1);
  add_commands(app, result.settings);
  std::map<std::string, Location> places;  // of options in files of --settings
  try {
    const CLI::App* const command = find_command(app, argc > 1 ? argv[1] : "");
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    refuse_empty_values(words);
    refuse_standard_input_twice(words);
    if (command != nullptr && command->get_option_no_throw("--settings") != nullptr) {
      words = with_settings(words, *command, places);
      refuse_standard_input_twice(words);
    }
    result.settings.accuracy.command = without_plan(argc > 0 ? argv[0] : "treedyn", words);
    std::ranges::reverse(words);
    app.parse(std::move(words));
    require_options(app, result.settings);
    result.settings.command = app.get_subcommands().front()->get_name();
    if (result.settings.command == "pages") {
      result.status = 0;
      result.out = result.settings.list_of == "man" ? manual_page(app) : bash_completion(app);
    }
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream out;
    std::ostringstream error;
    result.status = app.exit(success, out, error);
    result.out = out.str();
  } catch (const InputError& error) {  // of --settings
    result.status = kFailure;
    result.error = fmt::format("{}\n", error.what());
  } catch (const CLI::ExtrasError&) {
    result.status = kUsage;
    result.error = fmt::format("treedyn: not expected: {}; see treedyn --help\n",
                               fmt::join(app.remaining(true), " "));
  } catch (const CLI::ParseError& error) {
    const std::string what = error.what();
    const Location* const place = place_of(places, what);
    result.status = place == nullptr ? kUsage : kFailure;
    result.error = place == nullptr
                       ? fmt::format("treedyn: {}; see treedyn --help\n", what)
                       : fmt::format("{}\n", InputError(*place, "settings: " + what).what());
  }
  return result;
}

}  // namespace treedyn
