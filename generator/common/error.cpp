#include "common/error.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace treedyn {

std::string to_string(const Location& where) {
  if (where.line <= 0) {
    return where.file;
  }
  return where.column <= 0 ? fmt::format("{}:{}", where.file, where.line)
                           : fmt::format("{}:{}:{}", where.file, where.line, where.column);
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
