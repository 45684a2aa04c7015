// The result of a benchmark as a Markdown table, as CSV and as a bar chart.
#pragma once

#include <string>
#include <vector>

#include "benchmark/cell.hpp"

namespace treedyn::benchmark {

/// One table a robot, one row a function: least (median) ns and instructions a call of every
/// contestant, and how many times slower the fastest engine of Debian is.
std::string markdown(const std::vector<Cell>& cells);

/// One line a cell.
std::string csv(const std::vector<Cell>& cells);

/// Bars on a logarithmic axis, one panel a robot: least time relative to the first contestant.
std::string svg(const std::vector<Cell>& cells);

}  // namespace treedyn::benchmark
