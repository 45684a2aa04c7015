// Identifiers of one namespace of the generated code must differ.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/error.hpp"

namespace treedyn::description {

/// A name that can stand in files and comments: 1 to 255 bytes of UTF-8 without control
/// characters. \throws InputError otherwise. \param kind  what it names, for the message
void check_name(const Location& where, std::string_view name, std::string_view kind);

struct Named {
  std::string name;
  std::string identifier;
  Location where;
};

/// \param kind "joint", "point" or "phase", for the message
/// \throws InputError naming both, if two identifiers are equal.
void check_identifiers(const std::vector<Named>& names, const std::string& kind);

}  // namespace treedyn::description
