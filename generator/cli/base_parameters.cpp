#include "cli/base_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/transformed.hpp"
#include "emit/literal.hpp"
#include "model/reach.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

using Row = std::vector<Real>;

constexpr std::size_t kParameters = 10;

/// Rows of Y at states at random, enough of them for any rank.
std::vector<Row> rows_of(const program::Function& regressor, std::size_t columns) {
  program::Random random(11);
  std::vector<Row> rows;
  while (rows.size() < columns + kParameters) {
    std::vector<Row> state;
    for (const program::Array& array : regressor.signature.inputs) {
      state.emplace_back();
      for (int k = 0; k < array.size; ++k) {
        state.back().emplace_back(3 * random.symmetric());
      }
    }
    const Row Y = program::interpret<Real>(regressor, {state.begin(), state.end()});
    for (std::size_t first = 0; first < Y.size(); first += columns) {
      rows.emplace_back(Y.begin() + static_cast<std::ptrdiff_t>(first),
                        Y.begin() + static_cast<std::ptrdiff_t>(first + columns));
    }
  }
  return rows;
}

/// Reduced row echelon form by the largest pivots: the columns of the pivots; row k of the result
/// belongs to the k-th of them.
std::vector<std::size_t> reduce(std::vector<Row>& rows, std::size_t columns) {
  const Real zero("1e-30");
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < columns; ++column) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(pivots.size());
    const auto largest = std::max_element(from, rows.end(), [&](const Row& a, const Row& b) {
      return abs(a[column]) < abs(b[column]);
    });
    if (largest == rows.end() || abs((*largest)[column]) < zero) {
      continue;
    }
    std::iter_swap(from, largest);
    Row& pivot = *from;
    pivots.push_back(column);
    const Real scale = 1 / pivot[column];
    std::ranges::for_each(pivot, [&](Real& x) { x *= scale; });
    for (Row& row : rows) {
      if (&row == &pivot || row[column] == 0) {
        continue;
      }
      const Real factor = row[column];
      for (std::size_t k = column; k < columns; ++k) {
        row[k] -= factor * pivot[k];
      }
      row[column] = 0;
    }
  }
  rows.resize(pivots.size());
  return pivots;
}

std::string parameter_name(const model::Tree& tree, std::size_t column) {
  static constexpr std::array<const char*, kParameters> kNames = {
      "m", "m_c_x", "m_c_y", "m_c_z", "xx", "xy", "xz", "yy", "yz", "zz"};
  return fmt::format("{}.{}", tree.links[column / kParameters].name, kNames[column % kParameters]);
}

/// How many columns are independent by more than 1e-5 of the best of them, by elimination with the
/// largest pivot of all. Masses are taken at the size of the robot.
std::size_t measurable(const std::vector<Row>& exact, double size) {
  using Doubles = std::vector<double>;
  std::vector<std::size_t> left(exact.front().size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<Doubles> rows = transformed(exact, [&](const Row& row) {
    Doubles result(row.size());
    for (const std::size_t column : left) {
      const double scale = column % kParameters == 0 && size > 0 ? size : 1;
      result[column] = static_cast<double>(row[column]) / scale;
    }
    return result;
  });
  double least = 0;
  std::size_t rank = 0;
  while (!left.empty()) {
    std::size_t at = rank;
    std::size_t best = 0;
    for (std::size_t i = rank; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < left.size(); ++k) {
        const bool larger = std::abs(rows[i][left[k]]) > std::abs(rows[at][left[best]]);
        at = larger ? i : at;
        best = larger ? k : best;
      }
    }
    std::swap(rows[rank], rows[at]);
    const Doubles& pivot = rows[rank];
    const std::size_t column = left[best];
    least = rank == 0 ? 1e-5 * std::abs(pivot[column]) : least;
    if (std::abs(pivot[column]) < least) {
      break;
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    for (std::size_t i = ++rank; i < rows.size(); ++i) {
      const double factor = rows[i][column] / pivot[column];
      for (const std::size_t k : left) {
        rows[i][k] -= factor * pivot[k];
      }
    }
  }
  return rank;
}

}  // namespace

std::string base_parameters_text(const Model& model, const Request& request) {
  const model::Tree& tree = model.tree;
  if (tree.mimics() > 0) {
    throw InputError({request.model, 0, 0},
                     fmt::format("base parameters need a coordinate for every joint and {} joints "
                                 "follow others; expected --mimic independent",
                                 tree.mimics()));
  }
  formulate::Options options = formulate_options(model, request);
  options.effort = 0;
  const std::size_t columns = kParameters * tree.links.size();
  std::vector<Row> rows =
      rows_of(formulate::formulated(tree, "inverse_dynamics_regressor", options), columns);
  const std::vector<Row> all = rows;
  const std::vector<std::size_t> pivots = reduce(rows, columns);
  std::string result =
      fmt::format("base parameters: {} of {}; columns of inverse_dynamics_regressor, from 0\n",
                  pivots.size(), columns);
  const Real zero("1e-20");
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    const std::size_t own = pivots[k];
    result += fmt::format("{:5}  {}", own, parameter_name(tree, own));
    for (std::size_t column = own + 1; column < columns; ++column) {
      const Real& x = rows[k][column];
      if (abs(x) > zero) {
        const Real size = abs(x);
        result += fmt::format(" {} {}{}", x < 0 ? '-' : '+',
                              abs(size - 1) < zero ? "" : emit::decimal(size) + " ",
                              parameter_name(tree, column));
      }
    }
    result += "\n";
  }
  const std::size_t rank = measurable(all, model::size_of(tree, {}));
  if (rank < pivots.size()) {
    result += fmt::format(
        "to five digits: {}; what is beyond can hardly be measured; where an angle just misses a "
        "special value, vet names it and --snap takes that one\n",
        rank);
  }
  return result;
}

}  // namespace treedyn
