#include "simplify/factor.hpp"

#include <stdexcept>

#include "common/error.hpp"

namespace treedyn::simplify {

namespace {

constexpr const char* kNoPivot =
    "the mass matrix is singular to 40 digits; expected masses, lengths and inertias of fewer "
    "decades, or --functions without forward dynamics";

}  // namespace

Factorization::Factorization(Graph& graph, int size, const SparseSymmetric& matrix)
    : graph_(&graph),
      rows_(static_cast<std::size_t>(size)),
      pivot_(static_cast<std::size_t>(size)),
      inverse_(static_cast<std::size_t>(size)) {
  std::vector<std::map<int, Expr>> a(static_cast<std::size_t>(size));  // row k, columns <= k
  for (const auto& [place, entry] : matrix) {
    TREEDYN_EXPECT(place.first >= place.second);
    if (!entry.is_zero()) {
      a[static_cast<std::size_t>(place.first)][place.second] = entry;
    }
  }
  for (int k = size - 1; k >= 0; --k) {
    graph.set_body(k);
    std::map<int, Expr>& row = a[static_cast<std::size_t>(k)];
    const Expr pivot = row[k];
    if (pivot.is_zero()) {
      throw std::range_error(kNoPivot);
    }
    const Expr inverse = constant(graph, Real(1)) / pivot;
    graph.name(inverse.ref(), "inverse_pivot", k);
    pivot_[static_cast<std::size_t>(k)] = pivot;
    inverse_[static_cast<std::size_t>(k)] = inverse;
    row.erase(k);
    for (auto entry = row.rbegin(); entry != row.rend(); ++entry) {
      const auto& [i, a_ki] = *entry;
      const Expr l_ki = a_ki * inverse;
      for (const auto& [j, a_kj] : row) {
        if (j <= i) {
          Expr& target = a[static_cast<std::size_t>(i)][j];
          target = target - l_ki * a_kj;
        }
      }
      rows_[static_cast<std::size_t>(k)].emplace_back(i, l_ki);
    }
  }
}

/// L Y = 1: y_kj = -sum over i of L_ki y_ij.
std::vector<std::map<int, Expr>> Factorization::inverse_of_lower() const {
  std::vector<std::map<int, Expr>> y(rows_.size());
  for (int k = 0; k < size(); ++k) {
    std::map<int, Expr>& row_k = y[static_cast<std::size_t>(k)];
    for (const auto& [i, l_ki] : row(k)) {
      for (const auto& [j, y_ij] : y[static_cast<std::size_t>(i)]) {
        row_k[j] -= l_ki * y_ij;
      }
    }
    row_k[k] = constant(*graph_, Real(1));
  }
  return y;
}

std::vector<Expr> Factorization::solve(std::vector<Expr> x) const {
  for (int k = size() - 1; k >= 0; --k) {  // L^T y = right
    for (const auto& [i, l_ki] : row(k)) {
      x[static_cast<std::size_t>(i)] -= l_ki * x[static_cast<std::size_t>(k)];
    }
  }
  for (int k = 0; k < size(); ++k) {  // Delta, then L x = y
    Expr& x_k = x[static_cast<std::size_t>(k)];
    x_k = x_k * inverse_pivot(k);
    for (const auto& [i, l_ki] : row(k)) {
      x_k -= l_ki * x[static_cast<std::size_t>(i)];
    }
  }
  return x;
}

std::vector<Expr> Factorization::to_root(std::vector<Expr> x) const {
  for (int k = size() - 1; k >= 0; --k) {
    for (const auto& [i, l_ki] : row(k)) {
      const Expr term = l_ki * x[static_cast<std::size_t>(k)];
      x[static_cast<std::size_t>(i)] -= term;
    }
  }
  return x;
}

std::map<int, Expr> Factorization::to_root(std::map<int, Expr> x) const {
  for (int k = size() - 1; k >= 0; --k) {
    const auto entry = x.find(k);
    if (entry == x.end() || entry->second.is_zero()) {
      continue;
    }
    const Expr x_k = entry->second;
    for (const auto& [i, l_ki] : row(k)) {
      const Expr term = l_ki * x_k;
      x[i] -= term;
    }
  }
  return x;
}

std::vector<Expr> Factorization::from_root(std::vector<Expr> x) const {
  for (int k = 0; k < size(); ++k) {
    for (const auto& [i, l_ki] : row(k)) {
      const Expr term = l_ki * x[static_cast<std::size_t>(i)];
      x[static_cast<std::size_t>(k)] -= term;
    }
  }
  return x;
}

}  // namespace treedyn::simplify
