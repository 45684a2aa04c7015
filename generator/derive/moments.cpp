// R10: masses times centres are first moments, and what they turn is I = J_c - m Λ(c)².
#include <algorithm>

#include "derive/algebra.hpp"

namespace treedyn::derive {
/// True for c, Ω c, c×x, x×c and sums with such a term.
bool Algebra::has_centre(int x) const {
  const Value& v = value(x);
  const auto has = [this](int y) {
    return has_centre(y);
  };
  const bool about_joint = !values_.choices().keeps_joints;
  switch (v.op) {
    case Op::kApply:
      return about_joint && has(v.operands[1]);
    case Op::kCross:
    case Op::kLinear:
      return (about_joint || v.op == Op::kLinear) && std::ranges::any_of(v.operands, has);
    default:
      return v.name == "c^d";
  }
}

/// True for Λ(α), Λ(ω)² and their sums.
bool Algebra::is_turning(int S) const {
  const Value& v = value(S);
  return v.op == Op::kSkew || (v.op == Op::kSkewProduct && v.operands[0] == v.operands[1]) ||
         (v.op == Op::kLinear &&
          std::ranges::all_of(v.operands, [this](int x) { return is_turning(x); }));
}

/// True for h, m x and sums of nothing else.
bool Algebra::is_moment(int x) const {
  const Value& v = value(x);
  switch (v.op) {
    case Op::kLinear:
      return std::ranges::all_of(v.operands, [this](int y) { return is_moment(y); });
    case Op::kScale:
      return has_mass(x);
    default:
      return v.name == "h^d";
  }
}

/// True for m x, Ω h, h×x, x×h and sums with such a term: what has a moment about c. Where l is
/// asked for, c alone is no lever.
bool Algebra::has_mass(int x) const {
  const Value& v = value(x);
  if (values_.choices().keeps_joints) {
    return false;
  }
  switch (v.op) {
    case Op::kLinear:
      return std::ranges::any_of(v.operands, [this](int y) { return has_mass(y); });
    case Op::kScale:
      return std::ranges::any_of(v.operands, [this](int y) { return value(y).name == "m^d"; });
    case Op::kApply:
      return value(v.operands[1]).name == "h^d" && is_turning(v.operands[0]);
    case Op::kCross:
      return is_moment(v.operands[0]) || is_moment(v.operands[1]);
    default:
      return false;
  }
}

/// R10: m c = h, m (x + Ω c) = m x + Ω h; -1 if there is no m or no c.
int Algebra::with_moments(const std::vector<int>& numbers, int x) {
  const Value v = value(x);
  const auto mass = std::ranges::find_if(numbers, [this](int y) { return value(y).name == "m^d"; });
  if (mass == numbers.end() || !has_centre(x)) {
    return -1;
  }
  if (v.op == Op::kLinear) {
    return of_terms(x, [&](int term) { return scaled(numbers, term); });
  }
  if (v.op == Op::kApply) {
    return apply(v.operands[0], scaled(numbers, v.operands[1]));
  }
  if (v.op != Op::kLeaf) {
    return -1;
  }
  std::vector<int> others = numbers;
  others.erase(others.begin() + (mass - numbers.begin()));
  return note(Rule::kParameters, scaled(others, leaf("h^d", v.set, Type::kVector)));
}

/// R10: c×(m x + Ω h) = h×x + c×(Ω h). \pre has_mass(x)
int Algebra::moment_about_joint(int centre, int x) {
  const Value v = value(x);
  switch (v.op) {
    case Op::kLinear:
      return of_terms(x, [&](int term) { return cross(centre, term); });
    case Op::kScale: {
      const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
      return cross(scaled(numbers, centre), v.operands.back());
    }
    case Op::kApply:
      return moment_of_turning(v.operands[0]);
    default:
      return is_moment(v.operands[1])
                 ? moment_about_joint(centre, v.operands[0], v.operands[1])
                 : negative(moment_about_joint(centre, v.operands[1], v.operands[0]));
  }
}

/// R10: c×(x×h) = (I - J_c) x, c×(x×(m y)) = h×(x×y). \pre is_moment(h)
int Algebra::moment_about_joint(int centre, int x, int h) {
  const Value v = value(h);
  if (v.op == Op::kLinear) {
    return of_terms(h, [&](int term) { return moment_about_joint(centre, x, term); });
  }
  if (v.op == Op::kScale) {
    const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
    return cross(scaled(numbers, centre), cross(x, v.operands.back()));
  }
  return moment_of_turning(skew(x));
}

/// R10: c×(S h) by I = J_c - m Λ(c)²: (I - J_c) α for S = Λ(α), ω×((I - J_c) ω) for S = Λ(ω)².
/// \pre is_turning(S)
int Algebra::moment_of_turning(int S) {
  const Value v = value(S);
  if (v.op == Op::kLinear) {
    return of_terms(S, [this](int term) { return moment_of_turning(term); });
  }
  const int x = v.operands[0];
  const int I = leaf("I^d", v.set, Type::kTensor);
  const int J = leaf("J_c^d", v.set, Type::kTensor);
  const int more = linear({{kPlus, apply(I, x)}, {{-1, 1}, apply(J, x)}});
  return note(Rule::kParameters, v.op == Op::kSkew ? more : cross(x, more));
}

}  // namespace treedyn::derive
