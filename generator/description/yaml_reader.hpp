// Tree descriptions, INTERFACE.md 4, as written.
#pragma once

#include <string>

#include "description/raw_tree.hpp"

namespace treedyn::description {

/// \throws InputError for malformed YAML, unknown, repeated and missing keys, and values of the
/// wrong kind.
RawTree read_yaml(const std::string& text, const std::string& file);

}  // namespace treedyn::description
