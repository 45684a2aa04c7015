// Operations on columns of blocks, merged as they are made (R3, R5).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "derive/value.hpp"

namespace treedyn::derive {

/// What R6 and R7 do not cover.
struct NoComposites {};

/// Links as link j of the column sees them.
struct Places {
  bool here = false;    ///< j
  bool above = false;   ///< on the way from j to the root
  bool below = false;   ///< in the subtree of j
  bool beside = false;  ///< anywhere else
};

/// A superset of the links at which value `x` is not zero, if the rows on the way from j to the
/// root are enough to compute those rows of it.
/// \throws NoComposites if they are not: something comes up from below, from beside or from points
Places places(const Values& values, int x);

/// For δ = Σ factor Λ(a)Λ(b) with a, b among w, ω = D w and ω_f = N w: w, if
/// δ = Λ(ω)² - Λ(ω_f)² identically. The candidate is what is left of δ for ω_f = 0; that it
/// telescopes is a polynomial identity in w and ω_f, which is expanded, once for terms alike.
std::optional<int> telescopes(const Values& values, const Terms& terms);

class Algebra {
 public:
  explicit Algebra(Values& values) : values_(values) {}

  int zero(Set set, Type type) { return values_.intern({Op::kZero, set, type, {}, 0, {}, {}}); }
  int ones(Set set) { return values_.intern({Op::kOnes, set, Type::kScalar, {}, 0, {}, {}}); }
  int unit(Set set, Type type) { return values_.intern({Op::kUnit, set, type, {}, 0, {}, {}}); }
  int identity(Set set) {
    return values_.intern({Op::kIdentity, set, Type::kTensor, {}, 0, {}, {}});
  }
  int leaf(const std::string& name, Set set, Type type);

  /// Σ factor * value. \pre `terms` is not empty, all of one set and type.
  int linear(const Terms& terms);
  int negative(int x) { return linear({{{-1, 1}, x}}); }
  /// The sum of what becomes of the terms of a sum. \pre x is kLinear
  template <class Of>
  int of_terms(int x, Of of);
  int scale(int number, int x);
  int dot(int a, int b) { return bilinear(Op::kDot, Type::kScalar, a, b); }
  int cross(int a, int b);
  int skew(int a);
  int skew_product(int a, int b);
  int apply(int tensor, int v) { return bilinear(Op::kApply, Type::kVector, tensor, v); }
  int apply_transposed(int tensor, int v) {
    const bool symmetric = value(tensor).name == "J_c^d" || value(tensor).name == "I^d";
    return bilinear(symmetric ? Op::kApply : Op::kApplyTranspose, Type::kVector, tensor, v);
  }
  /// D, N, D^T, N^T, Π, W, .. times x; the result has a block for every element of `set`.
  int sum_along(Op op, Set set, int x);
  int component(int x, int k);
  /// x on the way from the column that is asked for to the root: without N y, which is zero there.
  /// \pre made with `Choices::composites` \throws NoComposites if N y is not
  int on_way_to_root(int x) { return in_place_of(x, rows_on_way_to_root(x)); }
  int assemble(const std::vector<int>& components);
  /// Steps of links as blocks: a number y stands for y E, a vector a for Λ(a). a b; -1: E.
  int product_of_steps(int a, int b);
  int block_of(int step) { return value(step).type == Type::kVector ? skew(step) : step; }
  int step(int X, int y);

  [[nodiscard]] const Value& value(int id) const { return values_[id]; }
  [[nodiscard]] bool of_unit(int id) const { return values_.of_unit(id); }
  int note(Rule rule, int id) { return values_.note(rule, id); }
  /// `to`, which takes the place of `from`, with the rules that made that.
  int in_place_of(int from, int to);

 private:
  int rows_on_way_to_root(int x);
  [[nodiscard]] bool is_zero(int x) const { return value(x).op == Op::kZero; }
  [[nodiscard]] Set set_of(int a, int b) const;
  /// The factor in front of x, and what it multiplies.
  [[nodiscard]] std::pair<Ratio, int> split(int x) const;
  int turned_twice(int a, int b);
  int bilinear(Op op, Type type, int a, int b);
  int scaled(const std::vector<int>& numbers, int x);
  int telescoped(Op op, int x);
  int of_kind(Op op, Set set, int x);
  int of_common(Op op, Set set, int x);
  int of_weighed_paths(Set set, int x);
  int of_levers(Set set, int x);
  [[nodiscard]] bool has_place(int x) const;
  [[nodiscard]] bool is_common(int x) const {
    return values_.choices().common_leaves &&
           (value(x).name == "g" || (value(x).op == Op::kSpread && !values_.of_unit(x)));
  }
  int common(int x, Set set);
  [[nodiscard]] bool has_centre(int x) const;
  [[nodiscard]] bool has_mass(int x) const;
  [[nodiscard]] bool is_moment(int x) const;
  [[nodiscard]] bool is_turning(int S) const;
  int with_moments(const std::vector<int>& numbers, int x);
  int moment_about_joint(int centre, int x);
  int moment_about_joint(int centre, int x, int h);
  int moment_of_turning(int S);

  /// A sum of terms X (D y), X (N y) and others.
  struct Opened {
    struct Path {
      Ratio factor;
      int step = -1;  ///< X; -1: E
      int y = -1;
      bool strict = false;  ///< N y
    };
    std::vector<Path> paths;
    Terms rest;
  };
  void open_paths(const Ratio& factor, int X, int x, Opened& opened);
  void join(std::vector<Opened::Path>& paths);
  [[nodiscard]] bool has_sum(int x) const;
  int of_composites(Op op, Set set, int x);
  [[nodiscard]] bool is_place(int x) const {
    return value(x).op == Op::kPath && value(value(x).operands.front()).op == Op::kLeaf;
  }
  /// X = a y or Λ(a) Y: a, what it multiplies, and the product with others in their place.
  struct Lever {
    int lever = -1;
    int rest = -1;
    Op op = Op::kScale;
  };
  [[nodiscard]] Lever lever_of(int x);
  int product_of(const Lever& product);
  int with_links(int x, int below);
  int whole_of(int x);
  int of_places(Op op, int x);

  Terms flattened(const Terms& terms);
  int opened(const Terms& terms, int sum);
  [[nodiscard]] int body_of(const Value& v) const;
  void merge_sums(Terms& terms);
  void merge_backward(Terms& terms);
  void merge_skews(Terms& terms);
  void merge_factors(Terms& terms);
  void merge_skew_products(Terms& terms);
  void merge_levers(Terms& terms, std::size_t common);
  void merge_seconds(Terms& terms);
  void merge_applied(Terms& terms);
  /// Replaces the terms for which `key` is the same, if there are several, by `merged` of them.
  template <class Key, class Merged>
  void merge(Terms& terms, Key key, Merged merged);
  /// The sum of what `operand` takes of the value of every term.
  template <class Operand>
  int summed(const Terms& terms, Operand operand);

  Values& values_;
};

template <class Of>
int Algebra::of_terms(int x, Of of) {
  const Value v = value(x);
  Terms terms;
  for (std::size_t k = 0; k < v.operands.size(); ++k) {
    terms.emplace_back(v.factors[k], of(v.operands[k]));
  }
  return in_place_of(x, linear(terms));
}

}  // namespace treedyn::derive
