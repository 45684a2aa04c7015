#include "common/error.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace treedyn {

namespace {

/// A path with its control characters escaped: it may stand in a file that somebody else wrote.
std::string printable(const std::string& path) {
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string to_string(const Location& where) {
  std::string file = printable(where.file);
  if (where.line <= 0) {
    return file;
  }
  return where.column <= 0 ? fmt::format("{}:{}", file, where.line)
                           : fmt::format("{}:{}:{}", file, where.line, where.column);
}

InputError::InputError(const Location& where, const std::string& message)
    : std::runtime_error(fmt::format("{}: {}", to_string(where), message)),
      where_(where),
      message_(message) {}

void broken_invariant(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "treedyn: broken invariant at %s:%d: %s\n", file, line, condition);
  std::abort();
}

}  // namespace treedyn
