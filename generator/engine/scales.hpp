// Natural scales: block expressions in which nothing cancels.
#pragma once

#include <span>
#include <vector>

#include "block/evaluate.hpp"

namespace treedyn::engine {

/// Every block of a plan as one number: of a leaf its norm, of a product the product, of a sum the
/// sum of the norms. So the number of a result is the sum of the norms of the terms of its
/// equation, multiplied out down to the leaves, whatever the frame.
class Scales {
 public:
  explicit Scales(const block::Plan& plan);

  /// The norms of the leaves of an evaluation of the same plan, then those of `steps`.
  template <class Scalar>
  void run(const block::Evaluation<Scalar>& evaluation, std::span<const int> steps) {
    for (std::size_t k = 0; k < norms_.size(); ++k) {
      if (plan_.steps()[k].operation == block::Operation::kLeaf) {
        std::vector<double> numbers;
        for (const Scalar& x : evaluation.blocks(static_cast<int>(k))) {
          numbers.push_back(static_cast<double>(x));
        }
        set_leaf(k, numbers);
      }
    }
    for (const int step : steps) {
      compute(static_cast<std::size_t>(step));
    }
  }

  /// One number for every number of a step, row-major as Evaluation::write.
  [[nodiscard]] std::vector<double> values(int step, const block::Shape& shape) const;

 private:
  void set_leaf(std::size_t step, const std::vector<double>& numbers);
  void compute(std::size_t number);

  const block::Plan& plan_;
  std::vector<std::vector<double>> norms_;  ///< by step, one for each block
};

}  // namespace treedyn::engine
