#include "common/real.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <climits>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <utility>

#include "common/provenance.hpp"
#include "common/recipe.hpp"

namespace treedyn {

namespace {

struct HashOfTwo {
  std::size_t operator()(const std::pair<Digits, Digits>& of) const {
    const std::hash<Digits> hash;
    return hash(of.first) * 31 + hash(of.second);
  }
};

/// function(x, y), which costs as much as hundreds of products: a search among formulations asks
/// for the same ones again and again. Each function has its own table in each thread.
template <class Function>
Digits remembered(const Digits& x, const Digits& y, Function function) {
  constexpr std::size_t kMost = 100000;
  thread_local std::unordered_map<std::pair<Digits, Digits>, Digits, HashOfTwo> known;
  if (x.is_zero() || y.is_zero() || !isfinite(x) || !isfinite(y)) {
    return function(x, y);  // +0 and -0 are equal, and not the same
  }
  if (known.size() > kMost) {
    known.clear();
  }
  const auto found = known.find({x, y});
  return found != known.end() ? found->second
                              : known.emplace(std::pair(x, y), function(x, y)).first->second;
}

template <class Function>
Digits remembered(const Digits& x, Function function) {
  return remembered(x, Digits(1), [&](const Digits& a, const Digits&) { return function(a); });
}

/// Of functions that have numbers without unit.
Real ratio(std::span<const Real> of, const Real& result) {
  note_ratio(of, result);
  return result;
}

}  // namespace

Real::Real(const char* text) : value_(text) {}

Real Real::from(long double value) { return Digits(value); }
Real Real::from(long long value) {
  static const std::array<Digits, 3> small = {Digits(-1), Digits(0), Digits(1)};
  return value >= -1 && value <= 1 ? small[static_cast<std::size_t>(value + 1)] : Digits(value);
}
Real Real::from(unsigned long long value) { return Digits(value); }

Real Real::seen_as(const Digits& value, const Digits& stand_in) {
  return {value, stand_in, value != stand_in};
}

Real Real::of_parameter(int index, const Digits& value, const Digits& stand_in) {
  return {value, stand_in, value != stand_in, recipe_of_parameter(index)};
}

template <class T>
T Real::convert_to() const {
  return value_.convert_to<T>();
}
template int Real::convert_to<int>() const;
template long Real::convert_to<long>() const;
template float Real::convert_to<float>() const;
template double Real::convert_to<double>() const;
template long double Real::convert_to<long double>() const;

std::string Real::str(std::streamsize digits, std::ios_base::fmtflags flags) const {
  return value_.str(digits, flags);
}

Real Real::operator-() const { return {-value_, -seen_, differs_, -recipe_}; }

template <class Operation>
Real Real::made(RecipeKind kind, const Real& a, const Real& b, Operation operation) {
  Real result = map(a, b, operation);
  if (a.recipe_ != 0 || b.recipe_ != 0) {
    result.recipe_ = recipe_of(kind, a, b);
  }
  if (result.differs_) {
    note_result(kind, a, b, result);
  }
  return result;
}

Real operator+(const Real& a, const Real& b) {
  return Real::made(RecipeKind::kAdd, a, b,
                    [](const Digits& x, const Digits& y) { return Digits(x + y); });
}
Real operator-(const Real& a, const Real& b) {
  return Real::made(RecipeKind::kSubtract, a, b,
                    [](const Digits& x, const Digits& y) { return Digits(x - y); });
}
Real operator*(const Real& a, const Real& b) {
  return Real::made(RecipeKind::kMultiply, a, b,
                    [](const Digits& x, const Digits& y) { return Digits(x * y); });
}
Real operator/(const Real& a, const Real& b) {
  return Real::made(RecipeKind::kDivide, a, b,
                    [](const Digits& x, const Digits& y) { return Digits(x / y); });
}

bool operator==(const Real& a, const Real& b) {
  return Real::both(a, b, [](const Digits& x, const Digits& y) { return x == y; });
}

std::partial_ordering Real::compared_with_zero() const {
  const Digits& x = seen();
  return isnan(x)       ? std::partial_ordering::unordered
         : x.is_zero()  ? std::partial_ordering::equivalent
         : x.sign() < 0 ? std::partial_ordering::less
                        : std::partial_ordering::greater;
}

std::partial_ordering operator<=>(const Real& a, const Real& b) {
  const Digits& x = a.seen();
  const Digits& y = b.seen();
  return x < y    ? std::partial_ordering::less
         : x > y  ? std::partial_ordering::greater
         : x == y ? std::partial_ordering::equivalent
                  : std::partial_ordering::unordered;
}

Real abs(const Real& x) { return x.seen() < 0 ? -x : x; }

Real Real::noted(RecipeKind kind, const Real& x, Real result) {
  result.recipe_ = recipe_of(kind, x);
  if (result.differs_) {
    note_result(kind, x, result);
  }
  return result;
}
Real sqrt(const Real& x) {
  const auto root = [](const Digits& a) {
    return remembered(a, [](const Digits& of) { return Digits(sqrt(of)); });
  };
  Real result = Real::map(x, root);
  if (x.recipe_ != 0 && x.seen() < 0) {  // which may be negative where the number is not
    result.seen_ = root(-x.seen());
  }
  return Real::noted(RecipeKind::kSqrt, x, result);
}
Real sin(const Real& x) {
  return Real::noted(RecipeKind::kSin, x, Real::map(x, [](const Digits& a) {
                       return remembered(a, [](const Digits& of) { return Digits(sin(of)); });
                     }));
}
Real cos(const Real& x) {
  return Real::noted(RecipeKind::kCos, x, Real::map(x, [](const Digits& a) {
                       return remembered(a, [](const Digits& of) { return Digits(cos(of)); });
                     }));
}
Real tan(const Real& x) {
  return ratio({&x, 1}, Real::map(x, [](const Digits& a) { return Digits(tan(a)); }));
}
Real log(const Real& x) {
  return ratio({&x, 1}, Real::map(x, [](const Digits& a) { return Digits(log(a)); }));
}
Real floor(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(floor(a)); });
}
Real round(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(round(a)); });
}
Real atan2(const Real& y, const Real& x) {
  return ratio(std::array{y, x}, Real::map(y, x, [](const Digits& a, const Digits& b) {
                 return remembered(
                     a, b, [](const Digits& p, const Digits& q) { return Digits(atan2(p, q)); });
               }));
}
Real pow(const Real& x, const Real& y) {
  return Real::map(x, y, [](const Digits& a, const Digits& b) { return Digits(pow(a, b)); });
}
Real ldexp(const Real& x, int exponent) {
  return Real::map(x, [exponent](const Digits& a) { return Digits(ldexp(a, exponent)); });
}
long lround(const Real& x) { return lround(x.digits()); }
bool isfinite(const Real& x) { return isfinite(x.digits()) && isfinite(x.seen()); }

Real larger(const Real& a, const Real& b) {
  return Real::map(a, b, [](const Digits& x, const Digits& y) {
    const Digits p = abs(x);
    const Digits q = abs(y);
    return p < q ? q : p;
  });
}

double nearly(const Digits& x) {
  using Backend = Digits::backend_type;
  constexpr int kLimb = 64;
  static_assert(sizeof(boost::multiprecision::limb_type) * CHAR_BIT == kLimb);
  if (x.backend().exponent() > Backend::max_exponent) {
    return x.convert_to<double>();  // zero, infinite, none
  }
  const auto& bits = x.backend().bits();
  const auto* const limbs = bits.limbs() + bits.size() - 1;
  const double leading = static_cast<double>(limbs[0]) * 0x1p64 + static_cast<double>(limbs[-1]);
  const double magnitude = std::ldexp(leading, static_cast<int>(x.backend().exponent()) + 1 -
                                                   static_cast<int>(Backend::bit_count) +
                                                   kLimb * (static_cast<int>(bits.size()) - 2));
  return x.sign() < 0 ? -magnitude : magnitude;
}

const Real& pi() {
  static const Real value = boost::math::constants::pi<Digits>();
  return value;
}

namespace {

/// True only if |x| > 2^-bits |of|, by their exponents: most comparisons end here.
bool is_beyond(const Digits& x, const Digits& of, int bits) {
  using Backend = Digits::backend_type;
  const auto of_x = x.backend().exponent();
  const auto of_other = of.backend().exponent();
  return of_x <= Backend::max_exponent && of_other <= Backend::max_exponent &&
         of_x > of_other - bits;
}

}  // namespace

bool negligible(const Real& value, const Real& scale) {
  return Real::both(value, scale, [](const Digits& x, const Digits& of) {
    constexpr int kBits = 132;  // 2^-132 > 1e-40
    static const Digits rounding(1e-40);
    return !is_beyond(x, of, kBits) && (x.is_zero() || abs(x) <= abs(of) * rounding);
  });
}

bool identical(const Real& a, const Real& b) {
  return Real::both(a, b, [](const Digits& x, const Digits& y) {
    static const Digits same(1e-38);
    return x == y || abs(x - y) <= abs(y) * same;
  });
}

}  // namespace treedyn
