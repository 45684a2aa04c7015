// The text of templates/, with @slots@ filled.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace treedyn::emit {

/// A file of the folder templates/, built into the program. \pre `name` is one of them.
std::string_view template_text(std::string_view name);

/// `text` with every `@slot@` replaced by its value; a slot alone on its line whose value is empty
/// takes the line with it. An unknown or an unused slot is a broken invariant.
std::string fill(std::string_view text, const std::map<std::string, std::string>& slots);

/// Text with `<`, `>` and `&` as HTML and SVG write them.
std::string html_text(std::string_view text);

}  // namespace treedyn::emit
