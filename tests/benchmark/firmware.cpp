// benchmark_cortex TREEDYN MODELS SOURCES -o DIR: generated code on a Cortex-M4F, of the biped and
// the quadruped of the folder MODELS; both also with late sines and with shared code of the limbs.
//
// Float, arm-none-eabi-g++ -Os without contraction, and other ways to compile: instructions that
// one call executes (counted by qemu-system-arm) and their cycles by a table, bytes of flash and of
// stack.
// SOURCES is the folder firmware/. Writes firmware.md.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "benchmark/object_file.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

const std::string kTool = "arm-none-eabi-";
const std::vector<std::string> kCompile{
    kTool + "g++",       "-std=c++17",        "-Os",
    "-mcpu=cortex-m4",   "-mthumb",           "-mfloat-abi=hard",
    "-mfpu=fpv4-sp-d16", "-fno-exceptions",   "-fno-rtti",
    "-fno-math-errno",   "-ffp-contract=off", "-ffunction-sections"};

/// In place of -Os and of what is off: other ways to compile the same text.
struct Way {
  const char* name;
  std::vector<std::string> flags;
};
const std::vector<Way> kWays = {
    {"-Os -ffp-contract=fast", {"-ffp-contract=fast"}},
    {"-O2", {"-O2"}},
    {"-O2 -fno-schedule-insns", {"-O2", "-fno-schedule-insns"}},
};

struct Function {
  const char* name;
  const char* arguments;
  const char* target;  ///< instructions, cycles and kB of flash, tests/benchmark/README.md
};
constexpr Function kFunctions[] = {
    {"mass_matrix", "(q, out)", "2200 / 3300 / 7.3"},
    {"bias_force", "(q, qd, out)", ""},
    {"gravity_force", "(q, out)", ""},
    {"inverse_dynamics", "(q, qd, x, out)", "2420 / 3750 / 7.9"},
    {"forward_dynamics", "(q, qd, x, out)", ""},
};

/// Cycles of an instruction on a Cortex-M4F, after ARM's technical reference manual: loads, stores
/// and moves between the register files of one word 2 or 1, of more words one each and 1, fused
/// products 3, quotients and roots 14, jumps 3; the rest 1.
long cycles_of(const std::string& instruction, const std::string& operands) {
  const auto is = [&](const char* begin) {
    return instruction.rfind(begin, 0) == 0;
  };
  if (is("vdiv") || is("vsqrt")) {
    return 14;
  }
  if (is("vfma") || is("vfms") || is("vfnma") || is("vfnms") || is("vmla") || is("vmls")) {
    return 3;
  }
  if (is("push") || is("pop") || is("vpush") || is("vpop") || is("vldm") || is("vstm") ||
      is("ldm") || is("stm")) {
    long words = 1 + std::count(operands.begin(), operands.end(), ',');
    if (const std::size_t dash = operands.find('-'); dash != std::string::npos) {
      const auto number = [&](std::size_t at) {
        return std::atol(operands.c_str() + operands.find_first_of("0123456789", at));
      };
      words = number(dash) - number(operands.find('{')) + 1;
    }
    return words + 1;
  }
  if (is("ldrd") || is("strd")) {
    return 3;
  }
  if (is("vldr") || is("vstr") || is("ldr") || is("str")) {
    return 2;
  }
  if (instruction == "b" || instruction == "b.n" || instruction == "b.w" || is("bl") || is("bx")) {
    return 3;
  }
  return 1;
}

std::vector<std::string> compile(const std::vector<std::string>& more) {
  std::vector<std::string> command = kCompile;
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

/// What a program executes.
struct Executed {
  long instructions = 0;
  long cycles = 0;  ///< by `cycles_of`
};

/// Cycles by address of the instructions of an image.
std::map<long, long> cycles_by_address(const fs::path& image) {
  std::map<long, long> result;
  std::istringstream lines(
      support::run_checked({kTool + "objdump", "-d", "--no-show-raw-insn", image}).out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string address;
    std::string instruction;
    std::string operands;
    words >> address >> instruction;
    std::getline(words, operands);
    if (address.size() > 1 && address.back() == ':') {
      result[std::strtol(address.c_str(), nullptr, 16)] = cycles_of(instruction, operands);
    }
  }
  return result;
}

/// Of an image with `calls` calls: one line of the emulator's log for each instruction.
Executed executed(const Function& function, int calls, const fs::path& sources,
                  const fs::path& work) {
  const std::string image = work / "image.elf";
  const std::string log = work / "log";
  support::run_checked(
      compile({fmt::format("-DCALLS={}", calls), fmt::format("-DFUNCTION={}", function.name),
               fmt::format("-DARGUMENTS={}", function.arguments), "-I", work.string(),
               sources / "image.cpp", work / "generated.o", "-T", sources / "image.ld",
               "-nostartfiles", "--specs=nosys.specs", "-o", image}));
  support::run_checked({"qemu-system-arm", "-M", "mps2-an386", "-display", "none", "-monitor",
                        "none", "-serial", "none", "-semihosting-config", "enable=on,target=native",
                        "-singlestep", "-d", "exec,nochain", "-D", log, "-kernel", image});
  const std::map<long, long> cycles = cycles_by_address(image);
  std::istringstream lines(support::read_file(log));
  Executed result;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("Trace", 0) != 0) {
      continue;
    }
    ++result.instructions;
    const std::size_t slash = line.find('/', line.find('['));
    const auto found = cycles.find(std::strtol(line.c_str() + slash + 1, nullptr, 16));
    result.cycles += found == cycles.end() ? 1 : found->second;
  }
  return result;
}

/// What compiled code costs on the microcontroller.
struct Compiled {
  Executed call;
  long flash = 0;
  long stack = 0;

  /// Instructions, cycles and bytes of flash.
  [[nodiscard]] std::string text() const {
    return fmt::format("{} / {} / {}", call.instructions, call.cycles, flash);
  }
};

struct Figures {
  long operations = 0;
  Compiled plain;
  std::vector<Compiled> others;  ///< by kWays
};

/// Where things are.
struct Places {
  std::string treedyn;
  fs::path models;
  fs::path sources;
};

Figures measured(const Function& function, const Places& places, const std::string& model,
                 const std::vector<std::string>& options, const std::vector<Way>& ways) {
  const support::TemporaryFolder folder;
  const fs::path& work = folder.path();
  std::vector<std::string> command{places.treedyn, "generate", places.models / (model + ".yaml")};
  command.insert(command.end(), {"--base", "axes", "--scalar", "float", "--name", "generated",
                                 "--functions", function.name, "-q", "-o", work});
  command.insert(command.end(), options.begin(), options.end());
  support::run_checked(command);
  const fs::path object = work / "generated.o";
  const auto compiled = [&](const std::vector<std::string>& more) {
    std::vector<std::string> flags{"-fstack-usage", "-c", work / "generated.cpp", "-o", object};
    flags.insert(flags.end(), more.begin(), more.end());
    support::run_checked(compile(flags));
    const Executed once = executed(function, 1, places.sources, work);
    const Executed twice = executed(function, 2, places.sources, work);
    return Compiled{{twice.instructions - once.instructions, twice.cycles - once.cycles},
                    flash_bytes(kTool + "size", object),
                    stack_bytes(work / "generated.su")};
  };
  const auto cost = support::read_manifest(work / "generated.json").functions.front().operations;
  Figures result{cost[0] + cost[1] + cost[2], compiled({}), {}};
  for (const Way& way : ways) {
    result.others.push_back(compiled(way.flags));
  }
  return result;
}

using AllFigures = std::vector<Figures>;

AllFigures all_figures(const Places& places, const std::string& model,
                       const std::vector<std::string>& options, const std::vector<Way>& ways = {}) {
  AllFigures result;
  for (const Function& function : kFunctions) {
    result.push_back(measured(function, places, model, options, ways));
  }
  return result;
}

std::string table(const AllFigures& figures) {
  std::string text = "| function | operations | instructions, cycles, bytes of flash | target |";
  std::string line = "\n|---|---|---|---|";
  for (const Way& way : kWays) {
    text += fmt::format(" with {} |", way.name);
    line += "---|";
  }
  text += " stack, bytes |" + line + "---|\n";
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const Figures& f = figures[k];
    text += fmt::format("| {} | {} | {} | {} |", kFunctions[k].name, f.operations, f.plain.text(),
                        kFunctions[k].target);
    for (const Compiled& other : f.others) {
      text += fmt::format(" {} |", other.text());
    }
    text += fmt::format(" {} |\n", f.plain.stack);
  }
  return text;
}

/// a / b (+10 %)
std::string pair(long a, long b) {
  const double change = 100.0 * static_cast<double>(b - a) / static_cast<double>(a);
  return fmt::format("{} / {} ({:+.0f} %)", a, b, change);
}

/// Cycles, flash and stack without / with the option.
std::string comparison(const Places& places, const std::string& option, const AllFigures& biped,
                       const AllFigures& quadruped) {
  std::string text = fmt::format(
      "\nThe same without / with `{}`.\n\n"
      "| robot | function | operations | flash, bytes | cycles | stack, bytes |\n"
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
      text +=
          fmt::format("| {} | {} | {} | {} | {} | {} / {} |\n", model, kFunctions[k].name,
                      pair(a.operations, b.operations), pair(a.plain.flash, b.plain.flash),
                      pair(a.plain.call.cycles, b.plain.call.cycles), a.plain.stack, b.plain.stack);
    }
  }
  return text;
}

void run(const Places& places, const fs::path& output) {
  const AllFigures packed = all_figures(places, "biped", {"--layout", "packed"}, kWays);
  const AllFigures biped = all_figures(places, "biped", {});
  const AllFigures quadruped = all_figures(places, "quadruped", {});
  std::string text =
      "biped.yaml `--base axes --scalar float --layout packed` on a Cortex-M4F, arm-none-eabi-g++ "
      "-Os -ffp-contract=off; executed instructions counted by qemu, cycles of each by a table "
      "after ARM's manual "
      "(loads and stores 2, fused products 3, jumps 3). Targets: instructions, cycles, kB of "
      "flash.\n\n" +
      table(packed);
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
