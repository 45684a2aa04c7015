#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "derive/algebra.hpp"
#include "derive/forms.hpp"

namespace treedyn::derive {
namespace {

class Relative {
 public:
  explicit Relative(const Values& values)
      : old_(values), new_(values.choices(), values.acted()), algebra_(new_) {}

  Values run(std::vector<int>& roots) {
    remake(old_, new_, roots, [this](Value value) { return replaced(std::move(value)); });
    return std::move(new_);
  }

 private:
  /// Composites whose links turn with ω = D w; s changes by u = ω_f×s + v.
  struct Body {
    int m = -1;
    int h = -1;  ///< h^c
    int s = -1;
    int u = -1;
    int v = -1;
    int omega = -1;
    int omega_f = -1;
    int w = -1;
    int rate = -1;    ///< of h^c
    int handed = -1;  ///< what the father takes of it, as seen from the father
  };
  /// Σ m Λ(r) Λ(r') of such composites, r' the rate of r: Λ(ω_f) E^c and `rest`.
  struct Turned {
    int inertia = -1;  ///< I^c
    int pseudo = -1;   ///< E^c
    int omega_f = -1;
    int rest = -1;
  };

  int replaced(Value value) {
    if (value.op == Op::kLinear) {
      Terms terms = terms_in(value);
      gather_momentum(terms);
      return algebra_.linear(terms);
    }
    const std::vector<int> operands = value.operands;
    const int result = value.op != Op::kBackward     ? -1
                       : value.type == Type::kVector ? rate_of_moment(value)
                                                     : rate_of_inertia(value);
    if (result < 0) {
      return new_.intern(std::move(value));
    }
    algebra_.in_place_of(operands.front(), result);
    algebra_.in_place_of(operands.back(), result);
    return new_.note(Rule::kRelative, result);
  }

  /// What `sum` is the rate of h^c of; nothing for other sums.
  std::optional<Body> body(const Value& sum) {
    const Value turning = new_[sum.operands[0]];
    const Value shift = new_[sum.operands[1]];
    if (turning.op != Op::kCross || shift.op != Op::kScale || shift.operands.size() != 2) {
      return std::nullopt;
    }
    Body result;
    result.omega = turning.operands[0];
    result.m = shift.operands[0];
    result.u = shift.operands[1];
    const Value omega = new_[result.omega];
    const Value u = new_[result.u];
    if (omega.op != Op::kPath || omega.operands.size() != 1 || u.op != Op::kLinear ||
        u.operands.size() != 2 || u.factors != std::vector{kPlus, kPlus}) {
      return std::nullopt;
    }
    result.w = omega.operands[0];
    result.omega_f = algebra_.sum_along(Op::kPathStrict, sum.set, result.w);
    for (const std::size_t k : {0U, 1U}) {
      const Value& term = new_[u.operands[k]];
      if (term.op == Op::kCross && term.operands[0] == result.omega_f) {
        result.s = term.operands[1];
        result.v = u.operands[1 - k];
      }
    }
    if (result.s < 0) {
      return std::nullopt;
    }
    const int ms = algebra_.scale(result.m, result.s);
    result.h =
        new_.intern({Op::kBackward, sum.set, sum.type, {}, 0, {turning.operands[1], ms}, {}});
    return result;
  }

  int sum(Op op, int x) { return algebra_.sum_along(op, Set::kLinks, x); }

  /// D^T (ω×h) + N^T m (ω_f×s + v) = ω_f×h^c + D^T (w×h^c) + N^T m v, h^c = D^T h + N^T m s.
  int rate_of_moment(const Value& value) {
    std::optional<Body> found = body(value);
    if (!found) {
      return -1;
    }
    const int mv = algebra_.scale(found->m, found->v);
    const int turning = sum(Op::kSubtree, algebra_.cross(found->w, found->h));
    const int seen = algebra_.linear({{kPlus, turning}, {kPlus, sum(Op::kSubtreeStrict, mv)}});
    found->handed = algebra_.linear({{kPlus, seen}, {kPlus, mv}});
    found->rate =
        algebra_.linear({{kPlus, algebra_.cross(found->omega_f, found->h)}, {kPlus, seen}});
    bodies_.push_back(*found);
    return found->rate;
  }

  /// D^T Λ(ω) E + N^T (Λ(s) Λ(h' + m u) + Λ(h^c) Λ(u)), h' = ω_f×h^c + x the rate of h^c, is
  /// Λ(ω_f) E^c + D^T Λ(w) E^c + N^T (Λ(s) Λ(x + m v) + Λ(h^c) Λ(v)).
  int rate_of_inertia(const Value& value) {
    const auto body = std::ranges::find_if(bodies_, [&](const Body& b) {
      const int moved = algebra_.linear({{kPlus, b.rate}, {kPlus, algebra_.scale(b.m, b.u)}});
      const int shift = algebra_.linear(
          {{kPlus, algebra_.skew_product(b.s, moved)}, {kPlus, algebra_.skew_product(b.h, b.u)}});
      const Value turning = new_[value.operands[0]];
      return value.operands[1] == shift && turning.op == Op::kProduct &&
             turning.operands[0] == algebra_.skew(b.omega) &&
             new_[turning.operands[1]].op == Op::kPseudo;
    });
    if (body == bodies_.end()) {
      return -1;
    }
    const auto tensor = [&](Op op, const std::vector<int>& operands) {
      return new_.intern({op, value.set, value.type, {}, 0, operands, {}});
    };
    Turned turned;
    turned.omega_f = body->omega_f;
    turned.inertia = tensor(Op::kComposite, {body->m, body->h, body->s});
    turned.pseudo = tensor(Op::kPseudo, {turned.inertia});
    const auto times_pseudo = [&](int omega) {
      return tensor(Op::kProduct, {algebra_.skew(omega), turned.pseudo});
    };
    const int handed = algebra_.linear({{kPlus, algebra_.skew_product(body->s, body->handed)},
                                        {kPlus, algebra_.skew_product(body->h, body->v)}});
    turned.rest = algebra_.linear({{kPlus, sum(Op::kSubtree, times_pseudo(body->w))},
                                   {kPlus, sum(Op::kSubtreeStrict, handed)}});
    const int result =
        algebra_.linear({{kPlus, times_pseudo(body->omega_f)}, {kPlus, turned.rest}});
    turned_[result] = turned;
    return result;
  }

  /// I^c (ω_f×x) - (Λ(ω_f) E^c + S) x = (E^c ω_f)×x - S x.
  void gather_momentum(Terms& terms) {
    for (auto& [factor, term] : terms) {
      const Value v = new_[term];
      const auto turned = v.op == Op::kApply ? turned_.find(v.operands[0]) : turned_.end();
      if (turned == turned_.end()) {
        continue;
      }
      const auto& [inertia, pseudo, omega_f, rest] = turned->second;
      const int x = v.operands[1];
      const std::pair<Ratio, int> other = {multiply(kMinus, factor),
                                           algebra_.apply(inertia, algebra_.cross(omega_f, x))};
      const auto found = std::ranges::find(terms, other);
      if (found != terms.end()) {
        found->second =
            new_.note(Rule::kMomentum, algebra_.cross(algebra_.apply(pseudo, omega_f), x));
        algebra_.in_place_of(v.operands[0], found->second);
        term = new_.note(Rule::kMomentum, algebra_.apply(rest, x));
        return;
      }
    }
  }

  const Values& old_;
  Values new_;
  Algebra algebra_;
  std::vector<Body> bodies_;
  std::map<int, Turned> turned_;  ///< by the tensor
};

}  // namespace

Values with_relative_speeds(const Values& values, std::vector<int>& roots) {
  const std::vector<int> needed = values.needed(roots);
  const bool any =
      std::ranges::any_of(needed, [&](int id) { return values[id].op == Op::kPseudo; });
  return any ? Relative(values).run(roots) : values;
}

}  // namespace treedyn::derive
