#include "model/expression.hpp"

#include <algorithm>

namespace treedyn::model {

Expression Expression::joined(const Expression& a, const Expression& b, Operation operation) {
  Expression result = a;
  result.program_.insert(result.program_.end(), b.program_.begin(), b.program_.end());
  result.program_.push_back({operation, 0, 0, {}, 0});
  return result;
}

Expression Expression::applied(Operation operation, int exponent) const {
  Expression result = *this;
  result.program_.push_back({operation, 0, 0, {}, exponent});
  return result;
}

Expression Expression::operator-() const {
  return is_constant() ? Expression(Real(-value())) : applied(Operation::kNegate);
}

Expression operator+(const Expression& a, const Expression& b) {
  if (a.is_constant() && b.is_constant()) {
    return Real(a.value() + b.value());
  }
  if (a.is_zero() || b.is_zero()) {
    return a.is_zero() ? b : a;
  }
  return Expression::joined(a, b, Expression::Operation::kAdd);
}

Expression operator-(const Expression& a, const Expression& b) {
  if (a.is_constant() && b.is_constant()) {
    return Real(a.value() - b.value());
  }
  if (a.is_zero() || b.is_zero()) {
    return a.is_zero() ? -b : a;
  }
  return Expression::joined(a, b, Expression::Operation::kSubtract);
}

Expression operator*(const Expression& a, const Expression& b) {
  if (a.is_constant() && b.is_constant()) {
    return Real(a.value() * b.value());
  }
  if (a.is_zero() || b.is_zero()) {
    return {};
  }
  if (a.is_constant() && abs(a.value()) == 1) {
    return a.value() == 1 ? b : -b;
  }
  if (b.is_constant() && abs(b.value()) == 1) {
    return b.value() == 1 ? a : -a;
  }
  return Expression::joined(a, b, Expression::Operation::kMultiply);
}

Expression operator/(const Expression& a, const Expression& b) {
  TREEDYN_EXPECT(!b.is_zero());
  if (b.is_constant()) {
    return a.is_constant() ? Expression(Real(a.value() / b.value())) : a * Real(1 / b.value());
  }
  return a.is_zero() ? Expression() : Expression::joined(a, b, Expression::Operation::kDivide);
}

Expression power(const Expression& a, int exponent) {
  TREEDYN_EXPECT(exponent >= 1);
  if (a.is_constant()) {
    return Expression::powered(a.value(), exponent);
  }
  return exponent == 1 ? a : a.applied(Expression::Operation::kPower, exponent);
}

Expression sqrt(const Expression& a) {
  if (a.is_constant()) {
    TREEDYN_EXPECT(a.value().plain() >= 0);
    return Real(sqrt(a.value()));
  }
  return a.applied(Expression::Operation::kSqrt);
}

Expression sin(const Expression& a) {
  return a.is_constant() ? Expression(Real(sin(a.value())))
                         : a.applied(Expression::Operation::kSin);
}

Expression cos(const Expression& a) {
  return a.is_constant() ? Expression(Real(cos(a.value())))
                         : a.applied(Expression::Operation::kCos);
}

bool Expression::uses(Quantity quantity) const {
  return std::ranges::any_of(program_, [quantity](const Instruction& i) {
    return i.operation == Operation::kVariable && i.variable.quantity == quantity;
  });
}

}  // namespace treedyn::model
