// R3: terms of a sum that share an operation or an operand become one.
#include <algorithm>
#include <map>

#include "common/error.hpp"
#include "derive/algebra.hpp"

namespace treedyn::derive {
namespace {

bool is_sum_along(Op op) { return op >= Op::kPath && op <= Op::kCollect && op != Op::kBackward; }

}  // namespace

/// Sums opened, equal values collected, zeros dropped; D^T a + N^T b taken apart again.
Terms Algebra::flattened(const Terms& terms) {
  std::map<int, Ratio> collected;
  const auto take = [&](const Ratio& factor, int x) {
    const auto [place, is_new] = collected.emplace(x, factor);
    if (!is_new) {
      place->second = add(place->second, factor);
    }
  };
  const auto open = [&](const Ratio& factor, int x) {
    if (value(x).op != Op::kBackward) {
      return take(factor, x);
    }
    const Value v = value(x);
    for (const auto& [op, operand] :
         {std::pair(Op::kSubtree, v.operands[0]), std::pair(Op::kSubtreeStrict, v.operands[1])}) {
      const auto [p, y] = split(sum_along(op, v.set, operand));
      take(multiply(factor, p), y);
    }
  };
  for (const auto& [factor, x] : terms) {
    const Value v = value(x);
    if (v.op != Op::kLinear) {
      open(factor, x);
    }
    for (std::size_t k = 0; v.op == Op::kLinear && k < v.operands.size(); ++k) {
      open(multiply(factor, v.factors[k]), v.operands[k]);
    }
  }
  Terms result;
  for (const auto& [x, factor] : collected) {
    if (factor.numerator != 0 && !is_zero(x)) {
      result.emplace_back(factor, x);
    }
  }
  return result;
}

template <class Key, class Merged>
void Algebra::merge(Terms& terms, Key key, Merged merged) {
  std::map<decltype(key(Value{})), Terms> groups;
  Terms rest;
  for (const auto& term : terms) {
    const auto k = key(value(term.second));
    if (k.empty()) {
      rest.push_back(term);
    } else {
      groups[k].push_back(term);
    }
  }
  for (const auto& [k, group] : groups) {
    if (group.size() == 1) {
      rest.push_back(group.front());
      continue;
    }
    const int result = note(Rule::kMerge, merged(group));
    for (const auto& [factor, x] : group) {
      in_place_of(x, result);
    }
    if (!is_zero(result)) {
      rest.emplace_back(kPlus, result);
    }
  }
  terms = flattened(rest);
}

template <class Operand>
int Algebra::summed(const Terms& terms, Operand operand) {
  Terms sum;
  for (const auto& [factor, x] : terms) {
    sum.emplace_back(factor, operand(value(x)));
  }
  return linear(sum);
}

/// D x + D y = D (x + y).
void Algebra::merge_sums(Terms& terms) {
  merge(
      terms,
      [this](const Value& v) {
        const auto from = [&] {
          return static_cast<int>(value(v.operands.front()).set);
        };
        return is_sum_along(v.op) ? std::vector<int>{static_cast<int>(v.op), from()}
                                  : std::vector<int>{};
      },
      [this](const Terms& group) {
        const Value first = value(group.front().second);
        return sum_along(first.op, first.set,
                         summed(group, [](const Value& v) { return v.operands[0]; }));
      });
}

/// Λ(a) + Λ(b) = Λ(a + b).
void Algebra::merge_skews(Terms& terms) {
  merge(
      terms,
      [](const Value& v) { return v.op == Op::kSkew ? std::vector<int>{0} : std::vector<int>{}; },
      [this](const Terms& group) {
        return skew(summed(group, [](const Value& v) { return v.operands[0]; }));
      });
}

/// a×x + b×x = (a + b)×x.
void Algebra::merge_seconds(Terms& terms) {
  merge(
      terms,
      [](const Value& v) {
        return v.op == Op::kCross ? std::vector<int>{v.operands[1]} : std::vector<int>{};
      },
      [this](const Terms& group) {
        const int second = value(group.front().second).operands[1];
        return cross(summed(group, [](const Value& v) { return v.operands[0]; }), second);
      });
}

/// S v + T v = (S + T) v, where a×v = Λ(a) v and v×a = -Λ(a) v join.
void Algebra::merge_applied(Terms& terms) {
  std::vector<int> applied;
  for (const auto& [factor, x] : terms) {
    if (value(x).op == Op::kApply) {
      applied.push_back(value(x).operands[1]);
    }
  }
  const auto is_applied = [&](int v) {
    return std::ranges::find(applied, v) != applied.end();
  };
  const auto place = [&](const Value& v) {  // of the vector that a matrix multiplies
    return v.op == Op::kApply || is_applied(v.operands[1]) ? 1U : 0U;
  };
  merge(
      terms,
      [&](const Value& v) {
        const bool joins =
            v.op == Op::kApply || (v.op == Op::kCross && is_applied(v.operands[place(v)]));
        return joins ? std::vector<int>{v.operands[place(v)]} : std::vector<int>{};
      },
      [&](const Terms& group) {
        Terms inner;
        int v = -1;
        for (const auto& [factor, x] : group) {
          const Value term = value(x);
          const bool first = place(term) == 0;
          v = term.operands[first ? 0 : 1];
          inner.emplace_back(
              first ? multiply(kMinus, factor) : factor,
              term.op == Op::kCross ? skew(term.operands[first ? 1 : 0]) : term.operands[0]);
        }
        return apply(linear(inner), v);
      });
}

/// What numbers scale: what is no number, or the only number that is no symbol; -1: several.
int Algebra::body_of(const Value& v) const {
  if (v.type != Type::kScalar) {
    return v.operands.back();
  }
  int body = -1;
  for (const int x : v.operands) {
    if (value(x).op != Op::kLeaf) {
      if (body >= 0) {
        return -1;
      }
      body = x;
    }
  }
  return body;
}

/// a×b + a×c = a×(b + c), S x + S y = S (x + y), m x + m y = m (x + y).
void Algebra::merge_factors(Terms& terms) {
  merge(
      terms,
      [this](const Value& v) {
        const bool bilinear = v.op == Op::kCross || v.op == Op::kApply ||
                              v.op == Op::kApplyTranspose || v.op == Op::kDot;
        const int body = bilinear ? v.operands.back() : v.op == Op::kScale ? body_of(v) : -1;
        std::vector<int> key;
        if (body >= 0) {
          key = v.operands;
          key.erase(std::find(key.rbegin(), key.rend(), body).base() - 1);
          key.push_back(-1 - static_cast<int>(v.op));
        }
        return key;
      },
      [this](const Terms& group) {
        const Value first = value(group.front().second);
        const int sum = summed(group, [this](const Value& v) {
          return v.op == Op::kScale ? body_of(v) : v.operands.back();
        });
        switch (first.op) {
          case Op::kCross:
            return cross(first.operands[0], sum);
          case Op::kApply:
            return apply(first.operands[0], sum);
          case Op::kApplyTranspose:
            return apply_transposed(first.operands[0], sum);
          case Op::kDot:
            return dot(first.operands[0], sum);
          default: {
            std::vector<int> numbers = first.operands;
            numbers.erase(std::find(numbers.rbegin(), numbers.rend(), body_of(first)).base() - 1);
            const int last = numbers.back();
            numbers.pop_back();
            return scale(scaled(numbers, last), sum);
          }
        }
      });
}

/// Λ(a)Λ(s) + Λ(b)Λ(s) = Λ(a + b)Λ(s), Λ(s)Λ(a) + Λ(s)Λ(b) = Λ(s)Λ(a + b) for a symbol s.
void Algebra::merge_skew_products(Terms& terms) {
  const auto place = [this](const Value& v) {  // of the symbol
    return value(v.operands[1]).op == Op::kLeaf ? 1U : 0U;
  };
  merge(
      terms,
      [&](const Value& v) {
        const bool has = v.op == Op::kSkewProduct && value(v.operands[place(v)]).op == Op::kLeaf;
        return has ? std::vector<int>{static_cast<int>(place(v)), v.operands[place(v)]}
                   : std::vector<int>{};
      },
      [&](const Terms& group) {
        const Value first = value(group.front().second);
        const bool last = place(first) == 1;
        const Ratio sign = group.front().first.numerator < 0 ? kMinus : kPlus;
        Terms inner;
        for (const auto& [factor, x] : group) {
          inner.emplace_back(multiply(sign, factor), value(x).operands[last ? 0 : 1]);
        }
        const int sum = linear(inner);
        return linear({{sign, last ? skew_product(sum, first.operands[1])
                                   : skew_product(first.operands[0], sum)}});
      });
}

/// Λ(a)Λ(x) + Λ(b)Λ(x) = Λ(a + b)Λ(x), or Λ(x)Λ(a + b), of any x.
void Algebra::merge_levers(Terms& terms, std::size_t common) {
  merge(
      terms,
      [common](const Value& v) {
        return v.op == Op::kSkewProduct ? std::vector<int>{v.operands[common]} : std::vector<int>{};
      },
      [&](const Terms& group) {
        const int x = value(group.front().second).operands[common];
        const int sum = summed(group, [common](const Value& v) { return v.operands[1 - common]; });
        return common == 0 ? skew_product(x, sum) : skew_product(sum, x);
      });
}

/// D^T a + N^T b: sons hand on b and their own sum.
void Algebra::merge_backward(Terms& terms) {
  const auto find = [&](Op op) {
    return std::ranges::find_if(terms,
                                [&](const auto& term) { return value(term.second).op == op; });
  };
  const auto a = find(Op::kSubtree);
  const auto b = find(Op::kSubtreeStrict);
  if (a == terms.end() || b == terms.end()) {
    return;
  }
  const Value v = value(a->second);
  const bool negative = values_.choices().composites && a->first == kMinus && b->first == kMinus;
  const int own = linear({{negative ? kPlus : a->first, v.operands[0]}});
  const int of_sons = linear({{negative ? kPlus : b->first, value(b->second).operands[0]}});
  const std::vector<int> gone = {a->second, b->second};
  std::erase_if(terms,
                [&](const auto& term) { return term.second == gone[0] || term.second == gone[1]; });
  const int both =
      note(Rule::kMerge, values_.intern({Op::kBackward, v.set, v.type, {}, 0, {own, of_sons}, {}}));
  for (const int sum : gone) {
    in_place_of(sum, both);
  }
  terms.emplace_back(negative ? kMinus : kPlus, both);
}

/// A sum with the rules that made the sums among its terms.
int Algebra::opened(const Terms& terms, int sum) {
  const auto is_sum = [this](int x) {
    return value(x).op == Op::kLinear || value(x).op == Op::kBackward;
  };
  for (const auto& [factor, x] : terms) {
    if (is_sum(x) && is_sum(sum)) {
      in_place_of(x, sum);
    }
  }
  return sum;
}

int Algebra::linear(const Terms& terms) {
  TREEDYN_EXPECT(!terms.empty());
  const Value first = value(terms.front().second);
  Terms rest = flattened(terms);
  if (rest.size() > 1) {
    merge_sums(rest);
    merge_skews(rest);
    merge_seconds(rest);
    merge_applied(rest);
    merge_factors(rest);
    merge_skew_products(rest);
    if (values_.choices().composites) {
      merge_levers(rest, 1);
      merge_levers(rest, 0);
    }
    merge_backward(rest);
  }
  if (rest.empty()) {
    return zero(first.set, first.type);
  }
  if (rest.size() == 1 && rest.front().first == kPlus) {
    return opened(terms, rest.front().second);
  }
  std::ranges::sort(rest, [](const auto& a, const auto& b) { return a.second < b.second; });
  return opened(terms, values_.intern(plain_sum(rest, first.set, first.type)));
}

}  // namespace treedyn::derive
