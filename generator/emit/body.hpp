// The statements of one function, split into parts that a compiler digests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/literal.hpp"
#include "emit/names.hpp"
#include "program/function.hpp"

namespace treedyn::emit {

/// A part of a function: the statements of one C++ function body.
struct Part {
  std::vector<std::string> lines;  ///< without indentation; comments and statements
  int level = 0;                   ///< stage of its first line
  std::vector<bool> uses;          ///< which arrays it touches: inputs, then outputs
  bool uses_workspace = false;
};

/// The body of a function. One part: a plain function; several: functions that share a workspace.
struct Body {
  std::vector<Part> parts;
  Part zeros;          ///< outputs that are zero, in a function of their own; no line: none
  int workspace = 0;   ///< elements for values that one part computes and another needs
  std::string number;  ///< the type of values
  std::string workspace_name;
  std::vector<std::size_t> stages;   ///< of a single part: where stages 1, 2, .. begin
  std::size_t angle_statements = 0;  ///< those of several angles together
  int statements = 0;
  int structural_zeros = 0;
};

/// Order, names and statements of a function. Every line fits into 100 columns with an indentation
/// of two; the operations are exactly those of the graph.
/// \throws std::range_error if a constant is too large for the scalar type.
/// \param level  stage of an input element (array, element), see program::Staged; the statements of
///               a stage stand behind those of the stages before it
Body body(const program::Function& function, const Vocabulary& words, const Target& target,
          const std::function<int(int, int)>& level = {});

}  // namespace treedyn::emit
