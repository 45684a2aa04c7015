// Independent tasks on several cores.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace treedyn {

/// At most so many threads work at once, all calls of `run_all` together; before the first call as
/// many as the machine has cores. \pre count > 0
void set_threads(int count);

/// Runs all tasks, begun in their order, and returns when every one is done. A task knows of the
/// sources of numbers (common/provenance.hpp) what the caller knew; what tasks find out the caller
/// knows afterwards, by their order: no result depends on the number of threads. Tasks may call it.
/// \throws what the first task that failed has thrown
void run_all(const std::vector<std::function<void()>>& tasks);

/// The results of tasks, in their order.
template <class Result>
std::vector<Result> results_of(const std::vector<std::function<Result()>>& tasks) {
  std::vector<std::optional<Result>> made(tasks.size());
  std::vector<std::function<void()>> all;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    all.emplace_back([&made, &tasks, k] { made[k] = tasks[k](); });
  }
  run_all(all);
  std::vector<Result> results;
  for (std::optional<Result>& result : made) {
    results.push_back(*std::move(result));
  }
  return results;
}

}  // namespace treedyn
