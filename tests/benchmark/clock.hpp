// Times of many functions in one interleaved run.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace treedyn::benchmark {

/// Least and median time of a call over all rounds, ns.
struct Time {
  double least = 0;
  double median = 0;
};

/// The middle value, the mean of both middle ones if there are two. \pre not empty
double median(std::vector<double> values);

/// Calls in a row: of states first, first + 1, ..., from the beginning again after the last.
struct Turn {
  std::size_t first = 0;
  int calls = 0;
};

/// Something that can be called many times in a row.
using Repeated = std::function<void(Turn)>;

/// `rounds` times, every function in turn: called `kBatch` nanoseconds long after a warm-up, each
/// time with other states. What slows the machine for a while slows all alike.
std::vector<Time> measure(const std::vector<Repeated>& functions, int rounds);

}  // namespace treedyn::benchmark
