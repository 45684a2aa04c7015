// Programs as the scalar type of their code holds their numbers.
#pragma once

#include "pipeline.hpp"

namespace treedyn {

/// The same programs without factors that the scalar type rounds to one: they are neither written
/// nor counted.
Programs in_scalar(Programs programs, emit::Scalar scalar);

}  // namespace treedyn
