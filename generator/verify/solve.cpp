#include "verify/solve.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace treedyn {

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

Solution least_squares(const Matrix& K, const Values& b) {
  Matrix square;
  Values right;
  for (const Values& row : K) {  // of the symmetric K
    square.emplace_back();
    std::ranges::transform(K, std::back_inserter(square.back()), [&](const Values& column) {
      return std::inner_product(row.begin(), row.end(), column.begin(), Real(0));
    });
    right.push_back(std::inner_product(row.begin(), row.end(), b.begin(), Real(0)));
  }
  Solution result = solved(std::move(square), std::move(right));
  result.least = sqrt(result.least);
  return result;
}

}  // namespace treedyn
