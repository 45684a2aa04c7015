// Texts of block expressions: "1/2 * T(qd) * (A * qd)".
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "block/block.hpp"
#include "common/real.hpp"

namespace treedyn::equations {

/// A mistake `offset` bytes after the first character.
class TextError : public std::runtime_error {
 public:
  TextError(std::size_t offset, const std::string& message)
      : std::runtime_error(message), offset_(offset) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

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

/// sum     := product { ("+" | "-") product }
/// product := factor { ("*" | "/") factor }
/// factor  := { "+" | "-" } primary [ "^" factor ]
/// primary := number | name | name "(" .. ")" | "(" sum ")"
/// \throws TextError
block::Expression parse(std::string_view text, const Scope& scope);

}  // namespace treedyn::equations
