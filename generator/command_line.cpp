#include "command_line.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "emit/names.hpp"
#include "simplify/scene_functions.hpp"
#include "simulation/integrator.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> result(1);
  for (const char c : list) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

Real number(const std::string& option, const std::string& text) {
  const Decimal decimal = read_decimal(text);
  if (!decimal) {
    throw CLI::ValidationError(option, describe(decimal.error, text));
  }
  return decimal.value;
}

/// A check whose words the option's type name already shows.
CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::IsMember(words).description("");
}

void add_name(CLI::App& command, Request& request) {
  command
      .add_option_function<std::string>(
          "--name",
          [&request](const std::string& name) {
            if (to_identifier(name) != name || emit::is_reserved(name)) {
              throw CLI::ValidationError(
                  "--name", fmt::format("{} is not usable as a namespace; expected an identifier "
                                        "that C++ and its library leave free",
                                        shown(name)));
            }
            request.name = name;
          },
          "file stem and namespace; default: the model's own name")
      ->type_name("NAME");
}

void add_model(CLI::App& command, Request& request) {
  command
      .add_option("MODEL", request.model,
                  "URDF (*.urdf) or tree description (*.yaml); -: YAML on standard input")
      ->required();
  command
      .add_option_function<std::string>(
          "--base",
          [&request](const std::string& base) {
            if (base == "free") {
              throw CLI::ValidationError("--base", "free is not there yet; expected fixed or axes");
            }
            if (base != "fixed" && base != "axes") {
              throw CLI::ValidationError(
                  "--base", fmt::format("{} is no base; expected fixed or axes", shown(base)));
            }
            request.read.base =
                base == "axes" ? description::Base::kAxes : description::Base::kFixed;
          },
          "what carries the root: fixed (the ground), axes (six joints); default fixed")
      ->type_name("fixed|axes");
  command
      .add_option_function<std::string>(
          "--snap",
          [&request](const std::string& text) {
            request.read.snap = number("--snap", text);
            if (request.read.snap < 0) {
              throw CLI::ValidationError("--snap", "a tolerance is not negative");
            }
          },
          "tolerance in rad below which decimals become exact angles; default 1e-9, 0: off")
      ->type_name("TOL");
  command
      .add_option_function<std::string>(
          "--mimic",
          [&request](const std::string& mimic) {
            request.read.mimic = mimic == "independent" ? description::Mimic::kIndependent
                                                        : description::Mimic::kReduce;
          },
          "URDF mimic joints; default reduce")
      ->check(one_of({"reduce", "independent"}))
      ->type_name("reduce|independent");
}

void set_functions(Request& request, const std::string& list) {
  std::vector<std::string> known = simplify::function_names();
  for (const simplify::SceneFunctionInfo& info : simplify::scene_function_infos()) {
    known.emplace_back(info.name);
  }
  for (const std::string& name : split(list)) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw CLI::ValidationError(
          "--functions", fmt::format("there is no function {}; expected some of {}", shown(name),
                                     fmt::join(known, ",")));
    }
    request.functions.push_back(name);
  }
}

void set_gravity(Request& request, const std::string& text) {
  const std::vector<std::string> values = split(text);
  if (values.size() != 3) {
    throw CLI::ValidationError("--gravity", "expected three numbers x,y,z");
  }
  for (std::size_t k = 0; k < 3; ++k) {
    request.gravity[k] = number("--gravity", values[k]);
  }
}

void set_forward_dynamics(Request& request, const std::string& choice) {
  using simplify::ForwardDynamics;
  request.forward_dynamics = choice == "factor"        ? ForwardDynamics::kFactor
                             : choice == "articulated" ? ForwardDynamics::kArticulated
                                                       : ForwardDynamics::kCheapest;
}

/// Names of passes, comma-separated.
void set_without(Request& request, const std::string& list) {
  for (const std::string& name : split(list)) {
    const auto& known = simplify::passes();
    const auto found =
        std::find_if(known.begin(), known.end(),
                     [&](const simplify::PassInfo& info) { return name == info.name; });
    if (found == known.end()) {
      throw CLI::ValidationError(
          "--without", fmt::format("there is no pass {}; expected some of {}", shown(name),
                                   fmt::join(pass_names(), ",")));
    }
    request.without.push_back(found->pass);
  }
}

void add_sharing(CLI::App& command, Request& request) {
  command.add_flag(
      "--share-limbs", request.share_limbs,
      "one function for limbs of equal structure: half the code, a few more operations");
}

void add_generation(CLI::App& command, Request& request) {
  add_model(command, request);
  add_sharing(command, request);
  command.get_option("MODEL")->required(false);
  command
      .add_option_function<std::string>(
          "--scene", [&request](const std::string& file) { request.scene = file; },
          "a scene: its model, effects and functions instead of a MODEL")
      ->type_name("FILE");
  add_name(command, request);
  command
      .add_option_function<std::string>(
          "--scalar",
          [&request](const std::string& scalar) {
            request.target.scalar =
                scalar == "float" ? emit::Scalar::kFloat : emit::Scalar::kDouble;
          },
          "the only floating-point type of the output; default double")
      ->check(one_of({"double", "float"}))
      ->type_name("double|float");
  command
      .add_option("--lanes", request.target.lanes,
                  "states computed at once, one a lane of a vector")
      ->check(one_of({"1", "2", "4", "8", "16"}))
      ->type_name("1|2|4|8|16")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--sincos",
          [&request](const std::string& choice) {
            request.target.builtin_sincos = choice == "builtin";
          },
          "sine and cosine of the C library or written into the source; default libm")
      ->check(one_of({"libm", "builtin"}))
      ->type_name("libm|builtin");
  command
      .add_option_function<std::string>(
          "--layout",
          [&request](const std::string& layout) { request.target.packed = layout == "packed"; },
          "of A: N x N, or its structural nonzeros on and below the diagonal with index tables in "
          "the header; default dense")
      ->check(one_of({"dense", "packed"}))
      ->type_name("dense|packed");
  command
      .add_option_function<std::string>(
          "--functions", [&request](const std::string& list) { set_functions(request, list); },
          "comma-separated; treedyn list functions names them")
      ->type_name("LIST");
  command
      .add_option_function<std::string>(
          "--points", [&request](const std::string& list) { request.points = list; },
          "comma-separated name, name=link, name=link:x,y,z, or all; default: the model's points")
      ->type_name("LIST");
  command
      .add_option_function<std::string>(
          "--gravity", [&request](const std::string& text) { set_gravity(request, text); },
          "m/s^2 in the base frame; default 0,0,-9.81")
      ->type_name("x,y,z");
  command.add_option("--effort", request.effort, "search effort in moves; 0: none")
      ->check(CLI::Range(0, 1000000000))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--without", [&request](const std::string& list) { set_without(request, list); },
          "passes to switch off, comma-separated; treedyn info --passes shows what each one gains")
      ->type_name("LIST");
  command
      .add_option_function<std::string>(
          "--forward-dynamics",
          [&request](const std::string& choice) { set_forward_dynamics(request, choice); },
          "method of forward_dynamics; default cheapest")
      ->check(one_of({"cheapest", "factor", "articulated"}))
      ->type_name("cheapest|factor|articulated");
}

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

/// An option whose value is a number above zero.
void add_positive(CLI::App& command, const std::string& name, const std::string& what,
                  const char* type, std::optional<Real>& value) {
  command
      .add_option_function<std::string>(
          name,
          [name, &value](const std::string& text) {
            value = number(name, text);
            if (*value <= 0) {
              throw CLI::ValidationError(name, "expected a number above zero");
            }
          },
          what)
      ->type_name(type);
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
  info->add_flag("--equations", settings.equations,
                 "the block equations with the zero blocks of D");

  CLI::App* vet = app.add_subcommand("vet", "report what looks wrong in a model");
  add_model(*vet, settings.request);
  add_talk(*vet, settings);
  vet->add_option("--error-format", settings.error_format, "default text")
      ->check(one_of({"text", "gcc", "json"}))
      ->type_name("text|gcc|json");

  add_simulate(app, settings);

  CLI::App* list = app.add_subcommand("list", "names that other commands accept");
  add_talk(*list, settings);
  list->add_option("WHAT", settings.list_of, "functions, effects or integrators")
      ->required()
      ->check(one_of({"functions", "effects", "integrators"}))
      ->type_name("");
}
/// CLI11 takes an unknown command for a positional argument and says less.
void require_known_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (!word.empty() && word.front() != '-' &&
      std::find(names.begin(), names.end(), word) == names.end()) {
    throw CLI::ParseError(fmt::format("there is no command {}; expected one of {}", shown(word),
                                      fmt::join(names, ", ")),
                          kUsage);
  }
}
/// A model or a scene, not both, and only what goes with a scene.
void require_model_or_scene(const Settings& settings) {
  const Request& request = settings.request;
  if (request.model.empty() && !request.scene) {
    throw CLI::ParseError("MODEL is required; expected a model or --scene FILE", kUsage);
  }
  if (request.share_limbs && (request.scene || request.target.lanes > 1)) {
    throw CLI::ParseError(
        "--share-limbs: functions of a scene and of several states at once have no shared limbs; "
        "expected a MODEL and 1 lane",
        kUsage);
  }
  if (!request.scene) {
    return;
  }
  const Request defaults;
  if (request.target.lanes > 1) {
    throw CLI::ParseError("--lanes: functions of a scene branch; expected 1 lane", kUsage);
  }
  if (request.points || request.gravity != defaults.gravity ||
      request.read.snap != defaults.read.snap || request.read.mimic != defaults.read.mimic) {
    throw CLI::ParseError(
        "--points, --gravity, --snap and --mimic are a matter of the scene; "
        "expected --scene without them",
        kUsage);
  }
}

/// Functions of a scene need one.
void require_scene_of_functions(const Request& request) {
  const auto of_scene =
      std::find_if(request.functions.begin(), request.functions.end(), simplify::is_scene_function);
  if (!request.scene && of_scene != request.functions.end()) {
    throw CLI::ParseError(
        fmt::format("--functions: {} is a function of a scene; expected --scene FILE", *of_scene),
        kUsage);
  }
}

void require_options(const CLI::App& app, const Settings& settings) {
  const auto generation = {"generate", "check", "outputs", "info"};
  if (std::any_of(generation.begin(), generation.end(),
                  [&](const char* name) { return app.got_subcommand(name); })) {
    require_model_or_scene(settings);
    require_scene_of_functions(settings.request);
  }
  if (settings.simulation.report && settings.simulation.output.empty()) {
    throw CLI::RequiredError("--report: -o DIR");
  }
  const bool writes = app.got_subcommand("generate") && settings.dump.empty();
  if (writes || app.got_subcommand("check") || app.got_subcommand("outputs")) {
    require_output(settings);
  }
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
  CommandLine result;
  CLI::App app("Flat C++ functions for the dynamics of tree-structured robots.", "treedyn");
  app.set_version_flag("--version", fmt::format("treedyn {}", kVersion));
  app.require_subcommand(1);
  add_commands(app, result.settings);
  try {
    require_known_command(app, argc > 1 ? argv[1] : "");
    app.parse(argc, argv);
    require_options(app, result.settings);
    result.settings.command = app.get_subcommands().front()->get_name();
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream out;
    std::ostringstream error;
    result.status = app.exit(success, out, error);
    result.out = out.str();
  } catch (const CLI::ParseError& error) {
    result.status = kUsage;
    result.error = fmt::format("treedyn: {}; see treedyn --help\n", error.what());
  }
  return result;
}

}  // namespace treedyn
