#include "formulate/scene_values.hpp"

#include "common/error.hpp"

namespace treedyn::formulate {

namespace {

using program::Ref;

/// An expression with the functions that it is short of.
struct Term {
  Graph* graph = nullptr;
  Expr value;

  Term operator-() const { return {graph, -value}; }
  friend Term operator+(const Term& a, const Term& b) { return {a.graph, a.value + b.value}; }
  friend Term operator-(const Term& a, const Term& b) { return {a.graph, a.value - b.value}; }
  friend Term operator*(const Term& a, const Term& b) { return {a.graph, a.value * b.value}; }
  /// \throws InputError if b is zero in every position
  friend Term operator/(const Term& a, const Term& b) {
    if (b.value.is_zero()) {
      throw InputError({},
                       "an expression or a law of the scene divides by what is zero in every "
                       "position, like the length of a spring; expected another one");
    }
    return {a.graph, a.value / b.value};
  }
  friend Term sqrt(const Term& a) { return {a.graph, {*a.graph, a.graph->sqrt(a.value.ref())}}; }
  friend Term sin(const Term& a) { return {a.graph, {*a.graph, a.graph->sin(a.value.ref())}}; }
  friend Term cos(const Term& a) { return {a.graph, {*a.graph, a.graph->cos(a.value.ref())}}; }
};

}  // namespace

Expr value_of(Graph& graph, const model::Expression& expression, const Meaning& meaning) {
  const auto number = [&](const Real& x) {
    return Term{&graph, constant(graph, x)};
  };
  const auto variable = [&](const model::Variable& v) {
    return Term{&graph, meaning(v)};
  };
  return expression.evaluate<Term>(number, variable).value;
}

Vec3 value_of(Graph& graph, const model::VectorExpression& expression, const Meaning& meaning) {
  Vec3 v;
  for (std::size_t n = 0; n < 3; ++n) {
    v[n] = value_of(graph, expression[n], meaning);
  }
  return v;
}

}  // namespace treedyn::formulate
