// benchmark_generating TREEDYN[,TREEDYN...] MODELS URDF ROUNDS -o DIR: what `generate` itself
// costs.
//
// Robots of the folders MODELS and URDF with default options, all functions; long chains with
// forward dynamics alone, `--effort 0`. Least processor and wall seconds of all rounds and the
// largest memory; of several programs in turn, each with its own columns. Writes generation.md.
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "benchmark/growing.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

struct Row {
  std::string name;
  fs::path model;
  std::vector<std::string> options;
};

std::vector<Row> rows(const fs::path& models, const fs::path& urdf, const fs::path& chains) {
  std::vector<Row> result{
      {"UR5", urdf / "ur5_robot.urdf", {}},
      {"PUMA 560", models / "puma560.yaml", {}},
      {"HyQ, fixed", urdf / "hyq_no_sensors.urdf", {}},
      {"HyQ, axes", urdf / "hyq_no_sensors.urdf", {"--base", "axes"}},
      {"humanoid, axes", urdf / "simple_humanoid.urdf", {"--base", "axes"}},
      {"biped, axes", models / "biped.yaml", {"--base", "axes"}},
  };
  for (const int size : {64, 128}) {
    const fs::path model = chains / fmt::format("chain{}.yaml", size);
    support::write_file(model, growing_robot(true, size));
    result.push_back({fmt::format("chain of {}: `--functions forward_dynamics --effort 0`", size),
                      model,
                      {"--functions", "forward_dynamics", "--effort", "0"}});
  }
  return result;
}

struct Cost {
  double processor = HUGE_VAL;  ///< s
  double wall = HUGE_VAL;       ///< s
  double memory = 0;            ///< MB
};

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// Of one run of a program. \throws std::runtime_error if it fails
Cost cost_of(std::vector<std::string> command) {
  std::vector<char*> words;
  for (std::string& word : command) {
    words.push_back(word.data());
  }
  words.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (const int error = posix_spawnp(&child, words[0], nullptr, nullptr, words.data(), environ);
      error != 0) {
    throw std::runtime_error(command[0] + ": " + std::strerror(error));
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (status != 0) {
    throw std::runtime_error(fmt::format("{} fails", fmt::join(command, " ")));
  }
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count(),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

void generate(const std::string& treedyn, const Row& row, Cost& cost) {
  const support::TemporaryFolder folder;
  std::vector<std::string> command{treedyn,     "generate", row.model, "--name",
                                   "generated", "-q",       "-o",      folder.path()};
  command.insert(command.end(), row.options.begin(), row.options.end());
  const Cost run = cost_of(command);
  cost = {std::min(cost.processor, run.processor), std::min(cost.wall, run.wall),
          std::max(cost.memory, run.memory)};
}

void run(const std::vector<std::string>& programs, const fs::path& models, const fs::path& urdf,
         int rounds, const fs::path& output) {
  const support::TemporaryFolder chains;
  const std::vector<Row> all = rows(models, urdf, chains.path());
  std::vector<std::vector<Cost>> costs(all.size(), std::vector<Cost>(programs.size()));
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (std::size_t p = 0; p < programs.size(); ++p) {
        generate(programs[p], all[k], costs[k][p]);
        std::cerr << fmt::format("{}: {:.2f} s\n", all[k].name, costs[k][p].processor);
      }
    }
  }
  std::string text = fmt::format(
      "`treedyn generate`, default options, all functions: processor seconds, wall seconds ({} "
      "cores, shared with other programs) and largest memory, runs: {}, least times of all.\n\n| "
      "robot |",
      std::thread::hardware_concurrency(), rounds);
  std::string line = "\n|---|";
  for (std::size_t p = 0; p < programs.size(); ++p) {
    text += " processor, s | wall, s | memory, MB |";
    line += "---|---|---|";
  }
  text += line + "\n";
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += fmt::format("| {} |", all[k].name);
    for (const Cost& cost : costs[k]) {
      text += fmt::format(" {:.1f} | {:.1f} | {:.0f} |", cost.processor, cost.wall, cost.memory);
    }
    text += "\n";
  }
  fs::create_directories(output);
  support::write_file(output / "generation.md", text);
  std::cout << text;
}

std::vector<std::string> separated(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    result.push_back(word);
  }
  return result;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(argc, argv, "benchmark_generating",
                     {"TREEDYN", "MODELS", "URDF", "ROUNDS", "-o", "DIR"}, [](const Words& words) {
                       run(separated(words[0]), words[1], words[2], std::stoi(words[3]), words[5]);
                     });
}
