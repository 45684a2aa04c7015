#include "common/error.hpp"

#include <cstdio>
#include <cstdlib>

namespace treedyn {

std::string to_string(const Location& where) {
  std::string text = where.file;
  if (where.line > 0) {
    text += ":" + std::to_string(where.line);
    if (where.column > 0) {
      text += ":" + std::to_string(where.column);
    }
  }
  return text;
}

InputError::InputError(const Location& where, const std::string& message)
    : std::runtime_error(to_string(where) + ": " + message), where_(where), message_(message) {}

void broken_invariant(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "treedyn: broken invariant at %s:%d: %s\n", file, line, condition);
  std::abort();
}

}  // namespace treedyn
