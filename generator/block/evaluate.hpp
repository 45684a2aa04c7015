// Runs a plan on numbers (or on symbols) of any scalar type that Eigen takes.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "block/plan.hpp"
#include "common/error.hpp"

namespace treedyn::block {

/// The values of all steps of a plan. Every buffer is allocated by the constructor; `run` allocates
/// nothing (unless the scalar type does).
template <class Scalar>
class Evaluation {
 public:
  /// \pre `plan` outlives this object and gets no further steps.
  explicit Evaluation(const Plan& plan);

  /// The blocks of a leaf, one after the other, each row-major; empty if no expression uses it.
  std::span<Scalar> leaf(const std::string& name);

  /// Computes the given steps (`Plan::needed`) from the leaves.
  void run(std::span<const int> steps);

  /// The blocks of a step.
  [[nodiscard]] std::span<const Scalar> blocks(int step) const;

  /// Writes a step row-major, zero blocks included; 1x1 blocks that `shape` wants as 3x3 become
  /// multiples of the unit matrix. \pre `out` fits `shape`.
  void write(int step, const Shape& shape, std::span<Scalar> out) const;

 private:
  Scalar* data(const Step& step) { return values_.data() + step.offset; }
  std::span<Scalar> block(const Step& step, int n) {
    const int size = step.block_size();
    return {data(step) + n * size, static_cast<std::size_t>(size)};
  }
  void run(const Step& step);
  void sum(const Step& step);
  void product(const Step& step);
  void path_sum(const Step& step);
  void transpose(const Step& step);
  void skew(const Step& step, bool transposed);

  const Plan* plan_;
  std::vector<Scalar> values_;
};

template <class Scalar>
Evaluation<Scalar>::Evaluation(const Plan& plan)
    : plan_(&plan), values_(static_cast<std::size_t>(plan.storage()), Scalar(0)) {
  for (const Step& step : plan.steps()) {
    for (std::size_t block = 0; block < step.constants.size(); ++block) {
      data(step)[block] = Scalar(step.constants[block]);
    }
  }
}

template <class Scalar>
std::span<Scalar> Evaluation<Scalar>::leaf(const std::string& name) {
  const int step = plan_->leaf(name);
  if (step < 0) {
    return {};
  }
  return {data(plan_->step(step)), static_cast<std::size_t>(plan_->step(step).numbers())};
}

template <class Scalar>
std::span<const Scalar> Evaluation<Scalar>::blocks(int step) const {
  const Step& s = plan_->step(step);
  return {values_.data() + s.offset, static_cast<std::size_t>(s.numbers())};
}

template <class Scalar>
void Evaluation<Scalar>::run(std::span<const int> steps) {
  for (const int step : steps) {
    run(plan_->step(step));
  }
}

template <class Scalar>
void Evaluation<Scalar>::run(const Step& step) {
  std::fill_n(data(step), step.numbers(), Scalar(0));
  switch (step.operation) {
    case Operation::kLeaf:
    case Operation::kConstant:
      return;
    case Operation::kSum:
      return sum(step);
    case Operation::kProduct:
      return product(step);
    case Operation::kPathSum:
    case Operation::kDiagonal:
      return path_sum(step);
    case Operation::kTranspose:
      return transpose(step);
    case Operation::kSkew:
      return skew(step, false);
    case Operation::kSkewTranspose:
      return skew(step, true);
  }
}

namespace detail {

/// y += factor * x for blocks `width` wide; by the size rule a single number x stands for x times
/// the unit matrix.
template <class Scalar>
void add_block(const Scalar& factor, std::span<const Scalar> x, std::span<Scalar> y, int width) {
  const bool single = x.size() != y.size();
  const std::size_t stride = single ? static_cast<std::size_t>(width) + 1 : 1;
  for (std::size_t n = 0; n < y.size(); n += stride) {
    y[n] += factor * x[single ? 0 : n];
  }
}

}  // namespace detail

template <class Scalar>
void Evaluation<Scalar>::sum(const Step& step) {
  for (const Term& term : step.terms) {
    const auto k = static_cast<std::size_t>(term.right);
    const Ratio& ratio = step.factors[k];
    const Scalar factor = Scalar(ratio.numerator) / Scalar(ratio.denominator);
    detail::add_block<Scalar>(factor, block(plan_->step(step.operands[k]), term.left),
                              block(step, term.target), step.width);
  }
}

template <class Scalar>
void Evaluation<Scalar>::path_sum(const Step& step) {
  const int size = step.block_size();
  for (const Term& term : step.terms) {
    const Scalar* from = term.right == 1 ? data(step) : data(plan_->step(step.operands.front()));
    Scalar* to = data(step) + term.target * size;
    for (int n = 0; n < size; ++n) {
      to[n] += from[term.left * size + n];
    }
  }
}

template <class Scalar>
void Evaluation<Scalar>::transpose(const Step& step) {
  const int size = step.block_size();
  const Scalar* source = data(plan_->step(step.operands.front()));
  for (const Term& term : step.terms) {
    for (int n = 0; n < size; ++n) {
      const int i = n / step.width;
      const int j = n % step.width;
      data(step)[term.target * size + n] = source[term.left * size + j * step.height + i];
    }
  }
}

template <class Scalar>
void Evaluation<Scalar>::skew(const Step& step, bool transposed) {
  const Scalar* source = data(plan_->step(step.operands.front()));
  for (const Term& term : step.terms) {
    const Scalar* a = source + term.left * 3;
    Eigen::Map<Eigen::Matrix<Scalar, 3, 3, Eigen::RowMajor>> m(data(step) + term.target * 9);
    m << Scalar(0), -a[2], a[1], a[2], Scalar(0), -a[0], -a[1], a[0], Scalar(0);
    if (transposed) {
      m.transposeInPlace();
    }
  }
}

namespace detail {

// A row vector must be row-major and a column vector column-major, says Eigen; in memory it is the
// same.
template <class Scalar, int Rows, int Cols>
using ConstBlock =
    Eigen::Map<const Eigen::Matrix<Scalar, Rows, Cols,
                                   (Cols == 1 && Rows != 1) ? Eigen::ColMajor : Eigen::RowMajor>>;
template <class Scalar, int Rows, int Cols>
using MutableBlock =
    Eigen::Map<Eigen::Matrix<Scalar, Rows, Cols,
                             (Cols == 1 && Rows != 1) ? Eigen::ColMajor : Eigen::RowMajor>>;

template <class Scalar, int Rows, int Inner, int Cols>
void multiply_blocks(const std::vector<Term>& terms, const Scalar* a, const Scalar* b, Scalar* c) {
  for (const Term& term : terms) {
    const ConstBlock<Scalar, Rows, Inner> x(a + term.left * Rows * Inner);
    const ConstBlock<Scalar, Inner, Cols> y(b + term.right * Inner * Cols);
    MutableBlock<Scalar, Rows, Cols> z(c + term.target * Rows * Cols);
    z += x.lazyProduct(y);
  }
}

/// Blocks of `size` numbers times numbers; `left`: the numbers stand left.
template <class Scalar>
void scale_blocks(const Step& step, bool left, const Scalar* a, const Scalar* b, Scalar* c) {
  const int size = step.block_size();
  for (const Term& term : step.terms) {
    const Scalar& factor = left ? a[term.left] : b[term.right];
    const Scalar* x = left ? b + term.right * size : a + term.left * size;
    for (int n = 0; n < size; ++n) {
      c[term.target * size + n] += factor * x[n];
    }
  }
}

}  // namespace detail

template <class Scalar>
void Evaluation<Scalar>::product(const Step& step) {
  const Step& left = plan_->step(step.operands[0]);
  const Step& right = plan_->step(step.operands[1]);
  const Scalar* a = data(left);
  const Scalar* b = data(right);
  Scalar* c = data(step);
  if (left.block_size() == 1 || right.block_size() == 1) {
    return detail::scale_blocks(step, left.block_size() == 1, a, b, c);
  }
  TREEDYN_EXPECT(left.width == right.height);
  switch (100 * left.height + 10 * left.width + right.width) {
    case 333:
      return detail::multiply_blocks<Scalar, 3, 3, 3>(step.terms, a, b, c);
    case 331:
      return detail::multiply_blocks<Scalar, 3, 3, 1>(step.terms, a, b, c);
    case 133:
      return detail::multiply_blocks<Scalar, 1, 3, 3>(step.terms, a, b, c);
    case 131:
      return detail::multiply_blocks<Scalar, 1, 3, 1>(step.terms, a, b, c);
    case 313:
      return detail::multiply_blocks<Scalar, 3, 1, 3>(step.terms, a, b, c);
    default:
      TREEDYN_EXPECT(false);
  }
}

namespace detail {

/// Copies a row-major block `width` wide into a matrix `stride` wide; a single number fills the
/// diagonal.
template <class Scalar>
void write_block(std::span<const Scalar> block, int size, int width, Scalar* target, int stride) {
  const bool single = block.size() == 1;
  for (int n = 0; n < size; ++n) {
    const int row = n / width;
    const int col = n % width;
    if (!single || row == col) {
      target[row * stride + col] = block[single ? 0 : static_cast<std::size_t>(n)];
    }
  }
}

}  // namespace detail

template <class Scalar>
void Evaluation<Scalar>::write(int step, const Shape& shape, std::span<Scalar> out) const {
  const Step& s = plan_->step(step);
  const int height = shape.rows.size;
  const int width = shape.cols.size;
  const int stride = s.pattern.cols() * width;
  const auto block_size = static_cast<std::size_t>(s.block_size());
  std::ranges::fill(out, Scalar(0));
  s.pattern.visit([&](int i, int j, int block) {
    const std::span<const Scalar> source =
        blocks(step).subspan(static_cast<std::size_t>(block) * block_size, block_size);
    detail::write_block(source, height * width, width, out.data() + i * height * stride + j * width,
                        stride);
  });
}

}  // namespace treedyn::block
