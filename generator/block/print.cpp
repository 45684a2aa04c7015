#include "block/print.hpp"

#include <fmt/format.h>

namespace treedyn::block {
namespace {

// How tightly an expression binds: an operand that binds less than its place needs is put in
// brackets.
enum class Binding { kSum, kProduct, kAtom };

std::string text(const Expression& e, Binding needed);

std::string sum(const Expression& e) {
  std::string result;
  for (const Expression& term : e.operands()) {
    const std::string next = text(term, Binding::kSum);
    if (result.empty()) {
      result = next;
    } else if (next.starts_with('-')) {
      result += fmt::format(" - {}", next.substr(1));
    } else {
      result += fmt::format(" + {}", next);
    }
  }
  return result;
}

std::string product(const Expression& e) {
  std::string result;
  for (const Expression& factor : e.operands()) {
    result += fmt::format("{}{}", result.empty() ? "" : " ", text(factor, Binding::kAtom));
  }
  return result;
}

std::string scaled(const Expression& e) {
  const Ratio& factor = e.node().factor;
  const Expression& operand = e.operands().front();
  const std::string body = text(operand, Binding::kProduct);
  if (factor.denominator != 1) {
    return fmt::format("{}/{} {}", factor.numerator, factor.denominator, body);
  }
  if (factor.numerator == -1) {
    return fmt::format("-{}", body);
  }
  return fmt::format("{} {}", factor.numerator, body);
}

/// z^d becomes z^dT, J^T becomes J; anything that is not one word takes brackets.
std::string transposed(const Expression& e) {
  const Expression& operand = e.operands().front();
  const bool symbol = operand.kind() == Kind::kLeaf || operand.kind() == Kind::kNamed;
  if (!symbol) {
    return fmt::format("({})^T", text(operand, Binding::kSum));
  }
  const std::string& name = operand.node().name;
  if (name.ends_with("^T")) {
    return name.substr(0, name.size() - 2);
  }
  const bool superscript = name.find('^') != std::string::npos;
  return fmt::format("{}{}", name, superscript ? "T" : "^T");
}

/// "D - E" reads "D-E" inside a product.
std::string compact(const std::string& sum) {
  constexpr std::size_t kShort = 9;
  const std::size_t minus = sum.find(" - ");
  if (sum.size() > kShort || minus == std::string::npos) {
    return sum;
  }
  return fmt::format("{}-{}", sum.substr(0, minus), sum.substr(minus + 3));
}

std::string text(const Expression& e, Binding needed) {
  switch (e.kind()) {
    case Kind::kLeaf:
    case Kind::kNamed:
      return e.node().name;
    case Kind::kSum:
      return needed == Binding::kSum ? sum(e) : fmt::format("({})", compact(sum(e)));
    case Kind::kProduct:
      return needed == Binding::kAtom ? fmt::format("({})", product(e)) : product(e);
    case Kind::kScaled:
      return needed == Binding::kSum ? scaled(e) : fmt::format("({})", scaled(e));
    case Kind::kTranspose:
      return transposed(e);
    case Kind::kSkew:
      return fmt::format("Λ({})", text(e.operands().front(), Binding::kSum));
    case Kind::kSkewTranspose:
      return fmt::format("Λ^T({})", text(e.operands().front(), Binding::kSum));
    case Kind::kDiagonal:
      return fmt::format("diagb({})", text(e.operands().front(), Binding::kSum));
  }
  return {};
}

}  // namespace

std::string print(const Expression& expression) { return text(expression, Binding::kSum); }

std::string print_definition(const Expression& expression) {
  if (expression.kind() != Kind::kNamed) {
    return print(expression);
  }
  return expression.node().name + " = " + print(expression.operands().front());
}

}  // namespace treedyn::block
