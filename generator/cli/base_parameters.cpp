#include "cli/base_parameters.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/transformed.hpp"
#include "emit/json.hpp"
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
Eigen::Index measurable(const std::vector<Row>& rows, double size) {
  Eigen::MatrixXd Y(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const double scale = k % kParameters == 0 && size > 0 ? size : 1;
      Y(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          static_cast<double>(rows[i][k]) / scale;
    }
  }
  return Eigen::FullPivLU<Eigen::MatrixXd>(Y).setThreshold(1e-5).rank();
}

/// A parameter of the robot and the factor that it has in a combination.
struct Term {
  std::size_t column = 0;
  Real factor;
};

struct BaseParameters {
  std::vector<std::vector<Term>> combinations;  ///< first in each the column that stays, times 1
  Eigen::Index to_five_digits = 0;              ///< how many of them
};

BaseParameters base_parameters(const Model& model, const Request& request) {
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
  BaseParameters result;
  result.to_five_digits = measurable(rows, model::size_of(tree, {}));
  const Real zero("1e-20");
  for (const std::size_t own : reduce(rows, columns)) {
    const Row& row = rows[result.combinations.size()];
    std::vector<Term> terms = {{own, 1}};
    for (std::size_t column = own + 1; column < columns; ++column) {
      if (abs(row[column]) > zero) {
        terms.push_back({column, abs(abs(row[column]) - 1) < zero ? Real(row[column] < 0 ? -1 : 1)
                                                                  : row[column]});
      }
    }
    result.combinations.push_back(std::move(terms));
  }
  return result;
}

std::string in_lines(const model::Tree& tree, const BaseParameters& found) {
  std::string result =
      fmt::format("base parameters: {} of {}; columns of inverse_dynamics_regressor, from 0\n",
                  found.combinations.size(), kParameters * tree.links.size());
  for (const std::vector<Term>& terms : found.combinations) {
    result +=
        fmt::format("{:5}  {}", terms.front().column, parameter_name(tree, terms.front().column));
    for (std::size_t k = 1; k < terms.size(); ++k) {
      const Real size = abs(terms[k].factor);
      result += fmt::format(" {} {}{}", terms[k].factor < 0 ? '-' : '+',
                            size == 1 ? "" : emit::decimal(size) + " ",
                            parameter_name(tree, terms[k].column));
    }
    result += "\n";
  }
  if (found.to_five_digits < std::ssize(found.combinations)) {
    result += fmt::format(
        "to five digits: {}; what is beyond can hardly be measured; where an angle just misses a "
        "special value, vet names it and --snap takes that one\n",
        found.to_five_digits);
  }
  return result;
}

std::string in_json(const model::Tree& tree, const BaseParameters& found) {
  const auto term_json = [&](const Term& term) {
    return emit::json_object({{"column", std::to_string(term.column)},
                              {"parameter", emit::json_string(parameter_name(tree, term.column))},
                              {"factor", emit::decimal(term.factor)}});
  };
  return fmt::format(
      "{{\n  \"columns\": {},\n  \"to_five_digits\": {},\n  \"base_parameters\": {}\n}}\n",
      kParameters * tree.links.size(), found.to_five_digits,
      emit::json_lines(transformed(found.combinations,
                                   [&](const std::vector<Term>& terms) {
                                     return emit::json_list(transformed(terms, term_json));
                                   }),
                       4));
}

}  // namespace

std::string base_parameters_text(const Model& model, const Request& request, bool json) {
  const BaseParameters found = base_parameters(model, request);
  return json ? in_json(model.tree, found) : in_lines(model.tree, found);
}

}  // namespace treedyn
