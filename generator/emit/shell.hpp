// Command lines as text that a shell reads back.
#pragma once

#include <string>
#include <vector>

namespace treedyn::emit {

/// Words as one line for a terminal, in POSIX quotes; `$'..'` (bash, zsh) only around words with
/// control characters or bytes that are not UTF-8.
std::string shell_line(const std::vector<std::string>& words);

/// Words as one line that nothing in it can end, nor a comment around it: `$'..'` around words with
/// more than plain characters, blanks and opening parentheses.
std::string shell_comment(const std::vector<std::string>& words);

}  // namespace treedyn::emit
