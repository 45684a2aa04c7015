// Finished text again as lines and definitions, for what changes all of them in the same way.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace treedyn::emit {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text);

/// Line `at` and those behind it up to the one that ends with `end`, as one; `at` moves to that.
std::string gathered(const Lines& lines, std::size_t& at, char end);

/// `void f(const Scalar q[6], Scalar /*A*/[36]) {` in its parts.
struct Declaration {
  std::string head;  ///< "void f"
  Lines arguments;
  std::string ending;  ///< " {"
};
Declaration declaration_of(const std::string& line);

/// True for the first line of a function at file level.
bool begins_function(const std::string& line);

/// The source with a macro in front of every function, which has to be defined outside.
std::string placed(const std::string& source, const std::string& section);

}  // namespace treedyn::emit
