// Mistakes in expressions.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace treedyn {

/// A mistake in an expression: `offset` bytes after its first character.
class TextError : public std::runtime_error {
 public:
  TextError(std::size_t offset, const std::string& message)
      : std::runtime_error(message), offset_(offset) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

}  // namespace treedyn
