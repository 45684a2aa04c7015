// Expressions of a scene: time, joint motion and the motion of a point, with what generated code
// may call.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "common/error.hpp"
#include "common/real.hpp"
#include "model/scene_number.hpp"

namespace treedyn::model {

/// What a variable stands for.
enum class Quantity : std::uint8_t {
  kTime,           ///< t, s
  kPosition,       ///< q[index], rad or m
  kVelocity,       ///< qd[index], rad/s or m/s
  kPointPosition,  ///< x, y, z of the point that the expression belongs to, base frame, m
  kPointVelocity,  ///< vx, vy, vz of this point, m/s
  kDepth,          ///< depth of this point below its plane, m
  kRaisedDepth,    ///< this depth to the power of the contact's exponent
  kNormalSpeed,    ///< velocity of this point along the plane's normal, m/s
  kPress,          ///< the force along this normal, N
};

struct Variable {
  Quantity quantity = Quantity::kTime;
  int index = 0;  ///< joint, or component 0, 1, 2
  bool operator==(const Variable&) const = default;
};

/// A value that depends on variables by + - * /, integer powers, sqrt, sin and cos.
///
/// Immutable; a program in postfix order. Operations on constants, and with 0 and 1, are done at
/// once, therefore a constant expression is one number. Numbers of an effect are no constants:
/// they stand as what they are in every operation.
class Expression {
 public:
  Expression() : Expression(Real(0)) {}
  Expression(const Real& constant)  // NOLINT(google-explicit-constructor): numbers are expressions
      : program_{{Operation::kConstant, constant, static_cast<double>(constant), {}, 0}} {}
  /// A number of an effect; a constant if it is 0.
  Expression(const Real& number, SceneNumber what) : Expression(number) {
    if (number != 0) {
      program_.front().what = what;
    }
  }
  explicit Expression(Variable variable) : program_{{Operation::kVariable, 0, 0, variable, 0}} {}

  Expression operator-() const;
  friend Expression operator+(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b);
  friend Expression operator*(const Expression& a, const Expression& b);
  /// \pre `b` is not the constant 0
  friend Expression operator/(const Expression& a, const Expression& b);
  /// \pre exponent >= 1
  friend Expression power(const Expression& a, int exponent);
  /// \pre `a` is no negative constant
  friend Expression sqrt(const Expression& a);
  friend Expression sin(const Expression& a);
  friend Expression cos(const Expression& a);
  /// The same program.
  friend bool operator==(const Expression& a, const Expression& b) {
    return a.program_ == b.program_;
  }

  [[nodiscard]] bool is_constant() const {
    const Instruction& first = program_.front();
    return first.operation == Operation::kConstant && !first.what && program_.size() == 1;
  }
  [[nodiscard]] bool is_zero() const { return is_constant() && value() == 0; }
  /// \pre is_constant()
  [[nodiscard]] const Real& value() const {
    TREEDYN_EXPECT(is_constant());
    return program_.front().constant;
  }
  [[nodiscard]] bool uses(Quantity quantity) const;
  [[nodiscard]] std::size_t size() const { return program_.size(); }
  /// Calls `change` for its numbers, in the order of its program.
  /// \param change  Real&, what it is of an effect ->; zero and one have to stay
  template <class Change>
  void change_constants(Change change) {
    for (Instruction& instruction : program_) {
      if (instruction.operation == Operation::kConstant) {
        change(instruction.constant, instruction.what);
        instruction.rounded = static_cast<double>(instruction.constant);
      }
    }
  }

  /// The value in a type with operators + - * / and, found by their arguments, sqrt, sin and cos:
  /// double, or the expressions of a program. Operations are done in the order of the program.
  /// \param constant  Real -> Value, or double -> Value
  /// \param variable  Variable -> Value
  template <class Value, class OfConstant, class OfVariable>
  Value evaluate(const OfConstant& constant, const OfVariable& variable) const;

  /// The value in double. \param variable  Variable -> double
  template <class OfVariable>
  [[nodiscard]] double evaluate(const OfVariable& variable) const;

 private:
  enum class Operation : std::uint8_t {
    kConstant,
    kVariable,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kNegate,
    kPower,
    kSqrt,
    kSin,
    kCos
  };
  struct Instruction {
    Operation operation = Operation::kConstant;
    Real constant = 0;
    double rounded = 0;  ///< the constant as double
    Variable variable;
    int exponent = 0;
    std::optional<SceneNumber> what = {};
    bool operator==(const Instruction&) const = default;
  };

  static Expression joined(const Expression& a, const Expression& b, Operation operation);
  [[nodiscard]] Expression applied(Operation operation, int exponent = 0) const;
  template <class Value>
  static void apply(const Instruction& instruction, std::vector<Value>& stack);
  template <class Value>
  static Value powered(const Value& x, int exponent);

  std::vector<Instruction> program_;
};

/// x^exponent by squaring, as a loop would: x^5 = (x^2)^2 x.
template <class Value>
Value Expression::powered(const Value& x, int exponent) {
  Value result = x;
  int bit = 1;
  while (2 * bit <= exponent) {
    bit *= 2;
  }
  for (bit /= 2; bit > 0; bit /= 2) {
    result = result * result;
    if ((exponent & bit) != 0) {
      result = result * x;
    }
  }
  return result;
}

template <class Value>
void Expression::apply(const Instruction& instruction, std::vector<Value>& stack) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Value b = stack.back();
  const bool binary =
      instruction.operation >= Operation::kAdd && instruction.operation <= Operation::kDivide;
  if (binary) {
    stack.pop_back();
  }
  Value& a = stack.back();
  switch (instruction.operation) {
    case Operation::kAdd:
      a = a + b;
      break;
    case Operation::kSubtract:
      a = a - b;
      break;
    case Operation::kMultiply:
      a = a * b;
      break;
    case Operation::kDivide:
      a = a / b;
      break;
    case Operation::kNegate:
      a = -b;
      break;
    case Operation::kPower:
      a = powered(b, instruction.exponent);
      break;
    case Operation::kSqrt:
      a = sqrt(b);
      break;
    case Operation::kSin:
      a = sin(b);
      break;
    case Operation::kCos:
      a = cos(b);
      break;
    case Operation::kConstant:
    case Operation::kVariable:
      break;
  }
}

template <class Value, class OfConstant, class OfVariable>
Value Expression::evaluate(const OfConstant& constant, const OfVariable& variable) const {
  std::vector<Value> stack;
  for (const Instruction& instruction : program_) {
    if (instruction.operation == Operation::kConstant) {
      if constexpr (std::is_invocable_v<const OfConstant&, const Real&>) {
        stack.push_back(constant(instruction.constant));
      } else {
        stack.push_back(constant(instruction.rounded));
      }
    } else if (instruction.operation == Operation::kVariable) {
      stack.push_back(variable(instruction.variable));
    } else {
      apply(instruction, stack);
    }
  }
  TREEDYN_EXPECT(!stack.empty());
  return stack.back();
}

template <class OfVariable>
double Expression::evaluate(const OfVariable& variable) const {
  return evaluate<double>([](double x) { return x; }, variable);
}

}  // namespace treedyn::model
