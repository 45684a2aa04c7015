#include "cli/generation_options.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <system_error>

#include <fmt/format.h>

#include "accuracy/core.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/parallel.hpp"
#include "equations/scene_table.hpp"
#include "model/scene_facts.hpp"
#include "stages/stages.hpp"

namespace treedyn {

Real number(const std::string& option, const std::string& text) {
  const Decimal decimal = read_decimal(text);
  if (!decimal) {
    throw CLI::ValidationError(option, describe(decimal.error, text));
  }
  return decimal.value;
}

Real positive(const std::string& option, const std::string& text) {
  Real value = number(option, text);
  if (value <= 0) {
    throw CLI::ValidationError(
        option, fmt::format("{} is not above 0; expected a number above 0", shown(text)));
  }
  return value;
}

CLI::Validator whole(int least, int most) {
  const auto check = [least, most](std::string& text) {
    int value = 0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || rest != end || value < least || value > most) {
      return fmt::format("{} is no whole number from {} to {}", shown(text), least, most);
    }
    text = std::to_string(value);
    return std::string();
  };
  const bool bounded = least != std::numeric_limits<int>::min();
  return {check, bounded ? fmt::format("INT in [{} - {}]", least, most) : "", "whole"};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::IsMember(words).description("");
}

CLI::Option* add_word(CLI::App& command, const std::string& name, const std::string& type,
                      const std::string& help, const std::function<void(const std::string&)>& set) {
  return command.add_option_function<std::string>(name, set, help)->type_name(type);
}

CLI::Option* add_choice(CLI::App& command, const std::string& name,
                        const std::vector<std::string>& words,
                        const std::function<void(const std::string&)>& set,
                        const std::string& help) {
  return add_word(command, name, fmt::format("{}", fmt::join(words, "|")), help, set)
      ->check(one_of(words));
}

namespace {

/// A word of the user's that the output takes as a name.
void add_output_word(CLI::App& command, const char* option, const char* what, const char* help,
                     const std::function<void(const std::string&)>& set) {
  add_word(command, option, "NAME", help, [option, what, set](const std::string& word) {
    if (to_identifier(word) != word || is_reserved(word)) {
      throw CLI::ValidationError(
          option,
          fmt::format(
              "{} is not usable as {}; expected an identifier that C++ and its library leave free",
              shown(word), what));
    }
    set(word);
  });
}

void add_language(CLI::App& command, Request& request) {
  add_choice(
      command, "--language", {"c++", "c99"},
      [&request](const std::string& language) {
        request.language = language == "c99" ? emit::Language::kC99 : emit::Language::kCpp;
      },
      "c99: the same statements as NAME.h and NAME.c, for C and C++; default c++");
  add_output_word(command, "--name", "a namespace",
                  "file stem, namespace and prefix; default: the model's own name",
                  [&request](const std::string& name) { request.name = name; });
  add_output_word(command, "--namespace", "a namespace", "of C++; default: the file stem",
                  [&request](const std::string& space) { request.space = space; });
  add_output_word(
      command, "--prefix", "a prefix",
      "of the functions and constants of C99, PREFIX_mass_matrix; default: the file stem",
      [&request](const std::string& prefix) { request.prefix = prefix; });
  add_output_word(command, "--section", "a macro",
                  "a macro in front of every function, which your build defines: where code goes",
                  [&request](const std::string& section) { request.section = section; });
}

void set_functions(Request& request, const std::string& list) {
  std::vector<std::string> known = formulate::function_names();
  const std::vector<std::string> of_scenes = words_of(equations::scene_function_infos());
  known.insert(known.end(), of_scenes.begin(), of_scenes.end());
  for (const std::string& name : split(list, ',')) {
    if (is_reserved_word(name)) {
      throw CLI::ValidationError("--functions",
                                 fmt::format("{} is a reserved word and no name of a function; "
                                             "expected another name, or some of {}",
                                             shown(name), fmt::join(known, ",")));
    }
    const bool may_be_users = !name.empty() && to_identifier(name) == name;
    if (!may_be_users && std::ranges::find(known, name) == known.end()) {
      throw CLI::ValidationError(
          "--functions", fmt::format("there is no function '{}'; expected some of {}", shown(name),
                                     fmt::join(known, ",")));
    }
    request.functions.push_back(name);
  }
}

void set_gravity(Request& request, const std::string& text) {
  const std::vector<std::string> values = split(text, ',');
  if (values.size() != 3) {
    throw CLI::ValidationError("--gravity", "expected three numbers x,y,z");
  }
  for (std::size_t k = 0; k < 3; ++k) {
    request.gravity[k] = number("--gravity", values[k]);
  }
}

/// Names of passes, comma-separated.
void set_without(Request& request, const std::string& list) {
  for (const std::string& name : split(list, ',')) {
    const auto& known = formulate::passes();
    const auto found = std::ranges::find(known, name, &formulate::PassInfo::name);
    if (found == known.end()) {
      throw CLI::ValidationError(
          "--without", fmt::format("there is no pass {}; expected some of {}", shown(name),
                                   fmt::join(pass_names(), ",")));
    }
    request.without.push_back(found->pass);
  }
}

void add_sharing(CLI::App& command, Request& request) {
  command.add_flag("--share-limbs", request.share_limbs,
                   "one function for limbs of equal structure: less code, a few more operations");
  command.add_flag_callback(
      "--limb-lanes",
      [&request] {
        request.share_limbs = true;
        request.target.limb_lanes = true;
      },
      "such limbs in the lanes of vectors (GNU vector extension), the trunk in numbers");
}

void add_checked(CLI::App& command, Request& request) {
  command.add_flag(
      "--self-test", request.self_test,
      "known answers from 50 digits, and a function self_test that compares with them");
  command.add_flag("--checked", request.checked,
                   "beside functions that can fail NAME_checked, which return a status: a pivot of "
                   "A that is not safely above zero, what is not a number");
}

}  // namespace

void add_model(CLI::App& command, Request& request) {
  command
      .add_option(
          "MODEL", request.model,
          "URDF (*.urdf) or tree description (*.yaml, *.yml, *.json); -: YAML on standard input")
      ->required();
  add_word(
      command, "--base", "fixed|axes",
      "what carries the root: fixed (the ground), axes (six joints); default fixed",
      [&request](const std::string& base) {
        if (base == "free") {
          throw CLI::ValidationError("--base", "free is not there yet; expected fixed or axes");
        }
        if (base != "fixed" && base != "axes") {
          throw CLI::ValidationError(
              "--base", fmt::format("{} is no base; expected fixed or axes", shown(base)));
        }
        request.read.base = base == "axes" ? description::Base::kAxes : description::Base::kFixed;
      });
  add_word(command, "--snap", "TOL",
           "tolerance in rad below which decimals become exact angles; default 1e-9, 0: off",
           [&request](const std::string& text) {
             request.read.snap = number("--snap", text);
             if (request.read.snap < 0) {
               throw CLI::ValidationError("--snap", "a tolerance is not negative");
             }
           });
  add_choice(
      command, "--mimic", {"reduce", "independent"},
      [&request](const std::string& mimic) {
        request.read.mimic =
            mimic == "independent" ? description::Mimic::kIndependent : description::Mimic::kReduce;
      },
      "URDF mimic joints; default reduce");
}

namespace {

void add_runtime(CLI::App& command, Request& request) {
  add_word(command, "--runtime", "LIST",
           "numbers that are known at run time only, comma-separated LINK.mass, LINK.com, "
           "LINK.inertia, LINK.offset, POINT.at, one of their components (LINK.com.x), gravity: "
           "fields of a struct Parameters; info prints what each costs",
           [&request](const std::string& list) {
             for (const std::string& name : split(list, ',')) {
               request.read.runtime.push_back(name);
             }
           });
}

/// What goes before the `stepping` of a scene.
void add_stepping(CLI::App& command, StepChoice& stepping) {
  command
      .add_option("--integrator", stepping.integrator, "of the scene's step, instead of its own")
      ->check(one_of(model::step_method_names()))
      ->type_name("NAME");
  add_word(command, "--step", "S", "length of the scene's step in s, instead of its own",
           [&stepping](const std::string& text) { stepping.step = positive("--step", text); });
  command
      .add_option("--cuts", stepping.cuts, "shorter steps that look for an event; 0: at the end")
      ->transform(whole(0, model::kMostCuts))
      ->type_name("N");
  add_choice(
      command, "--state", {"plain", "compensated"},
      [&stepping](const std::string& state) { stepping.compensated = state == "compensated"; },
      "compensated: the step keeps what rounding takes from the state; default plain");
}

}  // namespace

void settle_vectors(Request& request) {
  const bool room = room_for_vectors(request);
  request.target.vectors = request.vectors.value_or(room);
  if (request.target.vectors && !room) {
    throw CLI::ValidationError(
        "--sincos vector",
        "all angles of one state first, in C++; expected 1 lane, no --trig late (with --core of a "
        "microcontroller: --trig early), no --section and no --language c99");
  }
}

namespace {

/// The processor and what follows for the order of statements; `--trig` has the last word.
void add_core(CLI::App& command, Request& request) {
  const auto late = [](bool is_late) {
    return is_late ? program::Trigonometry::kLate : program::Trigonometry::kEarly;
  };
  CLI::Option* const trig = add_choice(
      command, "--trig", {"early", "late"},
      [&request, late](const std::string& place) {
        request.target.trigonometry = late(place == "late");
      },
      "sines and cosines at the beginning, or just before their first use, for processors that "
      "execute in order; default early, with --core of a microcontroller late");
  std::vector<std::string> names = words_of(accuracy::cores());
  names.insert(names.begin(), "generic");
  std::vector<std::string> known = names;
  known.emplace_back("m4");  // with its FPU
  add_word(command, "--core", fmt::format("{}", fmt::join(names, "|")),
           "the processor: header and manifest say how to compile for it and how many cycles a "
           "call takes (m4: m4f); default generic, which says neither",
           [&request, late, trig](const std::string& core) {
             request.core = core == "generic" ? "" : core == "m4" ? "m4f" : core;
             if (trig->count() == 0) {
               request.target.trigonometry = late(has_late_sines(request.core));
             }
           })
      ->check(one_of(known));
}

/// Numbers, sines and storage of the output.
void add_target(CLI::App& command, Request& request) {
  add_choice(
      command, "--scalar", {"double", "float"},
      [&request](const std::string& scalar) {
        request.target.scalar = scalar == "float" ? emit::Scalar::kFloat : emit::Scalar::kDouble;
      },
      "the only floating-point type of the output; default double");
  command
      .add_option("--lanes", request.target.lanes,
                  "states computed at once, one a lane of a vector")
      ->check(one_of({"1", "2", "4", "8", "16"}))
      ->type_name("1|2|4|8|16")
      ->capture_default_str();
  add_word(command, "--sincos", "vector|pair|libm",
           "sine and cosine by one branch-free function in the source, without contraction the "
           "same bits everywhere: for several angles of a function at once, as many as the "
           "processor's vectors hold, or one by one (builtin: pair); or of the C library; default "
           "vector, and pair in C, with --trig late, --section and for several lanes",
           [&request](const std::string& choice) {
             request.target.sincos = choice == "libm" ? emit::Sincos::kLibm : emit::Sincos::kPair;
             request.vectors = choice == "vector";
           })
      ->check(one_of({"vector", "pair", "libm", "builtin"}));
  add_core(command, request);
  add_choice(
      command, "--layout", {"dense", "packed"},
      [&request](const std::string& layout) { request.target.packed = layout == "packed"; },
      "of A and of matrices of users: dense, or the structural nonzeros, of A on and below the "
      "diagonal, with index tables in the header; default dense");
}

/// Which functions there are, and of what.
void add_contents(CLI::App& command, Request& request) {
  add_word(command, "--functions", "LIST", "comma-separated; treedyn list functions names them",
           [&request](const std::string& list) { set_functions(request, list); });
  add_word(command, "--equations", "FILE",
           "a file with equations of your own, may stand several times; info without a FILE: the "
           "block equations with the zero blocks of D",
           [&request](const std::string& file) { request.equations.push_back(file); })
      ->expected(0, 1)
      ->trigger_on_parse();
  add_word(command, "--points", "LIST",
           "comma-separated name, name=link, name=link:x,y,z, or all; default: the model's points",
           [&request](const std::string& list) { request.points = list; });
  add_word(command, "--gravity", "x,y,z", "m/s^2 in the base frame; default 0,0,-9.81",
           [&request](const std::string& text) { set_gravity(request, text); });
}

/// How formulations are looked for and measured.
void add_formulation(CLI::App& command, Request& request) {
  command
      .add_option("--accuracy-samples", request.accuracy_samples,
                  "states in which errors of the functions of the model are measured: into the "
                  "manifest; of info --accuracy, default 200")
      ->transform(whole(1, 10000))
      ->type_name("N");
  command.add_option("--effort", request.effort, "search effort in moves; 0: none")
      ->transform(whole(0, 1000000000))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option_function<int>("-j,--jobs", set_threads,
                                "threads, which decide no byte; default: cores of the machine")
      ->transform(whole(1, 1000))
      ->type_name("N");
  add_word(command, "--without", "LIST",
           "passes to switch off, comma-separated; treedyn info --passes shows what each one gains",
           [&request](const std::string& list) { set_without(request, list); });
  add_choice(
      command, "--units", {"auto", "si"},
      [&request](const std::string& choice) { request.metres = choice == "si"; },
      "unit of length inside functions: metres, or a length of the robot where that saves 2 % of "
      "the operations; default auto");
  add_choice(
      command, "--forward-dynamics", {"cheapest", "factor", "articulated"},
      [&request](const std::string& choice) {
        request.forward_dynamics = formulate::forward_dynamics_of(choice);
      },
      "method of forward_dynamics; default cheapest");
}

}  // namespace

void add_generation(CLI::App& command, Request& request) {
  add_model(command, request);
  add_sharing(command, request);
  add_checked(command, request);
  add_runtime(command, request);
  add_stepping(command, request.stepping);
  add_word(command, "--settings", "FILE",
           "a file with options of this list, a line each: scalar = \"float\"; accuracy --target "
           "writes one",
           [&request](const std::string& file) { request.settings.push_back(file); });
  command.get_option("MODEL")->required(false);
  add_word(command, "--scene", "FILE",
           "a scene: its model, effects and functions instead of a MODEL",
           [&request](const std::string& file) { request.scene = file; });
  add_language(command, request);
  add_target(command, request);
  add_contents(command, request);
  add_formulation(command, request);
}

}  // namespace treedyn
