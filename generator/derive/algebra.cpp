#include "derive/algebra.hpp"

#include <algorithm>
#include <optional>

#include "common/error.hpp"

namespace treedyn::derive {
Set Algebra::set_of(int a, int b) const {
  TREEDYN_EXPECT(value(a).set == value(b).set);
  return value(a).set;
}

std::pair<Ratio, int> Algebra::split(int x) const {
  const Value& v = value(x);
  if (v.op == Op::kLinear && v.operands.size() == 1) {
    return {v.factors.front(), v.operands.front()};
  }
  return {kPlus, x};
}

int Algebra::bilinear(Op op, Type type, int a, int b) {
  const Set set = set_of(a, b);
  if (is_zero(a) || is_zero(b)) {
    return zero(set, type);
  }
  const auto [p, x] = split(a);
  const auto [q, y] = split(b);
  const Value right = value(y);
  if (right.op == Op::kScale && is_common(right.operands.back()) &&
      (op == Op::kCross || op == Op::kDot)) {
    const std::vector<int> numbers(right.operands.begin(), right.operands.end() - 1);
    return note(
        Rule::kCommon,
        linear({{multiply(p, q), bilinear(op, type, scaled(numbers, x), right.operands.back())}}));
  }
  const int product = values_.intern({op, set, type, {}, 0, {x, y}, {}});
  const Ratio factor = multiply(p, q);
  return factor == kPlus ? product : linear({{factor, product}});
}

int Algebra::leaf(const std::string& name, Set set, Type type) {
  if (name == "l^d" && !values_.choices().keeps_joints) {
    return note(Rule::kPlaces, zero(set, type));
  }
  return values_.intern({Op::kLeaf, set, type, name, 0, {}, {}});
}

int Algebra::cross(int a, int b) {
  const auto [factor, x] = split(a);
  const int y = split(b).second;
  if (x == y) {
    return zero(set_of(a, b), Type::kVector);
  }
  if (value(x).name == "c^d" && has_mass(y)) {
    return linear({{factor, moment_about_joint(x, b)}});
  }
  if (value(x).op == Op::kLinear && has_mass(y) &&
      std::ranges::any_of(value(x).operands, [this](int t) { return value(t).name == "c^d"; })) {
    return linear({{factor, of_terms(x, [this, b](int term) { return cross(term, b); })}});
  }
  if (const int known = turned_twice(x, y); known >= 0) {
    return linear({{multiply(factor, split(b).first), known}});
  }
  if (value(x).op != Op::kPathStrict && value(y).op == Op::kPathStrict) {
    return negative(bilinear(Op::kCross, Type::kVector, b, a));
  }
  return bilinear(Op::kCross, Type::kVector, a, b);
}

/// R2'': ω×(ω×x), or (ω×x)×ω with a minus, as Λ(ω)² x, of ω = D w or N w; -1 if no term is such.
int Algebra::turned_twice(int a, int b) {
  const auto turns = [this](int omega, int y) {
    const Value& v = value(y);
    return v.op == Op::kCross && v.operands[0] == omega &&
           (value(omega).op == Op::kPath || value(omega).op == Op::kPathStrict);
  };
  if (turns(a, b) || turns(b, a)) {
    const bool swapped = !turns(a, b);
    const int omega = swapped ? b : a;
    const int x = value(swapped ? a : b).operands[1];
    const int result = note(Rule::kTwiceTurned, apply(skew_product(omega, omega), x));
    return swapped ? negative(result) : result;
  }
  const auto any = [&](int omega, int y) {
    return value(y).op == Op::kLinear &&
           std::ranges::any_of(value(y).operands, [&](int term) { return turns(omega, term); });
  };
  if (any(a, b)) {
    return of_terms(b, [&](int term) { return cross(a, term); });
  }
  return any(b, a) ? of_terms(a, [&](int term) { return cross(term, b); }) : -1;
}

/// Λ(a)Λ(b), a leading minus of a sum in front.
int Algebra::skew_product(int a, int b) {
  for (const int x : {a, b}) {
    if (value(x).op == Op::kLinear && value(x).factors.front().numerator < 0) {
      return negative(skew_product(x == a ? negative(a) : a, x == a ? b : negative(b)));
    }
  }
  return bilinear(Op::kSkewProduct, Type::kTensor, a, b);
}

int Algebra::skew(int a) {
  if (is_zero(a)) {
    return zero(value(a).set, Type::kTensor);
  }
  const auto [factor, x] = split(a);
  const Value v = value(x);
  const int result = v.op == Op::kPick  // points take the blocks of their links
                         ? sum_along(v.op, v.set, skew(v.operands.front()))
                         : values_.intern({Op::kSkew, v.set, Type::kTensor, {}, 0, {x}, {}});
  return factor == kPlus ? result : linear({{factor, result}});
}

int Algebra::in_place_of(int from, int to) {
  values_.note(values_.made_by(from), to);
  return to;
}

/// One canonical product: all numbers in ascending order, then what is no number.
int Algebra::scaled(const std::vector<int>& numbers, int x) {
  std::vector<int> factors;
  const auto take = [&](int number) {
    if (value(number).op == Op::kScale) {
      factors.insert(factors.end(), value(number).operands.begin(), value(number).operands.end());
    } else if (value(number).op != Op::kOnes) {
      factors.push_back(number);
    }
  };
  std::ranges::for_each(numbers, take);
  const Value v = value(x);
  int body = -1;
  if (v.type == Type::kScalar) {
    take(x);
  } else if (v.op == Op::kScale) {
    factors.insert(factors.end(), v.operands.begin(), v.operands.end() - 1);
    body = v.operands.back();
  } else {
    body = x;
  }
  if (body >= 0 && value(body).op == Op::kCross && !factors.empty()) {  // m (a×b) = (m a)×b
    const Value c = value(body);
    const bool has_mass =
        std::ranges::any_of(factors, [this](int y) { return value(y).name == "m^d"; });
    for (std::size_t k = 0; k < 2; ++k) {
      const Value factor = value(c.operands[k]);
      if (factor.op == Op::kLeaf || (has_mass && has_centre(c.operands[k])) ||
          (factor.op == Op::kScale && value(factor.operands.back()).op == Op::kLeaf)) {
        const int more = scaled(factors, c.operands[k]);
        return k == 0 ? cross(more, c.operands[1]) : cross(c.operands[0], more);
      }
    }
  }
  if (body >= 0 && value(body).op == Op::kSkew && !factors.empty()) {
    return skew(scaled(factors, value(body).operands.front()));
  }
  if (const int known = body < 0 ? -1 : with_moments(factors, body); known >= 0) {
    return known;
  }
  std::ranges::sort(factors);
  if (body >= 0) {
    factors.push_back(body);
  }
  if (factors.empty()) {
    return ones(v.set);
  }
  return factors.size() == 1 ? factors.front()
                             : values_.intern({Op::kScale, v.set, v.type, {}, 0, factors, {}});
}

int Algebra::scale(int number, int x) {
  const Set set = set_of(number, x);
  const Type type = value(x).type == Type::kScalar ? value(number).type : value(x).type;
  if (is_zero(number) || is_zero(x)) {
    return zero(set, type);
  }
  if (value(number).type != Type::kScalar) {
    TREEDYN_EXPECT(value(x).type == Type::kScalar);
    return scale(x, number);
  }
  const auto [p, a] = split(number);
  const auto [q, b] = split(x);
  const int product = scaled({a}, b);
  const Ratio factor = multiply(p, q);
  return factor == kPlus ? product : linear({{factor, product}});
}

int Algebra::component(int x, int k) {
  if (is_zero(x)) {
    return zero(value(x).set, Type::kScalar);
  }
  return values_.intern({Op::kComponent, value(x).set, Type::kScalar, {}, k, {x}, {}});
}

int Algebra::assemble(const std::vector<int>& components) {
  return values_.intern(
      {Op::kAssemble, value(components[0]).set, Type::kVector, {}, 0, components, {}});
}

int Algebra::sum_along(Op op, Set set, int x) {
  const Type type = value(x).type;
  if (is_zero(x)) {
    return zero(set, type);
  }
  if (value(x).set == Set::kOne && set == Set::kOne) {
    return x;
  }
  const auto [factor, y] = split(x);
  if (factor != kPlus) {
    return linear({{factor, sum_along(op, set, y)}});
  }
  if (value(x).op == Op::kLinear && value(x).factors.front().numerator < 0) {  // D(-x) = -D x
    return negative(sum_along(op, set, negative(x)));
  }
  if (op == Op::kSpread && value(x).op == Op::kOnes) {
    return ones(set);
  }
  if (op == Op::kPath || op == Op::kPathStrict) {
    if (const int known = telescoped(op, x); known >= 0) {
      return known;
    }
  }
  if (op == Op::kSubtree || op == Op::kSubtreeStrict || op == Op::kCollect) {
    if (const int known = of_composites(op, set, x); known >= 0) {
      return known;
    }
  }
  if (op == Op::kSubtree || op == Op::kSubtreeStrict) {
    if (const int known = of_places(op, x); known >= 0) {
      return in_place_of(x, known);
    }
  }
  if (const int known = of_kind(op, set, x); known >= 0) {
    return note(Rule::kKinds, in_place_of(x, known));
  }
  if (const int known = of_common(op, set, x); known >= 0) {
    return note(Rule::kCommon, in_place_of(x, known));
  }
  return note(Rule::kSums, values_.intern({op, set, type, {}, 0, {x}, {}}));
}

/// What all links or points have in common, for those of another set.
int Algebra::common(int x, Set set) {
  const Value v = value(x);
  return v.op != Op::kSpread ? leaf(v.name, set, v.type)
         : set == Set::kOne  ? v.operands.front()
                             : sum_along(Op::kSpread, set, v.operands.front());
}

/// R3': from sums over subtrees or all links; numbers take D off what they multiply there. -1 if
/// nothing is common.
int Algebra::of_common(Op op, Set set, int x) {
  const Value v = value(x);
  const bool all = op == Op::kCollect;
  if ((!all && op != Op::kSubtree && op != Op::kSubtreeStrict) || v.operands.empty()) {
    return -1;
  }
  const int last = v.operands.back();
  const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
  const auto sum = [&](int y) {
    return sum_along(op, set, y);
  };
  if (is_common(last) && v.op == Op::kScale) {
    return scale(sum(scaled(numbers, ones(v.set))), common(last, set));
  }
  if (is_common(last) && v.op == Op::kCross) {
    return cross(sum(v.operands.front()), common(last, set));
  }
  if (is_common(v.operands.front()) && v.op == Op::kCross) {
    return cross(common(v.operands.front(), set), sum(last));
  }
  if (v.op == Op::kDot && (is_common(last) || is_common(v.operands.front()))) {
    const bool first = !is_common(last);
    return dot(common(first ? v.operands.front() : last, set),
               sum(first ? last : v.operands.front()));
  }
  if (!all) {
    return -1;
  }
  const int known = of_levers(set, x);
  return known >= 0 ? known : of_weighed_paths(set, x);
}

/// R3': 1^T y D x = 1^T (D^T y) x for numbers y; -1 if no term of x is y D x.
int Algebra::of_weighed_paths(Set set, int x) {
  const Value v = value(x);
  const bool weighed = v.op == Op::kScale && v.type == Type::kVector;
  const int body = weighed ? v.operands.back() : x;
  const Value inner = value(body);
  const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
  const auto scaled_term = [&](int y) {
    return weighed ? scaled(numbers, y) : y;
  };
  if (weighed && inner.op == Op::kPath) {
    const int subtree = sum_along(Op::kSubtree, v.set, scaled(numbers, ones(v.set)));
    return sum_along(Op::kCollect, set, scale(subtree, inner.operands.front()));
  }
  const auto has_path = [&](int y) {
    const Value& term = value(y);
    return weighed ? term.op == Op::kPath
                   : term.op == Op::kScale && term.type == Type::kVector &&
                         of_weighed_paths(set, y) >= 0;
  };
  if (inner.op != Op::kLinear || std::ranges::none_of(inner.operands, has_path)) {
    return -1;
  }
  return of_terms(body, [&](int term) { return sum_along(Op::kCollect, set, scaled_term(term)); });
}

/// True for D s and for sums with it.
bool Algebra::has_place(int x) const {
  const Value& v = value(x);
  return v.op == Op::kLinear
             ? std::ranges::any_of(v.operands, [this](int y) { return has_place(y); })
             : is_place(x);
}

/// R1': 1^T (D s × y) = 1^T (s × D^T y); -1 if no term of x is D s × y.
int Algebra::of_levers(Set set, int x) {
  const Value v = value(x);
  const auto sum = [&](int y) {
    return sum_along(Op::kCollect, set, y);
  };
  const auto is_moment = [this](int y) {
    return value(y).op == Op::kCross && value(y).set == Set::kLinks &&
           has_place(value(y).operands[0]);
  };
  if (v.op == Op::kLinear && std::ranges::any_of(v.operands, is_moment)) {
    return of_terms(x, sum);
  }
  if (!is_moment(x)) {
    return -1;
  }
  const int lever = v.operands[0];
  const int y = v.operands[1];
  if (value(lever).op == Op::kLinear) {
    return of_terms(lever, [&](int z) { return sum(cross(z, y)); });
  }
  return note(Rule::kTransposes,
              sum(cross(value(lever).operands.front(), sum_along(Op::kSubtree, v.set, y))));
}

/// Sums of multiples of E and of skew blocks are such; -1 for other blocks and for points.
int Algebra::of_kind(Op op, Set set, int x) {
  const Value v = value(x);
  if (v.op == Op::kSkew && op != Op::kPick) {
    return skew(note(Rule::kKinds, sum_along(op, set, v.operands.front())));
  }
  if (v.op == Op::kScale && value(v.operands.back()).op == Op::kIdentity) {
    const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
    return scale(note(Rule::kKinds, sum_along(op, set, scaled(numbers, ones(v.set)))),
                 identity(set));
  }
  return -1;
}

/// R5 for sums of Λ(a)Λ(b) of w, D w and N w; -1 if it does not act.
int Algebra::telescoped(Op op, int x) {
  Terms terms;
  if (value(x).op == Op::kSkewProduct) {
    terms = {{kPlus, x}};
  } else if (value(x).op == Op::kLinear) {
    terms = terms_in(value(x));
  }
  const std::optional<int> w = telescopes(values_, terms);
  if (!w) {
    return -1;
  }
  const int omega = sum_along(op, Set::kLinks, *w);
  const int square = in_place_of(x, skew_product(omega, omega));
  for (const auto& [factor, term] : terms) {
    in_place_of(term, square);
  }
  return note(Rule::kTelescope, square);
}

}  // namespace treedyn::derive
