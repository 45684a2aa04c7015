// Names of a file made C++ identifiers, INTERFACE.md 3.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treedyn {

// Bytes of names and numbers, the same in every locale.
bool is_digit(char c);      ///< [0-9]
bool is_letter(char c);     ///< [A-Za-z_]
bool is_word_byte(char c);  ///< [A-Za-z0-9_]

/// True if `word` stands in `text`, not as a part of a longer word.
bool has_word(std::string_view text, std::string_view word);

/// What stands between separators; the whole text if there are none.
std::vector<std::string> split(std::string_view text, char separator);

/// What stands between white space.
std::vector<std::string> words_in(std::string_view text);

/// `text` with `_` for every byte outside [A-Za-z0-9_].
std::string identifier_part(std::string_view text);

/// True for what no identifier may be: keywords of C, C++ and the GNU modes of their compilers,
/// names that C headers or the compiler's environment define as macros (`NULL`, `NAN`, `linux`),
/// and `std`.
bool is_reserved_word(std::string_view name);

/// True for reserved words, and for what a namespace or a local must avoid besides: names that C
/// headers put into the global namespace (`signbit`, `index`, `y0`), and `main`.
bool is_reserved(std::string_view name);

/// `name` as a C++ identifier: every byte outside [A-Za-z0-9_] becomes `_`; a leading digit or `_`
/// gets the prefix `n`; a reserved word gets a trailing `_`. Different names may give the same
/// identifier.
std::string to_identifier(std::string_view name);

}  // namespace treedyn
