// NAME.hpp: what a user of the generated functions reads.
#pragma once

#include <string>

#include "emit/unit.hpp"

namespace treedyn::emit {

/// What stands in header and source in the place of their digest.
inline constexpr const char* kNoDigest = "0x0000000000000000ULL";

/// The header, with `kNoDigest`.
std::string header_text(const Unit& unit);

/// The command line as comment lines.
std::string command_comment(const std::vector<std::string>& command);

/// The independent joint that moves the father of the link of coordinate `k`; -1: none.
int father_coordinate(const model::Tree& tree, int k);

}  // namespace treedyn::emit
