// The C++ text that makes generated functions callable by name from a test.
#pragma once

#include <string>

#include "support/manifest.hpp"

namespace treedyn::support {

/// What stands for Scalar in the compiled code: its own type, or Measured of it.
enum class Variant { kPlain, kMeasured };

/// `header` (the text of NAME.hpp) with Scalar = Measured<..> for Variant::kMeasured.
/// \throws std::runtime_error if it has no line "using Scalar = double;" (or float).
std::string adapted_header(const std::string& header, const Manifest& manifest, Variant variant);

/// A source file with, for every function of the manifest,
///
///     extern "C" int call_<function>(const double* const* in, double* const* out,
///                                    double* const* bound)
///
/// which converts to Scalar, fills the outputs with NaN, calls `name::<function>`, converts back
/// and returns its status (0 of functions without); with Variant::kMeasured also the error bounds,
/// and `operations(long[6])`, which reads and resets the operation counts.
std::string shim_source(const std::string& name, const Manifest& manifest, Variant variant);

}  // namespace treedyn::support
