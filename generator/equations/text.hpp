// Texts of block expressions: "1/2 * T(qd) * (A * qd)".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "block/block.hpp"
#include "common/real.hpp"
#include "common/text_error.hpp"

namespace treedyn::equations {

/// A constant of a text; a small rational number stays one.
struct Number {
  Real value;
  std::optional<block::Ratio> ratio;
};
using Term = std::variant<Number, block::Expression>;

/// What a text may refer to; every function throws std::runtime_error, without a place, for what it
/// refuses.
struct Scope {
  std::function<Term(const std::string& name)> name;
  /// at, under, above, at_point, R.
  std::function<block::Expression(const std::string& function, const std::string& argument)> of;
  std::function<block::Expression(const Real& value)> number;  ///< a leaf of one number
  std::function<block::Expression(const block::Expression& e)> dot;
  /// 1/e of a single number that the tree alone decides, a leaf.
  std::function<block::Expression(const block::Expression& e)> reciprocal;
  std::function<void(const block::Expression& e)> check;  ///< units
};

/// The grammar is that of common/grammar.hpp, a name followed by "(" is a function.
/// \throws TextError
block::Expression parse(std::string_view text, const Scope& scope);

}  // namespace treedyn::equations
