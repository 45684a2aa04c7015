// What a mistake in the syntax of a YAML file most likely is, in words of its writer.
#pragma once

#include <string>

#include "description/raw_tree.hpp"

namespace treedyn::description {

/// "what is wrong; what was expected" for a problem that libyaml reports. \param where  its place
std::string yaml_message(const std::string& text, const Place& where, const std::string& problem);

}  // namespace treedyn::description
