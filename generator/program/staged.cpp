#include "program/staged.hpp"

#include <algorithm>

namespace treedyn::program {

namespace {

Expr entry(Graph& graph, const RowSolve& solve, int i, int j) {
  const int place = i * (i + 1) / 2 + j;
  const bool zero = solve.zeros[static_cast<std::size_t>(place)];
  return zero ? Expr() : Expr(graph, graph.input(0, place));
}

/// Row k of K = L D L^T: u_kj = K_kj - sum u_km l_jm, l_kj = u_kj / d_j, d_k = K_kk - sum u_kj
/// l_kj.
struct Triangle {
  std::vector<std::vector<Expr>> l;
  std::vector<Expr> pivots;
  std::vector<Expr> inverses;
  std::vector<Expr> wholes;  ///< what pivots are measured by
};

/// K_kk + sum of w_i^2 K_ii, w = K^-1 k_k of the rows before: L^T w = l.
Expr grown(Graph& graph, const RowSolve& solve, const Triangle& t, const std::vector<Expr>& l) {
  const std::size_t k = l.size();
  const auto own = [&](std::size_t i) {
    return entry(graph, solve, static_cast<int>(i), static_cast<int>(i));
  };
  std::vector<Expr> w = l;
  Expr result = own(k);
  for (std::size_t i = k; i-- > 0;) {
    for (std::size_t j = i + 1; j < k; ++j) {
      w[i] -= t.l[j][i] * w[j];
    }
    result += w[i] * w[i] * own(i);
  }
  return result;
}

Triangle factor(Graph& graph, const RowSolve& solve) {
  Triangle t;
  const auto r = static_cast<std::size_t>(solve.rows);
  const Expr one(graph, graph.constant(1));
  Expr growth = one;
  for (std::size_t k = 0; k < r; ++k) {
    std::vector<Expr> u;
    std::vector<Expr> l;
    const int row = static_cast<int>(k);
    const Expr own = entry(graph, solve, row, row);
    Expr pivot = own;
    for (std::size_t j = 0; j < k; ++j) {
      Expr value = entry(graph, solve, row, static_cast<int>(j));
      for (std::size_t m = 0; m < j; ++m) {
        value -= u[m] * t.l[j][m];
      }
      u.push_back(value);
      l.push_back(value * t.inverses[j]);
      pivot -= value * l.back();
    }
    t.l.push_back(l);
    t.pivots.push_back(pivot);
    const Expr checked(graph, graph.input(2, row));
    t.inverses.push_back(one / checked);
    t.wholes.push_back(solve.by_product ? own * growth : grown(graph, solve, t, l));
    growth = k == 0 ? one : growth * (own * t.inverses.back());
  }
  return t;
}

/// Multiplications and additions of a sum of `products` that is added to something.
Cost products(int count) { return {.add = count, .mul = count, .fused = count}; }

}  // namespace

Function regular_solve(const RowSolve& solve) {
  Function f;
  const int r = solve.rows;
  f.signature.name = "solve_regular";
  f.signature.inputs = {{kMatrixArray, r * (r + 1) / 2, ""}, {kRightArray, r, ""}, {"d", r, ""}};
  f.signature.outputs = {{"d", r, ""}, {kWholeArray, std::max(r - 2, 0), ""}, {"x", r, ""}};
  const Triangle t = factor(f.graph, solve);
  std::vector<Expr> x;
  for (int k = 0; k < r; ++k) {
    const auto n = static_cast<std::size_t>(k);
    f.outputs.push_back(t.pivots[n].ref());
    Expr z(f.graph, f.graph.input(1, k));
    for (std::size_t j = 0; j < n; ++j) {
      z -= t.l[n][j] * x[j];
    }
    x.push_back(z);
  }
  for (std::size_t k = 2; k < x.size(); ++k) {
    f.outputs.push_back(t.wholes[k].ref());
  }
  for (std::size_t k = x.size(); k-- > 0;) {
    x[k] = x[k] * t.inverses[k];
    for (std::size_t i = k + 1; i < x.size(); ++i) {
      x[k] -= t.l[i][k] * x[i];
    }
  }
  std::ranges::transform(x, std::back_inserter(f.outputs), [](const Expr& e) { return e.ref(); });
  return f;
}

Cost regular_cost(const RowSolve& solve) {
  const int twice = solve.twice ? std::max(solve.rows - 2, 0) : 0;
  return cost(regular_solve(solve)) + Cost{.mul = solve.rows - 1 + twice};  // the thresholds
}

/// The loops of templates/solve_rows.cpp.in.
Cost deficient_cost(int rows, int rank, bool doubtful) {
  Cost c{.add = 2, .mul = 2 + rows - rank};  // the bound of what is left, independence
  for (int k = 0; k < rank; ++k) {
    const int below = rows - k - 1;
    c = c + Cost{.mul = 3 * (rows - k), .div = 1};                   // the search, 1 / pivot
    c = c + Cost{.mul = below} + products(below * (below + 1) / 2);  // M, the remainder
    for (int j = k; j < rank; ++j) {
      c = c + products(rows - j - 1);  // S = M^T M
    }
    c = c + products(rows - k - 1);  // M^T b
    c.div += 1;
    c = c + Cost{.mul = k} + products(k * (k + 1) / 2);  // elimination of S
    c = c + Cost{.mul = 2} + products(2 * 2 * k);        // two solutions with S
    c.mul += 1;                                          // D^-1
    c.mul += 2;                                          // what rounding makes of the pivot
    c = doubtful ? c + Cost{.add = k, .mul = 2 * k, .fused = k} + products(k * (k - 1) / 2) : c;
  }
  for (int i = 0; i < rows; ++i) {
    c = c + products(std::min(i, rank));         // M v
    c = c + Cost{.add = 2 * rows, .mul = rows};  // what is left of the row
  }
  return c;
}

Cost cost(const Staged& staged) {
  Cost c = cost(staged.function) + test_cost(staged.pivots);
  for (const RowSolve& solve : staged.solves) {
    c = c + (solve.regular() ? regular_cost(solve) : deficient_cost(solve.rows, solve.rank, false));
  }
  return c;
}

int worst_powers(const Staged& staged) {
  auto count = std::ranges::count(staged.gates, Gate::kPower);
  for (const Staged& contact : staged.contacts) {
    count += worst_powers(contact);
  }
  return static_cast<int>(count);
}

Cost worst_cost(const Staged& staged) {
  Cost c = cost(staged.function) + test_cost(staged.pivots);
  for (const RowSolve& solve : staged.solves) {
    const Cost regular = solve.regular() ? regular_cost(solve) : Cost{};
    c = c + regular + deficient_cost(solve.rows, solve.rows, true);
  }
  for (const Staged& contact : staged.contacts) {
    c = c + worst_cost(contact);
  }
  return c;
}

}  // namespace treedyn::program
