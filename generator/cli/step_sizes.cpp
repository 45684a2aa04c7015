#include "cli/step_sizes.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "common/error.hpp"
#include "emit/definitions.hpp"
#include "system/compiler.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

using Words = std::vector<std::string>;
using Frames = std::map<std::string, long>;

const std::string kTool = "arm-none-eabi-";

/// All that generated code takes from <cmath>: libstdc++ is not needed.
constexpr const char* kMath =
    "#pragma once\n"
    "namespace std {\n"
    "inline float sqrt(float x) { return __builtin_sqrtf(x); }\n"
    "inline double sqrt(double x) { return __builtin_sqrt(x); }\n"
    "inline float sin(float x) { return __builtin_sinf(x); }\n"
    "inline double sin(double x) { return __builtin_sin(x); }\n"
    "inline float cos(float x) { return __builtin_cosf(x); }\n"
    "inline double cos(double x) { return __builtin_cos(x); }\n"
    "inline float pow(float x, float y) { return __builtin_powf(x, y); }\n"
    "inline double pow(double x, double y) { return __builtin_pow(x, y); }\n"
    "}\n";

/// Bytes of registers in "{r4, r5, lr}" or "{d8-d9}".
long pushed(const std::string& registers) {
  static const std::regex one("([rsdlipcf][0-9a-z]*)(?:-([rsd])([0-9]+))?");
  long bytes = 0;
  for (std::sregex_iterator at(registers.begin(), registers.end(), one), end; at != end; ++at) {
    const std::string first = (*at)[1];
    const long count = (*at)[3].matched ? std::stol((*at)[3]) - std::stol(first.substr(1)) + 1 : 1;
    bytes += count * (first[0] == 'd' ? 8 : 4);
  }
  return bytes;
}

/// Bytes by which an instruction lowers the stack pointer.
long lowered(const std::string& instruction) {
  static const std::regex push("(?:v?push|v?stmdb)(?:\\.w)?\t(?:sp!, )?\\{(.*)\\}.*");
  static const std::regex store("str.*\\[sp, #-([0-9]+)\\]!.*");
  static const std::regex subtract("sub.*\tsp,(?: sp,)? #([0-9]+).*");
  std::smatch match;
  if (std::regex_match(instruction, match, push)) {
    return pushed(match[1]);
  }
  if (std::regex_match(instruction, match, store) ||
      std::regex_match(instruction, match, subtract)) {
    return std::stol(match[1]);
  }
  return 0;
}

/// Who calls whom in a linked program, and what functions push.
struct Calls {
  std::map<std::string, std::set<std::string>> of;
  Frames pushes;
};

/// \param text  what objdump -d prints
Calls calls_in(const std::string& text) {
  static const std::regex head("[0-9a-f]+ <(.*)>:");
  static const std::regex branch("(?:b|bl|blx|cb)[a-z]*(?:\\.[nw])?\t.*<([^+>]*)(?:\\+.*)?>.*");
  static const std::regex leaves("(?:b(?:\\.[nw])?\t|bx\t|pop.*pc|ldmia.*pc|ldr.*\tpc).*");
  Calls result;
  std::string now;
  bool falls = false;
  std::smatch match;
  for (const std::string& line : emit::lines_of(text)) {
    if (std::regex_match(line, match, head)) {
      if (falls) {
        result.of[now].insert(match[1]);
      }
      now = match[1];
      result.of[now];
      falls = true;
      continue;
    }
    const std::size_t code = line.find('\t', line.find('\t') + 1);
    if (now.empty() || code == std::string::npos || line.find("\t.word") != std::string::npos) {
      continue;
    }
    const std::string instruction = line.substr(code + 1);
    falls = !std::regex_match(instruction, leaves);
    result.pushes[now] += lowered(instruction);
    if (std::regex_match(instruction, match, branch) && match[1] != now) {
      result.of[now].insert(match[1]);
    }
    if (instruction.rfind("blx\tr", 0) == 0) {
      throw InputError({}, fmt::format("the stack of '{}' is not known: it calls by address; "
                                       "expected another core, or no --stack",
                                       now));
    }
  }
  return result;
}

/// What the compiler tells of its frames: of a function by its symbol.
Frames frames_in(const std::string& text) {
  static const std::regex node("node: \\{ title: \"([^\"]*)\".*\\\\n([0-9]+) bytes \\(.*");
  Frames result;
  std::smatch match;
  for (const std::string& line : emit::lines_of(text)) {
    if (std::regex_match(line, match, node)) {
      const std::string title = match[1];
      result[title.substr(title.rfind(':') + 1)] = std::stol(match[2]);
    }
  }
  return result;
}

/// The deepest way from a function on, bytes; code without recursion.
long depth(const std::string& function, const Calls& calls, const Frames& frames,
           std::set<std::string>& open) {
  if (!open.insert(function).second) {
    return 0;
  }
  long below = 0;
  const auto callees = calls.of.find(function);
  if (callees != calls.of.end()) {
    for (const std::string& callee : callees->second) {
      below = std::max(below, depth(callee, calls, frames, open));
    }
  }
  open.erase(function);
  const auto frame = frames.find(function);
  const auto pushes = calls.pushes.find(function);
  return below + (frame != frames.end()          ? frame->second
                  : pushes != calls.pushes.end() ? pushes->second
                                                 : 0);
}

std::string contents(const std::string& path) { return read_file(path).value_or(""); }

/// Where the compiler and its tools work.
struct Workshop : TemporaryFolder {
  /// What a program prints. \throws InputError if it fails
  [[nodiscard]] std::string output(Words words) const {
    const std::string name = words.front();
    if (!succeeds(std::move(words), file("log"))) {
      throw InputError({}, fmt::format("--flash, --stack: {} fails on the generated step; expected "
                                       "Debian's arm-none-eabi compiler with newlib",
                                       name));
    }
    return contents(file("log"));
  }
};

/// Compiles and links the step alone. \return the symbol of `step`
std::string build(const Workshop& workshop, const StepFiles& files, const accuracy::Core& core) {
  std::vector<OutputFile> sources = {{workshop.file("cmath"), kMath}};
  for (const emit::File& file : files.files) {
    sources.push_back({workshop.file(file.name), file.text});
  }
  write_files(sources);
  Words common = {kTool + "g++", "-mthumb"};
  common.insert(common.end(), core.options.begin(), core.options.end());
  Words compile = common;
  compile.insert(
      compile.end(),
      {"-std=c++11", "-Os", "-ffp-contract=off", "-fno-math-errno", "-fno-exceptions", "-fno-rtti",
       "-ffunction-sections", "-fcallgraph-info=su", "-I" + workshop.file(""), "-c",
       workshop.file(files.name + ".cpp"), "-o", workshop.file("step.o")});
  static_cast<void>(workshop.output(compile));
  const Words nm = {kTool + "nm", "--defined-only", workshop.file("step.o")};
  std::string step;
  for (const std::string& line : emit::lines_of(workshop.output(nm))) {
    if (line.find("4stepE") != std::string::npos && line.find(" T ") != std::string::npos) {
      step = line.substr(line.rfind(' ') + 1);
    }
  }
  Words link = common;
  link.insert(link.end(),
              {"-nostdlib", "-Wl,--gc-sections", "-Wl,-e," + step, workshop.file("step.o"), "-lm",
               "-lc", "-lgcc", "-o", workshop.file("step.elf")});
  static_cast<void>(workshop.output(link));
  return step;
}

}  // namespace

void require_cross_compiler() {
  const TemporaryFolder folder;
  if (!succeeds({kTool + "g++", "--version"}, folder.file("log"))) {
    throw InputError({},
                     "--flash, --stack, --sizes: no arm-none-eabi-g++ on PATH, so nothing can "
                     "be measured; expected Debian's gcc-arm-none-eabi");
  }
}

accuracy::Size step_size(const StepFiles& files, const accuracy::Core& core) {
  const Workshop workshop;
  const std::string step = build(workshop, files, core);
  accuracy::Size result;
  std::istringstream sizes(workshop.output({kTool + "size", workshop.file("step.elf")}));
  std::string head;
  std::getline(sizes, head);
  long text = 0;
  long data = 0;
  sizes >> text >> data;
  result.flash = text + data;
  const Calls calls =
      calls_in(workshop.output({kTool + "objdump", "-d", workshop.file("step.elf")}));
  std::set<std::string> open;
  result.stack = depth(step, calls, frames_in(contents(workshop.file("step.ci"))), open);
  return result;
}

}  // namespace treedyn
