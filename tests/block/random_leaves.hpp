// Random numbers for all symbols of equations/symbols.hpp, full for `dense`, as blocks for a plan.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "block/dense.hpp"
#include "block/evaluate.hpp"
#include "equations/symbols.hpp"
#include "support/random_tree.hpp"

namespace treedyn::block {

inline Index random_index(int links, int points, support::Dice& dice) {
  const support::TreeShape shape = support::random_shape(links, dice);
  Index index;
  index.father = shape.father;
  for (const char type : shape.types) {
    index.revolute.push_back(type == 'R');
  }
  for (int p = 0; p < points; ++p) {
    index.carrier.push_back(dice.below(links + 1) - 1);
  }
  return index;
}

inline std::vector<Expression> all_symbols() {
  namespace eq = equations;
  return {eq::D,   eq::E,   eq::sigma, eq::W,   eq::ones, eq::ones_P, eq::m_d,
          eq::J_d, eq::z_d, eq::s_d,   eq::l_d, eq::c_d,  eq::t_d,    eq::qd_d,
          eq::qd,  eq::qdd, eq::f_b,   eq::n_b, eq::g};
}

/// One full matrix per symbol: zeros where its pattern says so, ones for constants, else random.
inline std::map<std::string, Eigen::MatrixXd> random_leaves(const Index& index,
                                                            support::Dice& dice) {
  std::map<std::string, Eigen::MatrixXd> result;
  for (const Expression& symbol : all_symbols()) {
    const Shape& shape = symbol.shape();
    const Pattern blocks = pattern(symbol, index);
    Eigen::MatrixXd m =
        Eigen::MatrixXd::Zero(dense::count(shape.rows, index), dense::count(shape.cols, index));
    for (int i = 0; i < blocks.rows(); ++i) {
      for (int b = blocks.begin(i); b < blocks.end(i); ++b) {
        auto block = m.block(i * shape.rows.size, blocks.column(b) * shape.cols.size,
                             shape.rows.size, shape.cols.size);
        for (Eigen::Index n = 0; n < block.size(); ++n) {
          const bool constant = is_constant(symbol.node().structure);
          block(n / block.cols(), n % block.cols()) = constant ? 1 : dice.number(2);
        }
      }
    }
    result[symbol.node().name] = m;
  }
  return result;
}

/// The blocks of `leaves` as a plan stores them.
inline void write_leaves(const Plan& plan, const std::map<std::string, Eigen::MatrixXd>& leaves,
                         Evaluation<double>& evaluation) {
  for (const Step& step : plan.steps()) {
    if (step.operation != Operation::kLeaf) {
      continue;
    }
    const std::span<double> values = evaluation.leaf(step.name);
    const Eigen::MatrixXd& m = leaves.at(step.name);
    std::size_t n = 0;
    for (int i = 0; i < step.pattern.rows(); ++i) {
      for (int b = step.pattern.begin(i); b < step.pattern.end(i); ++b) {
        for (int k = 0; k < step.block_size(); ++k) {
          values[n++] = m(i * step.height + k / step.width,
                          step.pattern.column(b) * step.width + k % step.width);
        }
      }
    }
  }
}

/// The value of `expression` through a plan, as a full matrix.
inline Eigen::MatrixXd planned(const Expression& expression, const Index& index,
                               const std::map<std::string, Eigen::MatrixXd>& leaves) {
  Plan plan(index);
  const int result = plan.add(expression);
  Evaluation<double> evaluation(plan);
  write_leaves(plan, leaves, evaluation);
  evaluation.run(plan.needed({result}));
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> out(
      dense::count(expression.shape().rows, index), dense::count(expression.shape().cols, index));
  out.setConstant(std::numeric_limits<double>::quiet_NaN());
  evaluation.write(result, expression.shape(), {out.data(), static_cast<std::size_t>(out.size())});
  return out;
}

}  // namespace treedyn::block
