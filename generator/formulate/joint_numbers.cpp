#include "formulate/joint_numbers.hpp"

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/functions.hpp"

namespace treedyn::formulate {
namespace {

using derive::Op;

constexpr const char* kNoPivot =
    "the mass matrix is singular to 40 digits; expected masses, lengths and inertias of fewer "
    "decades, or --functions without forward dynamics";

void subtract_multiple(SparseRow& x, const Expr& factor, const SparseRow& other) {
  for (const auto& [j, x_j] : other) {
    x[j] -= factor * x_j;
  }
}

}  // namespace

SparseRows sparse(int size, const SparseSymmetric& lower) {
  SparseRows rows(to_index(size));
  for (const auto& [place, entry] : lower) {
    TREEDYN_EXPECT(place.first >= place.second);
    if (!entry.is_zero()) {
      rows[to_index(place.first)][place.second] = entry;
    }
  }
  return rows;
}

SparseRows sparse(const std::vector<Expr>& column) {
  SparseRows rows;
  for (const Expr& x : column) {
    rows.push_back({{0, x}});
  }
  return rows;
}

std::vector<Expr> column_of(const SparseRows& rows) {
  return transformed(
      rows, [&](const SparseRow& row) { return row.empty() ? Expr() : row.begin()->second; });
}

Numbers::Numbers(Graph& graph, int size, const derive::Derivation& derivation, const Leaf& leaf,
                 int reactions, int passive)
    : graph_(graph),
      size_(to_index(size)),
      reactions_(to_index(reactions)),
      passive_(to_index(passive)),
      derivation_(derivation),
      needed_(derivation.values.needed(derivation.roots)),
      rows_(to_index(derivation.values.size())),
      costs_(to_index(derivation.values.size())) {
  for (const int id : needed_) {
    if (rows_[to_index(id)].empty() && derivation.values[id].op != Op::kTravelling) {
      run(id, leaf);
    }
  }
}

void Numbers::run(int id, const Leaf& leaf) {
  const derive::Value& v = derivation_.values[id];
  if (v.op == Op::kLeaf && v.name != "E") {
    rows_[to_index(id)] = leaf(v.name);
  } else if (v.op == Op::kEliminated) {
    eliminate(id, defined(v.operands[1]));
  } else if (v.op == Op::kFromLeaves) {
    rows_[to_index(id)] = rows_[to_index(v.operands[0])];
    for (std::size_t k = size_; k-- > 0;) {
      hand_on(id, v.operands[1], k);
    }
  } else {
    const std::size_t size = size_of(v.set);
    rows_[to_index(id)].resize(size);
    for (std::size_t k = 0; k < size; ++k) {
      make(id, k);
    }
  }
}

/// a and what L' is made of, row by row from the leaves.
void Numbers::eliminate(int id, int until) {
  rows_[to_index(id)] = rows_[to_index(derivation_.values[id].operands[0])];
  for (std::size_t k = size_; k-- > 0;) {
    graph_.set_body(static_cast<int>(k));
    for (const int g : needed_) {
      if (g > id && g <= until) {
        rows_[to_index(g)].resize(size_);
        make(g, k);
      }
    }
    hand_on(id, until, k);
  }
}

/// What row k takes from rows above it: x_i -= L'_ki x_k, the lower half of a.
void Numbers::hand_on(int id, int below, std::size_t k) {
  const std::size_t before = graph_.size();
  SparseRows& x = rows_[to_index(id)];
  const bool lower = derivation_.values[id].op == Op::kEliminated;
  const SparseRow& l = of(below, k);
  for (auto entry = l.rbegin(); entry != l.rend(); ++entry) {
    const auto& [i, l_ki] = *entry;
    for (const auto& [j, x_kj] : x[k]) {
      if (!lower || j <= i) {
        x[to_index(i)][j] -= l_ki * x_kj;
      }
    }
  }
  count_new(graph_, before, costs_[to_index(id)]);
}

void Numbers::make(int id, std::size_t k) {
  const std::size_t before = graph_.size();
  rows_[to_index(id)][k] = row(id, k);
  std::erase_if(rows_[to_index(id)][k], [](const auto& entry) { return entry.second.is_zero(); });
  count_new(graph_, before, costs_[to_index(id)]);
}

SparseRow Numbers::row(int id, std::size_t k) const {
  const derive::Value& v = derivation_.values[id];
  if (v.op == Op::kTransposed) {
    return transposed(v, k);
  }
  const int place = static_cast<int>(k);
  const Expr one = constant(graph_, Real(1));
  SparseRow x = v.operands.empty() ? SparseRow{{place, one}} : of(v.operands[0], k);
  switch (v.op) {
    case Op::kLinear:
      return linear(v, k);
    case Op::kDiagonal:
      if (x[place].is_zero()) {
        throw std::range_error(kNoPivot);
      }
      return {{place, x[place]}};
    case Op::kReciprocal:
      x[place] = one / x[place];
      graph_.name(x[place].ref(), "inverse_pivot", place);
      return x;
    case Op::kScale: {
      const Expr factor = x.at(place);
      x = of(v.operands[1], k);
      for (auto& [_, number] : x) {
        number = factor * number;
      }
      return x;
    }
    case Op::kFromRoot: {
      const SparseRow& l = of(v.operands[1], k);
      for (auto entry = l.rbegin(); entry != l.rend(); ++entry) {
        subtract_multiple(x, entry->second, of(id, to_index(entry->first)));
      }
      return x;
    }
    case Op::kApply:
      return applied(v, k);
    case Op::kCongruence:
      return congruent(v, k);
    default:
      return x;
  }
}

SparseRow Numbers::linear(const derive::Value& v, std::size_t k) const {
  SparseRow sum;
  for (std::size_t n = 0; n < v.operands.size(); ++n) {
    const Expr factor = constant(graph_, Real(v.factors[n].numerator) / v.factors[n].denominator);
    for (const auto& [j, x] : of(v.operands[n], k)) {
      sum[j] += factor * x;
    }
  }
  return sum;
}

SparseRow Numbers::transposed(const derive::Value& v, std::size_t k) const {
  SparseRow result;
  const SparseRows& rows = rows_[to_index(defined(v.operands[0]))];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SparseRow& row = rows[i];
    if (const auto entry = row.find(static_cast<int>(k)); entry != row.end()) {
      result.emplace(static_cast<int>(i), entry->second);
    }
  }
  return result;
}

/// Row k of a matrix times a column.
SparseRow Numbers::applied(const derive::Value& v, std::size_t k) const {
  SparseRow sum;
  for (const auto& [j, factor] : of(v.operands[0], k)) {
    for (const auto& [place, x] : of(v.operands[1], to_index(j))) {
      sum[place] += factor * x;
    }
  }
  return sum;
}

/// Row i of Y d Y^T or of Y Y^T, the lower half.
SparseRow Numbers::congruent(const derive::Value& v, std::size_t i) const {
  SparseRow result;
  const SparseRow& y_i = of(v.operands[0], i);
  for (std::size_t j = 0; j <= i; ++j) {
    for (const auto& [k, y_jk] : of(v.operands[0], j)) {
      if (const auto y_ik = y_i.find(k); y_ik != y_i.end()) {
        const bool one = v.operands.size() == 1;
        result[static_cast<int>(j)] +=
            y_ik->second * (one ? y_jk : y_jk * of(v.operands[1], to_index(k)).at(k));
      }
    }
  }
  return result;
}

std::size_t Numbers::size_of(block::Set set) const {
  return set == block::Set::kRows ? reactions_ : set == block::Set::kPassive ? passive_ : size_;
}

/// The value that a travelling one is.
int Numbers::defined(int id) const {
  const auto& definitions = derivation_.values.definitions();
  const auto found = definitions.find(id);
  return found == definitions.end() ? id : found->second;
}

}  // namespace treedyn::formulate
