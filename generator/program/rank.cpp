#include "program/rank.hpp"

#include <algorithm>

#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

namespace {

using Matrix = std::vector<std::vector<Real>>;

Matrix symmetric(const std::vector<Real>& lower, int rows) {
  const auto n = static_cast<std::size_t>(rows);
  Matrix a(n, std::vector<Real>(n));
  std::size_t place = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      a[i][j] = a[j][i] = lower[place++];
    }
  }
  return a;
}

/// The remainder after the elimination of row and column k.
void eliminate(Matrix& a, std::size_t k) {
  const Matrix before = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      a[i][j] = i == k || j == k ? Real(0)
                                 : Real(before[i][j] - before[i][k] * before[k][j] / before[k][k]);
    }
  }
}

std::size_t largest_diagonal(const Matrix& a) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    best = a[i][i] > a[best][best] ? i : best;
  }
  return best;
}

}  // namespace

int rank_of(const std::vector<Real>& lower, int rows) {
  Matrix a = symmetric(lower, rows);
  const std::size_t first = largest_diagonal(a);
  const Real least = a[first][first] * Real("1e-25");
  int rank = 0;
  for (; rank < rows; ++rank) {
    const std::size_t k = largest_diagonal(a);
    if (!(a[k][k] > least)) {
      break;
    }
    eliminate(a, k);
  }
  return rank;
}

RowSolve solve_of(const Function& function, int rows) {
  Random random(1);
  std::vector<std::vector<Real>> state;
  for (const Array& array : function.signature.inputs) {
    state.emplace_back();
    std::generate_n(std::back_inserter(state.back()), array.size,
                    [&] { return Real(random.symmetric()); });
  }
  const std::vector<std::span<const Real>> inputs(state.begin(), state.end());
  std::vector<Real> values = interpret<Real>(function, inputs);
  const auto size = static_cast<std::size_t>(rows * (rows + 1) / 2);
  RowSolve solve;
  solve.rows = rows;
  for (std::size_t k = 0; k < size; ++k) {
    solve.zeros.push_back(function.outputs[k] == 0);
  }
  values.resize(size);
  solve.rank = rank_of(values, rows);
  return solve;
}

}  // namespace treedyn::program
