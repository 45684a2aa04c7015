#include <map>

#include "derive/algebra.hpp"

namespace treedyn::derive {
namespace {

constexpr Places kEverywhere{true, true, true, true};

Places either(const Places& a, const Places& b) {
  return {a.here || b.here, a.above || b.above, a.below || b.below, a.beside || b.beside};
}
Places both(const Places& a, const Places& b) {
  return {a.here && b.here, a.above && b.above, a.below && b.below, a.beside && b.beside};
}

/// D x: what is above j has other subtrees, too.
Places of_path(const Places& x) {
  return x.above ? kEverywhere : Places{x.here, false, x.here || x.below, x.beside};
}

/// Of N x or Π x.
Places of_fathers(const Places& x) {
  return x.above ? kEverywhere : Places{false, false, x.here || x.below, x.beside};
}

/// D^T x, or without the own link.
Places of_subtree(const Places& x, bool strict) {
  if (x.below || x.beside) {
    throw NoComposites{};
  }
  return {!strict && x.here, x.here || x.above, false, false};
}

class Finder {
 public:
  explicit Finder(const Values& values) : values_(values) {}

  Places of(int x) {
    if (const auto found = known_.find(x); found != known_.end()) {
      return found->second;
    }
    const Value& v = values_[x];
    const Places result = v.op == Op::kZero    ? Places{}
                          : values_.of_unit(x) ? of_unit(v)
                                               : kEverywhere;
    known_.emplace(x, result);
    return result;
  }

 private:
  template <class Join>
  Places joined(const Value& v, Join join) {
    Places result = of(v.operands.front());
    for (const int x : v.operands) {
      result = join(result, of(x));
    }
    return result;
  }

  Places of_unit(const Value& v) {
    switch (v.op) {
      case Op::kUnit:
        return {.here = true};
      case Op::kLinear:
      case Op::kAssemble:
        return joined(v, either);
      case Op::kScale:
      case Op::kDot:
      case Op::kCross:
      case Op::kSkew:
      case Op::kSkewProduct:
      case Op::kApply:
      case Op::kApplyTranspose:
      case Op::kComponent:
        return joined(v, both);
      case Op::kPath:
        return of_path(of(v.operands.front()));
      case Op::kPathStrict:
      case Op::kFather:
        return of_fathers(of(v.operands.front()));
      case Op::kSubtree:
      case Op::kSubtreeStrict:
      case Op::kSons:
        return of_subtree(of(v.operands.front()), v.op != Op::kSubtree);
      case Op::kBackward:
        return either(of_subtree(of(v.operands[0]), false), of_subtree(of(v.operands[1]), true));
      default:
        throw NoComposites{};
    }
  }

  const Values& values_;
  std::map<int, Places> known_;
};

}  // namespace

Places places(const Values& values, int x) { return Finder(values).of(x); }

}  // namespace treedyn::derive
