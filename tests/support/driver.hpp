// A program that calls the functions of two generated sources and compares the bits.
#pragma once

#include <string>

#include "support/manifest.hpp"

namespace treedyn::support {

/// One of the two.
struct Program {
  std::string includes;
  std::string before;   ///< a name of a function: "p_", "space::"
  std::string results;  ///< names of what it returns: "c_"
};

/// Prints "0 of 500" if none of the calls (100 of each function, random arguments) differs in a
/// bit. `Scalar` is that of the second.
std::string comparing_driver(const Manifest& manifest, const Program& first, const Program& second);

}  // namespace treedyn::support
