#include "expansion/rational.hpp"

#include <boost/multiprecision/cpp_int.hpp>

namespace treedyn::expansion {
namespace {

using Integer = boost::multiprecision::cpp_int;

GiNaC::numeric to_numeric(const Integer& value) { return GiNaC::numeric(value.str().c_str()); }

}  // namespace

std::optional<GiNaC::numeric> nearby_rational(const Real& value) {
  const Real tolerance = (abs(value) > 1 ? Real(abs(value)) : Real(1)) * Real("1e-45");
  const Integer largest("100000000000000000000");
  Integer h0 = 0;
  Integer h1 = 1;
  Integer k0 = 1;
  Integer k1 = 0;
  Real rest = value;
  while (true) {
    const Real whole = floor(rest);
    const Integer a(whole.digits());
    const Integer h = a * h1 + h0;
    const Integer k = a * k1 + k0;
    if (k > largest) {
      return std::nullopt;
    }
    if (abs(Real(Digits(h) / Digits(k)) - value) <= tolerance) {
      return to_numeric(h) / to_numeric(k);
    }
    h0 = h1;
    h1 = h;
    k0 = k1;
    k1 = k;
    rest = 1 / (rest - whole);
  }
}

GiNaC::numeric binary_fraction(const Real& value) {
  int exponent = 0;
  const Digits mantissa = frexp(value.digits(), &exponent);
  constexpr int kBits = std::numeric_limits<Real>::digits;
  const Integer scaled(ldexp(mantissa, kBits));
  return to_numeric(scaled) * GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - kBits));
}

}  // namespace treedyn::expansion
