// Text of an expression to GiNaC, within limits.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ginac/ginac.h>

#include "expressions/constant.hpp"
#include "expressions/exact.hpp"

namespace treedyn::expressions {

/// An exact value and the number of operations that make it.
struct Exact {
  GiNaC::ex value;
  std::size_t size = 1;
};

using Names = std::map<std::string, Exact, std::less<>>;

/// The parameters behind `Constants`.
struct Constants::Table {
  /// Stands as a symbol among `names`.
  struct AtRunTime {
    std::string name;
    GiNaC::realsymbol symbol;
    Real number;
  };

  Names names;
  std::vector<AtRunTime> at_run_time;
};

/// Names beyond parameters: `name` or `name[index]`.
class Variables {
 public:
  virtual ~Variables() = default;
  /// Nothing for an unknown name.
  [[nodiscard]] virtual std::optional<GiNaC::ex> find(
      std::string_view name, std::optional<std::string_view> index) const = 0;
  /// ", t, q[joint]": what a message about an unknown name expects.
  [[nodiscard]] virtual std::string expected() const = 0;
  /// All there are, as one would write them.
  [[nodiscard]] virtual std::vector<std::string> known() const { return {}; }
};

/// True if no symbol occurs.
bool is_constant(const GiNaC::ex& value);

/// \param variables  nullptr: constants only
/// \throws TextError
Exact parse(std::string_view text, const Names& names, const Variables* variables = nullptr);

/// What GiNaC or CLN refused, as a mistake in the expression.
TextError unreadable(std::string_view text, const std::exception& problem);

/// Everything that GiNaC or CLN may throw of an expression, as a mistake in it.
template <class Read>
auto guarded(std::string_view text, const Read& read) {
  const Precision precision;
  try {
    return read();
  } catch (const TextError&) {
    throw;
  } catch (const std::exception& problem) {  // GiNaC: poles; CLN: overflow
    throw unreadable(text, problem);
  }
}

}  // namespace treedyn::expressions
