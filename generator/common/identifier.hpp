// Names of a file made C++ identifiers, INTERFACE.md 3.
#pragma once

#include <string>
#include <string_view>

namespace treedyn {

/// True for keywords and alternative tokens of C++20, and for names that the standard headers or
/// the compiler's environment define as macros (`NULL`, `NAN`, `linux`) or as a namespace (`std`).
bool is_reserved_word(std::string_view name);

/// `name` as a C++ identifier: every byte outside [A-Za-z0-9_] becomes `_`; a leading digit or `_`
/// gets the prefix `n`; a reserved word gets a trailing `_`. Different names may give the same
/// identifier.
std::string to_identifier(std::string_view name);

}  // namespace treedyn
