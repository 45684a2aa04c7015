// benchmark_growth TREEDYN COMPILER LARGEST -o DIR: what generated code costs as a robot grows.
//
// For chains and binary trees of 4, 8, .. LARGEST links: processor seconds to generate (--effort 0)
// and to compile, bytes of code and of stack of mass_matrix, bias_force, inverse_dynamics and
// forward_dynamics.
// Writes growth.md and growth.svg.
#include <sys/resource.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "benchmark/growing.hpp"
#include "benchmark/lines.hpp"
#include "benchmark/object_file.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSeconds = "300";  ///< of wall time after which the compiler is stopped
const std::vector<std::string> kOptions{"-std=c++17", "-O2"};

struct Tools {
  std::string treedyn;
  std::string compiler;
};

struct Row {
  std::string shape;
  int size = 0;
  std::string function;
  long operations = 0;
  double generation = 0;   ///< s
  double compilation = 0;  ///< s; negative: stopped
  long code = 0;           ///< bytes
  long stack = 0;          ///< bytes
};

/// Processor time of all programs that were run, s.
double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Processor time of a program; negative if it was stopped.
double seconds_of(const std::vector<std::string>& command) {
  const double start = seconds_of_children();
  const support::Outcome outcome = support::run(command);
  constexpr int kStopped = 124;  // of timeout
  if (outcome.status != 0 && outcome.status != kStopped) {
    throw std::runtime_error(fmt::format("{}: {}", command.front(), outcome.err));
  }
  return outcome.status == 0 ? seconds_of_children() - start : -1;
}

Row measure(const Tools& tools, bool chain, int size, const std::string& function) {
  const support::TemporaryFolder folder;
  const fs::path model = folder.path() / "robot.yaml";
  support::write_file(model, growing_robot(chain, size));
  Row row{chain ? "chain" : "binary tree", size, function};
  row.generation = seconds_of({tools.treedyn, "generate", model.string(), "--effort", "0",
                               "--functions", function, "-o", folder.path().string()});
  const auto count = support::read_manifest(folder.path() / "robot.json").functions.front();
  row.operations = count.operations[0] + count.operations[1] + count.operations[2];
  std::vector<std::string> command{"timeout", kSeconds, tools.compiler};
  command.insert(command.end(), kOptions.begin(), kOptions.end());
  const fs::path object = folder.path() / "robot.o";
  command.insert(command.end(), {"-fstack-usage", "-c", (folder.path() / "robot.cpp").string(),
                                 "-o", object.string()});
  row.compilation = seconds_of(command);
  if (row.compilation >= 0) {
    row.code = code_bytes("size", object);
    row.stack = stack_bytes(folder.path() / "robot.su");
  }
  return row;
}

std::string markdown(const std::vector<Row>& rows) {
  std::string text =
      "| robot | N | function | operations | generate, s | compile, s | code, bytes | stack, bytes "
      "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    text += fmt::format("| {} | {} | {} | {} | {:.2f} |", row.shape, row.size, row.function,
                        row.operations, row.generation);
    text += row.compilation < 0
                ? " stopped | | |\n"
                : fmt::format(" {:.2f} | {} | {} |\n", row.compilation, row.code, row.stack);
  }
  return text;
}

/// One panel a quantity, one line a function and shape.
std::string svg(const std::vector<Row>& rows) {
  const std::pair<const char*, double (*)(const Row&)> quantities[] = {
      {"generate, s",
       [](const Row& row) {
         return row.generation;
       }},
      {"compile, s",
       [](const Row& row) {
         return row.compilation;
       }},
      {"code, bytes",
       [](const Row& row) {
         return static_cast<double>(row.code);
       }},
      {"stack, bytes", [](const Row& row) {
         return static_cast<double>(row.stack);
       }}};
  std::vector<Panel> panels;
  for (const auto& [title, value] : quantities) {
    Panel panel{title, {}};
    for (const Row& row : rows) {
      const std::string name = row.shape + ", " + row.function;
      if (panel.lines.empty() || panel.lines.back().name != name) {
        panel.lines.push_back({name, {}});
      }
      if (value(row) > 0) {
        panel.lines.back().points.emplace_back(row.size, value(row));
      }
    }
    panels.push_back(panel);
  }
  return line_chart("N", panels);
}

void run(const Tools& tools, int largest, const fs::path& output) {
  std::vector<Row> rows;
  for (const bool chain : {true, false}) {
    for (const char* function :
         {"mass_matrix", "bias_force", "inverse_dynamics", "forward_dynamics"}) {
      for (int size = 4; size <= largest; size *= 2) {
        rows.push_back(measure(tools, chain, size, function));
        std::cerr << rows.back().shape << ' ' << size << ' ' << function << '\n';
      }
    }
  }
  const std::string text = fmt::format(
      "Processor seconds on one machine; `--effort 0`, {} {} {}, stopped after {} s.\n\n{}",
      fs::path(tools.compiler).filename().string(), kOptions[0], kOptions[1], kSeconds,
      markdown(rows));
  fs::create_directories(output);
  support::write_file(output / "growth.md", text);
  support::write_file(output / "growth.svg", svg(rows));
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(argc, argv, "benchmark_growing",
                     {"TREEDYN", "COMPILER", "LARGEST", "-o", "DIR"}, [](const Words& words) {
                       run({words[0], words[1]}, std::stoi(words[2]), words[4]);
                     });
}
