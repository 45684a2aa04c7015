// The meaning of block expressions, spelled out with full matrices: no zero pattern, no path sums.
#pragma once

#include <map>
#include <string>

#include <Eigen/Core>

#include "block/block.hpp"
#include "block/pattern.hpp"

namespace treedyn::block::dense {

using Eigen::MatrixXd;

inline int count(const Side& side, const Index& index) {
  const int n = side.set == Set::kLinks    ? index.links()
                : side.set == Set::kPoints ? index.points()
                : side.set == Set::kRows   ? index.rows()
                                           : 1;
  return n * side.size;
}

/// Kronecker product with the 3x3 unit matrix.
inline MatrixXd kronecker(const MatrixXd& a) {
  MatrixXd result = MatrixXd::Zero(3 * a.rows(), 3 * a.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      result.block<3, 3>(3 * i, 3 * j) = a(i, j) * Eigen::Matrix3d::Identity();
    }
  }
  return result;
}

inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return m;
}

/// Evaluates expressions; `leaves` holds the full matrices of all symbols.
class Evaluator {
 public:
  /// With `magnitudes` every leaf, factor and sign counts positive: a bound of all partial sums.
  Evaluator(Index index, std::map<std::string, MatrixXd> leaves, bool magnitudes = false)
      : index_(std::move(index)), leaves_(std::move(leaves)), magnitudes_(magnitudes) {}

  [[nodiscard]] MatrixXd operator()(const Expression& e) const {
    const auto& x = e.operands();
    switch (e.kind()) {
      case Kind::kLeaf:
        return signless(leaves_.at(e.node().name));
      case Kind::kNamed:
        return (*this)(x.front());
      case Kind::kScaled:
        return signless((*this)(x.front()) * e.node().factor.numerator /
                        e.node().factor.denominator);
      case Kind::kTranspose:
        return (*this)(x.front()).transpose();
      case Kind::kSum:
        return sum(e);
      case Kind::kProduct:
        return product(e);
      case Kind::kSkew:
        return signless(skew((*this)(x.front()), false));
      case Kind::kSkewTranspose:
        return signless(skew((*this)(x.front()), true));
      case Kind::kDiagonal:
        return diagonal((*this)(x.front()), e.shape().rows.size);
    }
    return {};
  }

 private:
  [[nodiscard]] MatrixXd signless(const MatrixXd& m) const {
    return magnitudes_ ? MatrixXd(m.cwiseAbs()) : m;
  }

  [[nodiscard]] MatrixXd sum(const Expression& e) const {
    const int rows = count(e.shape().rows, index_);
    MatrixXd result = MatrixXd::Zero(rows, count(e.shape().cols, index_));
    for (const Expression& term : e.operands()) {
      const MatrixXd value = (*this)(term);
      result += value.rows() == rows ? value : kronecker(value);
    }
    return result;
  }

  [[nodiscard]] MatrixXd product(const Expression& e) const {
    MatrixXd result = (*this)(e.operands().front());
    for (std::size_t k = 1; k < e.operands().size(); ++k) {
      const MatrixXd factor = (*this)(e.operands()[k]);
      if (result.cols() == factor.rows()) {
        result = MatrixXd(result * factor);
      } else if (3 * result.cols() == factor.rows()) {
        result = MatrixXd(kronecker(result) * factor);
      } else {
        result = MatrixXd(result * kronecker(factor));
      }
    }
    return result;
  }

  static MatrixXd skew(const MatrixXd& x, bool transposed) {
    MatrixXd result(x.rows(), 3 * x.cols());
    for (Eigen::Index i = 0; i < x.rows(); i += 3) {
      for (Eigen::Index j = 0; j < x.cols(); ++j) {
        const Eigen::Matrix3d m = cross_matrix(x.block<3, 1>(i, j));
        result.block<3, 3>(i, 3 * j) = transposed ? Eigen::Matrix3d(m.transpose()) : m;
      }
    }
    return result;
  }

  static MatrixXd diagonal(const MatrixXd& x, int size) {
    const Eigen::Index n = x.rows() / size;
    MatrixXd result = MatrixXd::Zero(x.rows(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      result.block(size * i, i, size, 1) = x.block(size * i, 0, size, 1);
    }
    return result;
  }

  Index index_;
  std::map<std::string, MatrixXd> leaves_;
  bool magnitudes_;
};

}  // namespace treedyn::block::dense
