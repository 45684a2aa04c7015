// A function body in several C++ functions that share a workspace.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/body.hpp"
#include "emit/layout.hpp"

namespace treedyn::emit {

/// What follows the opening brace of a function.
std::string block(const std::vector<std::string>& lines);

/// Adds arrays to those that are used.
void unite(std::vector<bool>& uses, const std::vector<bool>& more);

/// A function by the lines between its braces, behind its `parts`, if there are some.
std::string definition(const std::string& parts, const program::Signature& signature,
                       const std::vector<bool>& uses, const std::vector<std::string>& lines);

/// Functions in a namespace without a name, behind an empty line; empty without functions.
std::string unnamed(const std::string& functions);

struct WholeText {
  std::string parts;               ///< the functions of the parts; empty: the body is in one
  std::vector<std::string> lines;  ///< the statements, or the workspace and a call of each part
  std::vector<bool> used;          ///< arrays: inputs, then outputs
  int stages = 0;                  ///< how many have begun
};

/// A body of one part, or of several as functions stem_1, stem_2, ...
/// \param before  what stands in front of stage 1, 2, ..
WholeText whole_text(const program::Signature& signature, const std::string& stem, const Body& body,
                     const std::function<Lines(int)>& before = {});

/// Stems for the parts of functions with these names: the names, but where another function has the
/// name that a part would get, as those of phases `stance` and `stance_2`.
std::map<std::string, std::string> stems_of_parts(const std::set<std::string>& names);

/// The zeros of a body: their function, and its call, which is empty if there is none.
struct ZerosText {
  std::string function;
  std::string call;
};
ZerosText zeros_text(const program::Signature& signature, const Body& body);

}  // namespace treedyn::emit
