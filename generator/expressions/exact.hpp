// Exact numbers of GiNaC: evaluated, and functions of them with their domains.
#pragma once

#include <span>
#include <string_view>

#include <ginac/ginac.h>

#include "common/real.hpp"

namespace treedyn::expressions {

/// Sets GiNaC's global precision to 100 digits for the lifetime of the object.
class Precision {
 public:
  Precision();
  ~Precision() { GiNaC::Digits = before_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;

 private:
  long before_;
};

/// The value in 50 digits, from an evaluation in 100; what is below 1e-80 is an exact zero.
/// \throws TextError if it is beyond 1e1000.
/// \pre `value` is real and has no symbol; a `Precision` is alive.
Real to_real(const GiNaC::ex& value);

/// `value`, or the 0, 1 or -1 that it is but for the rounding of 100 digits: keeps roots and arcs
/// real.
GiNaC::ex tidied(const GiNaC::ex& value);

/// A decimal as an exact rational. \pre digits, at most one point, an exponent of a few digits.
GiNaC::ex exact_decimal(std::string_view text);

/// A function, and the arguments for which it is real and finite.
struct FunctionRow {
  std::string_view name;
  GiNaC::ex (*apply)(const GiNaC::ex&);
  bool (*accepts)(const Real&);
  std::string_view domain;
  bool of_variables;  ///< what generated code may call
};

/// The row of sqrt, sin, cos, tan, asin, acos or atan; nullptr for other names.
const FunctionRow* find_function(std::string_view name);
/// All of them.
std::span<const FunctionRow> functions();

}  // namespace treedyn::expressions
