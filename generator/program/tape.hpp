// A function compiled once for fast repeated evaluation in double.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// A list of instructions on registers; what the function's graph computes, in the same order.
class Tape {
 public:
  explicit Tape(const Function& function);

  /// \param inputs   one array per input of the signature
  /// \param outputs  all output arrays, one behind the other; size outputs()
  /// Allocates nothing. O(instructions).
  void evaluate(std::span<const std::span<const double>> inputs, std::span<double> outputs);

  [[nodiscard]] std::size_t outputs() const { return results_.size(); }
  [[nodiscard]] std::size_t instructions() const { return instructions_.size(); }

 private:
  enum class Operation : std::uint8_t {
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kSin,
    kCos,
    kSqrt,
    kSqrtOfNegative
  };
  struct Instruction {
    Operation operation;
    std::int32_t result;
    std::int32_t a;
    std::int32_t b;
  };
  struct Load {
    std::int32_t result;
    std::int32_t array;
    std::int32_t element;
  };

  std::vector<double> registers_;  ///< register 0 is zero; constants are set once
  std::vector<Load> loads_;
  std::vector<Instruction> instructions_;
  std::vector<Ref> results_;  ///< registers with signs
};

}  // namespace treedyn::program
