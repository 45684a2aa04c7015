// Scalar expressions as a graph in which every value exists once.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "common/real.hpp"

namespace treedyn::program {

/// A value: 0 is the number zero, +k is node k, -k its negative. A sign is part of the use of a
/// value and costs nothing.
using Ref = std::int32_t;

/// The position of the node that `a` or its negative is.
constexpr std::size_t node_index(Ref a) { return to_index(a < 0 ? -a : a); }
/// `value`, negated where `sign` is negative.
constexpr Ref with_sign(Ref value, Ref sign) { return sign < 0 ? -value : value; }

/// Input arrays from this number on hold numbers that are known when code is generated, but are not
/// the same in all limbs that share it (limbs.hpp).
inline constexpr int kFixedArrays = 1 << 20;

enum class Kind : std::uint8_t { kConstant, kInput, kAdd, kMultiply, kDivide, kSin, kCos, kSqrt };
/// Sums, products and quotients.
constexpr bool is_arithmetic(Kind kind) { return kind >= Kind::kAdd && kind <= Kind::kDivide; }

/// One node. kConstant: a = index of the (positive) constant. kInput: a = array, b = element.
/// kAdd: a > 0, b of either sign. kMultiply, kDivide, kSin, kCos: operands positive. kSqrt: of
/// either sign. b is unused by functions.
struct Node {
  Kind kind = Kind::kConstant;
  Ref a = 0;
  Ref b = 0;
  bool operator==(const Node&) const = default;
};

/// How a reader of the generated code would call a value: symbol, body, component ("omega", 3,
/// "x"). Pointers to string literals; nullptr: no name, a numbered temporary of the body. A value
/// and its negative may have different names.
struct Hint {
  const char* symbol = nullptr;
  int body = -1;
  const char* component = nullptr;
};

/// Grows by hash-consing: equal operations on equal operands are the same node, so shared
/// subexpressions are shared from the start; zeros, ones and constant operations vanish here.
///
/// Node numbers are given in order of creation, therefore ascending order is a valid order of
/// evaluation, and the same calls give the same graph on every run. The order within a `section`
/// is the compiler's, which evaluates the operands of a + b in any order: see `canonical`.
class Graph {
 public:
  Graph();

  Ref constant(const Real& value);
  Ref input(int array, int element);
  Ref add(Ref a, Ref b);
  Ref multiply(Ref a, Ref b);
  Ref divide(Ref a, Ref b);
  Ref sin(Ref a);
  Ref cos(Ref a);
  Ref sqrt(Ref a);

  [[nodiscard]] bool is_constant(Ref a) const;
  [[nodiscard]] bool is_operation(Ref a) const { return a != 0 && node(a).kind >= Kind::kAdd; }
  /// True if no argument of the function is needed: a constant, or made of constants of limbs.
  [[nodiscard]] bool is_fixed(Ref a) const { return a == 0 || fixed_[node_index(a)]; }
  /// \pre is_constant(a)
  [[nodiscard]] Real value(Ref a) const;
  [[nodiscard]] const Node& node(Ref a) const { return nodes_[node_index(a)]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  /// Names the value `a` unless it has a name already or is a constant or an input. Begins a
  /// section.
  void name(Ref a, const char* symbol, int body, const char* component = nullptr);
  [[nodiscard]] const Hint& hint(Ref a) const { return hints_[hint_index(a)]; }
  void set_hint(Ref a, const Hint& hint) { hints_[hint_index(a)] = hint; }
  /// The body that new nodes belong to (temporaries are numbered per body). Begins a section.
  void set_body(int body);
  /// The section in which a node was made: ascending numbers of the stretches of code between two
  /// calls of `name` or `set_body`.
  [[nodiscard]] int section(Ref a) const { return sections_[node_index(a)]; }

 private:
  static std::size_t hint_index(Ref a) { return 2 * node_index(a) + to_index(a < 0); }
  Ref make(Kind kind, Ref a, Ref b);
  Ref add_constant(Ref sum, Ref constant);
  [[nodiscard]] bool is_one(Ref a) const;

  /// The place of a node in the table, its own or an empty one.
  [[nodiscard]] std::size_t slot(const Node& node) const;
  void grow_table();

  std::vector<Node> nodes_;
  std::vector<Hint> hints_;  ///< two for each node: of its value, of the negative
  std::vector<int> sections_;
  std::vector<bool> fixed_;
  std::vector<Real> constants_;
  std::vector<Ref>
      table_;  ///< nodes by their hash, 0 where there is none; a power of two, half full
  std::multimap<double, Ref> constant_table_;
  int body_ = -1;
  int section_ = 0;
};

/// Calls `visit(operand)` for every operand of a node that is itself a node.
template <class Visit>
void for_each_operand(const Node& node, Visit visit) {
  if (node.kind == Kind::kConstant || node.kind == Kind::kInput) {
    return;
  }
  visit(node.a);
  if (node.b != 0) {
    visit(node.b);
  }
}

/// The nodes that `outputs` need, ascending: a valid order of evaluation.
std::vector<Ref> reachable(const Graph& graph, std::span<const Ref> outputs);

/// An expression with the operators of mathematics; a default-constructed one is zero.
class Expr {
 public:
  Expr() = default;
  Expr(Graph& graph, Ref ref) : graph_(&graph), ref_(ref) {}

  [[nodiscard]] Ref ref() const { return ref_; }
  [[nodiscard]] bool is_zero() const { return ref_ == 0; }
  [[nodiscard]] bool is_constant() const { return ref_ == 0 || graph_->is_constant(ref_); }
  [[nodiscard]] bool is_fixed() const { return ref_ == 0 || graph_->is_fixed(ref_); }
  [[nodiscard]] Real value() const { return ref_ == 0 ? Real(0) : graph_->value(ref_); }
  bool operator==(const Expr& other) const { return ref_ == other.ref_; }

  Expr operator-() const { return Expr(graph_, -ref_); }
  friend Expr operator+(Expr a, Expr b) { return combine(a, b, a.ref_, b.ref_); }
  friend Expr operator-(Expr a, Expr b) { return combine(a, b, a.ref_, -b.ref_); }
  friend Expr operator*(Expr a, Expr b) {
    return a.is_zero() || b.is_zero() ? Expr() : Expr(a.graph_, a.graph_->multiply(a.ref_, b.ref_));
  }
  friend Expr operator/(Expr a, Expr b) {
    return a.is_zero() ? Expr() : Expr(a.graph_, a.graph_->divide(a.ref_, b.ref_));
  }
  Expr& operator+=(Expr other) { return *this = *this + other; }
  Expr& operator-=(Expr other) { return *this = *this - other; }

 private:
  Expr(Graph* graph, Ref ref) : graph_(graph), ref_(ref) {}
  static Expr combine(Expr a, Expr b, Ref x, Ref y) {
    Graph* graph = a.graph_ != nullptr ? a.graph_ : b.graph_;
    return x == 0 && y == 0 ? Expr() : Expr(graph, graph->add(x, y));
  }

  Graph* graph_ = nullptr;
  Ref ref_ = 0;
};

/// Element `element` of an argument of the function.
inline Expr input(Graph& graph, int array, int element) {
  return {graph, graph.input(array, element)};
}

}  // namespace treedyn::program
