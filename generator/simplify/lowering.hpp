// Values of a derivation to expressions: link by link, each in the frame where it is cheap.
#pragma once

#include <optional>
#include <vector>

#include "program/function.hpp"
#include "simplify/blocks.hpp"
#include "simplify/derived.hpp"

namespace treedyn::simplify {

class Lowering {
 public:
  Lowering(const Task& task, const Derived& function, Way way);

  [[nodiscard]] const derive::Derivation& derivation() const { return derivation_; }

  /// Column `k` of what the function derives to: a block for every element of its rows.
  const Blocks& root(int k);
  /// The same where the column that is asked for is `place`, component `component`.
  const Blocks& root_of_unit(int place, int component);

  /// Vectors in the base frame, numbers as they are, one behind the other.
  [[nodiscard]] std::vector<Expr> written(const Blocks& blocks, block::Set set) const;
  [[nodiscard]] int count(block::Set set) const;

  /// Operations that the values took, by their number in the derivation.
  [[nodiscard]] const std::vector<program::Cost>& costs() const { return costs_; }

 private:
  using Value = derive::Value;

  void compute(int id);
  [[nodiscard]] const char* symbol(const Value& v) const;
  Blocks made(const Value& v) const;
  Blocks unit(const Value& v) const;
  Blocks leaf(const Value& v) const;
  Blocks link_leaf(const Value& v) const;
  Blocks input(const Value& v, const equations::UserArgument& argument, int array) const;
  Blocks orientation(const equations::UserFrame& frame) const;
  Blocks linear(const Value& v) const;
  Blocks scale(const Value& v) const;
  Blocks product(const Value& v) const;
  Blocks applied(const Value& v) const;
  Blocks path(const Value& v) const;
  Blocks subtree(const Value& v) const;
  Blocks shifted(const Value& v) const;
  Blocks at_points(const Value& v) const;
  Blocks spread(const Value& v) const;
  Blocks collect(const Value& v) const;
  Blocks components(const Value& v) const;

  [[nodiscard]] const Blocks& of(int id) const { return *memo_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Value& value(int id) const { return derivation_.values[id]; }
  [[nodiscard]] Blocks empty(const Value& v) const;
  [[nodiscard]] std::vector<std::pair<Expr, int>> terms(int id) const;
  [[nodiscard]] int home(block::Set set, int e) const;
  [[nodiscard]] int father(int i) const { return task_.kinematics.link(i).father; }
  [[nodiscard]] int meeting(const Value& v, int e) const;
  [[nodiscard]] Expr number(const Real& x) const;
  [[nodiscard]] Expr element(int array, int k) const;
  [[nodiscard]] Graph& graph() const { return task_.kinematics.graph(); }

  const Task& task_;
  const Derived& function_;
  const derive::Derivation& derivation_;
  FrameChanges frames_;
  std::vector<int> needed_;
  std::vector<bool> of_unit_;  ///< depends on the column that is asked for
  std::vector<std::optional<Blocks>> memo_;
  std::vector<program::Cost> costs_;
  int place_ = 0;
  int component_ = 0;
};

}  // namespace treedyn::simplify
