#include "verify/solve.hpp"

#include <algorithm>
#include <numeric>

#include "common/transformed.hpp"

namespace treedyn::verify {

Real dot(const Values& a, const Values& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Real(0));
}

Real largest(const Values& values) {
  return std::accumulate(
      values.begin(), values.end(), Real(0),
      [](const Real& most, const Real& x) { return std::max(most, Real(abs(x))); });
}

Solution solved(Matrix s, Values b, const Real& least) {
  const std::size_t n = b.size();
  std::vector<std::size_t> order;
  Solution result{Values(n), 1};
  Values& x = result.x;
  const auto free = [&](std::size_t i) {
    return std::ranges::find(order, i) == order.end();
  };
  const Matrix whole = s;
  const auto share = [&](std::size_t i) {  // of its own diagonal entry
    return whole[i][i] > 0 ? Real(s[i][i] / whole[i][i]) : Real(0);
  };
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t p = n;
    for (std::size_t i = 0; i < n; ++i) {
      p = free(i) && (p == n || share(i) > share(p)) ? i : p;
    }
    if (!(share(p) > least)) {
      break;
    }
    order.push_back(p);
    result.least = std::min(result.least, share(p));
    for (std::size_t i = 0; i < n; ++i) {
      if (!free(i)) {
        continue;
      }
      const Real factor = s[i][p] / s[p][p];
      for (std::size_t j = 0; j < n; ++j) {
        s[i][j] -= factor * s[p][j];
      }
      b[i] -= factor * b[p];
    }
  }
  for (auto p = order.rbegin(); p != order.rend(); ++p) {
    Real sum = b[*p];
    for (std::size_t j = 0; j < n; ++j) {
      sum -= j == *p ? Real(0) : Real(s[*p][j] * x[j]);
    }
    x[*p] = sum / s[*p][*p];
  }
  return result;
}

namespace {

/// The columns of L of K = L L^T. \param[out] least  the smallest pivot
Matrix factored(const Matrix& K, Real& least) {
  Matrix rest = K;
  Matrix columns;
  const auto share = [&](std::size_t i) {  // of its own diagonal entry
    return K[i][i] > 0 ? Real(rest[i][i] / K[i][i]) : Real(0);
  };
  while (columns.size() < K.size()) {
    std::size_t p = 0;
    for (std::size_t i = 1; i < K.size(); ++i) {
      p = share(i) > share(p) ? i : p;
    }
    if (!(share(p) > Real("1e-25"))) {
      break;
    }
    least = std::min(least, share(p));
    const Real root = sqrt(rest[p][p]);
    const Values column = transformed<Real>(rest[p], [&](const Real& x) { return x / root; });
    for (std::size_t i = 0; i < K.size(); ++i) {
      for (std::size_t j = 0; j < K.size(); ++j) {
        rest[i][j] = i == p || j == p ? Real(0) : Real(rest[i][j] - column[i] * column[j]);
      }
    }
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

Solution least_squares(const Matrix& K, const Values& b) {
  Solution result{Values(b.size()), 1};
  const Matrix columns = factored(K, result.least);
  const Matrix squared = transformed<Values>(columns, [&](const Values& column) {
    return transformed<Real>(columns, [&](const Values& other) { return dot(column, other); });
  });
  Values along = transformed<Real>(columns, [&](const Values& column) { return dot(column, b); });
  for (int pass = 0; pass < 2; ++pass) {
    Solution once = solved(squared, along, 0);
    along = std::move(once.x);
    result.least = std::min(result.least, once.least);
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (std::size_t i = 0; i < b.size(); ++i) {
      result.x[i] += columns[k][i] * along[k];
    }
  }
  return result;
}

}  // namespace treedyn::verify
