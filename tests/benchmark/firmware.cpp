// benchmark_cortex TREEDYN MODELS SOURCES -o DIR: generated code on a Cortex-M4F, of the biped and
// the quadruped of the folder MODELS; both also with late sines and with shared code of the limbs.
//
// Float, builtin sine and cosine, arm-none-eabi-g++ -O2: instructions in the code, instructions
// that one call executes (counted by qemu-system-arm), bytes of flash and of stack. SOURCES is the
// folder firmware/. Writes firmware.md.
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "benchmark/object_file.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

const std::string kTool = "arm-none-eabi-";
const std::vector<std::string> kCompile{kTool + "g++",
                                        "-std=c++17",
                                        "-O2",
                                        "-mcpu=cortex-m4",
                                        "-mthumb",
                                        "-mfloat-abi=hard",
                                        "-mfpu=fpv4-sp-d16",
                                        "-fno-exceptions",
                                        "-fno-rtti",
                                        "-fno-math-errno",
                                        "-ffunction-sections"};

/// Without gcc's scheduling before register allocation, which keeps more values alive than the 32
/// registers hold.
constexpr const char* kUnscheduled = "-fno-schedule-insns";

struct Function {
  const char* name;
  const char* arguments;
  const char* limit;  ///< instructions a call, tests/benchmark/README.md, of the biped on axes
};
constexpr Function kFunctions[] = {
    {"mass_matrix", "(q, out)", "1500"},         {"bias_force", "(q, qd, out)", ""},
    {"gravity_force", "(q, out)", ""},           {"inverse_dynamics", "(q, qd, x, out)", "2200"},
    {"forward_dynamics", "(q, qd, x, out)", ""},
};

support::Outcome checked(const std::vector<std::string>& command) {
  support::Outcome outcome = support::run(command);
  if (outcome.status != 0) {
    throw std::runtime_error(fmt::format("{}: {}", command.front(), outcome.err));
  }
  return outcome;
}

std::vector<std::string> compile(const std::vector<std::string>& more) {
  std::vector<std::string> command = kCompile;
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

/// Instructions that an image with `calls` calls executes: one line of the emulator's log each.
long executed(const Function& function, int calls, const fs::path& sources, const fs::path& work) {
  const std::string image = work / "image.elf";
  const std::string log = work / "log";
  checked(compile({fmt::format("-DCALLS={}", calls), fmt::format("-DFUNCTION={}", function.name),
                   fmt::format("-DARGUMENTS={}", function.arguments), "-I", work.string(),
                   sources / "image.cpp", work / "generated.o", "-T", sources / "image.ld",
                   "-nostartfiles", "--specs=nosys.specs", "-o", image}));
  checked({"qemu-system-arm", "-M", "mps2-an386", "-display", "none", "-monitor", "none", "-serial",
           "none", "-semihosting-config", "enable=on,target=native", "-singlestep", "-d",
           "exec,nochain", "-D", log, "-kernel", image});
  std::istringstream lines(support::read_file(log));
  long count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.rfind("Trace", 0) == 0 ? 1 : 0;
  }
  return count;
}

/// What a function costs on the microcontroller.
struct Figures {
  long operations = 0;
  long instructions = 0;
  long executed = 0;
  long unscheduled = 0;  ///< executed, compiled with kUnscheduled
  long flash = 0;
  long stack = 0;
};

/// Where things are.
struct Places {
  std::string treedyn;
  fs::path models;
  fs::path sources;
};

Figures measured(const Function& function, const Places& places, const std::string& model,
                 const std::vector<std::string>& options) {
  const support::TemporaryFolder folder;
  const fs::path& work = folder.path();
  std::vector<std::string> command{places.treedyn, "generate", places.models / (model + ".yaml")};
  command.insert(command.end(),
                 {"--base", "axes", "--scalar", "float", "--sincos", "builtin", "--name",
                  "generated", "--functions", function.name, "-q", "-o", work});
  command.insert(command.end(), options.begin(), options.end());
  checked(command);
  const fs::path object = work / "generated.o";
  const auto build = [&](const std::vector<std::string>& more) {
    std::vector<std::string> flags{"-fstack-usage", "-c", work / "generated.cpp", "-o", object};
    flags.insert(flags.end(), more.begin(), more.end());
    checked(compile(flags));
  };
  const auto of_a_call = [&] {
    const long once = executed(function, 1, places.sources, work);
    return executed(function, 2, places.sources, work) - once;
  };
  const auto cost = support::read_manifest(work / "generated.json").functions.front().operations;
  build({kUnscheduled});
  const long unscheduled = of_a_call();
  build({});
  return {cost[0] + cost[1] + cost[2],
          instructions(kTool + "objdump", object),
          of_a_call(),
          unscheduled,
          flash_bytes(kTool + "size", object),
          stack_bytes(work / "generated.su")};
}

using AllFigures = std::vector<Figures>;

AllFigures all_figures(const Places& places, const std::string& model,
                       const std::vector<std::string>& options) {
  AllFigures result;
  for (const Function& function : kFunctions) {
    result.push_back(measured(function, places, model, options));
  }
  return result;
}

std::string table(const AllFigures& figures) {
  std::string text = fmt::format(
      "| function | operations | instructions in the code | executed by a call | with {} | target "
      "| "
      "flash, bytes | stack, bytes |\n|---|---|---|---|---|---|---|---|\n",
      kUnscheduled);
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const Figures& f = figures[k];
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", kFunctions[k].name,
                        f.operations, f.instructions, f.executed, f.unscheduled,
                        kFunctions[k].limit, f.flash, f.stack);
  }
  return text;
}

/// a / b (+10 %)
std::string pair(long a, long b) {
  const double change = 100.0 * static_cast<double>(b - a) / static_cast<double>(a);
  return fmt::format("{} / {} ({:+.0f} %)", a, b, change);
}

/// Time, flash and stack without / with the option.
std::string comparison(const Places& places, const std::string& option, const AllFigures& biped,
                       const AllFigures& quadruped) {
  std::string text = fmt::format(
      "\nThe same without / with `{}`.\n\n"
      "| robot | function | operations | flash, bytes | executed by a call | stack, bytes |\n"
      "|---|---|---|---|---|---|\n",
      option);
  for (const auto& [model, own] :
       {std::pair("biped", &biped), std::pair("quadruped", &quadruped)}) {
    std::istringstream words(option);
    const std::vector<std::string> more{std::istream_iterator<std::string>(words), {}};
    const AllFigures with = all_figures(places, model, more);
    for (std::size_t k = 0; k < own->size(); ++k) {
      const Figures& a = (*own)[k];
      const Figures& b = with[k];
      text += fmt::format("| {} | {} | {} | {} | {} | {} / {} |\n", model, kFunctions[k].name,
                          pair(a.operations, b.operations), pair(a.flash, b.flash),
                          pair(a.executed, b.executed), a.stack, b.stack);
    }
  }
  return text;
}

void run(const Places& places, const fs::path& output) {
  const AllFigures biped = all_figures(places, "biped", {});
  const AllFigures quadruped = all_figures(places, "quadruped", {});
  std::string text =
      "biped.yaml `--base axes --scalar float --sincos builtin` on a Cortex-M4F, arm-none-eabi-g++ "
      "-O2; executed instructions counted by qemu.\n\n" +
      table(biped);
  for (const char* option : {"--trig late", "--layout packed --trig late", "--share-limbs"}) {
    text += comparison(places, option, biped, quadruped);
  }
  fs::create_directories(output);
  support::write_file(output / "firmware.md", text);
  std::cout << text;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(argc, argv, "benchmark_cortex", {"TREEDYN", "MODELS", "SOURCES", "-o", "DIR"},
                     [](const Words& words) {
                       run({words[0], words[1], words[2]}, words[4]);
                     });
}
