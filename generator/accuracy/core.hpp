// What an operation costs on a processor: tables of cycles and instructions, no measurement.
#pragma once

#include <string_view>
#include <vector>

#include "program/function.hpp"

namespace treedyn::accuracy {

/// What operations of one floating-point type take, loads, stores and moves included.
struct Prices {
  double add = 0;
  double mul = 0;
  double div = 0;
  double sqrt = 0;
  double pair = 0;  ///< sine and cosine of one angle
  double libm = 0;  ///< the same by the C library
};

/// A floating-point type on a processor.
struct Precision {
  Prices cycles;
  Prices instructions;
};

/// A processor. Additions and multiplications are issued in order, without contraction.
struct Core {
  std::string_view name;   ///< of `--on`
  std::string_view brief;  ///< for the reader
  Precision single;
  Precision twice;  ///< double
  /// Options of arm-none-eabi-g++; none: its code is not measured.
  std::vector<std::string_view> options = {};

  [[nodiscard]] bool has_flash() const { return !options.empty(); }
};

/// The processors that `--on` knows. Where the numbers come from stands beside them.
const std::vector<Core>& cores();

/// Null if there is none of this name.
const Core* find_core(std::string_view name);

/// Instructions are within this part of what is counted, each function of the tests alone.
inline constexpr double kInstructionsOff = 0.15;

/// Cycles of one call. \param is_float  which of the two types
/// \param libm  sines are those of the C library
double cycles(const program::Cost& cost, const Core& core, bool is_float, bool libm = false);

/// Instructions of one call of code that g++ has compiled with -O2 -ffp-contract=off.
double instructions(const program::Cost& cost, const Core& core, bool is_float);

}  // namespace treedyn::accuracy
