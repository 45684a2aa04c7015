// Differences between two texts, as `diff -u` writes them.
#pragma once

#include <string>
#include <string_view>

namespace treedyn {

/// Unified diff with three lines of context; empty if the texts are equal. The shortest one (Myers
/// 1986) unless the texts differ in more than some thousand lines.
std::string unified_diff(std::string_view old_text, std::string_view new_text,
                         const std::string& old_label, const std::string& new_label);

/// The text with every literal of a program replaced by `#`: decimals (a point or an exponent),
/// hexadecimal digests. Equal for two generated files: they differ in constants only.
std::string without_literals(std::string_view text);

/// Lines that a diff adds, or those that it removes if they are more.
int changed_lines(std::string_view old_text, std::string_view new_text);

}  // namespace treedyn
