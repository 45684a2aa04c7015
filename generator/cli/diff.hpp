// Differences between two texts, as `diff -u` writes them.
#pragma once

#include <string>
#include <string_view>

namespace treedyn {

/// Unified diff with three lines of context; empty if the texts are equal. The shortest one (Myers
/// 1986) unless the texts differ in more than some thousand lines.
std::string unified_diff(std::string_view old_text, std::string_view new_text,
                         const std::string& old_label, const std::string& new_label);

}  // namespace treedyn
