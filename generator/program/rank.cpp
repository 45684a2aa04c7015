#include "program/rank.hpp"

#include <algorithm>
#include <ios>

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

/// Pivots as parts of their own diagonal entries, the largest first; those of 1e-25 count as zero.
std::vector<Real> pivot_shares(const std::vector<Real>& lower, int rows) {
  Matrix a = symmetric(lower, rows);
  const Matrix whole = a;
  const auto share = [&](std::size_t i) {
    return whole[i][i] == 0 ? Real(0) : Real(a[i][i] / whole[i][i]);
  };
  std::vector<Real> shares;
  while (shares.size() < a.size()) {
    std::size_t k = 0;
    for (std::size_t i = 1; i < a.size(); ++i) {
      k = share(i) > share(k) ? i : k;
    }
    if (!(share(k) > Real("1e-25"))) {
      break;
    }
    shares.push_back(share(k));
    eliminate(a, k);
  }
  return shares;
}

/// The product of the same parts in the order of the rows.
Real product_of_pivots(const std::vector<Real>& lower, int rows) {
  Matrix a = symmetric(lower, rows);
  Real result = 1;
  for (std::size_t k = 0; k < a.size() && result > 0; ++k) {
    const Real& whole = lower[k * (k + 3) / 2];
    result *= whole == 0 ? Real(0) : Real(a[k][k] / whole);
    if (result > 0) {
      eliminate(a, k);
    }
  }
  return result;
}

}  // namespace

int rank_of(const std::vector<Real>& lower, int rows) {
  return static_cast<int>(pivot_shares(lower, rows).size());
}

namespace {

/// The outputs of stage 0 for some values of q; the other inputs are `others`.
std::vector<Real> values_at(const Function& function, std::vector<std::vector<Real>> inputs,
                            const std::vector<double>& q) {
  inputs.front().assign(q.begin(), q.end());
  const std::vector<std::span<const Real>> spans(inputs.begin(), inputs.end());
  return interpret<Real>(function, spans);
}

/// K with zeros for some rows and columns.
template <class Wanted>
std::vector<Real> without(std::vector<Real> lower, Wanted is_left_out) {
  for (std::size_t i = 0, place = 0; place < lower.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j, ++place) {
      lower[place] = is_left_out(i) || is_left_out(j) ? Real(0) : lower[place];
    }
  }
  return lower;
}

/// With two digits.
double rounded(const Real& x) { return std::stod(x.str(2, std::ios_base::scientific)); }

}  // namespace

RowSolve solve_of(const Function& function, int rows, const OrdinaryRows& ordinary) {
  Random random(1);
  std::vector<std::vector<Real>> inputs;
  for (const Array& array : function.signature.inputs) {
    inputs.emplace_back();
    std::generate_n(std::back_inserter(inputs.back()), array.size,
                    [&] { return Real(random.symmetric()); });
  }
  const std::vector<std::span<const Real>> spans(inputs.begin(), inputs.end());
  std::vector<Real> values = interpret<Real>(function, spans);
  values.resize(static_cast<std::size_t>(rows * (rows + 1) / 2));
  const auto is_rounding = [&](std::size_t row) {
    return ordinary.is_rounding(row);
  };
  RowSolve solve;
  solve.rows = rows;
  for (std::size_t k = 0; k < values.size(); ++k) {
    solve.zeros.push_back(function.outputs[k] == 0);
  }
  const std::vector<Real> generic = pivot_shares(without(values, is_rounding), rows);
  solve.rank = ordinary.holds ? ordinary.rank : static_cast<int>(generic.size());
  solve.elsewhere = static_cast<int>(
      std::ranges::count_if(generic, [](const Real& share) { return share > kIndependent; }));
  std::vector<Real> sizes(static_cast<std::size_t>(rows));
  Real least = 0;
  Real product = 0;
  for (const std::vector<double>& q : ordinary.states) {
    std::vector<Real> K = values_at(function, inputs, q);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      sizes[k] = std::max(sizes[k], K[k * (k + 3) / 2]);
    }
    K.resize(values.size());
    const std::vector<Real> shares = pivot_shares(without(K, is_rounding), rows);
    const auto last = static_cast<std::size_t>(solve.rank);
    least = last > 0 && last <= shares.size() ? std::max(least, shares[last - 1]) : least;
    product = solve.regular() ? std::max(product, product_of_pivots(K, rows)) : product;
  }
  solve.least = rounded(least);
  solve.product = rounded(product);
  ordinary.raise_rounding(std::span(sizes));
  std::ranges::transform(sizes, std::back_inserter(solve.sizes), rounded);
  return solve;
}

}  // namespace treedyn::program
