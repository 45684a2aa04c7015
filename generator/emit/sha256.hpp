// SHA-256 (FIPS 180-4), by which files and runs are told apart.
#pragma once

#include <string>
#include <string_view>

namespace treedyn::emit {

/// 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace treedyn::emit
