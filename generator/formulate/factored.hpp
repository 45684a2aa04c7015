// Functions of numbers of joints: factors of A, what they solve, the inverse (R12).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formulate/derived.hpp"

namespace treedyn::formulate {

/// What R12 makes of an equation. Leaves are `given`, E, or the last argument of the function.
struct FactoredFunction {
  derive::Derivation derivation;
  std::vector<std::pair<std::string, std::shared_ptr<const Derived>>> given;
};
/// \pre `name` stands in equations::functions() and solves an equation.
const FactoredFunction& factored(const std::string& name);

/// The expressions of the function, in the independent coordinates.
std::vector<Expr> build_factored(const Task& task, const std::string& name);

/// The factors of a matrix that is given, and equations with L.
class Factors {
 public:
  Factors(Graph& graph, int size, const SparseSymmetric& A);

  /// y of L^T y = right.
  [[nodiscard]] SparseRows to_root(const SparseRows& right) const;
  /// x of L x = right.
  [[nodiscard]] std::vector<Expr> from_root(const std::vector<Expr>& right) const;
  [[nodiscard]] Expr inverse_pivot(int k) const {
    return factors_.root(2)[static_cast<std::size_t>(k)].at(k);
  }

 private:
  [[nodiscard]] SparseRows solve(const derive::Derivation& triangle, const SparseRows& right) const;

  Graph& graph_;
  int size_;
  Numbers factors_;
};

/// Operations of every value of the derivation, before any search.
std::vector<program::Cost> costs_of_numbers(const model::Tree& tree, const std::string& name,
                                            const Options& options);

}  // namespace treedyn::formulate
