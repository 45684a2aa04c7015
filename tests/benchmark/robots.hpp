// The robots of a benchmark program; CMake writes the list.
#pragma once

#include <string>
#include <vector>

#include "benchmark/code.hpp"

namespace treedyn::benchmark {

struct RobotInfo {
  std::string name;
  std::string model;   ///< file
  std::string base;    ///< of --base
  std::string points;  ///< of --points
  const Code* libm;
  const Code* vector;  ///< default options
};

std::vector<RobotInfo> robots();

}  // namespace treedyn::benchmark
