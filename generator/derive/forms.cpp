#include "derive/forms.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "derive/algebra.hpp"

namespace treedyn::derive {
namespace {

/// Ω = Λ(α) + Λ(ω)².
std::optional<Turning> turning(const Values& values, int Omega) {
  const Value& v = values[Omega];
  if (v.op != Op::kLinear || v.operands.size() != 2 || v.factors[0] != kPlus ||
      v.factors[1] != kPlus) {
    return std::nullopt;
  }
  Turning result{Omega, -1, -1};
  for (const int x : v.operands) {
    const Value& term = values[x];
    if (term.op == Op::kSkew) {
      result.alpha = term.operands[0];
    } else if (term.op == Op::kSkewProduct && term.operands[0] == term.operands[1]) {
      result.omega = term.operands[0];
    }
  }
  return result.alpha >= 0 && result.omega >= 0 ? std::optional(result) : std::nullopt;
}

class Forms {
 public:
  explicit Forms(const Values& values)
      : old_(values), new_(values.choices(), values.acted()), algebra_(new_) {}

  Values run(std::vector<int>& roots) {
    remake(old_, new_, roots, [this](Value value) { return replaced(std::move(value)); });
    return std::move(new_);
  }

 private:
  /// \param of  the values that it takes the place of
  int noted(Rule rule, Value value, std::initializer_list<int> of = {}) {
    const int result = new_.note(rule, new_.intern(std::move(value)));
    for (const int x : of) {
      algebra_.in_place_of(x, result);
    }
    return result;
  }

  int replaced(Value value) {
    if (value.op == Op::kApply) {
      if (const int whole = of_links(value.operands[0]); whole >= 0) {  // F3
        value.operands[0] =
            noted(Rule::kFathers, {Op::kFather, Set::kLinks, Type::kTensor, {}, 0, {whole}, {}});
      }
    } else if (value.op == Op::kBackward) {
      if (const int inertia = composite(value); inertia >= 0) {
        return inertia;
      }
      if (const int rates = twice(value); rates >= 0) {
        return rates;
      }
    } else if (value.op == Op::kDot && is_momentum(value.operands[1]) &&
               new_[value.operands[1]].operands[1] == value.operands[0]) {
      const int omega = value.operands[0];
      return noted(Rule::kSquare, {Op::kSquare, value.set, value.type, {}, 0, {omega}, {}},
                   {value.operands[1]});
    } else if (value.op == Op::kLinear) {
      if (const int path = started(value); path >= 0) {
        return path;
      }
      gather_moment(value);
      gather_turned(value);
      if (value.operands.size() == 1 && value.factors[0] == kPlus) {
        return value.operands[0];
      }
    }
    return new_.intern(std::move(value));
  }

  /// S(D x) of S(N x); -1 for what is made of others.
  int of_links(int S) {
    Value value = new_[S];
    if (value.op == Op::kPathStrict) {
      return algebra_.sum_along(Op::kPath, Set::kLinks, value.operands[0]);
    }
    if (value.op != Op::kLinear && value.op != Op::kSkew && value.op != Op::kSkewProduct) {
      return -1;
    }
    for (int& operand : value.operands) {
      operand = of_links(operand);
      if (operand < 0) {
        return -1;
      }
    }
    return value.op == Op::kLinear ? algebra_.linear(terms_in(value))
                                   : new_.intern(std::move(value));
  }

  /// F2: D x ± g.
  int started(const Value& value) {
    if (value.operands.size() != 2 || new_.choices().common_leaves) {
      return -1;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const Value& path = new_[value.operands[k]];
      const int g = value.operands[1 - k];
      if (path.op == Op::kPath && path.operands.size() == 1 && new_[g].name == "g" &&
          value.factors[k] == kPlus) {
        const int x = path.operands[0];
        const int start = algebra_.linear({{value.factors[1 - k], g}});
        return noted(Rule::kStart, {Op::kPath, value.set, value.type, {}, 0, {x, start}, {}},
                     {value.operands[k]});
      }
    }
    return -1;
  }

  /// F4: I α + ω×(I ω) among the terms.
  void gather_moment(Value& sum) {
    for (std::size_t a = 0; a < sum.operands.size(); ++a) {
      for (std::size_t b = 0; b < sum.operands.size(); ++b) {
        const Value& linear = new_[sum.operands[a]];
        const Value& square = new_[sum.operands[b]];
        if (sum.factors[a] != kPlus || sum.factors[b] != kPlus || !is_momentum(sum.operands[a]) ||
            square.op != Op::kCross || !is_momentum(square.operands[1]) ||
            new_[square.operands[1]].operands[1] != square.operands[0]) {
          continue;
        }
        const int alpha = linear.operands[1];
        const int omega = square.operands[0];
        const int Omega = algebra_.linear(
            {{kPlus, algebra_.skew(alpha)}, {kPlus, algebra_.skew_product(omega, omega)}});
        sum.operands[a] = noted(Rule::kPseudoInertia,
                                {Op::kMoment, sum.set, sum.type, {}, 0, {Omega, alpha, omega}, {}},
                                {sum.operands[a], sum.operands[b]});
        sum.operands.erase(sum.operands.begin() + static_cast<std::ptrdiff_t>(b));
        sum.factors.erase(sum.factors.begin() + static_cast<std::ptrdiff_t>(b));
        return;
      }
    }
  }

  /// F8: f (Λ(ω) J_c - J_c Λ(ω) - Λ(J_c ω)) - 2 f Λ(c) Λ(ω×h) among the terms is -2 f Λ(ω) E.
  void gather_turned(Value& sum) {
    for (std::size_t k = 0; k < sum.operands.size(); ++k) {
      const Value first = new_[sum.operands[k]];
      if (first.op != Op::kProduct || new_[first.operands[0]].op != Op::kSkew ||
          new_[first.operands[1]].name != "J_c^d") {
        continue;
      }
      const int J = first.operands[1];
      const int omega = new_[first.operands[0]].operands[0];
      const Ratio f = sum.factors[k];
      const Ratio minus = multiply(kMinus, f);
      const Ratio twice = multiply({-2, 1}, f);
      const int c = algebra_.leaf("c^d", sum.set, Type::kVector);
      const int h = algebra_.leaf("h^d", sum.set, Type::kVector);
      const Terms wanted = {
          {f, sum.operands[k]},
          {minus,
           new_.intern({Op::kProduct, sum.set, sum.type, {}, 0, {J, first.operands[0]}, {}})},
          {minus, algebra_.skew(algebra_.apply(J, omega))},
          {twice, algebra_.skew_product(c, algebra_.cross(omega, h))}};
      Terms rest;
      for (const auto& term : terms_in(sum)) {
        if (std::ranges::find(wanted, term) == wanted.end()) {
          rest.push_back(term);
        }
      }
      if (rest.size() + wanted.size() != sum.operands.size()) {
        continue;
      }
      const int I = algebra_.leaf("I^d", sum.set, Type::kTensor);
      const int E = new_.intern({Op::kPseudo, sum.set, sum.type, {}, 0, {I}, {}});
      rest.emplace_back(
          twice, noted(Rule::kTurned,
                       {Op::kProduct, sum.set, sum.type, {}, 0, {first.operands[0], E}, {}}));
      sum = plain_sum(rest, sum.set, sum.type);
      return;
    }
  }

  /// F5: D^T I - N^T (Λ(h)Λ(s) + Λ(s)Λ(h + m s)) for h = D^T h_own + N^T (m s); -1: another sum.
  int composite(const Value& sum) {
    const Value X = new_[sum.operands[1]];
    if (new_[sum.operands[0]].name != "I^d" || X.op != Op::kLinear || X.operands.size() != 2 ||
        X.factors[0] != kMinus || X.factors[1] != kMinus) {
      return -1;
    }
    for (const std::size_t k : {0U, 1U}) {
      const Value& first = new_[X.operands[k]];
      const Value& second = new_[X.operands[1 - k]];
      if (first.op != Op::kSkewProduct || second.op != Op::kSkewProduct ||
          first.operands[1] != second.operands[0]) {
        continue;
      }
      const int h = first.operands[0];
      const int s = first.operands[1];
      const int shifted = second.operands[1];
      const int ms = new_[h].op == Op::kBackward ? new_[h].operands[1] : -1;
      if (ms >= 0 && new_[ms].op == Op::kScale && new_[ms].operands.size() == 2 &&
          new_[ms].operands[1] == s && algebra_.linear({{kPlus, h}, {kPlus, ms}}) == shifted) {
        return noted(Rule::kComposite,
                     {Op::kComposite, sum.set, sum.type, {}, 0, {new_[ms].operands[0], h, s}, {}},
                     {X.operands[k], X.operands[1 - k], sum.operands[1]});
      }
    }
    return -1;
  }

  /// F7: D^T a + N^T (a + 2 b); -1: another sum.
  int twice(const Value& sum) {
    const int a = sum.operands[0];
    const Terms rest = {{kPlus, sum.operands[1]}, {kMinus, a}};
    const Value both = new_[algebra_.linear(rest)];
    if (both.op != Op::kLinear ||
        std::ranges::any_of(both.factors, [](const Ratio& f) { return f.numerator % 2 != 0; })) {
      return -1;
    }
    Terms inner = {{kPlus, a}};
    for (std::size_t k = 0; k < both.operands.size(); ++k) {
      inner.emplace_back(multiply({1, 2}, both.factors[k]), both.operands[k]);
    }
    const int below = algebra_.sum_along(Op::kSubtreeStrict, sum.set, algebra_.linear(inner));
    return new_.note(Rule::kTwice, algebra_.linear({{kPlus, a}, {{2, 1}, below}}));
  }

  /// I x.
  [[nodiscard]] bool is_momentum(int x) const {
    return new_[x].op == Op::kApply && new_[new_[x].operands[0]].name == "I^d";
  }

  const Values& old_;
  Values new_;
  Algebra algebra_;
};

/// x z for numbers x, or 0.
bool is_along_axis(const Values& values, int x) {
  const Value& v = values[x];
  return v.op == Op::kScale && values[v.operands.back()].name == "z^d";
}

/// α = D (x z + ω_f×w), terms of x z apart.
bool turns_about_axes(const Values& values, const Turning& turning) {
  const Value& omega = values[turning.omega];
  const Value& alpha = values[turning.alpha];
  if (omega.op != Op::kPath || alpha.op != Op::kPath || alpha.operands.size() != 1 ||
      !is_along_axis(values, omega.operands[0])) {
    return false;
  }
  const int w = omega.operands[0];
  const int x = alpha.operands[0];
  const Value& v = values[x];
  const bool sum = v.op == Op::kLinear;
  int crosses = 0;
  for (std::size_t k = 0; k < (sum ? v.operands.size() : 1); ++k) {
    const int term = sum ? v.operands[k] : x;
    const Value& t = values[term];
    const bool with_father = t.op == Op::kCross && t.operands[1] == w &&
                             values[t.operands[0]].op == Op::kPathStrict &&
                             values[t.operands[0]].operands[0] == w;
    if (with_father && (!sum || v.factors[k] == kPlus)) {
      ++crosses;
    } else if (!is_along_axis(values, term)) {
      return false;
    }
  }
  return crosses == 1;
}

}  // namespace

Values with_forms(const Values& values, std::vector<int>& roots) {
  return Forms(values).run(roots);
}

std::vector<Turning> turnings_about_axes(const Values& values, const std::vector<int>& needed) {
  std::vector<Turning> result;
  for (const int id : needed) {
    const std::optional<Turning> found = turning(values, id);
    if (found && turns_about_axes(values, *found)) {
      result.push_back(*found);
    }
  }
  return result;
}

}  // namespace treedyn::derive
