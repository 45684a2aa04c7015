// Constant expressions of a model file (`pi/2`, `sqrt(3)/2`, `0.433*H`), exact until they are
// evaluated.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "common/real.hpp"
#include "common/text_error.hpp"

namespace treedyn::expressions {

/// Named constants and the expressions that use them, of common/grammar.hpp.
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
  /// \throws TextError for a mistake in the expression or a name that is taken or not an
  /// identifier.
  void define(const std::string& name, std::string_view text);
  /// The same for a value that is known at run time only: `number` makes it of that of `text`.
  void define_at_run_time(const std::string& name, std::string_view text,
                          const std::function<Real(const Real&)>& number);

  /// The value with 50 digits; a value below 1e-80 is what exact zeros leave and becomes 0.
  /// \param run_time  it may use names whose values are known at run time only
  /// \throws TextError
  [[nodiscard]] Real evaluate(std::string_view text, bool run_time = false) const;

  struct Table;
  [[nodiscard]] const Table& table() const { return *table_; }

 private:
  void check_name(const std::string& name) const;

  std::unique_ptr<Table> table_;
};

}  // namespace treedyn::expressions
