// A function body in several C++ functions that share a workspace.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/body.hpp"

namespace treedyn::emit {

/// What follows the opening brace of a function.
std::string block(const std::vector<std::string>& lines);

/// Adds arrays to those that are used.
void unite(std::vector<bool>& uses, const std::vector<bool>& more);

struct SplitText {
  std::string parts;               ///< the functions of the parts
  std::string declaration;         ///< of the workspace in the caller; empty: none
  std::vector<std::string> calls;  ///< one per part
  std::vector<bool> used;          ///< arrays: inputs, then outputs
};

/// The parts of a body as functions stem_1, stem_2, ...
SplitText split_text(const program::Signature& signature, const std::string& stem,
                     const Body& body);

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
