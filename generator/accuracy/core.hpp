// What an operation costs on a processor: tables of cycles, no measurement.
#pragma once

#include <string_view>
#include <vector>

#include "program/function.hpp"

namespace treedyn::accuracy {

/// Cycles of one operation in one floating-point type.
struct Cycles {
  double add = 0;
  double mul = 0;
  double div = 0;
  double sqrt = 0;
  double pair = 0;    ///< sine and cosine of one angle
  double libm = 0;    ///< the same by the C library
  double memory = 0;  ///< loads, stores and moves, for each addition and multiplication
};

/// A processor. Additions and multiplications are issued in order, without contraction.
struct Core {
  std::string_view name;   ///< of `--on`
  std::string_view brief;  ///< for the reader
  Cycles single;
  Cycles twice;  ///< double
  /// Options of arm-none-eabi-g++; none: its code is not measured.
  std::vector<std::string_view> options = {};

  [[nodiscard]] bool has_flash() const { return !options.empty(); }
};

/// The processors that `--on` knows. Where the numbers come from stands beside them.
const std::vector<Core>& cores();

/// Null if there is none of this name.
const Core* find_core(std::string_view name);

/// Cycles of one call. \param is_float  which of the two tables
/// \param libm  sines are those of the C library
double cycles(const program::Cost& cost, const Core& core, bool is_float, bool libm = false);

}  // namespace treedyn::accuracy
