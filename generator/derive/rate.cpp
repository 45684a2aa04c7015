#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "derive/columns.hpp"
#include "derive/derive.hpp"
#include "equations/symbols.hpp"

namespace treedyn::derive {
namespace {

namespace eq = equations;

/// What R11' does not cover.
struct NoRate {};

/// The frame in which a rate is seen. With w = σ q̇ z the latter is the former + w×x.
enum class Seen { kFromLink, kFromFather };

class Rates {
 public:
  explicit Rates(Values& values)
      : values_(values),
        columns_(values),
        algebra_(columns_.algebra()),
        w_(columns_.column(eq::z_d * eq::sigma * eq::qd)),
        slide_(columns_.column(eq::z_d * (eq::E - eq::sigma) * eq::qd)) {}

  int of(int x, Seen seen) {
    std::map<int, int>& known = known_[static_cast<std::size_t>(seen)];
    if (const auto found = known.find(x); found != known.end()) {
      return found->second;
    }
    const int result = values_.note(Rule::kValueRates, made(x, seen));
    known.emplace(x, result);
    return result;
  }

 private:
  int made(int x, Seen seen) {
    const Value v = values_[x];
    if (v.set != Set::kLinks) {
      throw NoRate{};
    }
    switch (v.op) {
      case Op::kZero:
      case Op::kOnes:
      case Op::kIdentity:
      case Op::kUnit:
        return algebra_.zero(v.set, v.type);
      case Op::kLeaf:
        return of_leaf(x, v, seen);
      case Op::kLinear: {
        Terms terms;
        for (std::size_t k = 0; k < v.operands.size(); ++k) {
          terms.emplace_back(v.factors[k], of(v.operands[k], seen));
        }
        return algebra_.linear(terms);
      }
      case Op::kScale:
      case Op::kDot:
      case Op::kCross:
      case Op::kSkewProduct:
      case Op::kApply:
        return of_product(v, seen);
      case Op::kSubtree:
      case Op::kBackward:
      case Op::kComposite:
        return seen == Seen::kFromLink ? of_sum(x, v) : from_father(x, of(x, Seen::kFromLink));
      default:
        throw NoRate{};
    }
  }

  /// Sums of what is symmetric in every link.
  [[nodiscard]] bool is_symmetric(int S) const {
    const Value& v = values_[S];
    const bool of_symmetric = v.op == Op::kSubtree || v.op == Op::kScale || v.op == Op::kLinear;
    return v.type == Type::kScalar || v.op == Op::kComposite || v.name == "I^d" ||
           v.name == "J_c^d" ||
           (of_symmetric &&
            std::ranges::all_of(v.operands, [this](int x) { return is_symmetric(x); }));
  }

  /// w×x, or Λ(w) S - S Λ(w) of a symmetric S.
  int turning(int x) {
    const Value v = values_[x];
    switch (v.type) {
      case Type::kScalar:
        return algebra_.zero(v.set, v.type);
      case Type::kVector:
        return algebra_.cross(w_, x);
      case Type::kTensor:
        break;
    }
    if (!is_symmetric(x)) {
      throw NoRate{};
    }
    return values_.intern({Op::kLever, v.set, v.type, {}, 0, {w_, x, x}, {}});
  }

  int from_father(int x, int from_link) {
    return algebra_.linear({{kPlus, from_link}, {kPlus, turning(x)}});
  }

  /// s rests in the frame of the father but for the slide (l = 0: F1); the others in that of the
  /// link.
  int of_leaf(int x, const Value& v, Seen seen) {
    if (v.name == "s^d") {
      return seen == Seen::kFromFather
                 ? slide_
                 : algebra_.linear({{kPlus, slide_}, {kMinus, algebra_.cross(w_, x)}});
    }
    static const std::set<std::string> kConstant = {"m^d", "h^d",   "c^d", "I^d",
                                                    "z^d", "J_c^d", "σ",   "E-σ"};
    if (!kConstant.contains(v.name)) {
      throw NoRate{};
    }
    const int zero = algebra_.zero(v.set, v.type);
    return seen == Seen::kFromLink || v.name == "z^d" ? zero : from_father(x, zero);
  }

  /// One factor after the other.
  int of_product(const Value& v, Seen seen) {
    Terms terms;
    for (std::size_t k = 0; k < v.operands.size(); ++k) {
      const int own = of(v.operands[k], seen);
      if (values_[own].op != Op::kZero) {
        std::vector<int> factors = v.operands;
        factors[k] = own;
        terms.emplace_back(kPlus, product(v.op, factors));
      }
    }
    return terms.empty() ? algebra_.zero(v.set, v.type) : algebra_.linear(terms);
  }

  int product(Op op, const std::vector<int>& x) {
    switch (op) {
      case Op::kDot:
        return algebra_.dot(x[0], x[1]);
      case Op::kCross:
        return algebra_.cross(x[0], x[1]);
      case Op::kSkewProduct:
        return algebra_.skew_product(x[0], x[1]);
      case Op::kApply:
        return algebra_.apply(x[0], x[1]);
      default:
        break;
    }
    int result = x.back();
    for (std::size_t k = x.size() - 1; k-- > 0;) {
      result = algebra_.scale(x[k], result);
    }
    return result;
  }

  /// Of y = D^T a + N^T b: what sons hand on turns with them.
  int of_sum(int y, const Value& v) {
    int b = turning(y);
    int a = -1;
    if (v.op == Op::kComposite) {
      a = algebra_.zero(v.set, v.type);
      b = algebra_.linear({{kPlus, b}, {kMinus, of_shift(v)}});
    } else {
      a = of(v.operands.front(), Seen::kFromLink);
    }
    if (v.op == Op::kBackward) {
      b = algebra_.linear({{kPlus, b}, {kPlus, of(v.operands.back(), Seen::kFromFather)}});
    }
    const int of_sons = algebra_.sum_along(Op::kSubtreeStrict, v.set, b);
    return algebra_.linear({{kPlus, algebra_.sum_along(Op::kSubtree, v.set, a)}, {kPlus, of_sons}});
  }

  /// Of Λ(h)Λ(s) + Λ(s)Λ(h + m s) on the way from a son to its father.
  int of_shift(const Value& composite) {
    const int m = composite.operands[0];
    const int h = composite.operands[1];
    const int s = composite.operands[2];
    const int dh = of(h, Seen::kFromFather);
    const int ds = of(s, Seen::kFromFather);
    const int sum = algebra_.linear({{kPlus, h}, {kPlus, algebra_.scale(m, s)}});
    const int dsum = algebra_.linear({{kPlus, dh}, {kPlus, algebra_.scale(m, ds)}});
    return algebra_.linear({{kPlus, algebra_.skew_product(dh, s)},
                            {kPlus, algebra_.skew_product(h, ds)},
                            {kPlus, algebra_.skew_product(ds, sum)},
                            {kPlus, algebra_.skew_product(s, dsum)}});
  }

  Values& values_;
  Columns columns_;
  Algebra& algebra_;
  int w_;
  int slide_;
  std::array<std::map<int, int>, 2> known_;
};

}  // namespace

std::optional<Derivation> rate(const Derivation& derivation) {
  if (derivation.values.choices().keeps_joints) {  // slides are in l or in the sons' s
    return std::nullopt;
  }
  Derivation result = derivation;
  Rates rates(result.values);
  try {
    for (int& root : result.roots) {
      const int whole = root;
      root = rates.of(whole, Seen::kFromLink);
      result.values.note(result.values.made_by(whole), root);
    }
  } catch (const NoRate&) {
    return std::nullopt;
  }
  return result;
}

}  // namespace treedyn::derive
