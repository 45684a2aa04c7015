// R7: what two sums along the tree enclose becomes a composite: D^T X D = D^T X^c + X^c N.
#include <algorithm>

#include "derive/algebra.hpp"
#include "derive/places.hpp"

namespace treedyn::derive {
int Algebra::product_of_steps(int a, int b) {
  if (a < 0 || b < 0) {
    return std::max(a, b);  // E
  }
  const Type left = value(a).type;
  const Type right = value(b).type;
  if (left == Type::kScalar || right == Type::kScalar) {
    return scale(left == Type::kScalar ? a : b, left == Type::kScalar ? b : a);
  }
  if (left == Type::kVector && right == Type::kVector) {
    return skew_product(a, b);
  }
  return bilinear(Op::kProduct, Type::kTensor, block_of(a), block_of(b));
}

int Algebra::step(int X, int y) {
  if (X < 0) {
    return y;
  }
  switch (value(X).type) {
    case Type::kScalar:
      return scale(X, y);
    case Type::kVector:
      return cross(X, y);
    case Type::kTensor:
      break;
  }
  return apply(X, y);
}

/// factor * X x as a sum of terms X' (D y), X' (N y) and what has no sum along paths.
void Algebra::open_paths(const Ratio& factor, int X, int x, Opened& opened) {
  const Value v = value(x);
  switch (v.op) {
    case Op::kPath:
    case Op::kPathStrict:
      opened.paths.push_back({factor, X, v.operands.front(), v.op == Op::kPathStrict});
      return;
    case Op::kLinear:
      for (std::size_t k = 0; k < v.operands.size(); ++k) {
        open_paths(multiply(factor, v.factors[k]), X, v.operands[k], opened);
      }
      return;
    case Op::kCross: {
      const bool second = values_.of_unit(v.operands[1]);
      open_paths(second ? factor : multiply(kMinus, factor),
                 product_of_steps(X, v.operands[second ? 0 : 1]), v.operands[second ? 1 : 0],
                 opened);
      return;
    }
    case Op::kApply:
      open_paths(factor, product_of_steps(X, v.operands[0]), v.operands[1], opened);
      return;
    case Op::kScale:
      if (v.type == Type::kScalar && values_.of_unit(x)) {
        const int unit =
            *std::ranges::find_if(v.operands, [this](int y) { return values_.of_unit(y); });
        std::vector<int> others = v.operands;
        std::erase(others, unit);
        open_paths(factor, product_of_steps(X, scaled(others, ones(v.set))), unit, opened);
        return;
      }
      if (!values_.of_unit(v.operands.front()) && values_.of_unit(v.operands.back())) {
        const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
        open_paths(factor, product_of_steps(X, scaled(numbers, ones(v.set))), v.operands.back(),
                   opened);
        return;
      }
      break;
    default:
      break;
  }
  opened.rest.emplace_back(factor, step(X, x));
}

/// Terms of one y take one step where it is a block for one of them: a×y is Λ(a) y then.
void Algebra::join(std::vector<Opened::Path>& paths) {
  const auto type = [this](const Opened::Path& path) {
    return path.step < 0 ? Type::kScalar : value(path.step).type;
  };
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const Opened::Path path = paths[k];
    const auto of_same = [&](const Opened::Path& other) {
      return other.y == path.y && other.strict == path.strict && type(other) != Type::kScalar;
    };
    const bool blocks = std::ranges::any_of(paths, [&](const Opened::Path& other) {
      return of_same(other) && type(other) == Type::kTensor;
    });
    if (!blocks || type(path) == Type::kScalar) {
      continue;
    }
    Terms terms;
    for (const Opened::Path& other : paths) {
      if (of_same(other)) {
        terms.emplace_back(other.factor, block_of(other.step));
      }
    }
    std::erase_if(paths, of_same);
    paths.insert(paths.begin() + static_cast<std::ptrdiff_t>(k),
                 {kPlus, linear(terms), path.y, path.strict});
  }
}

/// True for what the subtree decides, not the link alone.
bool Algebra::has_sum(int x) const {
  const Value& v = value(x);
  const bool of_subtree = v.op == Op::kSubtree || v.op == Op::kSubtreeStrict ||
                          v.op == Op::kBackward || v.op == Op::kSons || v.op == Op::kCollect;
  return of_subtree ||
         std::any_of(v.operands.begin(), v.operands.end(), [this](int y) { return has_sum(y); });
}

/// D^T x or N^T x by composites, all of its rows; -1 if x has no sum along paths in it.
int Algebra::of_composites(Op op, int x) {
  if (!values_.choices().composites || !values_.of_unit(x)) {
    return -1;
  }
  Opened opened;
  open_paths(kPlus, -1, x, opened);
  if (opened.paths.empty()) {
    return -1;
  }
  note(Rule::kComposites);
  join(opened.paths);
  Terms terms;
  for (const auto& [factor, y] : opened.rest) {
    terms.emplace_back(factor, sum_along(op, Set::kLinks, y));
  }
  for (const Opened::Path& path : opened.paths) {
    const int X = path.step < 0 ? ones(Set::kLinks) : path.step;
    const int below = sum_along(Op::kSubtreeStrict, Set::kLinks, X);
    const int whole =
        has_sum(X) ? linear({{kPlus, X}, {kPlus, below}}) : sum_along(Op::kSubtree, Set::kLinks, X);
    const int father = sum_along(Op::kPathStrict, Set::kLinks, path.y);
    const bool inclusive = op == Op::kSubtree;
    const int first = path.strict ? step(below, path.y) : step(whole, path.y);
    terms.emplace_back(path.factor, sum_along(path.strict ? Op::kSubtree : op, Set::kLinks, first));
    if (!inclusive && !path.strict) {
      terms.emplace_back(path.factor, step(below, path.y));
    }
    terms.emplace_back(path.factor, step(inclusive ? whole : below, father));
  }
  return linear(terms);
}

/// The rows of x on the way from the column that is asked for to the root: there N y is zero.
int Algebra::on_way_to_root(int x) {
  const Value v = value(x);
  if (!values_.of_unit(x)) {
    return x;
  }
  switch (v.op) {
    case Op::kPathStrict:
      if (places(values_, v.operands.front()).above) {
        throw NoComposites{};
      }
      return zero(v.set, v.type);
    case Op::kLinear: {
      Terms terms;
      for (std::size_t k = 0; k < v.operands.size(); ++k) {
        terms.emplace_back(v.factors[k], on_way_to_root(v.operands[k]));
      }
      return linear(terms);
    }
    case Op::kScale: {
      const int last = on_way_to_root(v.operands.back());
      const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
      return scale(scaled(numbers, ones(v.set)), last);
    }
    case Op::kDot:
      return dot(on_way_to_root(v.operands[0]), on_way_to_root(v.operands[1]));
    case Op::kCross:
      return cross(on_way_to_root(v.operands[0]), on_way_to_root(v.operands[1]));
    case Op::kApply:
      return apply(v.operands[0], on_way_to_root(v.operands[1]));
    default:
      return x;
  }
}

}  // namespace treedyn::derive
