// One operation on block-sparse matrices, spelled out as the blocks it combines.
#pragma once

#include <string>
#include <vector>

#include "block/block.hpp"
#include "block/pattern.hpp"

namespace treedyn::block {

enum class Operation {
  kLeaf,      ///< values from outside
  kConstant,  ///< small integers, known from the tree
  kSum,       ///< sum of factors[k] * operand k
  kProduct,   ///< operand 0 times operand 1
  kPathSum,   ///< D x, D^T x, (D-E) x, .. or x D, ..: every block is a sum along the tree
  kTranspose,
  kSkew,
  kSkewTranspose,
  kDiagonal,
};

/// Adds to block `target` of the result; blocks are numbered as in the patterns.
struct Term {
  int target = 0;
  int left = 0;   ///< block of operand 0 (kSum: of operand `right`; kPathSum: see `right`)
  int right = 0;  ///< kProduct: block of operand 1; kPathSum: 0 operand, 1 the result itself
};

/// A matrix of a plan: where its blocks are and how they come from earlier steps.
struct Step {
  Operation operation = Operation::kLeaf;
  int height = 1;  ///< of a block, 1 or 3
  int width = 1;
  Pattern pattern;
  std::vector<int> operands;   ///< earlier steps
  std::vector<Ratio> factors;  ///< kSum
  std::vector<Term> terms;     ///< in the order of evaluation
  std::vector<int> constants;  ///< kConstant: the value of every block
  std::string name;            ///< kLeaf
  int offset = 0;              ///< of the first number in the plan's storage

  [[nodiscard]] int block_size() const { return height * width; }
  [[nodiscard]] int numbers() const { return pattern.blocks() * block_size(); }
};

/// The path sums that a multiplication by D and its relatives means.
struct PathSum {
  bool subtree = false;   ///< D^T (sum over descendants), else D (sum over ancestors)
  bool strict = false;    ///< without the own term: D-E, D^T-E
  bool on_right = false;  ///< x D: sums run over columns; D as right factor sums over descendants
};

Step constant_step(Pattern pattern, std::vector<int> values);
Step sum_step(const std::vector<const Step*>& operands, std::vector<Ratio> factors);
Step product_step(const Step& a, const Step& b);
Step path_sum_step(const PathSum& sum, const Step& x, const Index& index);
Step transpose_step(const Step& a);
Step skew_step(const Step& a, Operation operation);
Step diagonal_step(const Step& a);

/// The integers of a step whose operands are constants.
Step folded(const Step& step, const std::vector<const Step*>& operands);

}  // namespace treedyn::block
