// R12: equations for numbers of joints, by factors of A whose zeros are those of D.
#include <algorithm>

#include "derive/derive.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::Kind;

bool is_leaf(const Expression& e, const std::string& name) {
  return e.kind() == Kind::kLeaf && e.node().name == name;
}

bool holds(const Expression& e, const std::string& name) {
  return is_leaf(e, name) || std::any_of(e.operands().begin(), e.operands().end(),
                                         [&](const Expression& f) { return holds(f, name); });
}

class Factoring {
 public:
  Factoring(Factored& result, std::string unknown)
      : result_(result), values_(result.derivation.values), unknown_(std::move(unknown)) {}

  bool run(const Expression& equation);

 private:
  using Sum = std::vector<std::pair<Ratio, Expression>>;
  using Terms = std::vector<std::pair<Ratio, int>>;

  void open(const Ratio& factor, const Expression& e);
  int made(Op op, std::vector<int> operands, const std::string& name = "") {
    return values_.intern({op, Set::kLinks, Type::kScalar, name, 0, std::move(operands), {}});
  }
  int identity() { return made(Op::kLeaf, {}, "E"); }
  int given(const char* name, const Sum& sum);
  int sum(const Terms& terms);
  int right();
  bool factor(const Sum& A);
  int solve(Op op, int r, const std::string& name) {
    return values_.note(Rule::kTriangles, made(op, {r, below_}, name));
  }
  bool solve(const Expression& matrix);

  Factored& result_;
  Values& values_;
  std::string unknown_;
  Sum with_;          ///< terms with the unknown
  Sum without_;       ///< the others
  int below_ = -1;    ///< L' = L - E
  int inverse_ = -1;  ///< Δ^-1
};

void Factoring::open(const Ratio& factor, const Expression& e) {
  if (e.kind() == Kind::kScaled) {
    open(multiply(factor, e.node().factor), e.operands().front());
  } else if (e.kind() == Kind::kSum) {
    for (const Expression& term : e.operands()) {
      open(factor, term);
    }
  } else {
    (holds(e, unknown_) ? with_ : without_).emplace_back(factor, e);
  }
}

/// A leaf that stands for a sum.
int Factoring::given(const char* name, const Sum& sum) {
  std::optional<Expression> all;
  for (const auto& [factor, e] : sum) {
    const Expression term = factor == kPlus ? e : factor * e;
    all = all ? *all + term : term;
  }
  result_.given.emplace_back(name, *all);
  return made(Op::kLeaf, {}, name);
}

int Factoring::sum(const Terms& terms) {
  Value value{Op::kLinear, Set::kLinks, Type::kScalar, {}, 0, {}, {}};
  for (const auto& [factor, x] : terms) {
    value.factors.push_back(factor);
    value.operands.push_back(x);
  }
  return value.factors == std::vector{kPlus} ? value.operands.front() : values_.intern(value);
}

/// What the unknown's term is equal to: symbols as they are, less one column h of all else.
int Factoring::right() {
  Sum rest;
  std::copy_if(without_.begin(), without_.end(), std::back_inserter(rest),
               [](const auto& term) { return term.second.kind() != Kind::kLeaf; });
  const int h = rest.empty() ? -1 : given("h", rest);
  Terms terms;
  for (const auto& [factor, e] : without_) {
    if (e.kind() == Kind::kLeaf) {
      terms.emplace_back(multiply(kMinus, factor), made(Op::kLeaf, {}, e.node().name));
    }
  }
  if (h >= 0) {
    terms.emplace_back(kMinus, h);
  }
  return sum(terms);
}

/// A = L^T Δ L: L^T a = A for the lower half of a = Δ L.
bool Factoring::factor(const Sum& A) {
  const int matrix = given("A", A);
  if (!derive(result_.given.back().second, false, false).symmetric) {
    return false;
  }
  below_ = made(Op::kTravelling, {}, "L'");
  const int a = values_.note(Rule::kFactors, made(Op::kEliminated, {matrix, below_}, "a"));
  const int diagonal = made(Op::kDiagonal, {a}, "Δ");
  inverse_ = made(Op::kReciprocal, {diagonal}, "Δ^-1");
  values_.define(below_, made(Op::kScale, {inverse_, sum({{kPlus, a}, {kMinus, diagonal}})}));
  const int L = sum({{kPlus, identity()}, {kPlus, below_}});
  result_.derivation.roots = {L, diagonal, inverse_};
  return true;
}

/// A x = r: L^T y = r, Δ w = y, L x = w; A X = E: X = Y Δ^-1 Y^T, L Y = E.
bool Factoring::solve(const Expression& matrix) {
  const bool one = matrix.shape().rows.size == 1 && result_.derivation.shape.cols.size == 1;
  const bool column = result_.derivation.shape.cols.set == Set::kOne;
  const int r = without_.empty() ? -1 : right();
  const bool turned = matrix.kind() == Kind::kTranspose;
  const Expression& L = turned ? matrix.operands().front() : matrix;
  if (r >= 0 && L.kind() == Kind::kLeaf && L.node().structure == block::Structure::kAlongPaths) {
    below_ = sum({{kPlus, made(Op::kLeaf, {}, L.node().name)}, {kMinus, identity()}});
    result_.derivation.roots = {solve(turned ? Op::kFromLeaves : Op::kFromRoot, r, unknown_)};
    return true;
  }
  if (r < 0 || !one || (!column && values_[r].name != "E") || !factor({{kPlus, matrix}})) {
    return false;
  }
  if (column) {
    const int w = made(Op::kScale, {inverse_, solve(Op::kFromLeaves, r, "y")}, "w");
    result_.derivation.roots = {solve(Op::kFromRoot, w, unknown_)};
  } else {
    const int Y = solve(Op::kFromRoot, r, "Y");
    result_.derivation.roots = {made(Op::kCongruence, {Y, inverse_}, unknown_)};
  }
  return true;
}

bool Factoring::run(const Expression& equation) {
  open(kPlus, equation);
  result_.derivation.shape = equation.shape();
  if (with_.size() != 1 || with_.front().second.kind() != Kind::kProduct) {
    return false;
  }
  const auto& [sign, term] = with_.front();
  const std::vector<Expression>& f = term.operands();
  const bool last = is_leaf(f.back(), unknown_);
  if (last && f.size() == 3 && block::equal(f[0], block::transpose(f[2])) && sign == kMinus &&
      f[1].node().structure == block::Structure::kDiagonal) {
    return factor(without_);
  }
  Expression matrix = f.front();
  for (std::size_t k = 1; k + 1 < f.size(); ++k) {
    matrix = matrix * f[k];
  }
  return last && sign == kPlus && !holds(matrix, unknown_) && solve(matrix);
}

}  // namespace

std::optional<Factored> factored(const Expression& equation, const std::string& unknown) {
  Factored result;
  return Factoring(result, unknown).run(equation) ? std::optional(result) : std::nullopt;
}

}  // namespace treedyn::derive
