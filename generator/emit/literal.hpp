// Numbers as C++ literals.
#pragma once

#include <string>

#include "common/real.hpp"
#include "program/schedule.hpp"

namespace treedyn::emit {

/// The only floating-point type of a generated file.
enum class Scalar { kDouble, kFloat };

/// What the generated functions compute with.
struct Target {
  Scalar scalar = Scalar::kDouble;
  int lanes = 1;                ///< states at once; more than one: Scalar is a vector type
  bool builtin_sincos = false;  ///< sin and cos without a library; always with several lanes
  bool packed = false;          ///< A: what is not structurally zero, lower triangle
  program::Trigonometry trigonometry = program::Trigonometry::kEarly;
};

/// "double" or "float".
std::string type_name(Scalar scalar);

/// The shortest decimal that reads back as `value` rounded to nearest in the scalar type: `0.5`,
/// `1e-05f`. \throws std::range_error if the value is too large for the type.
std::string literal(const Real& value, Scalar scalar);

/// `value` in plain JSON and for the reader: shortest digits that read back as the same double.
std::string decimal(const Real& value);

}  // namespace treedyn::emit
