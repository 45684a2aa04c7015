// R7: what two sums along the tree enclose becomes a composite: D^T X D = D^T X^c + X^c N.
#include <algorithm>

#include "derive/algebra.hpp"

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
  if (v.op == Op::kSpread) {  // the same for all links
    return false;
  }
  const bool of_subtree = v.op == Op::kSubtree || v.op == Op::kSubtreeStrict ||
                          v.op == Op::kBackward || v.op == Op::kSons || v.op == Op::kCollect;
  return of_subtree || std::ranges::any_of(v.operands, [this](int y) { return has_sum(y); });
}

/// D^T x of N^T x; of what is a sum over subtrees itself x + N^T x.
int Algebra::with_links(int x, int below) {
  return has_sum(x) ? linear({{kPlus, x}, {kPlus, below}})
                    : sum_along(Op::kSubtree, Set::kLinks, x);
}

/// D^T x, N^T x, all of its rows, or 1^T x by composites; -1 if x has no sum along paths in it.
int Algebra::of_composites(Op op, Set set, int x) {
  if (!values_.choices().composites || !values_.of_unit(x) || value(x).set != Set::kLinks) {
    return -1;
  }
  Opened opened;
  open_paths(kPlus, -1, x, opened);
  if (opened.paths.empty()) {
    return -1;
  }
  join(opened.paths);
  const Rule rule = op == Op::kCollect ? Rule::kPlaceSums : Rule::kComposites;
  Terms terms;
  for (const auto& [factor, y] : opened.rest) {
    terms.emplace_back(factor, sum_along(op, set, y));
  }
  for (const Opened::Path& path : opened.paths) {
    const int X = path.step < 0 ? ones(Set::kLinks) : path.step;
    const int below = note(rule, sum_along(Op::kSubtreeStrict, Set::kLinks, X));
    const int whole = note(rule, with_links(X, below));
    const int first = path.strict ? step(below, path.y) : step(whole, path.y);
    if (op == Op::kCollect) {
      terms.emplace_back(path.factor, note(rule, sum_along(op, set, first)));
      continue;
    }
    const int father = sum_along(Op::kPathStrict, Set::kLinks, path.y);
    const bool inclusive = op == Op::kSubtree;
    terms.emplace_back(path.factor, sum_along(path.strict ? Op::kSubtree : op, Set::kLinks, first));
    if (!inclusive && !path.strict) {
      terms.emplace_back(path.factor, step(below, path.y));
    }
    terms.emplace_back(path.factor, step(inclusive ? whole : below, father));
  }
  return note(rule, in_place_of(x, linear(terms)));
}

Algebra::Lever Algebra::lever_of(int x) {
  const Value v = value(x);
  switch (v.op) {
    case Op::kScale: {
      if (v.type != Type::kVector) {
        return {};
      }
      const std::vector<int> numbers(v.operands.begin(), v.operands.end() - 1);
      return {v.operands.back(), scaled(numbers, ones(v.set)), v.op};
    }
    case Op::kSkewProduct:
    case Op::kCross: {
      const Lever scaled_lever = lever_of(v.operands[0]);
      return scaled_lever.op == Op::kScale && scaled_lever.lever >= 0
                 ? Lever{scaled_lever.lever, scale(scaled_lever.rest, v.operands[1]), v.op}
                 : Lever{v.operands[0], v.operands[1], v.op};
    }
    case Op::kProduct:
      return value(v.operands[0]).op == Op::kSkew
                 ? Lever{value(v.operands[0]).operands[0], v.operands[1], v.op}
                 : Lever{};
    default:
      return {};
  }
}

int Algebra::product_of(const Lever& product) {
  switch (product.op) {
    case Op::kScale:
      return scale(product.rest, product.lever);
    case Op::kCross:
      return cross(product.lever, product.rest);
    default:
      return product_of_steps(product.lever, product.rest);
  }
}

/// D^T x, term by term.
int Algebra::whole_of(int x) {
  return value(x).op == Op::kLinear ? of_terms(x, [this](int term) { return whole_of(term); })
                                    : with_links(x, sum_along(Op::kSubtreeStrict, Set::kLinks, x));
}

/// R7'' of places P = D s: D^T (P y) = P D^T y + N^T (s D^T y), and what all links have in common
/// stays in front; -1 if no lever of x is such.
int Algebra::of_places(Op op, int x) {
  if (!values_.choices().composites || values_.of_unit(x)) {
    return -1;
  }
  const auto sum = [&](int y) {
    return sum_along(op, Set::kLinks, y);
  };
  const auto is_in_front = [this](int y) {
    return is_place(y) || is_common(y);
  };
  if (value(x).op == Op::kLinear) {
    const std::vector<int> operands = value(x).operands;
    return std::ranges::any_of(operands, [&](int y) { return of_places(op, y) >= 0; })
               ? of_terms(x, sum)
               : -1;
  }
  const Lever product = lever_of(x);
  if (product.lever < 0) {
    return -1;
  }
  const auto with = [&](int lever, int rest) {
    return product_of({lever, rest, product.op});
  };
  if (value(product.lever).op == Op::kLinear) {
    const std::vector<int> levers = value(product.lever).operands;
    const auto splits = [&](int y) {
      return is_in_front(y) || of_places(op, with(y, product.rest)) >= 0;
    };
    return std::ranges::any_of(levers, splits)
               ? of_terms(product.lever, [&](int y) { return sum(with(y, product.rest)); })
               : -1;
  }
  if (!is_in_front(product.lever)) {
    return -1;
  }
  const int rest = op == Op::kSubtree ? whole_of(product.rest) : sum(product.rest);
  const int first = with(product.lever, rest);
  if (is_common(product.lever)) {
    return note(Rule::kCommon, first);
  }
  const int s = value(product.lever).operands.front();
  const int whole = whole_of(product.rest);
  const int below = sum_along(Op::kSubtreeStrict, Set::kLinks, with(s, whole));
  return note(Rule::kPlaceSums, linear({{kPlus, first}, {kPlus, below}}));
}

/// The rows of x on the way from the column that is asked for to the root: there N y is zero.
int Algebra::rows_on_way_to_root(int x) {
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
    case Op::kLinear:
      return of_terms(x, [this](int term) { return on_way_to_root(term); });
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
