#include "benchmark/clock.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace treedyn::benchmark {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBatch = 20000;  ///< ns; long beside the clock's own 30 ns

#if defined(__x86_64__)
[[gnu::target("avx")]] void clear_upper_halves() { __builtin_ia32_vzeroupper(); }
#endif

/// Code for AVX may leave numbers in the upper halves of registers; code for SSE after it would
/// wait for them with every instruction.
void forget_others() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx") != 0) {
    clear_upper_halves();
  }
#endif
}

double time_of(const Repeated& function, Turn turn) {
  const auto start = Clock::now();
  function(turn);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// How many calls fill a batch.
int calls_in_batch(const Repeated& function) {
  constexpr int kMany = 1 << 20;
  int calls = 16;
  forget_others();
  function({0, calls});
  while (calls < kMany && time_of(function, {0, calls}) < kBatch) {
    calls *= 2;
  }
  return calls;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<Time> measure(const std::vector<Repeated>& functions, int rounds) {
  std::vector<int> calls;
  for (const Repeated& function : functions) {
    calls.push_back(calls_in_batch(function));
  }
  std::vector<std::vector<double>> times(functions.size());
  std::vector<std::size_t> next(functions.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const int warm_up = std::max(4, calls[k] / 8);
      forget_others();
      functions[k]({next[k], warm_up});
      next[k] += static_cast<std::size_t>(warm_up);
      times[k].push_back(time_of(functions[k], {next[k], calls[k]}) / calls[k]);
      next[k] += static_cast<std::size_t>(calls[k]);
    }
  }
  std::vector<Time> result;
  for (const std::vector<double>& of_function : times) {
    result.push_back(
        {*std::min_element(of_function.begin(), of_function.end()), median(of_function)});
  }
  return result;
}

}  // namespace treedyn::benchmark
