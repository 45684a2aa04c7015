// Sine and cosine in the generated source.
#pragma once

#include <string>

#include "emit/unit.hpp"

namespace treedyn::emit {

/// The function that gives both, and that for several angles.
inline constexpr const char* kSineCosine = "sine_cosine";
inline constexpr const char* kSinesCosines = "sines_cosines";

/// Angles in the longest vector of the source; arrays of sines have room for whole vectors.
std::size_t most_angles(Scalar scalar);

/// True if the source defines sines and cosines: where some are needed that <cmath> does not give.
bool has_sincos(const Unit& unit);

/// What lets compilers keep the order and the rounding of sums, or stops them with `error`.
/// \param finite  a condition more, a line that ends in `|| \`
std::string order_of_sums(Scalar scalar, const std::string& error, const std::string& finite = "");

/// Definitions of `sine_cosine` for Scalar, the same text for every model, and of `sin` and `cos`
/// as far as `functions`, the text of those behind it, call them.
/// \param has_numbers  false: there are angles of limbs together only
std::string sincos_text(Target target, const std::string& functions, bool has_numbers);
/// The same for `target.number`, a vector that is passed by reference; inline, as a processor works
/// on a limb's angles side by side.
std::string sincos_of_limbs(const Target& target, const std::string& functions);

/// What the source's `sine_cosine` returns for float and double, bit by bit.
template <class T>
struct SineCosine {
  T sine;
  T cosine;
};
SineCosine<float> sine_cosine(float x);
SineCosine<double> sine_cosine(double x);

/// What headers state: the largest error of a sine or cosine of angles up to `range`, rad.
struct StatedSines {
  double error;
  double range;
};
StatedSines stated_sines(Scalar scalar);

/// Error, range and end in rad as JSON: {"error": 1.7e-16, "range": 1.3e7, "end": 1.32e7}.
std::string sincos_range(const Target& target);

/// What the user of a header has to know about them: error and range, one sentence.
std::string sincos_comment(const Target& target);

}  // namespace treedyn::emit
