// What R12 derives, carried out with numbers: matrices with the zeros of a tree and without.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "equations/equations.hpp"
#include "equations/symbols.hpp"
#include "formulate/joint_numbers.hpp"

namespace treedyn::formulate {
namespace {

const Real kTolerance("1e-30");  // of 40 digits, over a dozen products of numbers below 10

struct Sample {
  const char* name;
  std::vector<int> father;  ///< empty: no zeros
  int size;
};
void PrintTo(const Sample& sample, std::ostream* stream) { *stream << sample.name; }

class Factored : public testing::TestWithParam<Sample> {
 protected:
  Factored() {
    const Sample& sample = GetParam();
    const auto number = [this](int k) {
      return constant(graph_, Real((37 * k + 11) % 19 - 9) / 10);
    };
    for (int i = 0; i < sample.size; ++i) {
      A_[{i, i}] = constant(graph_, Real(10 + i));
      b_.push_back(number(i));
      int j = above(i);
      for (int k = 5 * i; j >= 0; j = above(j)) {
        A_[{i, j}] = number(++k);
      }
    }
  }

  [[nodiscard]] static int above(int i) {
    const std::vector<int>& father = GetParam().father;
    return father.empty() ? i - 1 : father[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] Real A(int i, int j) const {
    const auto found = A_.find({std::max(i, j), std::min(i, j)});
    return found == A_.end() ? Real(0) : found->second.value();
  }
  /// The k-th unknown.
  [[nodiscard]] SparseRows of(const equations::Expression& equation, const char* unknown,
                              std::size_t k = 0) {
    const derive::Derivation d = derive::factored(equation, unknown).value().derivation;
    const auto leaf = [&](const std::string& name) {
      return name == "A" ? sparse(GetParam().size, A_) : sparse(b_);
    };
    return Numbers(graph_, GetParam().size, d, leaf).root(k);
  }
  static Real at(const SparseRows& rows, int i, int j) {
    const SparseRow& row = rows[static_cast<std::size_t>(i)];
    const auto found = row.find(j);
    return found == row.end() ? Real(0) : found->second.value();
  }
  /// (A x)_i.
  [[nodiscard]] Real times(const SparseRows& x, int i, int column) const {
    Real sum = 0;
    for (int k = 0; k < GetParam().size; ++k) {
      sum += A(i, k) * at(x, k, column);
    }
    return sum;
  }

  Graph graph_;
  SparseSymmetric A_;
  std::vector<Expr> b_;
};

TEST_P(Factored, MatricesAreTheirFactors) {
  const SparseRows L = of(equations::mass_matrix_factor(), "L");
  const SparseRows d = of(equations::mass_matrix_factor(), "L", 1);
  for (int i = 0; i < GetParam().size; ++i) {
    EXPECT_EQ(at(L, i, i), 1);
    for (int j = 0; j < GetParam().size; ++j) {
      Real sum = 0;
      for (int k = 0; k < GetParam().size; ++k) {
        sum += at(L, k, i) * at(d, k, k) * at(L, k, j);
      }
      EXPECT_LE(abs(sum - A(i, j)), kTolerance) << i << "," << j;
      EXPECT_TRUE(at(L, i, j) == 0 || A_.contains({i, j})) << "fill-in";
    }
  }
}

TEST_P(Factored, SystemsAreSolved) {
  const SparseRows x = of(equations::mass_matrix_solve(), "x");
  for (int i = 0; i < GetParam().size; ++i) {
    EXPECT_LE(abs(times(x, i, 0) - b_[static_cast<std::size_t>(i)].value()), kTolerance) << i;
  }
}

TEST_P(Factored, InversesInvert) {
  SparseRows X = of(equations::mass_matrix_inverse(), "X");
  for (int i = 0; i < GetParam().size; ++i) {  // the lower half twice
    for (int j = 0; j < i; ++j) {
      X[static_cast<std::size_t>(j)][i] = constant(graph_, at(X, i, j));
    }
  }
  for (int i = 0; i < GetParam().size; ++i) {
    for (int j = 0; j < GetParam().size; ++j) {
      EXPECT_LE(abs(times(X, i, j) - (i == j ? 1 : 0)), kTolerance) << i << "," << j;
    }
  }
}

TEST_P(Factored, ErrorsOfEquationsArrive) {
  const block::Shape column{equations::kLinks, equations::kOne};
  const equations::Expression x = block::leaf("x", block::Structure::kFull, column);
  const equations::Expression b = block::leaf("b", block::Structure::kFull, column);
  const SparseRows wrong = of(equations::mass_matrix() * x + 3 * b, "x");
  for (int i = 0; i < GetParam().size; ++i) {
    EXPECT_LE(abs(times(wrong, i, 0) + 3 * b_[static_cast<std::size_t>(i)].value()), kTolerance);
  }
}

/// A x = r + J^T λ, and J x - s = K λ - b for every λ.
TEST_P(Factored, MotionsUnderRowsAreSolvedButForTheReactions) {
  constexpr int kRows = 3;
  const int n = GetParam().size;
  const auto number = [this](int k) {
    return constant(graph_, Real((23 * k + 5) % 17 - 8) / 10);
  };
  SparseRows J_T(static_cast<std::size_t>(n));
  std::vector<Expr> lambda;
  std::vector<Expr> s;
  for (int r = 0; r < kRows; ++r) {
    for (int i = r; i < n; i += 2) {  // some are zero
      J_T[static_cast<std::size_t>(i)][r] = number(7 * r + i);
    }
    lambda.push_back(number(40 + r));
    s.push_back(number(50 + r));
  }
  const block::Side joints = equations::kLinks;
  const block::Side rows = equations::kRows;
  const auto leaf = [](const char* name, const block::Side& height, const block::Side& width) {
    return block::leaf(name, block::Structure::kFull, {height, width});
  };
  const block::Expression J = leaf("J_T", joints, rows);
  const block::Expression x = leaf("x", joints, equations::kOne);
  const block::Expression reactions = leaf("λ", rows, equations::kOne);
  const derive::Derivation derivation =
      derive::constrained(
          equations::mass_matrix() * x - leaf("r", joints, equations::kOne) - J * reactions,
          block::transpose(J) * x - leaf("s", rows, equations::kOne), "x", "λ")
          .value()
          .derivation;
  const Numbers solved(
      graph_, n, derivation,
      [&](const std::string& name) {
        return name == "A"     ? sparse(n, A_)
               : name == "J^T" ? J_T
               : name == "r"   ? sparse(b_)
               : name == "s"   ? sparse(s)
                               : sparse(lambda);
      },
      kRows);
  for (int i = 0; i < n; ++i) {
    Real rest = times(solved.root(2), i, 0) - b_[static_cast<std::size_t>(i)].value();
    for (int r = 0; r < kRows; ++r) {
      rest -= at(J_T, i, r) * lambda[static_cast<std::size_t>(r)].value();
    }
    EXPECT_LE(abs(rest), kTolerance) << i;
  }
  for (int r = 0; r < kRows; ++r) {
    Real rest = at(solved.root(1), r, 0) - s[static_cast<std::size_t>(r)].value();
    for (int i = 0; i < n; ++i) {
      rest += at(J_T, i, r) * at(solved.root(2), i, 0);
    }
    for (int k = 0; k < kRows; ++k) {
      rest -= at(solved.root(0), std::max(r, k), std::min(r, k)) *
              lambda[static_cast<std::size_t>(k)].value();
    }
    EXPECT_LE(abs(rest), kTolerance) << r;
  }
}

/// λ = M^T μ and M λ = K μ for every μ; τ = h - J^T λ, M = E_u^T J^T.
TEST_P(Factored, ReactionsAreTheLeastOfThoseThatDoWithoutDrives) {
  constexpr int kRows = 3;
  constexpr int kPassive = 2;
  const int n = GetParam().size;
  const auto number = [this](int k) {
    return constant(graph_, Real((29 * k + 3) % 17 - 8) / 10);
  };
  SparseRows J_T(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    for (int r = i % 2; r < kRows; ++r) {
      J_T[static_cast<std::size_t>(i)][r] = number(5 * i + r);
    }
  }
  SparseRows E_u(static_cast<std::size_t>(n));
  const std::array<int, kPassive> joints = {1, n - 1};
  std::vector<Expr> mu;
  for (int u = 0; u < kPassive; ++u) {
    E_u[static_cast<std::size_t>(joints[static_cast<std::size_t>(u)])][u] =
        constant(graph_, Real(1));
    mu.push_back(number(60 + u));
  }
  const auto& [passive, drives] = equations::constrained_inverse_dynamics();
  const derive::Derivation derivation = derive::least(passive, drives, "λ", "μ").value().derivation;
  const Numbers solved(
      graph_, n, derivation,
      [&](const std::string& name) {
        return name == "J^T" ? J_T : name == "E_u" ? E_u : name == "h" ? sparse(b_) : sparse(mu);
      },
      kRows, kPassive);
  for (int r = 0; r < kRows; ++r) {
    Real rest = at(solved.root(2), r, 0);
    for (std::size_t u = 0; u < kPassive; ++u) {
      rest -= at(J_T, joints[u], r) * mu[u].value();
    }
    EXPECT_LE(abs(rest), kTolerance) << r;
  }
  const auto pushed = [&](int i) {  // J^T λ
    Real sum = 0;
    for (int r = 0; r < kRows; ++r) {
      sum += at(J_T, i, r) * at(solved.root(2), r, 0);
    }
    return sum;
  };
  for (int u = 0; u < kPassive; ++u) {
    const int i = joints[static_cast<std::size_t>(u)];
    Real rest = pushed(i);
    for (int k = 0; k < kPassive; ++k) {
      rest -= at(solved.root(0), std::max(u, k), std::min(u, k)) *
              mu[static_cast<std::size_t>(k)].value();
    }
    EXPECT_LE(abs(rest), kTolerance) << u;
    EXPECT_LE(abs(at(solved.root(1), u, 0) - b_[static_cast<std::size_t>(i)].value()), kTolerance);
  }
  for (int i = 0; i < n; ++i) {
    const Real h = b_[static_cast<std::size_t>(i)].value();
    EXPECT_LE(abs(at(solved.root(3), i, 0) - (h - pushed(i))), kTolerance) << i;
  }
}

TEST_P(Factored, MatricesWithoutPivotAreRejected) {
  A_[{GetParam().size - 1, GetParam().size - 1}] = Expr();
  EXPECT_THROW(of(equations::mass_matrix_factor(), "L"), std::range_error);
}

INSTANTIATE_TEST_SUITE_P(Matrices, Factored,
                         testing::Values(Sample{"Full", {}, 5},
                                         Sample{"Tree", {-1, 0, 1, 1, 0, 4, 4}, 7},
                                         Sample{"Forest", {-1, 0, -1, 2, 2}, 5}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn::formulate
