#include <algorithm>
#include <array>
#include <map>

#include "derive/algebra.hpp"
#include "derive/forms.hpp"

namespace treedyn::derive {
namespace {

/// Goes from a sum over all links down to what it is made of, with the factors in front.
class Transposer {
 public:
  explicit Transposer(Values& values) : values_(values), algebra_(values) {}

  std::optional<int> run(int root) {
    const Value v = values_[root];
    if (!has_subtrees(root)) {
      return std::nullopt;
    }
    if (v.op == Op::kLinear && v.operands.size() == 1) {
      return algebra_.linear({{v.factors[0], *run(v.operands[0])}});
    }
    if (v.op == Op::kScale) {  // numbers in front stay there
      const auto x = std::ranges::find_if(v.operands, [this](int y) { return has_subtrees(y); });
      int result = *run(*x);
      for (auto y = v.operands.begin(); y != v.operands.end(); ++y) {
        result = y == x ? result : algebra_.scale(*y, result);
      }
      return result;
    }
    factors_[root] = {{kPlus, algebra_.ones(Set::kOne)}};
    std::map<int, int> rest;  // factors by what they stand in front of
    std::vector<int> handed_on;
    while (!factors_.empty()) {
      const auto [x, terms] = *factors_.rbegin();
      factors_.erase(x);
      const int factor = algebra_.linear(terms);
      if (has_subtrees(x)) {
        hand_on(Value(values_[x]), factor);
        handed_on.push_back(x);
      } else {
        rest[x] = factor;
      }
    }
    Terms result;
    for (const auto& [x, factor] : rest) {
      result.emplace_back(kPlus, collected(factor, x));
    }
    const int sum = values_.note(Rule::kTransposes, algebra_.linear(result));
    for (const int x : handed_on) {
      algebra_.in_place_of(x, sum);
    }
    return sum;
  }

 private:
  /// The operands that the value is linear in.
  [[nodiscard]] static std::vector<int> linear_operands(const Value& v) {
    switch (v.op) {
      case Op::kLinear:
      case Op::kScale:
      case Op::kDot:
      case Op::kCross:
      case Op::kCollect:
        return v.operands;
      case Op::kApply:
      case Op::kApplyTranspose:
        return {v.operands.back()};
      default:
        return {};
    }
  }

  /// True for what is linear in vectors summed over subtrees.
  bool has_subtrees(int x) {
    const auto known = known_.find(x);
    return known != known_.end() ? known->second : (known_[x] = looks_for_subtrees(x));
  }
  bool looks_for_subtrees(int x) {
    const Value& v = values_[x];
    if (v.op == Op::kSubtree || v.op == Op::kSubtreeStrict || v.op == Op::kBackward) {
      return v.type == Type::kVector;
    }
    const std::vector<int> operands = linear_operands(v);
    const auto those = std::ranges::count_if(operands, [this](int y) { return has_subtrees(y); });
    return those == 1 || (those > 0 && v.op == Op::kLinear);
  }

  void add(int x, const Ratio& ratio, int factor) { factors_[x].emplace_back(ratio, factor); }

  /// factor·v by what stands in front of its operands.
  void hand_on(const Value& v, int factor) {
    const auto path = [&](Op op) {
      return algebra_.sum_along(op, Set::kLinks, factor);
    };
    const int a = v.operands.front();
    const int b = v.operands.back();
    switch (v.op) {
      case Op::kLinear:
        for (std::size_t k = 0; k < v.operands.size(); ++k) {
          add(v.operands[k], v.factors[k], factor);
        }
        return;
      case Op::kScale:
        return hand_on_product(v, factor);
      case Op::kDot:
        return add(has_subtrees(a) ? a : b, kPlus, algebra_.scale(factor, has_subtrees(a) ? b : a));
      case Op::kCross:  // f·(a×b) = a·(b×f) = b·(f×a)
        return has_subtrees(a) ? add(a, kPlus, algebra_.cross(b, factor))
                               : add(b, kPlus, algebra_.cross(factor, a));
      case Op::kCollect:
        return add(a, kPlus, algebra_.sum_along(Op::kSpread, values_[a].set, factor));
      case Op::kApply:
        return add(b, kPlus, algebra_.apply_transposed(a, factor));
      case Op::kApplyTranspose:
        return add(b, kPlus, algebra_.apply(a, factor));
      case Op::kSubtreeStrict:
        return add(a, kPlus, path(Op::kPathStrict));
      case Op::kBackward:
        add(b, kPlus, path(Op::kPathStrict));
        [[fallthrough]];
      default:
        return add(a, kPlus, path(Op::kPath));
    }
  }

  void hand_on_product(const Value& v, int factor) {
    const auto x = std::ranges::find_if(v.operands, [this](int y) { return has_subtrees(y); });
    for (auto y = v.operands.begin(); y != v.operands.end(); ++y) {
      if (y != x) {
        factor = times(*y, factor);
      }
    }
    add(*x, kPlus, factor);
  }

  /// a·b of two vectors, or of a number and what it scales.
  int times(int a, int b) {
    const bool vectors = values_[a].type == Type::kVector && values_[b].type == Type::kVector;
    return vectors ? algebra_.dot(a, b) : algebra_.scale(a, b);
  }

  /// 1^T (factor·x).
  int collected(int factor, int x) {
    if (values_[x].set == Set::kOne) {
      return times(factor, x);
    }
    return algebra_.sum_along(Op::kCollect, Set::kOne, product(factor, x));
  }

  /// a·x, sums opened; of three vectors the last that is no symbol stands in front.
  int product(int a, int x) {
    const Value v = values_[x];
    if (v.op == Op::kLinear) {
      return algebra_.of_terms(x, [&](int term) { return product(a, term); });
    }
    if (v.op != Op::kCross) {
      return times(a, x);
    }
    std::array<int, 3> three = {a, v.operands[0], v.operands[1]};
    const auto last = [this](int y) {
      return std::pair(values_[y].op != Op::kLeaf, y);
    };
    const auto front =
        std::ranges::max_element(three, [&](int y, int z) { return last(y) < last(z); });
    std::rotate(three.begin(), front, three.end());
    const bool swaps = three[1] > three[2];
    const int area =
        swaps ? algebra_.cross(three[2], three[1]) : algebra_.cross(three[1], three[2]);
    return algebra_.linear({{{swaps ? -1 : 1, 1}, algebra_.dot(three[0], area)}});
  }

  Values& values_;
  Algebra algebra_;
  std::map<int, Terms> factors_;  ///< in front of values that are not done yet
  std::map<int, bool> known_;     ///< has_subtrees
};

}  // namespace

std::optional<int> transposed(Values& values, int root) { return Transposer(values).run(root); }

}  // namespace treedyn::derive
