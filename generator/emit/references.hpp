// References of C++ text as pointers of C.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace treedyn::emit {

/// Of functions that take references the places of these among the arguments.
using ReferencePlaces = std::map<std::string, std::set<std::ptrdiff_t>>;

/// Calls pass addresses where the function takes references.
std::string with_addresses(std::string body, const ReferencePlaces& by_reference);

/// The body of a function whose parameters of these names were references and are pointers: `x.` is
/// `x->`, `&x` is `x`.
std::string with_pointers(const std::string& body, const std::set<std::string>& references);

}  // namespace treedyn::emit
