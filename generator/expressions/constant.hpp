// Constant expressions of a model file (`pi/2`, `sqrt(3)/2`, `0.433*H`), exact until they are
// evaluated.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/real.hpp"

namespace treedyn::expressions {

/// A mistake in an expression: `offset` bytes after its first character.
class ConstantError : public std::runtime_error {
 public:
  ConstantError(std::size_t offset, const std::string& message)
      : std::runtime_error(message), offset_(offset) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// Named constants and the expressions that use them.
///
///     sum     := product { ("+" | "-") product }         product := factor { ("*" | "/") factor }
///     factor  := { "+" | "-" } primary [ "^" factor ]    primary := number | name | function "("
///     sum ")" | "(" sum ")"
///
/// Functions: sqrt sin cos tan asin acos atan (radians). `pi` is predefined. Time and memory are
/// bounded: length, nesting, size after substitution of parameters, exponents and magnitudes have
/// limits.
class Constants {
 public:
  Constants();
  ~Constants();
  Constants(Constants&&) noexcept;
  Constants& operator=(Constants&&) noexcept;
  Constants(const Constants&) = delete;
  Constants& operator=(const Constants&) = delete;

  /// Gives `name` the exact value of `text`, which may use names defined before.
  /// \throws ConstantError for a mistake in the expression or a name that is taken or not an
  /// identifier.
  void define(const std::string& name, std::string_view text);
  /// The same for a value that is known at run time only: `number` makes it of that of `text`.
  void define_at_run_time(const std::string& name, std::string_view text,
                          const std::function<Real(const Real&)>& number);

  /// The value with 50 digits; a value below 1e-80 is what exact zeros leave and becomes 0.
  /// \param run_time  it may use names whose values are known at run time only
  /// \throws ConstantError
  [[nodiscard]] Real evaluate(std::string_view text, bool run_time = false) const;

  struct Table;
  [[nodiscard]] const Table& table() const { return *table_; }

 private:
  void check_name(const std::string& name) const;

  std::unique_ptr<Table> table_;
};

}  // namespace treedyn::expressions
