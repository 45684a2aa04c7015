// Generated code on Cortex-M0+, M4F, M7 and M33, under qemu: the bits of the host, budgets of
// instructions, stack and flash, and how far the table of instructions of `treedyn accuracy` is
// off.
//
//   firmware TREEDYN MODELS SOURCES BUDGETS [--update]
//
// Sines are those of `--sincos pair`, on the host too, as the table's are. SOURCES is the folder of
// this file. BUDGETS has a line for every function; it fails if a figure is exceeded by more than
// 0.5 %, or if code keeps something in .data, or code in float calls a function for double.
// --update writes it anew.
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibration.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"

namespace {

using namespace treedyn;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

struct Core {
  const char* name;
  Words options;
  const char* board;
  const char* code;  ///< addresses of memory
  const char* data;

  bool fuses_float = true;  ///< has fused multiply-adds
  bool fuses_double = false;
};

/// qemu has no board with a Cortex-M0+ and enough memory: its code runs on a Cortex-M3, which has
/// all its instructions.
const std::vector<Core> kCores = {
    {"m0plus", {"-mcpu=cortex-m0plus"}, "mps2-an385", "0", "0x20000000", false},
    {"m4f",
     {"-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"},
     "mps2-an386",
     "0",
     "0x20000000"},
    {"m7",
     {"-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"},
     "mps2-an500",
     "0",
     "0x20000000",
     true,
     true},
    {"m33",
     {"-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"},
     "mps2-an505",
     "0x10000000",
     "0x38000000"},
};

/// Not contracted, or compiled with contraction for the table of `treedyn accuracy` alone.
constexpr const char* kExact = "-ffp-contract=off";
constexpr const char* kContracted = "-ffp-contract=fast";

/// Of generate and info.
constexpr const char* kEffort = "200";

struct Robot {
  const char* name;
  Words arguments;             ///< of generate
  std::string functions = "";  ///< all that a scene has where empty
  bool is_float = true;

  /// Of no scene.
  [[nodiscard]] bool is_model() const { return arguments.front() != "--scene"; }
};

std::vector<Robot> robots() {
  const std::string functions =
      "mass_matrix,bias_force,gravity_force,inverse_dynamics,forward_dynamics";
  return {
      {"biped", {"biped.yaml", "--layout", "packed"}, functions},
      {"quadruped", {"quadruped.yaml"}, functions},
      {"puma560", {"puma560.yaml"}, functions},
      {"puma560_double", {"puma560.yaml"}, functions, false},
      {"panda", {"panda.yaml"}, functions},
      {"panda_double", {"panda.yaml"}, functions, false},
      {"drop", {"--scene", "scenes/drop.yaml"}},
      {"biped_feet", {"--scene", "scenes/biped_double_support.yaml"}, "constrained_dynamics"},
  };
}

bool is_there(const std::string& program) {
  try {
    return support::run({program, "--version"}).status == 0;
  } catch (const std::exception&) {
    return false;
  }
}

Words joined(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The arrays of one kind of a function, as C++ text: their definition and the name of the table.
std::string arrays(const std::string& table, const Words& names, const std::vector<int>& sizes,
                   const std::vector<bool>& integer) {
  std::string text;
  std::string rows;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = table + "_" + names[k];
    text += fmt::format("{} {}[{}];\n", integer[k] ? "int" : "Scalar", name, sizes[k]);
    rows += fmt::format("{{{}, {}, {}}}, ", name, sizes[k], integer[k] ? 1 : 0);
  }
  return text + fmt::format("const Array {}[] = {{{}{{nullptr, 0, 0}}}};\n", table, rows);
}

/// The table of `exercise.hpp` for a manifest.
std::string calls_text(const support::Manifest& manifest) {
  std::string text = "#include \"exercise.hpp\"\n#include \"generated.hpp\"\n\nnamespace {\n";
  std::string rows;
  for (const support::FunctionInfo& function : manifest.functions) {
    const std::string in = "in_" + function.name;
    const std::string out = "out_" + function.name;
    text += arrays(in, function.arguments, function.inputs, function.integer_inputs);
    text += arrays(out, function.results, function.outputs, function.integer_outputs);
    Words places;
    for (const std::string& name : function.arguments) {
      places.push_back(in + "_" + name);
    }
    for (const std::string& name : function.results) {
      places.push_back(out + "_" + name);
    }
    const std::string call =
        fmt::format("generated::{}({})", function.name, fmt::join(places, ", "));
    text += function.status
                ? fmt::format("int call_{}() {{ return {}; }}\n", function.name, call)
                : fmt::format("int call_{}() {{ {}; return 0; }}\n", function.name, call);
    rows += fmt::format("    {{\"{0}\", call_{0}, {1}, {2}, {3}, {4}}},\n", function.name, in,
                        function.arguments.size(), out, function.results.size());
  }
  return text + fmt::format(
                    "}}  // namespace\n\nextern const Call kCalls[] = {{\n{}}};\nextern const int "
                    "kCallsSize = {};\n",
                    rows, manifest.functions.size());
}

struct Places {
  std::string treedyn;
  fs::path models;
  fs::path sources;
};

/// Name of the function to its line of figures.
using Lines = std::map<std::string, std::vector<std::string>>;

Lines lines_of(const std::string& text) {
  Lines result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    for (std::string word; words >> word;) {
      result[name].push_back(word);
    }
  }
  return result;
}

Words scalar_option(const Robot& robot) {
  return robot.is_float ? Words{} : Words{"-DEXERCISE_DOUBLE"};
}

Lines on_the_host(const Robot& robot, const Places& places, const fs::path& work) {
  support::run_checked(
      joined({"g++", "-std=c++17", "-O2", kExact, "-I", places.sources, "-I", work,
              work / "generated.cpp", work / "calls.cpp", places.sources / "exercise.cpp",
              places.sources / "host.cpp", "-o", work / "host"},
             scalar_option(robot)));
  return lines_of(support::run_checked({work / "host"}).out);
}

/// Instructions of a call on the host, counted by callgrind in ten.
long on_the_host(const fs::path& work, const std::string& function) {
  const support::Outcome outcome =
      support::run_checked({"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                            fmt::format("--toggle-collect=*call_{}()", function), work / "host"});
  const std::size_t place = outcome.err.find("Collected : ");
  if (place == std::string::npos) {
    throw std::runtime_error("valgrind has not counted: " + outcome.err);
  }
  return std::atol(outcome.err.c_str() + place + std::strlen("Collected : ")) / 10;
}

/// Bytes of code and constants; nothing may be in .data or .bss, and nothing may miss a function
/// for double.
long flash_of(const std::string& object, bool is_float) {
  for (const auto& [symbol, unused] : lines_of(
           support::run_checked({"arm-none-eabi-nm", "-u", "--format=just-symbols", object}).out)) {
    if (is_float && (symbol.rfind("__aeabi_d", 0) == 0 || symbol == "__aeabi_f2d")) {
      throw std::runtime_error(fmt::format("{} calls {}", object, symbol));
    }
  }
  std::istringstream words(support::run_checked({"arm-none-eabi-size", object}).out);
  std::string heading;
  std::getline(words, heading);
  long text = 0;
  long data = 0;
  long bss = 0;
  words >> text >> data >> bss;
  if (data + bss != 0) {
    throw std::runtime_error(fmt::format("{} has {} bytes of data", object, data + bss));
  }
  return text;
}

/// The driver for C: that for C++ would link libstdc++, which is not needed.
const Words kCompile = {"arm-none-eabi-gcc",  "-std=c++17", "-mthumb",
                        "-fno-exceptions",    "-fno-rtti",  "-fno-math-errno",
                        "-ffunction-sections"};

/// Name, hash, instructions and stack of every function on a core.
Lines on_a_core(const Robot& robot, const Places& places, const fs::path& work, const Core& core,
                const std::string& optimisation, const std::string& contraction, long* flash) {
  const Words options =
      joined(joined(kCompile, joined(core.options, {contraction, "-I", places.sources, "-I", work,
                                                    "-I", places.sources / "include"})),
             scalar_option(robot));
  const std::string object = work / "generated.o";
  support::run_checked(joined(options, {optimisation, "-c", work / "generated.cpp", "-o", object}));
  *flash = flash_of(object, robot.is_float);
  support::run_checked(
      joined(options,
             {"-O1", work / "calls.cpp", places.sources / "exercise.cpp",
              places.sources / "image.cpp", object, "-nostartfiles", "-T",
              places.sources / "image.ld", fmt::format("-Wl,--defsym=CODE_AT={}", core.code),
              fmt::format("-Wl,--defsym=DATA_AT={}", core.data), "-lm", "-o", work / "image.elf"}));
  const support::Outcome outcome =
      support::run({"qemu-system-arm", "-M", core.board, "-display", "none", "-monitor", "none",
                    "-serial", "none", "-semihosting-config", "enable=on,target=native", "-icount",
                    "shift=6,sleep=off", "-kernel", work / "image.elf"});
  return lines_of(outcome.out + outcome.err);
}

struct Budget {
  long instructions = 0;
  long stack = 0;
  long flash = 0;  ///< of the whole file
};
using Budgets = std::map<std::string, Budget>;

Budgets read_budgets(const std::string& path) {
  Budgets result;
  std::istringstream text(support::read_file(path));
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    const std::size_t key =
        line.find(',', line.find(',', line.find(',', line.find(',') + 1) + 1) + 1);
    Budget& budget = result[line.substr(0, key)];
    if (std::sscanf(line.c_str() + key, ",%ld,%ld,%ld", &budget.instructions, &budget.stack,
                    &budget.flash) != 3) {
      throw std::runtime_error(fmt::format("{}: not a line of budgets: {}", path, line));
    }
  }
  return result;
}

std::string budgets_text(const Budgets& budgets) {
  std::string text = "robot,core,optimisation,function,instructions,stack,flash of the file\n";
  for (const auto& [key, budget] : budgets) {
    text += fmt::format("{},{},{},{}\n", key, budget.instructions, budget.stack, budget.flash);
  }
  return text;
}

/// What exceeds a budget, a line each.
int exceeded(const Budgets& measured, const Budgets& budgets) {
  int failures = 0;
  const auto check = [&](const std::string& key, const char* what, long value, long most) {
    if (static_cast<double>(value) > 1.005 * static_cast<double>(most)) {
      fmt::print("{}: {} {}, budget {}\n", key, what, value, most);
      ++failures;
    }
  };
  for (const auto& [key, budget] : measured) {
    const auto found = budgets.find(key);
    if (found == budgets.end()) {
      fmt::print("{}: no budget\n", key);
      ++failures;
      continue;
    }
    check(key, "instructions", budget.instructions, found->second.instructions);
    check(key, "bytes of stack", budget.stack, found->second.stack);
    check(key, "bytes of flash", budget.flash, found->second.flash);
  }
  return failures;
}

/// \returns the number of functions whose bits differ
int compare(const std::string& place, const Lines& host, const Lines& core, long flash,
            Budgets& budgets) {
  int failures = 0;
  for (const auto& [function, words] : host) {
    const auto found = core.find(function);
    const std::string key = fmt::format("{},{}", place, function);
    if (found == core.end() || found->second.size() != 3) {
      fmt::print("{}: did not end\n", key);
      ++failures;
    } else if (found->second[0] != words[0]) {
      fmt::print("{}: other bits than on the host\n", key);
      ++failures;
    } else {
      budgets[key] = {std::atol(found->second[1].c_str()), std::atol(found->second[2].c_str()),
                      flash};
    }
  }
  return failures;
}

using Fused = std::map<std::string, int>;

/// Multiply-adds by the names of a model's functions, counted in the same text.
Fused fused_of(const Robot& robot, const Places& places) {
  Fused result;
  const support::Outcome outcome = support::run_checked(joined(
      joined({places.treedyn, "info"}, robot.arguments), {"--effort", kEffort, "-q", "--json"}));
  const nlohmann::json info = nlohmann::json::parse(outcome.out);
  for (const nlohmann::json& function : info.at("functions")) {
    result[function.at("name")] = function.at("fused");
  }
  return result;
}

/// What the table of `treedyn accuracy` is compared with: functions without rows to solve.
/// \param fused  where they are compiled with contraction
void add_counted(const Robot& robot, const std::string& core, const support::Manifest& manifest,
                 const Fused* fused, const std::function<long(const std::string&)>& instructions,
                 Counts& counts) {
  for (const support::FunctionInfo& function : manifest.functions) {
    if (!function.status) {
      const auto& o = function.operations;
      program::Cost cost;
      cost.add = static_cast<int>(o[0]);
      cost.mul = static_cast<int>(o[1]);
      cost.div = static_cast<int>(o[2]);
      cost.sqrt = static_cast<int>(o[3]);
      cost.sin = static_cast<int>(o[4]);
      cost.cos = static_cast<int>(o[5]);
      cost.angles = std::max(cost.sin, cost.cos);
      cost.fused = fused == nullptr ? 0 : fused->at(function.name);
      counts.push_back({core, robot.is_float, fmt::format("{} {}", robot.name, function.name), cost,
                        instructions(function.name), fused != nullptr});
    }
  }
}

int measure(const Robot& robot, const Places& places, Budgets& budgets, Counts& counts) {
  const support::TemporaryFolder folder;
  const fs::path& work = folder.path();
  fs::current_path(places.models);
  const Words functions = robot.functions.empty() ? Words{} : Words{"--functions", robot.functions};
  support::run_checked(
      joined(joined({places.treedyn, "generate"}, joined(robot.arguments, functions)),
             {"--scalar", robot.is_float ? "float" : "double", "--name", "generated", "--sincos",
              "pair", "--effort", kEffort, "-q", "-o", work}));
  const support::Manifest manifest = support::read_manifest(work / "generated.json");
  support::write_file(work / "calls.cpp", calls_text(manifest));
  const Lines host = on_the_host(robot, places, work);
  if (!is_there("valgrind")) {
    fmt::print("valgrind is not installed: nothing was counted on the host\n");
  } else {
    add_counted(
        robot, "host", manifest, nullptr,
        [&](const std::string& name) { return on_the_host(work, name); }, counts);
  }
  int failures = host.empty() ? 1 : 0;
  const Fused fused = robot.is_model() ? fused_of(robot, places) : Fused{};
  for (const Core& core : kCores) {
    for (const char* optimisation : {"-Os", "-O2"}) {
      long flash = 0;
      const Lines lines = on_a_core(robot, places, work, core, optimisation, kExact, &flash);
      const std::string place = fmt::format("{},{},{}", robot.name, core.name, optimisation + 1);
      failures += compare(place, host, lines, flash, budgets);
      if (optimisation == std::string("-O2")) {
        add_counted(
            robot, core.name, manifest, nullptr,
            [&](const std::string& name) {
              return budgets[fmt::format("{},{}", place, name)].instructions;
            },
            counts);
      }
    }
    if (!fused.empty() && (robot.is_float ? core.fuses_float : core.fuses_double)) {
      long flash = 0;
      const Lines lines = on_a_core(robot, places, work, core, "-O2", kContracted, &flash);
      add_counted(
          robot, core.name, manifest, &fused,
          [&](const std::string& name) {
            const auto line = lines.find(name);
            if (line == lines.end()) {
              throw std::runtime_error(
                  fmt::format("{}, {}, contracted: {} did not end", robot.name, core.name, name));
            }
            return std::atol(line->second[1].c_str());
          },
          counts);
    }
  }
  return failures;
}

int run(const Places& places, const std::string& path, bool update) {
  for (const char* program : {"arm-none-eabi-gcc", "qemu-system-arm"}) {
    if (!is_there(program)) {
      fmt::print("{} is not installed: nothing was measured\n", program);
      return 77;
    }
  }
  Budgets budgets;
  int failures = 0;
  Counts counts;
  for (const Robot& robot : robots()) {
    failures += measure(robot, places, budgets, counts);
  }
  failures += off_the_table(counts);
  if (update) {
    support::write_file(path, budgets_text(budgets));
  } else {
    failures += exceeded(budgets, read_budgets(path));
  }
  fmt::print("{} functions on {} processors, twice each: {} failures\n",
             budgets.size() / kCores.size() / 2, kCores.size(), failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const Words words(argv, argv + argc);
  if (words.size() < 5) {
    fmt::print("usage: firmware TREEDYN MODELS SOURCES BUDGETS [--update]\n");
    return 2;
  }
  try {
    return run({words[1], words[2], words[3]}, words[4],
               words.size() > 5 && words[5] == "--update");
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
    return 1;
  }
}
