#include "formulate/scene_solution.hpp"

#include "common/index.hpp"
#include "formulate/factored.hpp"

namespace treedyn::formulate {
namespace {

/// Columns of E, a row for every joint.
SparseRows columns_of_unit(Graph& graph, const std::vector<int>& joints, int dof) {
  SparseRows result(to_index(dof));
  for (std::size_t u = 0; u < joints.size(); ++u) {
    result[to_index(joints[u])][static_cast<int>(u)] = constant(graph, Real(1));
  }
  return result;
}

/// J^T, a row for every joint.
SparseRows transposed(const std::vector<Row>& rows, std::size_t joints) {
  SparseRows result(joints);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const auto& [k, value] : rows[r].columns) {
      result[to_index(k)][static_cast<int>(r)] = value;
    }
  }
  return result;
}

}  // namespace

SceneSolution::SceneSolution(const char* function, Graph& graph, int dof,
                             const std::vector<Row>& rows, const Numbers::Leaf& leaf,
                             const std::vector<int>& passive)
    : numbers_(
          graph, dof, factored(function).derivation,
          [&](const std::string& symbol) {
            return symbol == "J^T"   ? transposed(rows, to_index(dof))
                   : symbol == "E_u" ? columns_of_unit(graph, passive, dof)
                                     : leaf(symbol);
          },
          static_cast<int>(rows.size()), static_cast<int>(passive.size())) {}

std::vector<Expr> SceneSolution::equations() const {
  std::vector<Expr> result;
  const SparseRows& K = numbers_.root(0);
  for (std::size_t i = 0; i < K.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto found = K[i].find(static_cast<int>(j));
      result.push_back(found == K[i].end() ? Expr() : found->second);
    }
  }
  const std::vector<Expr> b = column_of(numbers_.root(1));
  result.insert(result.end(), b.begin(), b.end());
  return result;
}

}  // namespace treedyn::formulate
