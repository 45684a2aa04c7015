// Numbers as C++ literals.
#pragma once

#include <string>

#include "common/real.hpp"
#include "program/schedule.hpp"

namespace treedyn::emit {

/// The only floating-point type of a generated file. Extended is that of references only: `long
/// double`, with the forms and bounds of double and the sines of <cmath>.
enum class Scalar { kDouble, kFloat, kExtended };

/// Where sine and cosine come from: one function of the source for both, or <cmath>.
enum class Sincos { kPair, kLibm };

/// What the generated functions compute with.
struct Target {
  Scalar scalar = Scalar::kDouble;
  int lanes = 1;                  ///< states at once; more than one: Scalar is a vector type
  std::string number = "Scalar";  ///< the type of values
  bool limb_lanes = false;        ///< limbs that share code are the lanes of vectors
  Sincos sincos = Sincos::kPair;
  bool vectors = false;      ///< the pair of all angles of a function together, in vectors
  bool packed = false;       ///< A: what is not structurally zero, lower triangle
  bool zeros_apart = false;  ///< many outputs that are zero get a function of their own
  program::Trigonometry trigonometry = program::Trigonometry::kEarly;

  /// True if <cmath> gives sines and cosines: it has none for several lanes.
  [[nodiscard]] bool takes_libm() const { return sincos == Sincos::kLibm && lanes == 1; }
  /// True if the angles of a function are worked on together.
  [[nodiscard]] bool takes_vectors() const { return vectors && lanes == 1; }
  /// Of vectors all sines come first, too: their calls keep no register.
  [[nodiscard]] program::Trigonometry order() const {
    const bool first = lanes > 1 && trigonometry == program::Trigonometry::kEarly;
    return takes_vectors() || first ? program::Trigonometry::kTogether : trigonometry;
  }
};

/// "double", "float" or "long double".
std::string type_name(Scalar scalar);

/// The shortest decimal that reads back as `value` rounded to nearest in the scalar type: `0.5`,
/// `1e-05f`. \throws std::range_error if the value is too large for the type.
std::string literal(const Real& value, Scalar scalar);

/// Columns to keep free for the literal: those of the longest, as the digits of a number of the
/// robot must not decide where lines end; the actual ones of numbers that structure gives.
int literal_width(const Real& value, Scalar scalar);

/// True if the literal is that of 1.
bool rounds_to_one(const Real& value, Scalar scalar);

/// A number with a point or an exponent: no integer of a literal or a manifest.
std::string with_point(const std::string& number);

/// `value` in plain JSON and for the reader: shortest digits that read back as the same double.
std::string decimal(const Real& value);

}  // namespace treedyn::emit
