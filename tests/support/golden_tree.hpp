// Golden cases (EQUATIONS.md 9) as trees and numbers, without any reader of ours.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::support {

/// A constraint row: a unit force or moment on a link.
struct GoldenRow {
  model::Point point;  ///< link in tree order
  bool moment = false;
  model::Vector3 direction{};  ///< base frame
};

/// A file of tests/data/golden. Links and joint arrays are in the order of `tree` (fathers first).
struct GoldenCase {
  std::string name;
  model::Tree tree;
  std::vector<model::Point> points;  ///< t of every link, in tree order
  model::Vector3 gravity{};
  std::vector<double> q, qd, qdd_in, tau;
  std::vector<double> f, n;     ///< 3 N, in tree order
  std::vector<GoldenRow> rows;  ///< empty without constraints
  /// R [9N], O [3N], P [3N], A [N N], B, C [N 3N], H, G, gamma_f, gamma_n, qdd, tau_id, row-major,
  /// in tree order; G on the right-hand side as in the file.
  std::map<std::string, std::vector<double>> expected;
};

/// Reads one file; numbers keep their 17 digits.
GoldenCase read_golden(const std::string& path);

/// All files of tests/data/golden, by name.
std::vector<std::string> golden_files();

/// max |x - y| <= tol * max|y|, absolute where max|y| < 1e-9 (EQUATIONS.md 9): the left side
/// divided by what tol multiplies.
template <class Scalar>
double golden_error(const std::vector<Scalar>& x, const std::vector<double>& y) {
  double error = x.size() == y.size() ? 0 : 1e300;
  double scale = 0;
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) {
    const auto difference = static_cast<double>(x[i] - static_cast<Scalar>(y[i]));
    if (std::isnan(difference)) {
      return difference;
    }
    error = std::max(error, std::abs(difference));
    scale = std::max(scale, y[i] < 0 ? -y[i] : y[i]);
  }
  return scale < 1e-9 ? error : error / scale;
}

}  // namespace treedyn::support
