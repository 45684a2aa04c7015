// Header and source in C99: the statements of the C++ text, word for word, with the few words that
// differ.
#pragma once

#include <string>
#include <utility>

#include "emit/unit.hpp"

namespace treedyn::emit {

/// The C++ texts of a unit as C99, which C++ compilers read as well: `prefix_` before what has
/// external linkage and before its constants, `static` for the anonymous namespace, enumerators for
/// constant integers, `(Scalar)0` for `Scalar(0)`.
/// \param header, source  as `header_text` and `source_text` make them
/// \pre no lanes, no limb code
std::pair<std::string, std::string> in_c99(const Unit& unit, const std::string& header,
                                           const std::string& source);

}  // namespace treedyn::emit
