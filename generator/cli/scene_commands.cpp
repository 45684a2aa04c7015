#include "cli/scene_commands.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/generation_options.hpp"
#include "common/decimal.hpp"
#include "model/effects.hpp"
#include "model/scene.hpp"
#include "model/scene_facts.hpp"
#include "simulation/integrator.hpp"

namespace treedyn {

void add_talk(CLI::App& command, Settings& settings) {
  command.add_flag("-q,--quiet", settings.quiet, "no warnings");
  command.add_flag("-v,--verbose", settings.verbose, "also what was done, with times");
}

namespace {

/// An option whose value is a number above 0.
template <class Value>
void add_positive(CLI::App& command, const std::string& name, const std::string& what,
                  const char* type, std::optional<Value>& value) {
  add_word(command, name, type, what, [name, &value](const std::string& text) {
    value = static_cast<Value>(positive(name, text));
  });
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
  add_word(command, name, "N", "bytes that the choice may take, or 64k", set);
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
  add("--without", "effects that are left out, one at a time, beside the whole scene",
      words_of(model::effects()), axes.without);
}

/// What is studied, and what is looked for.
void add_study(CLI::App& command, AccuracyRequest& request) {
  command.add_option("SCENE", request.scene, "scene (*.yaml), or a case of hard_cases (*.json)")
      ->required();
  command
      .add_option("-o,--output", request.output,
                  "folder of NAME_accuracy.html, .svg, .csv and .json; with --target "
                  "NAME_accuracy_CORE.toml of each processor, for generate --settings")
      ->type_name("DIR");
  const std::vector<std::string> names = words_of(accuracy::cores());
  command
      .add_option("--on", request.on,
                  fmt::format("processors, whose tables of cycles count: {}; default {}",
                              fmt::join(names, ","), fmt::join(request.on, ",")))
      ->delimiter(',')
      ->check(one_of(names))
      ->type_name("LIST");
  command.add_option("--integrators", request.integrators, "default: the explicit ones")
      ->delimiter(',')
      ->check(one_of(model::step_method_names()))
      ->type_name("LIST");
  command
      .add_option_function<std::vector<std::string>>(
          "--steps",
          [&request](const std::vector<std::string>& steps) {
            for (const std::string& step : steps) {
              request.steps.push_back(static_cast<double>(positive("--steps", step)));
            }
          },
          "s; default: the time between two comparisons, by 1, 2, 5, 10 ..")
      ->delimiter(',')
      ->type_name("LIST");
  add_positive(command, "--rate",
               "of a controller, Hz: only steps of which a whole number makes its period", "HZ",
               request.rate);
  add_positive(command, "--target",
               "largest error, see --error: prints the cheapest setting that keeps it", "E",
               request.target);
}

/// What is wrong with a value of --spread.
std::string check_spread(const std::string& text) {
  const Decimal decimal = read_decimal(text);
  const bool is_part = decimal && decimal.value >= Real("1e-9") && decimal.value <= 1;
  return is_part ? "" : fmt::format("{} is no part; expected 1e-9 to 1", shown(text));
}

/// Which motions are compared, and by what.
void add_comparison(CLI::App& command, AccuracyRequest& request) {
  command
      .add_option(
          "--states", request.states,
          fmt::format("initial states, the scene's own among them; default {}", request.states))
      ->transform(whole(1, 1000))
      ->type_name("N");
  command
      .add_option(
          "--spread", request.spread,
          "by which part of their size coordinates and speeds of the others differ at most, "
          "1e-9 to 1; default 0.01")
      ->check(CLI::Validator(check_spread, ""))
      ->type_name("PART");
  const std::vector<std::string> errors = words_of(accuracy::kErrors);
  command
      .add_option("--error", request.error,
                  "which one targets, fronts and pictures are of; default joints")
      ->check(one_of(errors))
      ->type_name(fmt::format("{}", fmt::join(errors, "|")));
  command
      .add_option("--points", request.points,
                  "whose places are compared, as in generate; default: those of the scene")
      ->type_name("LIST");
}

/// What a setting takes of a processor and of this machine.
void add_resources(CLI::App& command, AccuracyRequest& request) {
  command.add_flag("--sizes", request.sizes,
                   "flash and stack of every step on the processors, by arm-none-eabi-g++");
  command.add_flag("--time", request.time,
                   "wall time of every step on this machine, as multiples of the fastest; changes "
                   "from run to run");
  add_bytes(command, "--flash", request.limits.flash);
  add_bytes(command, "--stack", request.limits.stack);
}

/// A study by several processes, or one that goes on.
void add_parts(CLI::App& command, AccuracyRequest& request) {
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
      ->transform(whole())
      ->type_name("N")
      ->needs(parts)
      ->excludes("--plan");
  add_word(command, "--gather", "DIR",
           "measure nothing: all settings are in the folder that --parts had",
           [&request](const std::string& folder) {
             request.parts = folder;
             request.joined = true;
           })
      ->excludes("--plan", "--part", "--parts");
}

/// In the order in which they come first.
template <class Value>
void keep_once(std::vector<Value>& values) {
  std::vector<Value> once;
  for (const Value& value : values) {
    if (std::ranges::find(once, value) == once.end()) {
      once.push_back(value);
    }
  }
  values = once;
}

/// How the motion is integrated.
void add_integration(CLI::App& command, SimulateRequest& request) {
  command
      .add_option("--integrator", request.integrator,
                  "treedyn list integrators names them; default the scene's, which is fehlberg78 "
                  "unless it says another")
      ->check(one_of(words_of(simulation::integrators())))
      ->type_name("NAME");
  add_positive(command, "--step",
               "s; the longest one of an adaptive integrator, default no limit; of others default "
               "the scene's, or 1e-3",
               "H", request.step);
  add_positive(command, "--tolerance",
               "error of a step of an adaptive integrator; default the scene's, or 1e-10", "T",
               request.tolerance);
}

}  // namespace

void tidy_study(AccuracyRequest& request) {
  keep_once(request.on);
  keep_once(request.integrators);
  keep_once(request.steps);
}

void add_accuracy(CLI::App& app, Settings& settings) {
  AccuracyRequest& request = settings.accuracy;
  CLI::App& command =
      *app.add_subcommand("accuracy", "what the accuracy of a scene's generated step costs");
  add_study(command, request);
  add_comparison(command, request);
  add_axes(command, request.axes);
  add_resources(command, request);
  add_parts(command, request);
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
  CLI::Option* compiled =
      command.add_flag("--compiled", request.compiled, "generated functions, by the C++ compiler")
          ->excludes(engine);
  CLI::Option* generated =
      command
          .add_flag("--as-generated", request.as_generated,
                    "the generated step, by the C++ compiler: what firmware does")
          ->excludes(engine)
          ->excludes(compiled);
  command
      .add_option("--scalar", request.scalar,
                  "floating-point type of the generated step; default double")
      ->needs(generated)
      ->check(one_of({"double", "float"}))
      ->type_name("double|float");
  add_integration(command, request);
  add_positive(command, "--duration", "s; default the scene's", "T", request.duration);
  add_positive(command, "--max-steps", "end where more steps would be needed; default 1e7", "N",
               request.most_steps);
  add_positive(command, "--drift-limit",
               "end where a constraint is further off: rad, or parts of the robot's size; default "
               "0.01, 0.1 with --drift none",
               "D", request.drift_limit);
  add_positive(command, "--energy-limit",
               "end where more energy appears without power: parts of what the motion has "
               "exchanged; default 1",
               "E", request.energy_limit);
  add_choice(
      command, "--drift", {"none", "baumgarte", "projection"},
      [&request](const std::string& drift) { request.drift = model::drift_of(drift); },
      "what is done about the drift of constraints; default the scene's, or projection "
      "(generated steps: of closed loops only)");
  add_talk(command, settings);
}

}  // namespace treedyn
