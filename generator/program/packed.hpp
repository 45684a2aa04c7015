// A matrix without what is zero in every state and, if it is symmetric, above the diagonal.
#pragma once

#include <string>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// The places of a matrix that are stored: value k is entry (row[k], column[k]), row by row.
struct Packing {
  int rows = 0;
  int columns = 0;
  bool mirrored = false;  ///< symmetric: column[k] <= row[k]
  std::vector<int> row = {};
  std::vector<int> column = {};
  bool is_zero = false;  ///< all entries are: the one that is stored, too

  [[nodiscard]] int size() const { return static_cast<int>(row.size()); }
};

/// The places at which `dense`, a function whose first output is a rows x columns matrix, is not
/// zero in every state; of a matrix whose entries are made as those of its transpose on and below
/// the diagonal. At least one: C++ and C have no arrays of nothing.
Packing stored_entries(const Function& dense, int rows, int columns);

/// The same function with the entries of `packing` alone in every output array called `matrix`.
Function packed(Function function, const std::string& matrix, const Packing& packing);

}  // namespace treedyn::program
