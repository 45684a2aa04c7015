// Calls every function of every contestant under callgrind; engines.cpp starts this program and
// reads the counts. Compiled for x86-64-v3, since valgrind 3.19 knows no AVX-512.
#include "benchmark/instructions.hpp"

#include <valgrind/callgrind.h>

#include <exception>
#include <iostream>

#include "benchmark/task.hpp"

namespace treedyn::benchmark {
namespace {

void count(const Task& task, Contestant& contestant) {
  for (const QuantityInfo& info : kQuantities) {
    if (contestant.can(info.quantity)) {
      const std::string label = label_of(task.robot, info.function, contestant.name());
      contestant.run(info.quantity, {0, 1});
      CALLGRIND_START_INSTRUMENTATION;
      CALLGRIND_ZERO_STATS;
      contestant.run(info.quantity, {0, kCountedCalls});
      CALLGRIND_DUMP_STATS_AT(label.c_str());
      CALLGRIND_STOP_INSTRUMENTATION;
    }
  }
}

}  // namespace
}  // namespace treedyn::benchmark

int main() {
  try {
    for (const auto& robot : treedyn::benchmark::robots()) {
      const auto task = treedyn::benchmark::make_task(robot);
      for (const auto& contestant : treedyn::benchmark::contestants(task, robot)) {
        treedyn::benchmark::count(task, *contestant);
      }
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
