#include "engine/scales.hpp"

#include <cmath>

namespace treedyn::engine {

Scales::Scales(const block::Plan& plan) : plan_(plan) {
  for (const block::Step& step : plan.steps()) {
    norms_.emplace_back(static_cast<std::size_t>(step.pattern.blocks()), 0);
    for (std::size_t k = 0; k < step.constants.size(); ++k) {
      norms_.back()[k] = std::abs(static_cast<double>(step.constants[k]));
    }
  }
}

void Scales::set_leaf(std::size_t step, const std::vector<double>& numbers) {
  std::vector<double>& norms = norms_[step];
  const std::size_t size = norms.empty() ? 1 : numbers.size() / norms.size();
  for (std::size_t k = 0; k < norms.size(); ++k) {
    double squares = 0;
    for (std::size_t n = 0; n < size; ++n) {
      squares += numbers[k * size + n] * numbers[k * size + n];
    }
    norms[k] = std::sqrt(squares);
  }
}

void Scales::compute(std::size_t number) {
  const block::Step& step = plan_.steps()[number];
  std::vector<double> norms(norms_[number].size(), 0);
  const auto of = [&](std::size_t operand, int block) {
    return norms_[static_cast<std::size_t>(step.operands[operand])]
                 [static_cast<std::size_t>(block)];
  };
  for (const block::Term& term : step.terms) {
    double& norm = norms[static_cast<std::size_t>(term.target)];
    const auto k = static_cast<std::size_t>(term.right);
    switch (step.operation) {
      case block::Operation::kSum:
        norm += std::abs(static_cast<double>(step.factors[k].numerator) /
                         static_cast<double>(step.factors[k].denominator)) *
                of(k, term.left);
        break;
      case block::Operation::kProduct:
        norm += of(0, term.left) * of(1, term.right);
        break;
      case block::Operation::kPathSum:
      case block::Operation::kDiagonal:
        norm += term.right == 1 ? norms[static_cast<std::size_t>(term.left)] : of(0, term.left);
        break;
      case block::Operation::kTranspose:
      case block::Operation::kSkew:
      case block::Operation::kSkewTranspose:
        norm = of(0, term.left);
        break;
      case block::Operation::kLeaf:
      case block::Operation::kConstant:
        break;
    }
  }
  norms_[number] = std::move(norms);
}

std::vector<double> Scales::values(int step, const block::Shape& shape) const {
  const block::Step& of = plan_.step(step);
  const int height = shape.rows.size;
  const int width = shape.cols.size;
  const int stride = of.pattern.cols() * width;
  std::vector<double> result(static_cast<std::size_t>(of.pattern.rows() * height * stride), 0);
  of.pattern.visit([&](int i, int j, int block) {
    for (int n = 0; n < height * width; ++n) {
      result[static_cast<std::size_t>((i * height + n / width) * stride + j * width + n % width)] =
          norms_[static_cast<std::size_t>(step)][static_cast<std::size_t>(block)];
    }
  });
  return result;
}

}  // namespace treedyn::engine
