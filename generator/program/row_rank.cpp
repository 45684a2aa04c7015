#include "program/row_rank.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/index.hpp"
#include "program/random.hpp"

namespace treedyn::program {

namespace {

using Values = std::vector<double>;

constexpr int kSamples = 8;          ///< states near the first one
constexpr int kSteps = 60;           ///< of one search
constexpr double kHolds = 1e-9;      ///< error of rows that hold, of what a reach changes
constexpr double kMoves = 1e-2;      ///< in reaches: states of a mechanism that moves differ
constexpr double kShortest = 1e-14;  ///< of all rows and a row's scale: what is smaller is rounding

/// phi and J in a state, columns per reach instead of per rad or m.
struct Sample {
  Values phi, J;
};

Sample sample(const ConstraintRows& rows, const Values& q, const Values& reach) {
  Sample result{Values(to_index(rows.rows)), Values(to_index(rows.rows * rows.columns))};
  rows.evaluate(q, result.phi, result.J);
  for (std::size_t k = 0; k < result.J.size(); ++k) {
    result.J[k] *= reach[k % to_index(rows.columns)];
  }
  return result;
}

double norm(const double* x, std::size_t n) {
  return std::sqrt(std::inner_product(x, x + n, x, 0.0));
}

/// Errors as parts of what a reach of every coordinate changes, or of what it ordinarily would.
double error_of(const Sample& at, const Values& scales) {
  const double ordinary = norm(scales.data(), scales.size());
  const double changes = norm(at.J.data(), at.J.size());
  return norm(at.phi.data(), at.phi.size()) /
         std::max(changes > kShortest * ordinary ? changes : ordinary, 1e-300);
}

/// x of S x = b by Cholesky's factors, in place. \pre S (n x n) is positive definite
void solve(Values& S, Values& b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j <= k; ++j) {
      double sum = S[k * n + j];
      for (std::size_t m = 0; m < j; ++m) {
        sum -= S[k * n + m] * S[j * n + m];
      }
      S[k * n + j] = j < k ? sum / S[j * n + j] : std::sqrt(std::max(sum, 1e-300));
    }
    b[k] = (b[k] - std::inner_product(&S[k * n], &S[k * n] + k, b.begin(), 0.0)) / S[k * n + k];
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) {
      b[k] -= S[j * n + k] * b[j];
    }
    b[k] /= S[k * n + k];
  }
}

/// Rows of one length, which is 1; rows that are rounding are zero.
void normalise(Sample& at, const Values& scales, std::size_t n) {
  const double longest = norm(at.J.data(), at.J.size());
  for (std::size_t i = 0; i < at.phi.size(); ++i) {
    double* const row = at.J.data() + i * n;
    const double length = norm(row, n);
    const double scale = length > kShortest * std::max(longest, scales[i]) ? 1 / length : 0;
    std::transform(row, row + n, row, [&](double x) { return x * scale; });
    at.phi[i] *= scale;
  }
}

/// One step towards phi = 0: (J^T J + mu) x = -J^T phi, mu = |phi|.
void step(const ConstraintRows& rows, const Values& reach, Sample at, Values& q) {
  const std::size_t n = q.size();
  normalise(at, rows.scales, n);
  const double mu = norm(at.phi.data(), at.phi.size()) + 1e-14;
  Values S(n * n);
  Values x(n);
  for (std::size_t r = 0; r < to_index(rows.rows); ++r) {
    const double* const row = at.J.data() + r * n;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] -= row[i] * at.phi[r];
      for (std::size_t j = 0; j <= i; ++j) {
        S[i * n + j] += row[i] * row[j];
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    S[i * n + i] += mu;
  }
  solve(S, x);
  for (std::size_t i = 0; i < n; ++i) {
    q[i] += reach[i] * x[i];
  }
}

/// True if it gets where the rows hold.
bool approach(const ConstraintRows& rows, const Values& reach, Values& q) {
  double least = HUGE_VAL;
  Values best = q;
  for (int k = 0; k < kSteps; ++k) {
    const Sample at = sample(rows, q, reach);
    const double error = error_of(at, rows.scales);
    if (!(error >= 0)) {
      break;
    }
    if (error < least) {
      least = error;
      best = q;
    }
    if (error < 1e-15) {
      break;
    }
    step(rows, reach, at, q);
  }
  q = best;
  return least < kHolds;
}

/// Rows that are independent of those before them, the longest rest first.
int rank_of_rows(Values J, std::size_t n, const Values& sizes) {
  const std::size_t r = sizes.size();
  std::vector<bool> done(r);
  int rank = 0;
  for (; to_index(rank) < std::min(r, n); ++rank) {
    std::size_t best = r;
    double most = kDependent;
    for (std::size_t i = 0; i < r; ++i) {
      const double rest = done[i] || sizes[i] == 0 ? 0 : norm(&J[i * n], n) / sizes[i];
      best = rest > most ? i : best;
      most = std::max(most, rest);
    }
    if (best == r) {
      break;
    }
    done[best] = true;
    const double length = norm(&J[best * n], n);
    for (std::size_t i = 0; i < r; ++i) {
      double* const row = &J[i * n];
      const double share =
          done[i] ? 0 : std::inner_product(row, row + n, &J[best * n], 0.0) / (length * length);
      for (std::size_t k = 0; k < n; ++k) {
        row[k] -= share * J[best * n + k];
      }
    }
  }
  return rank;
}

/// Norms of the rows, the largest of some states; of rows that are rounding zero.
Values sizes_of(const ConstraintRows& rows, const std::vector<Values>& states, const Values& reach,
                const std::vector<bool>& counts) {
  Values sizes(to_index(rows.rows));
  const std::size_t n = to_index(rows.columns);
  double longest = 0;
  for (const Values& q : states) {
    const Sample at = sample(rows, q, reach);
    longest = std::max(longest, norm(at.J.data(), at.J.size()));
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) {
        sum += counts[k] ? at.J[i * n + k] * at.J[i * n + k] : 0;
      }
      sizes[i] = std::max(sizes[i], std::sqrt(sum));
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = sizes[i] > kShortest * std::max(longest, rows.scales[i]) ? sizes[i] : 0;
  }
  return sizes;
}

/// How far states lie from the first one, in reaches.
double spread_of(const std::vector<Values>& states, const Values& reach) {
  double most = 0;
  for (const Values& q : states) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      most = std::max(most, std::abs(q[i] - states.front()[i]) / reach[i]);
    }
  }
  return most;
}

}  // namespace

OrdinaryRows ordinary_rows(const ConstraintRows& rows, const Values& q0, const Values& reach,
                           const std::vector<int>& columns) {
  Random random(3);
  OrdinaryRows result;
  std::vector<Values> held;
  std::vector<Values> near;
  Values start = q0;
  if (approach(rows, reach, start)) {
    held.push_back(start);
  }
  for (int k = 0; k < kSamples; ++k) {
    Values q = start;
    const double size = k < kSamples / 2 ? 0.05 : 0.4;
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += size * reach[i] * static_cast<double>(random.symmetric());
    }
    near.push_back(q);
    if (approach(rows, reach, q)) {
      held.push_back(q);
    }
  }
  std::vector<bool> counts(to_index(rows.columns), columns.empty());
  for (const int k : columns) {
    counts[to_index(k)] = true;
  }
  result.holds = !held.empty();
  result.states = near;
  result.states.insert(result.states.end(), held.begin(), held.end());
  result.lengths = sizes_of(rows, result.states, reach, counts);
  for (const Values& q : result.holds ? held : near) {
    Sample at = sample(rows, q, reach);
    for (std::size_t k = 0; k < at.J.size(); ++k) {
      at.J[k] *= counts[k % to_index(rows.columns)] ? 1 : 0;
    }
    result.rank = std::max(result.rank, rank_of_rows(at.J, to_index(rows.columns), result.lengths));
  }
  // rows that leave velocities free and hold in one place only: a singular position
  const bool moves = spread_of(held, reach) > kMoves;
  result.holds = result.holds && (moves || (columns.empty() && result.rank == rows.columns));
  return result;
}

}  // namespace treedyn::program
