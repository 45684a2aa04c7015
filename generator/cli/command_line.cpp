#include "cli/command_line.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/dump.hpp"
#include "cli/generation_options.hpp"
#include "cli/pages.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "equations/scene_table.hpp"
#include "formulate/scene_functions.hpp"
#include "formulate/scene_steps.hpp"
#include "model/effects.hpp"
#include "model/scene.hpp"
#include "model/scene_facts.hpp"
#include "simulation/integrator.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

void add_talk(CLI::App& command, Settings& settings) {
  command.add_flag("-q,--quiet", settings.quiet, "no warnings");
  command.add_flag("-v,--verbose", settings.verbose, "also what was done, with times");
}

CLI::App* add_output_command(CLI::App& app, const char* name, const char* what,
                             Settings& settings) {
  CLI::App* command = app.add_subcommand(name, what);
  add_generation(*command, settings.request);
  add_talk(*command, settings);
  command->add_option("-o,--output", settings.output, "folder of the files; created if missing")
      ->type_name("DIR");
  return command;
}

void require_output(const Settings& settings) {
  if (settings.output.empty()) {
    throw CLI::RequiredError("-o DIR");
  }
  if (settings.numeric && settings.request.target.lanes > 1) {
    throw CLI::ValidationError("--numeric", "compares functions of one state; expected --lanes 1");
  }
}

/// An option whose value is a number above 0.
template <class Value>
void add_positive(CLI::App& command, const std::string& name, const std::string& what,
                  const char* type, std::optional<Value>& value) {
  command
      .add_option_function<std::string>(
          name,
          [name, &value](const std::string& text) {
            value = static_cast<Value>(positive(name, text));
          },
          what)
      ->type_name(type);
}

/// An option whose value is a number of bytes, 4096 or 4k.
void add_bytes(CLI::App& command, const std::string& name, std::optional<long>& value) {
  const auto set = [name, &value](const std::string& text) {
    const bool kilo = text.ends_with('k') || text.ends_with('K');
    const Decimal decimal = read_decimal(text.substr(0, text.size() - (kilo ? 1 : 0)));
    const Real bytes = decimal.value * (kilo ? 1024 : 1);
    if (!decimal || bytes < 1 || bytes > 1e12 || bytes != floor(bytes)) {
      throw CLI::ValidationError(
          name, fmt::format("'{}' is no number of bytes above 0; expected one like 65536 or 64k",
                            shown(text)));
    }
    value = static_cast<long>(bytes);
  };
  command.add_option_function<std::string>(name, set, "bytes that the choice may take, or 64k")
      ->type_name("N");
}

/// In the order in which they come first.
template <class Value>
void keep_once(std::vector<Value>& values) {
  std::vector<Value> once;
  for (const Value& value : values) {
    if (std::find(once.begin(), once.end(), value) == once.end()) {
      once.push_back(value);
    }
  }
  values = once;
}

/// What a study varies besides scalar, integrator and step, only if it is asked to.
void add_axes(CLI::App& command, AccuracyAxes& axes) {
  const auto add = [&](const char* name, const char* what, const std::vector<std::string>& words,
                       std::vector<std::string>& values) {
    command.add_option(name, values, what)->delimiter(',')->check(one_of(words))->type_name("LIST");
  };
  add("--sincos", "sines of each, pair or libm", {"pair", "libm"}, axes.sincos);
  add("--forward-dynamics", "methods, factor or articulated", {"factor", "articulated"},
      axes.forward_dynamics);
  add("--stabilisation", "against drift: none, baumgarte or projection",
      {"none", "baumgarte", "projection"}, axes.stabilisation);
  std::vector<std::string> cuts;
  for (int k = 0; k <= model::kMostCuts; ++k) {
    cuts.push_back(std::to_string(k));
  }
  add("--cuts", "shorter steps that look for an event; 0: at the end", cuts, axes.cuts);
  std::vector<std::string> effects;
  for (const model::EffectRow& row : model::kEffects) {
    effects.emplace_back(row.name);
  }
  add("--without", "effects that are left out, one at a time, beside the whole scene", effects,
      axes.without);
}

void add_accuracy(CLI::App& app, Settings& settings) {
  AccuracyRequest& request = settings.accuracy;
  CLI::App& command =
      *app.add_subcommand("accuracy", "what the accuracy of a scene's generated step costs");
  command.add_option("SCENE", request.scene, "scene (*.yaml)")->required();
  command
      .add_option("-o,--output", request.output,
                  "folder of NAME_accuracy.html, .svg, .csv and .json")
      ->type_name("DIR");
  std::vector<std::string> names;
  for (const accuracy::Core& core : accuracy::cores()) {
    names.emplace_back(core.name);
  }
  command.add_option("--on", request.on, "processors, whose tables of cycles count")
      ->delimiter(',')
      ->check(one_of(names))
      ->type_name("LIST");
  std::vector<std::string> methods = model::step_method_names();
  command.add_option("--integrators", request.integrators, "default: the explicit ones")
      ->delimiter(',')
      ->check(one_of(methods))
      ->type_name("LIST");
  command
      .add_option_function<std::vector<std::string>>(
          "--steps",
          [&request](const std::vector<std::string>& steps) {
            for (const std::string& step : steps) {
              request.steps.push_back(static_cast<double>(positive("--steps", step)));
            }
          },
          "s; default: a ladder of 1, 2, 5")
      ->delimiter(',')
      ->type_name("LIST");
  add_positive(command, "--rate",
               "of a controller, Hz: only steps of which a whole number makes its period", "HZ",
               request.rate);
  add_positive(command, "--target",
               "largest error, see --error: prints the cheapest setting that keeps it", "E",
               request.target);
  command.add_option("--states", request.states, "initial states, the scene's own among them")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command
      .add_option(
          "--spread", request.spread,
          "by which part of their size coordinates and speeds of the others differ at most; "
          "default 0.01")
      ->check(CLI::Range(1e-9, 1.0))
      ->type_name("PART");
  std::vector<std::string> errors;
  for (const accuracy::ErrorRow& row : accuracy::kErrors) {
    errors.emplace_back(row.name);
  }
  command
      .add_option("--error", request.error,
                  "which one targets, fronts and pictures are of; default joints")
      ->check(one_of(errors))
      ->type_name("NAME");
  command
      .add_option("--points", request.points,
                  "whose places are compared, as in generate; default: those of the scene")
      ->type_name("LIST");
  add_axes(command, request.axes);
  command.add_flag("--sizes", request.sizes,
                   "flash and stack of every step on the processors, by arm-none-eabi-g++");
  command.add_flag("--time", request.time,
                   "wall time of every step on this machine, as multiples of the fastest; changes "
                   "from run to run");
  add_bytes(command, "--flash", request.limits.flash);
  add_bytes(command, "--stack", request.limits.stack);
  CLI::Option* parts =
      command
          .add_option("--parts", request.parts,
                      "folder of the results of single settings: they are kept there and taken "
                      "from there, so a study that was broken off goes on")
          ->type_name("DIR");
  command
      .add_option("--plan", request.plan,
                  "write the commands of all settings that are not in --parts, a line each")
      ->type_name("FILE")
      ->needs(parts);
  command.add_option("--part", request.part, "measure this setting alone, into --parts")
      ->type_name("N")
      ->needs(parts)
      ->excludes("--plan");
  command
      .add_option_function<std::string>(
          "--gather",
          [&request](const std::string& folder) {
            request.parts = folder;
            request.joined = true;
          },
          "measure nothing: all settings are in the folder that --parts had")
      ->type_name("DIR")
      ->excludes("--plan", "--part", "--parts");
  add_talk(command, settings);
}

void add_simulate(CLI::App& app, Settings& settings) {
  SimulateRequest& request = settings.simulation;
  CLI::App& command = *app.add_subcommand("simulate", "run a scene in time");
  command.add_option("SCENE", request.scene, "scene (*.yaml), or a case of hard_cases (*.json)")
      ->required();
  command
      .add_option("-o,--output", request.output,
                  "folder of NAME.csv; without it the table goes to standard output")
      ->type_name("DIR");
  command.add_flag("--json", request.json, "NAME.json too; without -o instead of the table");
  command.add_flag("--report", request.report, "NAME.html too: plots and a moving figure");
  CLI::Option* engine =
      command.add_flag("--engine", request.engine, "the generic engine, for comparison");
  command.add_flag("--compiled", request.compiled, "generated functions, by the C++ compiler")
      ->excludes(engine);
  CLI::Option* generated =
      command
          .add_flag("--as-generated", request.as_generated,
                    "the generated step, by the C++ compiler: what firmware does")
          ->excludes(engine);
  command
      .add_option("--scalar", request.scalar,
                  "floating-point type of the generated step; default double")
      ->needs(generated)
      ->check(one_of({"double", "float"}))
      ->type_name("double|float");
  std::vector<std::string> integrators;
  for (const simulation::IntegratorRow& row : simulation::integrators()) {
    integrators.emplace_back(row.name);
  }
  command.add_option("--integrator", request.integrator, "treedyn list integrators names them")
      ->check(one_of(integrators))
      ->type_name("NAME");
  add_positive(command, "--step", "s; the longest one of an adaptive integrator", "H",
               request.step);
  add_positive(command, "--tolerance", "error of a step of an adaptive integrator", "T",
               request.tolerance);
  add_positive(command, "--duration", "s", "T", request.duration);
  add_positive(command, "--max-steps", "end where more steps would be needed; default 1e7", "N",
               request.most_steps);
  add_positive(command, "--drift-limit",
               "end where a constraint is further off: rad, or parts of the robot's size; default "
               "0.01",
               "D", request.drift_limit);
  add_positive(command, "--energy-limit",
               "end where more energy appears without power: parts of what the motion has "
               "exchanged; default 1",
               "E", request.energy_limit);
  command
      .add_option_function<std::string>(
          "--drift",
          [&request](const std::string& drift) {
            request.drift = drift == "none"        ? model::Drift::kNone
                            : drift == "baumgarte" ? model::Drift::kBaumgarte
                                                   : model::Drift::kProjection;
          },
          "what is done about the drift of constraints")
      ->check(one_of({"none", "baumgarte", "projection"}))
      ->type_name("none|baumgarte|projection");
  add_talk(command, settings);
}

void add_commands(CLI::App& app, Settings& settings) {
  CLI::App* generate = add_output_command(
      app, "generate", "write NAME.hpp, NAME.cpp and NAME.json into a folder", settings);
  generate->add_option("--depfile", settings.depfile, "also write a Make-style dependency file")
      ->type_name("FILE");
  generate
      ->add_option("--stamp", settings.stamp,
                   "also write this empty file, at every run: what Make waits for, as unchanged "
                   "files keep their time")
      ->type_name("FILE");
  generate
      ->add_option("--dump", settings.dump, "print what leaves a stage instead of writing files")
      ->check(one_of(stages()))
      ->type_name(fmt::format("{}", fmt::join(stages(), "|")));
  CLI::App* check = add_output_command(
      app, "check", "compare a folder with what generate would write; 1 if it differs", settings);
  check->add_flag("--numeric", settings.numeric,
                  "compile old and new functions and compare values");
  add_output_command(app, "outputs", "print the paths that generate would write", settings);

  CLI::App* info = app.add_subcommand("info", "joints, D, masses, snapped constants, costs");
  add_generation(*info, settings.request);
  add_talk(*info, settings);
  info->add_flag("--json", settings.json, "as JSON");
  info->add_flag("--passes", settings.passes, "operations of every function, pass by pass");
  info->add_flag("--accuracy", settings.errors,
                 "largest errors of every function in float and double beside its operations, "
                 "option by option");
  info->add_option("--derivation", settings.derivation,
                   "how the code of a function comes about: equation, rules, recursion, cost")
      ->type_name("FUNCTION");
  info->add_flag("--base-parameters", settings.base_parameters,
                 "what of masses, first moments and inertias motions and joint forces can tell");

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
  if (!word.empty() && word.front() != '-') {
    throw CLI::ParseError(fmt::format("there is no command {}; expected one of {}", shown(word),
                                      fmt::join(names, ", ")),
                          kUsage);
  }
  return nullptr;
}

/// What a scene says itself; its base may stand beside a MODEL, which has to be the scene's.
void refuse_options_of_scene(const CLI::App& command, const Request& request) {
  std::vector<std::string> options = {"--points", "--gravity", "--snap", "--mimic"};
  if (request.model.empty()) {
    options.emplace_back("--base");
  }
  for (const std::string& option : options) {
    if (command.count(option) > 0) {
      throw CLI::ParseError(
          fmt::format("{}: is a matter of the scene; expected --scene without it", option), kUsage);
    }
  }
}

/// A model or a scene, and only what goes with a scene.
void require_model_or_scene(const CLI::App& command, const Settings& settings) {
  const Request& request = settings.request;
  if (request.model.empty() && !request.scene) {
    throw CLI::ParseError("MODEL is required; expected a model or --scene FILE", kUsage);
  }
  const StepChoice& step = request.stepping;
  if (!request.scene && (step.integrator || step.step || step.cuts || step.compensated)) {
    throw CLI::ParseError(
        "--integrator, --step, --cuts and --state are of the step of a scene; expected --scene "
        "FILE",
        kUsage);
  }
  if (request.share_limbs && (request.scene || request.target.lanes > 1)) {
    throw CLI::ParseError(
        "--share-limbs: functions of a scene and of several states at once have no shared limbs; "
        "expected a MODEL and 1 lane",
        kUsage);
  }
  if (request.target.limb_lanes &&
      (request.target.sincos == emit::Sincos::kLibm || request.target.vectors)) {
    throw CLI::ParseError("--limb-lanes: vectors have the pair alone; expected --sincos pair",
                          kUsage);
  }
  if (request.checked && (request.share_limbs || request.target.lanes > 1)) {
    throw CLI::ParseError(
        "--checked: a status is that of one state and of code that is not shared; expected no "
        "--share-limbs and 1 lane",
        kUsage);
  }
  if (!request.scene) {
    return;
  }
  if (request.target.lanes > 1) {
    throw CLI::ParseError("--lanes: functions of a scene branch; expected 1 lane", kUsage);
  }
  refuse_options_of_scene(command, request);
}

/// What the language and the functions have words for.
void require_words_of_language(const Request& request) {
  const bool c = request.language == emit::Language::kC99;
  if (c && (request.share_limbs || request.target.lanes > 1)) {
    throw CLI::ParseError(
        "--language c99: has no lanes and no code that limbs share; expected no --share-limbs and "
        "1 lane",
        kUsage);
  }
  if (c && request.space) {
    throw CLI::ParseError("--namespace: C has none; expected --prefix", kUsage);
  }
  if (!c && request.prefix) {
    throw CLI::ParseError("--prefix: is that of --language c99; expected --namespace", kUsage);
  }
  if (request.self_test && request.target.lanes > 1) {
    throw CLI::ParseError("--self-test: tests functions of one state; expected 1 lane", kUsage);
  }
}

/// Functions of a scene need one.
void require_scene_of_functions(const Request& request) {
  const auto of_scene = std::find_if(request.functions.begin(), request.functions.end(),
                                     equations::is_scene_function);
  if (!request.scene && of_scene != request.functions.end()) {
    throw CLI::ParseError(
        fmt::format("--functions: {} is a function of a scene; expected --scene FILE", *of_scene),
        kUsage);
  }
}

/// Passes are shown of functions of a model, beside a scene too.
void require_functions_of_passes(const Settings& settings) {
  const Request& request = settings.request;
  if (settings.passes && request.scene &&
      std::all_of(request.functions.begin(), request.functions.end(),
                  equations::is_scene_function)) {
    throw CLI::ParseError(
        "--passes: functions of a scene have no table of passes; expected --functions of its model",
        kUsage);
  }
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
}

void require_options(const CLI::App& app, Settings& settings) {
  split_equations(app, settings);
  keep_once(settings.accuracy.on);
  keep_once(settings.accuracy.integrators);
  keep_once(settings.accuracy.steps);
  const auto generation = {"generate", "check", "outputs", "info"};
  if (std::any_of(generation.begin(), generation.end(),
                  [&](const char* name) { return app.got_subcommand(name); })) {
    require_model_or_scene(*app.get_subcommands().front(), settings);
    require_words_of_language(settings.request);
    require_room_for_vectors(settings.request);
    require_scene_of_functions(settings.request);
    require_functions_of_passes(settings);
  }
  if (app.got_subcommand("info") && settings.request.accuracy_samples > 0 && !settings.errors) {
    throw CLI::ParseError("--accuracy-samples: is a number of states; expected --accuracy", kUsage);
  }
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
    } else if (words[k].rfind("--plan=", 0) != 0) {
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
  try {
    const CLI::App* const command = find_command(app, argc > 1 ? argv[1] : "");
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (command != nullptr && command->get_option_no_throw("--settings") != nullptr) {
      words = with_settings(words, *command);
    }
    result.settings.accuracy.command = without_plan(argc > 0 ? argv[0] : "treedyn", words);
    std::reverse(words.begin(), words.end());
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
    result.error = fmt::format("treedyn: {}\n", error.what());
  } catch (const CLI::ParseError& error) {
    result.status = kUsage;
    result.error = fmt::format("treedyn: {}; see treedyn --help\n", error.what());
  }
  return result;
}

}  // namespace treedyn
