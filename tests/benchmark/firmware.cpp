// benchmark_cortex TREEDYN MODEL SOURCES -o DIR: generated code on a Cortex-M4F.
//
// Float, builtin sine and cosine, arm-none-eabi-g++ -O2: instructions in the code, instructions
// that one call executes (counted by qemu-system-arm), bytes of flash and of stack. SOURCES is the
// folder firmware/. Writes firmware.md.
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

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

struct Function {
  const char* name;
  const char* arguments;
  const char* limit;  ///< instructions a call, PERFORMANCE.md 6, of the biped on axes
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

std::string row(const Function& function, const std::string& treedyn, const fs::path& model,
                const fs::path& sources) {
  const support::TemporaryFolder folder;
  const fs::path& work = folder.path();
  checked({treedyn, "generate", model.string(), "--base", "axes", "--scalar", "float", "--sincos",
           "builtin", "--name", "generated", "--functions", function.name, "-o", work.string()});
  const fs::path object = work / "generated.o";
  checked(compile({"-fstack-usage", "-c", work / "generated.cpp", "-o", object.string()}));
  const auto cost = support::read_manifest(work / "generated.json").functions.front().operations;
  const long once = executed(function, 1, sources, work);
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", function.name,
                     cost[0] + cost[1] + cost[2], instructions(kTool + "objdump", object),
                     executed(function, 2, sources, work) - once, function.limit,
                     code_bytes(kTool + "size", object), stack_bytes(work / "generated.su"));
}

void run(const std::string& treedyn, const fs::path& model, const fs::path& sources,
         const fs::path& output) {
  std::string text = fmt::format(
      "{} `--base axes --scalar float --sincos builtin` on a Cortex-M4F, arm-none-eabi-g++ -O2; "
      "executed instructions counted by qemu.\n\n"
      "| function | operations | instructions in the code | executed by a call | target | flash, "
      "bytes | stack, bytes |\n|---|---|---|---|---|---|---|\n",
      model.filename().string());
  for (const Function& function : kFunctions) {
    text += row(function, treedyn, model, sources);
  }
  fs::create_directories(output);
  support::write_file(output / "firmware.md", text);
  std::cout << text;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() != 5 || words[3] != "-o") {
    std::cerr << "usage: benchmark_cortex TREEDYN MODEL SOURCES -o DIR\n";
    return 2;
  }
  try {
    treedyn::benchmark::run(words[0], words[1], words[2], words[4]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
