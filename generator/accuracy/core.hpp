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
  /// Of code that is compiled with contraction: a multiplication and the addition that takes it in,
  /// and a pair.
  double fused = 0;
  double fused_pair = 0;
};

/// A floating-point type on a processor.
struct Precision {
  Prices cycles;
  Prices instructions;
};

/// A processor.
struct Core {
  std::string_view name;   ///< of `--on`
  std::string_view brief;  ///< for the reader
  Precision single;
  Precision twice;  ///< double
  /// Options of arm-none-eabi-g++; none: its code is not measured.
  std::vector<std::string_view> options = {};
  /// Has no latency to hide: g++'s pass in front of the allocation of registers only makes it spill
  /// (on the M4F with -O2 14 and 1 % of the cycles of A and tau of the biped, forward dynamics
  /// gains 1 %).
  bool in_order = false;

  [[nodiscard]] bool has_flash() const { return !options.empty(); }
};

/// The processors that `--on` knows. Where the numbers come from stands beside them.
const std::vector<Core>& cores();

/// Null if there is none of this name.
const Core* find_core(std::string_view name);

/// Instructions are within this part of what is counted, each function of the tests alone.
inline constexpr double kInstructionsOff = 0.15;

/// Code and how it was compiled.
struct Build {
  bool is_float = true;     ///< which of the two types
  bool libm = false;        ///< sines are those of the C library
  bool contracted = false;  ///< -ffp-contract=fast, not off
  int angles = 1;           ///< of which sines are taken at once: 1, 2 or 4
};

/// Cycles of one call.
double cycles(const program::Cost& cost, const Core& core, const Build& build);

/// Instructions of one call of code that g++ has compiled with -O2.
double instructions(const program::Cost& cost, const Core& core, const Build& build);

}  // namespace treedyn::accuracy
