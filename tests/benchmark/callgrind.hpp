// Instructions of labelled pieces of a program that runs under valgrind.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace treedyn::benchmark {

/// Executed instructions by label: `command` marks its pieces with CALLGRIND_DUMP_STATS_AT(label).
/// Empty if there is no valgrind. \throws std::runtime_error if `command` fails under it.
std::map<std::string, long> count_instructions(const std::vector<std::string>& command);

}  // namespace treedyn::benchmark
