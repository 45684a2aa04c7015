#include "block/rewrite.hpp"

#include <algorithm>
#include <numeric>

namespace treedyn::block {
namespace {

Expression push_into_sum(const std::vector<Expression>& terms) {
  return std::accumulate(
      terms.begin() + 1, terms.end(), push_transpose(terms.front()),
      [](const Expression& sum, const Expression& term) { return sum + push_transpose(term); });
}

Expression push_into_product(const std::vector<Expression>& factors) {
  return std::accumulate(factors.rbegin() + 1, factors.rend(), push_transpose(factors.back()),
                         [](const Expression& product, const Expression& factor) {
                           return product * push_transpose(factor);
                         });
}

}  // namespace

Expression push_transpose(const Expression& e) {
  const std::vector<Expression>& x = e.operands();
  switch (e.kind()) {
    case Kind::kNamed:
      return push_transpose(x.front());
    case Kind::kTranspose:
      return x.front();
    case Kind::kScaled:
      return e.node().factor * push_transpose(x.front());
    case Kind::kSum:
      return push_into_sum(x);
    case Kind::kProduct:
      return push_into_product(x);
    default:
      return transpose(e);
  }
}

bool constant_expression(const Expression& e) {
  if (e.kind() == Kind::kLeaf) {
    return is_constant(e.node().structure);
  }
  return std::all_of(e.operands().begin(), e.operands().end(), constant_expression);
}

void flatten(const Expression& e, std::vector<Expression>& factors, Ratio& factor) {
  switch (e.kind()) {
    case Kind::kNamed:
      return flatten(e.operands().front(), factors, factor);
    case Kind::kScaled:
      factor.numerator *= e.node().factor.numerator;
      factor.denominator *= e.node().factor.denominator;
      return flatten(e.operands().front(), factors, factor);
    case Kind::kProduct:
      for (const Expression& operand : e.operands()) {
        flatten(operand, factors, factor);
      }
      return;
    default:
      factors.push_back(e);
  }
}

}  // namespace treedyn::block
