#include "derive/affine.hpp"

#include <algorithm>

namespace treedyn::derive {
bool Opening::depends(int x) const {
  const Value& v = values_[x];
  return v.name == unknown_ ||
         std::ranges::any_of(v.operands, [this](int y) { return depends(y); });
}

int Opening::rest(const Affine& a, Type type) {
  return a.rest.empty() ? algebra_.zero(Set::kLinks, type) : algebra_.linear(a.rest);
}

template <class Block, class Rest>
Affine Opening::mapped(const Affine& a, Block block, Rest rest) {
  Affine result;
  for (const auto& [atom, X] : a.blocks) {
    result.blocks.emplace(atom, block(X));
  }
  for (const auto& [factor, x] : a.rest) {
    result.rest.emplace_back(factor, rest(x));
  }
  return result;
}

Affine Opening::times(int X, const Affine& a) {
  return mapped(
      a, [&](int Y) { return algebra_.product_of_steps(X, Y); },
      [&](int x) { return algebra_.step(X, x); });
}

/// A number times a number, a vector or a block.
int Opening::number(int a, int b) {
  if (values_[a].type != Type::kScalar && values_[b].type != Type::kScalar) {
    throw NoComposites{};
  }
  return algebra_.scale(a, b);
}

Affine Opening::sum(const Value& v) {
  Affine result;
  for (std::size_t k = 0; k < v.operands.size(); ++k) {
    const Affine term = open(v.operands[k]);
    for (const auto& [atom, X] : term.blocks) {
      const int more = algebra_.linear({{v.factors[k], X}});
      const auto [place, is_new] = result.blocks.emplace(atom, more);
      if (!is_new && values_[place->second].type != values_[more].type) {
        throw NoComposites{};
      }
      place->second = is_new ? more : algebra_.linear({{kPlus, place->second}, {kPlus, more}});
    }
    for (const auto& [factor, x] : term.rest) {
      result.rest.emplace_back(multiply(v.factors[k], factor), x);
    }
  }
  return result;
}

Affine Opening::scaled(const Value& v) {
  int others = algebra_.ones(v.set);
  Affine part;
  for (const int x : v.operands) {
    if (depends(x)) {
      part = open(x);
    } else {
      others = algebra_.scale(others, x);
    }
  }
  const auto times_others = [&](int x) {
    return number(x, others);
  };
  return mapped(part, times_others, times_others);
}

/// a×b and a·b.
Affine Opening::product(const Value& v) {
  const bool second = depends(v.operands[1]);
  const int X = v.operands[second ? 0 : 1];
  const Affine a = open(v.operands[second ? 1 : 0]);
  if (depends(X)) {
    throw NoComposites{};
  }
  return v.op == Op::kCross ? times(second ? X : algebra_.negative(X), a)
                            : mapped(
                                  a, [&](int row) { return number(row, X); },
                                  [&](int x) { return algebra_.dot(X, x); });
}

/// S x; (Λ(a) + T) x = -Λ(x) a + T x.
Affine Opening::applied(const Value& v) {
  const int S = v.operands[0];
  const int x = v.operands[1];
  if (!depends(S)) {
    return times(S, open(x));
  }
  if (depends(x)) {
    throw NoComposites{};
  }
  return mapped(
      open(S), [&](int X) { return algebra_.product_of_steps(algebra_.negative(x), X); },
      [&](int T) { return algebra_.apply(T, x); });
}

/// F4 taken apart: I α + the moment of Λ(ω)².
Affine Opening::moment(const Value& v) {
  Affine result = times(algebra_.leaf("I^d", v.set, Type::kTensor), open(v.operands[1]));
  const int square = rest(open(v.operands[0]), Type::kTensor);
  const int none = algebra_.zero(v.set, Type::kVector);
  result.rest = {
      {kPlus, values_.intern({v.op, v.set, v.type, {}, 0, {square, none, v.operands[2]}, {}})}};
  return result;
}

Affine Opening::open(int x) {
  Affine result = parts(x);
  const auto follow = [&](int part) {
    const Value& value = values_[part];
    const Value& unsigned_value = value.op == Op::kLinear && value.operands.size() == 1
                                      ? values_[value.operands.front()]
                                      : value;
    if (part != x && !unsigned_value.operands.empty()) {  // symbols stand in other lines, too
      values_.note(values_.made_by(x), part);
    }
  };
  for (const auto& [atom, block] : result.blocks) {
    follow(block);
  }
  for (const auto& [factor, part] : result.rest) {
    follow(part);
  }
  return result;
}

/// Of the value itself.
Affine Opening::parts(int x) {
  const Value v = values_[x];
  const auto same = [](int X) {
    return X;
  };
  if (!depends(x)) {
    return {{}, {{kPlus, x}}};
  }
  switch (v.op) {
    case Op::kLeaf:
    case Op::kPath:
    case Op::kSubtree:
    case Op::kBackward:
      return {{{{x, false}, algebra_.ones(v.set)}}, {}};
    case Op::kPathStrict:
      return {{{{algebra_.sum_along(Op::kPath, v.set, v.operands[0]), true}, algebra_.ones(v.set)}},
              {}};
    case Op::kFather: {
      Affine result = mapped(open(v.operands[0]), same, [&](int T) {
        return values_.intern({v.op, v.set, v.type, {}, 0, {T}, {}});
      });
      for (const auto& [atom, X] : std::exchange(result.blocks, {})) {
        result.blocks.emplace(Atom{atom.first, true}, X);
      }
      return result;
    }
    case Op::kLinear:
      return sum(v);
    case Op::kScale:
      return scaled(v);
    case Op::kSkew:
      return mapped(open(v.operands[0]), same, [&](int a) { return algebra_.skew(a); });
    case Op::kDot:
    case Op::kCross:
      return product(v);
    case Op::kApply:
      return applied(v);
    case Op::kMoment:
      return moment(v);
    default:
      throw NoComposites{};
  }
}

}  // namespace treedyn::derive
