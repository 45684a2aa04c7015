// R12: equations for numbers of joints, by factors of A whose zeros are those of D.
#include <algorithm>
#include <iterator>

#include "block/rewrite.hpp"
#include "derive/derive.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::Kind;

using Sum = std::vector<std::pair<Ratio, Expression>>;

void open(const Ratio& factor, const Expression& e, Sum& terms) {
  if (e.kind() == Kind::kScaled) {
    open(multiply(factor, e.node().factor), e.operands().front(), terms);
  } else if (e.kind() == Kind::kSum) {
    for (const Expression& term : e.operands()) {
      open(factor, term, terms);
    }
  } else {
    terms.emplace_back(factor, e);
  }
}

Sum terms_of(const Expression& e) {
  Sum terms;
  open(kPlus, e, terms);
  return terms;
}

/// The terms with a symbol, or those without it.
Sum with(const Sum& terms, const std::string& name, bool wanted = true) {
  Sum result;
  std::ranges::copy_if(terms, std::back_inserter(result),
                       [&](const auto& term) { return holds(term.second, name) == wanted; });
  return result;
}

/// M of the one term M x with the unknown; nothing of others.
std::optional<Expression> factor_of(const Sum& terms, const std::string& unknown,
                                    const Ratio& sign) {
  const Sum one = with(terms, unknown);
  if (one.size() != 1 || one.front().second.kind() != Kind::kProduct || one.front().first != sign) {
    return std::nullopt;
  }
  const std::vector<Expression>& f = one.front().second.operands();
  const Expression matrix = product_of(f.begin(), f.end() - 1);
  return is_leaf(f.back(), unknown) && !holds(matrix, unknown) ? std::optional(matrix)
                                                               : std::nullopt;
}

class Factoring {
 public:
  Factoring(Factored& result, std::string unknown)
      : result_(result), values_(result.derivation.values), unknown_(std::move(unknown)) {}

  bool run(const Expression& equation);
  bool constrain(const Expression& motion, const Expression& rows, const std::string& reaction);
  bool along(const Expression& e);
  bool least(const Expression& equation, const Expression& remainder,
             const std::string& multiplier);

 private:
  int made(Op op, std::vector<int> operands, const std::string& name = "", Set set = Set::kLinks) {
    return values_.intern({op, set, Type::kScalar, name, 0, std::move(operands), {}});
  }
  int identity() { return made(Op::kLeaf, {}, "E"); }
  int given(const std::string& name, const Sum& sum);
  std::optional<int> number(const Expression& e);
  std::optional<int> sum_of(const Sum& terms);
  int sum(const Terms& terms);
  int right(const Sum& terms);
  bool factor(const Sum& A);
  int solve(Op op, int r, const std::string& name) {
    return values_.note(Rule::kTriangles, made(op, {r, below_}, name));
  }
  bool solve(const Expression& matrix, const Sum& others);

  Factored& result_;
  Values& values_;
  std::string unknown_;
  int least_ = -1;    ///< what the unknown is, where others are made of it
  int below_ = -1;    ///< L' = L - E
  int inverse_ = -1;  ///< Δ^-1
};

/// A leaf that stands for a sum.
int Factoring::given(const std::string& name, const Sum& sum) {
  std::optional<Expression> all;
  for (const auto& [factor, e] : sum) {
    const Expression term = factor == kPlus ? e : factor * e;
    all = all ? *all + term : term;
  }
  const auto same = [&](const auto& one) {
    return one.first == name && equal(one.second, *all);
  };
  if (std::ranges::none_of(result_.given, same)) {
    result_.given.emplace_back(name, *all);
  }
  return made(Op::kLeaf, {}, name, all->shape().rows.set);
}

std::optional<int> Factoring::sum_of(const Sum& terms) {
  Terms result;
  for (const auto& [factor, e] : terms) {
    const std::optional<int> x = number(e);
    if (!x) {
      return std::nullopt;
    }
    result.emplace_back(factor, *x);
  }
  return sum(result);
}

/// Sums and products of symbols whose entries are numbers of their own, and of what has a name,
/// which is given. Nothing for others.
std::optional<int> Factoring::number(const Expression& e) {
  const std::vector<Expression>& operands = e.operands();
  const Set rows = e.shape().rows.set;
  switch (e.kind()) {
    case Kind::kLeaf: {
      const bool known = e.node().structure == block::Structure::kRowPoints ||
                         e.node().structure == block::Structure::kFull;
      return !known ? std::nullopt
             : is_leaf(e, unknown_.c_str()) && least_ >= 0
                 ? std::optional(least_)
                 : std::optional(made(Op::kLeaf, {}, e.node().name, rows));
    }
    case Kind::kNamed:
      return holds(e, unknown_) ? std::nullopt : std::optional(given(e.node().name, {{kPlus, e}}));
    case Kind::kTranspose: {
      const std::optional<int> inner = number(operands.front());
      return inner ? std::optional(made(Op::kTransposed, {*inner}, "", rows)) : std::nullopt;
    }
    case Kind::kProduct: {
      std::optional<int> x = number(operands.back());
      for (auto f = operands.rbegin() + 1; f != operands.rend() && x; ++f) {
        const std::optional<int> left = number(*f);
        x = left ? std::optional(made(Op::kApply, {*left, *x}, "", f->shape().rows.set)) : left;
      }
      return x;
    }
    case Kind::kScaled:
    case Kind::kSum:
      return sum_of(terms_of(e));
    default:
      return std::nullopt;
  }
}

int Factoring::sum(const Terms& terms) {
  const auto& [factor, x] = terms.front();
  return terms.size() == 1 && factor == kPlus
             ? x
             : values_.intern(plain_sum(terms, values_[x].set, Type::kScalar));
}

/// What the unknown's term is equal to: symbols as they are, less one column of all else, which is
/// called h where it has no name.
int Factoring::right(const Sum& terms) {
  Sum rest;
  std::ranges::copy_if(terms, std::back_inserter(rest),
                       [](const auto& term) { return term.second.kind() != Kind::kLeaf; });
  const bool has_name =
      rest.size() == 1 && rest.front().first == kPlus && rest.front().second.kind() == Kind::kNamed;
  const int h = rest.empty() ? -1 : given(has_name ? rest.front().second.node().name : "h", rest);
  Terms result;
  for (const auto& [factor, e] : terms) {
    if (e.kind() == Kind::kLeaf) {
      result.emplace_back(multiply(kMinus, factor),
                          made(Op::kLeaf, {}, e.node().name, e.shape().rows.set));
    }
  }
  if (h >= 0) {
    result.emplace_back(kMinus, h);
  }
  return sum(result);
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
bool Factoring::solve(const Expression& matrix, const Sum& others) {
  const bool one = matrix.shape().rows.size == 1 && result_.derivation.shape.cols.size == 1;
  const bool column = result_.derivation.shape.cols.set == Set::kOne;
  const int r = others.empty() ? -1 : right(others);
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

/// L^T Y = J^T, L^T y = r: K = Y^T Δ^-1 Y, b = s - Y^T Δ^-1 y, L x = Δ^-1 (y + Y λ).
bool Factoring::constrain(const Expression& motion, const Expression& rows,
                          const std::string& reaction) {
  const Sum terms = terms_of(motion);
  const std::optional<Expression> A = factor_of(terms, unknown_, kPlus);
  const std::optional<Expression> J_T = factor_of(terms, reaction, kMinus);
  const std::optional<Expression> J = factor_of(terms_of(rows), unknown_, kPlus);
  const Sum others = with(with(terms, unknown_, false), reaction, false);
  const Sum wanted = with(terms_of(rows), unknown_, false);
  if (!A || !J_T || !J || !block::equal(*J, block::transpose(*J_T)) || wanted.empty()) {
    return false;
  }
  result_.derivation.shape = motion.shape();
  const int r = others.empty() ? -1 : right(others);
  const int s = right(wanted);
  if (result_.given.size() > 1 && result_.given[0].first == result_.given[1].first) {
    return false;  // one name for two columns
  }
  const int jacobian = given("J^T", {{kPlus, *J_T}});
  if (!factor({{kPlus, *A}})) {
    return false;
  }
  const int Y = solve(Op::kFromLeaves, jacobian, "Y");
  const int rows_of_Y = made(Op::kTransposed, {Y}, "", Set::kRows);
  const int K = made(Op::kCongruence, {rows_of_Y, inverse_}, "K_λ", Set::kRows);
  const int reactions = made(Op::kLeaf, {}, reaction, Set::kRows);
  const int pulled = made(Op::kApply, {made(Op::kScale, {inverse_, Y}), reactions});
  int b = s;
  int w = pulled;
  if (r >= 0) {
    const int free = made(Op::kScale, {inverse_, solve(Op::kFromLeaves, r, "y")}, "w");
    b = sum({{kPlus, s}, {kMinus, made(Op::kApply, {rows_of_Y, free}, "", Set::kRows)}});
    w = sum({{kPlus, free}, {kPlus, pulled}});
  }
  const int x = solve(Op::kFromRoot, w, unknown_);
  result_.derivation.roots = {values_.note(Rule::kReactions, K), b, x};
  return true;
}

/// Sums of products with S.
bool Factoring::along(const Expression& e) {
  const std::optional<int> x = number(block::unnamed(e));
  if (x) {
    result_.derivation.shape = e.shape();
    result_.derivation.roots = {values_.note(Rule::kDistribute, *x)};
  }
  return x.has_value();
}

/// λ = M^T μ, M M^T μ = s.
bool Factoring::least(const Expression& equation, const Expression& remainder,
                      const std::string& multiplier) {
  const Sum terms = terms_of(equation);
  const std::optional<Expression> matrix = factor_of(terms, unknown_, kPlus);
  Sum others = with(terms, unknown_, false);
  for (auto& [factor, _] : others) {
    factor = multiply(kMinus, factor);
  }
  const std::optional<int> M = matrix ? number(*matrix) : std::nullopt;
  const std::optional<int> s = M && !others.empty() ? sum_of(others) : std::nullopt;
  if (!s) {
    return false;
  }
  const Set rows = matrix->shape().rows.set;
  const Set cols = matrix->shape().cols.set;
  const int K = values_.note(Rule::kLeast, made(Op::kCongruence, {*M}, "K_μ", rows));
  const int mu = made(Op::kLeaf, {}, multiplier, rows);
  const int turned = made(Op::kTransposed, {*M}, "", cols);
  least_ = values_.note(Rule::kLeast, made(Op::kApply, {turned, mu}, unknown_, cols));
  const std::optional<int> left = number(block::unnamed(remainder));
  if (left) {
    result_.derivation.shape = remainder.shape();
    result_.derivation.roots = {K, *s, least_, *left};
  }
  return left.has_value();
}

bool Factoring::run(const Expression& equation) {
  const Sum terms = terms_of(equation);
  const Sum unknown = with(terms, unknown_);
  const Sum others = with(terms, unknown_, false);
  result_.derivation.shape = equation.shape();
  if (unknown.size() != 1 || unknown.front().second.kind() != Kind::kProduct) {
    return false;
  }
  const auto& [sign, term] = unknown.front();
  const std::vector<Expression>& f = term.operands();
  if (is_leaf(f.back(), unknown_) && f.size() == 3 && block::equal(f[0], block::transpose(f[2])) &&
      sign == kMinus && f[1].node().structure == block::Structure::kDiagonal) {
    return factor(others);
  }
  const std::optional<Expression> matrix = factor_of(terms, unknown_, kPlus);
  return matrix && solve(*matrix, others);
}

}  // namespace

std::optional<Factored> factored(const Expression& equation, const std::string& unknown) {
  Factored result;
  return Factoring(result, unknown).run(equation) ? std::optional(result) : std::nullopt;
}

std::optional<Factored> with_directions(const Expression& e) {
  Factored result;
  return Factoring(result, "").along(e) ? std::optional(result) : std::nullopt;
}

std::optional<Factored> constrained(const Expression& motion, const Expression& rows,
                                    const std::string& unknown, const std::string& reaction) {
  Factored result;
  return Factoring(result, unknown).constrain(motion, rows, reaction) ? std::optional(result)
                                                                      : std::nullopt;
}

std::optional<Factored> least(const Expression& equation, const Expression& remainder,
                              const std::string& unknown, const std::string& multiplier) {
  Factored result;
  return Factoring(result, unknown).least(equation, remainder, multiplier) ? std::optional(result)
                                                                           : std::nullopt;
}

}  // namespace treedyn::derive
