// Lines and declarations the way clang-format leaves them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program/function.hpp"

namespace treedyn::emit {

using Lines = std::vector<std::string>;

/// Adds the lines `more`, each behind `indentation`.
void append(Lines& lines, const Lines& more, const std::string& indentation = "");
/// Adds the line where it is needed.
void append_if(Lines& lines, bool needed, const std::string& line);
/// The lines one below the other, each behind `indentation`, without the last line break.
std::string joined(const Lines& lines, const std::string& indentation);

inline constexpr std::size_t kColumns = 100;
inline constexpr std::size_t kContinuation = 6;  ///< indentation of the second line of a statement
inline constexpr const char* kNextLine = "\n      ";  ///< and the break before it
inline constexpr std::size_t kLongestCell = 32;  ///< of what models name, in tables of comments

/// `text` broken at spaces into lines of at most 100 columns, each after `prefix`; continued lines
/// get `hang` more spaces. Ends with a line feed.
std::string wrapped(std::string_view text, std::string_view prefix, std::size_t hang = 0);

/// `void name(argument, ...) noexcept` and `ending`, continued under the first argument.
std::string declaration(const std::string& head, const std::vector<std::string>& arguments,
                        const std::string& ending);

/// `const Scalar q[6]` for every input, `Scalar A[36]` for every output; an array that `uses` does
/// not hold is an unnamed parameter, `const Scalar /*q*/[6]`. Structs are references.
std::vector<std::string> parameters(const program::Signature& signature,
                                    const std::vector<bool>& uses);
/// True for every input and output.
std::vector<bool> all_arrays(const program::Signature& signature);

/// Columns two spaces apart, each row behind `prefix`.
std::string table(const std::vector<std::vector<std::string>>& rows, std::string_view prefix = "");

/// `void name(..)` of a function, `int name(..)` of one that returns a status, with all arguments
/// named, or those that `uses` holds, and `ending`.
std::string declaration(const program::Signature& signature, const std::string& ending);
std::string declaration(const program::Signature& signature, const std::vector<bool>& uses,
                        const std::string& ending);

/// `head(arguments);` behind an indentation, which is not part of it.
std::string call_text(const std::string& head, const std::vector<std::string>& arguments,
                      std::size_t indentation = 2);

/// mass_matrix -> MassMatrix
std::string camel_case(const std::string& name);

/// "12 mul, 8 add, 1 sin"; "none" if nothing is computed.
std::string cost_text(const program::Cost& cost);
/// "+12 mul, -1 add", or "0": what is more of them.
std::string change_text(const program::Cost& with, const program::Cost& without);

}  // namespace treedyn::emit
