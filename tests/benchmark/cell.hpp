// What a benchmark program found out about one function of one robot by one contestant.
#pragma once

#include <optional>
#include <string>

namespace treedyn::benchmark {

struct Cell {
  std::string robot;
  int dof = 0;
  std::string function;
  std::string contestant;
  double error = 0;                    ///< largest, relative; see task.hpp
  double least = 0;                    ///< ns a call, of all rounds
  double median = 0;                   ///< ns a call
  std::optional<double> instructions;  ///< a call, if callgrind is there
};

}  // namespace treedyn::benchmark
