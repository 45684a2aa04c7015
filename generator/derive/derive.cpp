#include "derive/derive.hpp"

#include "derive/columns.hpp"

namespace treedyn::derive {
namespace {

/// The unit vector e_k, or the number 1.
int basis(Algebra& algebra, const block::Side& side, int k) {
  if (side.size == 1) {
    return algebra.ones(Set::kOne);
  }
  std::vector<int> components(3, algebra.zero(Set::kOne, Type::kScalar));
  components[static_cast<std::size_t>(k)] = algebra.ones(Set::kOne);
  return algebra.assemble(components);
}

}  // namespace

Derivation derive(const block::Expression& expression, bool by_rows) {
  Derivation result;
  result.shape = expression.shape();
  const bool one_col = result.shape.cols.set == Set::kOne;
  const bool one_row = result.shape.rows.set == Set::kOne;
  const bool column = result.shape.cols == block::Side{};
  result.by_rows = one_row && !column ? true : one_col ? false : by_rows;
  result.by_units = !one_col && !one_row;
  Columns columns(result.values);
  const block::Side& side = result.by_rows ? result.shape.rows : result.shape.cols;
  if (result.by_units) {
    result.values.note(Rule::kUnits);
    const Type type = side.size == 1 ? Type::kScalar : Type::kVector;
    result.roots = {
        columns.apply(expression, result.by_rows, columns.algebra().unit(side.set, type))};
    return result;
  }
  for (int k = 0; k < side.size; ++k) {
    const int unit = basis(columns.algebra(), side, k);
    result.roots.push_back(columns.apply(expression, result.by_rows, unit));
  }
  return result;
}

}  // namespace treedyn::derive
