// Sine and cosine in the generated source, where no library is wanted or several lanes are
// computed.
#pragma once

#include <string>

#include "emit/literal.hpp"

namespace treedyn::emit {

/// Definitions of `sin` and `cos` for Scalar, the same text for every model.
std::string sincos_text(const Target& target);

}  // namespace treedyn::emit
