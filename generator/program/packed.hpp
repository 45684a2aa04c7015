// A symmetric matrix without what is zero in every state and above the diagonal.
#pragma once

#include <string>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// The places of a symmetric matrix that are stored: value k is entry (row[k], column[k]),
/// column[k] <= row[k], row by row.
struct Packing {
  std::vector<int> row;
  std::vector<int> column;

  [[nodiscard]] int size() const { return static_cast<int>(row.size()); }
};

/// The places on and below the diagonal at which `dense`, a function whose first output is an
/// n x n matrix, is not structurally zero.
Packing lower_triangle(const Function& dense, int n);

/// The same function with the entries of `packing` alone in every output array called `matrix`,
/// which holds n x n values.
Function packed(Function function, const std::string& matrix, int n, const Packing& packing);

}  // namespace treedyn::program
