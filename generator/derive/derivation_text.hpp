// A derivation as text, in the field's symbols.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "derive/derive.hpp"

namespace treedyn::derive {

/// A value with its line "ω = D w".
struct Line {
  int id = 0;
  std::string text;
  std::set<Rule> rules;  ///< that made it, or a symbol in it
};

/// The recursion of a derivation, operands before their users.
/// \param result  the name of its one result; empty: it gets one like other values
std::vector<Line> lines(const Derivation& derivation, const std::string& result = {});

}  // namespace treedyn::derive
