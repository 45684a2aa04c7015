#include "derive/derive.hpp"

#include <algorithm>

#include "derive/algebra.hpp"
#include "derive/columns.hpp"
#include "derive/forms.hpp"
#include "equations/dot.hpp"

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

/// The column of 3x3 blocks that has E at one place, as long as its blocks keep a kind.
bool derive_wide(const block::Expression& expression, Derivation& result) {
  const block::Side& side = result.by_rows ? result.shape.rows : result.shape.cols;
  if (side.size != 3) {
    return false;
  }
  Values values(result.values.choices());
  Columns columns(values, true);
  Algebra& algebra = columns.algebra();
  const int E = algebra.scale(algebra.unit(side.set, Type::kScalar), algebra.identity(side.set));
  const std::optional<int> root = result.shape.cols == block::Side{}
                                      ? columns.meet(expression, E, algebra.ones(Set::kOne))
                                      : columns.wide(expression, result.by_rows, E);
  if (root) {
    result.roots = {values.note(Rule::kUnits, *root)};
    result.values = std::move(values);
    result.wide = result.by_units = true;
  }
  return root.has_value();
}

/// The columns of a matrix of numbers between links by composites, if A e_j and A^T e_j derive to
/// the same, if all of it is zero but between links on one path and if the rows on the way to the
/// root need no others.
bool derive_symmetric(const block::Expression& expression, Derivation& result) {
  const block::Side joints{Set::kLinks, 1};
  if (result.shape != block::Shape{joints, joints}) {
    return false;
  }
  Choices choices = result.values.choices();
  const auto column = [&](Values& values, bool transposed) {
    Columns columns(values);
    const int unit = columns.algebra().unit(Set::kLinks, Type::kScalar);
    const int x = columns.apply(expression, transposed, unit);
    return choices.composites ? columns.algebra().on_way_to_root(x) : x;
  };
  Values plain(choices);
  if (column(plain, false) != column(plain, true)) {
    return false;
  }
  choices.composites = true;
  Values values(choices);
  try {
    const int root = column(values, false);
    if (places(values, root).beside) {
      return false;
    }
    values.note({Rule::kUnits, Rule::kSymmetric}, root);
    result.roots = {root};
  } catch (const NoComposites&) {
    return false;
  }
  result.values = std::move(values);
  result.symmetric = true;
  return true;
}

/// The columns of any matrix with one for each joint, all rows of a column by composites.
void derive_by_composites(const block::Expression& expression, Derivation& result) {
  Choices choices = result.values.choices();
  choices.composites = true;
  result.values = Values(choices);
  Columns columns(result.values);
  const int unit = columns.algebra().unit(Set::kLinks, Type::kScalar);
  result.roots = {result.values.note(Rule::kUnits, columns.apply(expression, false, unit))};
}

/// The same of a matrix of numbers between links.
bool derive_composites(const block::Expression& expression, Derivation& result) {
  const block::Side joints{Set::kLinks, 1};
  if (result.shape != block::Shape{joints, joints}) {
    return false;
  }
  derive_by_composites(expression, result);
  return true;
}

/// Three numbers for each joint, a sum over all links: column by column by composites, if tensors
/// would travel to the root for each of three rows and nothing of a column travels.
bool derive_sums(const block::Expression& expression, Derivation& result) {
  if (result.shape != block::Shape{{Set::kOne, 3}, {Set::kLinks, 1}}) {
    return false;
  }
  Derivation sums = result;
  derive_by_composites(expression, sums);
  const Values& values = sums.values;
  const std::vector<int> needed = values.needed(sums.roots);
  const auto travels = [&](int id) {
    return values.of_unit(id) && values[id].op >= Op::kPath && values[id].op <= Op::kSons;
  };
  if (std::ranges::none_of(needed, [&](int id) { return values[id].name == "I^d"; }) ||
      std::ranges::any_of(needed, travels)) {
    return false;
  }
  result = std::move(sums);
  result.by_units = true;
  result.by_rows = false;
  return true;
}

/// The columns (or rows) one by one.
void derive_unit(const block::Expression& expression, Derivation& result) {
  const block::Side& side = result.by_rows ? result.shape.rows : result.shape.cols;
  Columns columns(result.values);
  const Type type = side.size == 1 ? Type::kScalar : Type::kVector;
  const int unit = columns.algebra().unit(side.set, type);
  result.roots = {
      result.values.note(Rule::kUnits, columns.apply(expression, result.by_rows, unit))};
}

Derivation derive_with(const block::Expression& expression, bool by_rows, const Choices& choices) {
  Derivation result;
  result.values = Values(choices);
  result.shape = expression.shape();
  const bool one_col = result.shape.cols.set == Set::kOne;
  const bool one_row = result.shape.rows.set == Set::kOne;
  const bool column = result.shape.cols == block::Side{};
  result.by_units = !one_col && !one_row;
  if (result.by_units && (derive_wide(expression, result) || derive_symmetric(expression, result) ||
                          derive_composites(expression, result))) {
    return result;
  }
  if (derive_sums(expression, result)) {
    return result;
  }
  result.by_rows = one_row && !column ? true : one_col ? false : by_rows;
  if (result.by_units) {
    if (!result.by_rows || !derive_wide(expression, result)) {
      derive_unit(expression, result);
    }
    return result;
  }
  const block::Side& side = result.by_rows ? result.shape.rows : result.shape.cols;
  Columns columns(result.values);
  for (int k = 0; k < side.size; ++k) {
    const int unit = basis(columns.algebra(), side, k);
    result.roots.push_back(columns.apply(expression, result.by_rows, unit));
  }
  return result;
}

/// Sums along the tree that cannot be carried out while code is generated.
auto sums(const Derivation& derivation) {
  const std::vector<int> needed = derivation.values.needed(derivation.roots);
  return std::ranges::count_if(needed, [&](int id) {
    const Value& v = derivation.values[id];
    return v.type != Type::kScalar && v.op >= Op::kPath && v.op <= Op::kBackward;
  });
}

Derivation with_forms(Derivation derivation) {
  derivation.values = with_forms(derivation.values, derivation.roots);
  derivation.values = with_relative_speeds(derivation.values, derivation.roots);
  return derivation;
}

block::Expression places_of(const block::Expression& e, bool keeps_joints) {
  return keeps_joints ? e : equations::with_free_places(e);
}

/// Numbers alone can be transposed.
Derivation transposed(Derivation derivation) {
  for (int& root : derivation.roots) {
    const Value& v = derivation.values[root];
    if (!derivation.by_units && v.set == Set::kOne && v.type == Type::kScalar) {
      root = transposed(derivation.values, root).value_or(root);
    }
  }
  return derivation;
}

}  // namespace

std::optional<Derivation> derive_rows(const block::Expression& column, bool keeps_joints) {
  Derivation result;
  result.values = Values({.keeps_joints = keeps_joints});
  result.shape = column.shape();
  result.by_rows = true;
  return derive_wide(places_of(column, keeps_joints), result)
             ? std::optional(with_forms(std::move(result)))
             : std::nullopt;
}

Derivation derive(const block::Expression& expression, bool by_rows, bool keeps_joints) {
  const block::Expression seen = places_of(expression, keeps_joints);
  std::optional<Derivation> best;
  for (const bool common_leaves : {true, false}) {
    const Derivation plain = derive_with(seen, by_rows, {keeps_joints, common_leaves});
    for (const bool transposes : {false, true}) {
      Derivation next = with_forms(transposes ? transposed(plain) : plain);
      if (!best || sums(next) < sums(*best)) {
        best = std::move(next);
      }
    }
  }
  return *best;
}

}  // namespace treedyn::derive
