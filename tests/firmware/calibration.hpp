// How far the table of instructions that `treedyn accuracy` counts with is off.
#pragma once

#include <string>
#include <vector>

#include "program/function.hpp"

namespace treedyn {

/// A function whose instructions were counted on a processor.
struct Count {
  std::string core;  ///< a name of accuracy::cores()
  bool is_float = true;
  std::string function;  ///< for the reader
  program::Cost cost;
  long instructions = 0;
  bool contracted = false;
};
using Counts = std::vector<Count>;

/// Prints for each processor and scalar the largest deviation.
/// \returns the number of functions for which it is larger than the table says
int off_the_table(const Counts& counts);

}  // namespace treedyn
