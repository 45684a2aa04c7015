// Characters of text that people wrote, whatever the locale.
#pragma once

#include <cstddef>
#include <string_view>

namespace treedyn {

/// The length of the UTF-8 character that begins `text` (RFC 3629), 0 if there is none: overlong
/// forms and surrogates are none.
std::size_t utf8_length(std::string_view text);

}  // namespace treedyn
