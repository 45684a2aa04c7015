// Programs as the scalar type of their code holds their numbers.
#pragma once

#include "pipeline.hpp"

namespace treedyn {

/// The same programs of a model without factors that the scalar type rounds to one, which are
/// neither written nor counted, and with tests of the pivots that may lose their digits in it.
program::Programs in_scalar(program::Programs programs, const Model& model, emit::Scalar scalar);

/// Functions of which float keeps no digits.
std::vector<Warning> float_warnings(const program::Programs& programs, emit::Scalar scalar,
                                    const Location& where);

/// What users should know of the numbers of programs: `float_warnings`, and functions without some
/// pass that would have amplified rounding.
std::vector<Warning> warnings_of(const program::Programs& programs, const Request& request);

}  // namespace treedyn
