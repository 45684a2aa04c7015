// benchmark_engines --rounds N [--count PROGRAM] -o DIR: generated code beside engines of Debian.
//
// Checks the values of every contestant, then times all functions of all robots in one interleaved
// run, and writes engines.md, engines.csv and engines.svg. With --count also the instructions that
// PROGRAM (instructions.cpp) executes under callgrind.

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/callgrind.hpp"
#include "benchmark/clock.hpp"
#include "benchmark/instructions.hpp"
#include "benchmark/report.hpp"
#include "benchmark/task.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  int rounds = 0;
  std::string counter;
  fs::path output;
};

Arguments parse(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) {
    if (words[k] == "--rounds") {
      result.rounds = std::stoi(words[k + 1]);
    } else if (words[k] == "--count") {
      result.counter = words[k + 1];
    } else if (words[k] == "-o") {
      result.output = words[k + 1];
    } else {
      throw std::runtime_error("unknown option " + words[k]);
    }
  }
  if (result.rounds < 1 || result.output.empty() || words.size() % 2 != 0) {
    throw std::runtime_error("usage: benchmark_engines --rounds N [--count PROGRAM] -o DIR");
  }
  return result;
}

/// A robot with everybody who competes on it.
struct Contest {
  Task task;
  std::vector<std::unique_ptr<Contestant>> contestants;
};

std::vector<std::unique_ptr<Contest>> contests() {
  std::vector<std::unique_ptr<Contest>> result;
  for (const RobotInfo& robot : robots()) {
    auto contest = std::make_unique<Contest>(Contest{make_task(robot), {}});
    contest->contestants = contestants(contest->task, robot);
    result.push_back(std::move(contest));
  }
  return result;
}

/// Cells with checked values and what is to be timed, one for one.
struct Plan {
  std::vector<Cell> cells;
  std::vector<Repeated> functions;
};

Plan checked_plan(const std::vector<std::unique_ptr<Contest>>& contests) {
  Plan plan;
  for (const auto& contest : contests) {
    for (const QuantityInfo& info : kQuantities) {
      for (const auto& contestant : contest->contestants) {
        if (!contestant->can(info.quantity)) {
          continue;
        }
        Cell cell{contest->task.robot,
                  static_cast<int>(contest->task.dof()),
                  info.function,
                  contestant->name(),
                  0,
                  0,
                  0,
                  {}};
        cell.error = checked_error(contest->task, *contestant, info.quantity);
        plan.cells.push_back(cell);
        plan.functions.emplace_back([&contestant, quantity = info.quantity](Turn turn) {
          contestant->run(quantity, turn);
        });
      }
    }
  }
  return plan;
}

void add_instructions(const std::string& counter, std::vector<Cell>& cells) {
  const auto counts = count_instructions({counter});
  for (Cell& cell : cells) {
    const auto found = counts.find(label_of(cell.robot, cell.function, cell.contestant));
    if (found != counts.end()) {
      cell.instructions = static_cast<double>(found->second) / kCountedCalls;
    }
  }
}

void run(const Arguments& arguments) {
  const auto all = contests();
  Plan plan = checked_plan(all);
  const std::vector<Time> times = measure(plan.functions, arguments.rounds);
  for (std::size_t k = 0; k < times.size(); ++k) {
    plan.cells[k].least = times[k].least;
    plan.cells[k].median = times[k].median;
  }
  if (!arguments.counter.empty()) {
    add_instructions(arguments.counter, plan.cells);
  }
  fs::create_directories(arguments.output);
  support::write_file(arguments.output / "engines.md", markdown(plan.cells));
  support::write_file(arguments.output / "engines.csv", csv(plan.cells));
  support::write_file(arguments.output / "engines.svg", svg(plan.cells));
  std::cout << markdown(plan.cells);
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  try {
    treedyn::benchmark::run(treedyn::benchmark::parse({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
