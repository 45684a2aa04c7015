// Identifiers of one namespace of the generated code must differ.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"

namespace treedyn::description {

struct Named {
  std::string name;
  std::string identifier;
  Location where;
};

/// \param kind "joint" or "point", for the message
/// \throws InputError naming both, if two identifiers are equal.
void check_identifiers(const std::vector<Named>& names, const std::string& kind);

}  // namespace treedyn::description
