// How to compute block expressions for one tree: zero blocks, path sums and the order of products.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "block/block.hpp"
#include "block/pattern.hpp"
#include "block/step.hpp"

namespace treedyn::block {

/// Steps that compute any number of expressions for one tree; no numbers, so any scalar type may
/// run it.
///
/// Zero blocks never become terms, products with D, D^T, D-E and D^T-E are path sums, products of
/// several factors are associated for the fewest multiplications (a column from the right, through
/// the terms of sums), and equal subexpressions are computed once.
class Plan {
 public:
  explicit Plan(Index index);

  /// Adds the steps of `expression` that are not there yet; returns the step that is its value.
  int add(const Expression& expression);

  [[nodiscard]] const Index& index() const { return index_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const Step& step(int i) const { return steps_[static_cast<std::size_t>(i)]; }
  /// Numbers that the blocks of all steps hold.
  [[nodiscard]] int storage() const { return storage_; }
  /// The steps that `results` are computed from, themselves included, in order; no leaves, no
  /// constants.
  [[nodiscard]] std::vector<int> needed(const std::vector<int>& results) const;
  /// The step of the leaf `name`, -1 if no expression uses it.
  [[nodiscard]] int leaf(const std::string& name) const;

 private:
  using Key = std::vector<int>;
  struct Scaled {
    int step = -1;
    Ratio factor;
  };

  int append(Step step);
  int constant(Step step);
  template <class Make>
  int once(const Key& key, const std::vector<int>& ids, Make make);
  [[nodiscard]] std::vector<const Step*> operands(const std::vector<int>& ids) const;
  [[nodiscard]] bool is_constant(const std::vector<int>& ids) const;

  int add_leaf(const Expression& e);
  int add_terms(const Expression& sum);
  int add_sum(const std::vector<Scaled>& terms);
  int add_unary(const Expression& e);
  int add_product(const Expression& e);
  int apply(const Expression& e, int column);
  int apply_terms(const Expression& sum, int column);
  int multiply(int a, int b);
  int path_sum(const PathSum& sum, int matrix, int x);
  int chain(const std::vector<int>& factors);
  [[nodiscard]] const PathSum* as_path_sum(int step) const;

  Index index_;
  std::vector<Step> steps_;
  std::map<std::string, int> leaves_;
  std::map<Key, int> known_;
  std::map<std::pair<Pattern, std::vector<int>>, int> constants_;
  std::map<int, PathSum> path_sums_;
  int identity_ = -1;
  int storage_ = 0;
};

/// The zero pattern of `expression` for a tree.
Pattern pattern(const Expression& expression, const Index& index);

}  // namespace treedyn::block
