#include "expansion/polynomial.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include <fmt/format.h>

#include "common/real.hpp"

namespace treedyn::expansion {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

void add_factor(const Ring& ring, const ex& factor, Monomial& monomial, numeric& coefficient) {
  if (GiNaC::is_a<numeric>(factor)) {
    coefficient *= GiNaC::ex_to<numeric>(factor);
  } else if (GiNaC::is_a<GiNaC::power>(factor)) {
    monomial.emplace_back(ring.index(factor.op(0)), GiNaC::ex_to<numeric>(factor.op(1)).to_int());
  } else {
    monomial.emplace_back(ring.index(factor), 1);
  }
}

void add_term(const Ring& ring, const ex& term, Polynomial& result) {
  Monomial monomial;
  numeric coefficient = 1;
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const ex& factor : term) {
      add_factor(ring, factor, monomial, coefficient);
    }
  } else {
    add_factor(ring, term, monomial, coefficient);
  }
  std::ranges::sort(monomial);
  if (!coefficient.is_zero()) {
    result.emplace(monomial, coefficient);
  }
}

/// Digits of an integer, without GiNaC's printer.
boost::multiprecision::cpp_int integer(const numeric& value) {
  const numeric base = 1'000'000'000;
  const numeric magnitude = GiNaC::abs(value);
  boost::multiprecision::cpp_int result = 0;
  std::vector<long> digits;
  for (numeric rest = magnitude; !rest.is_zero(); rest = GiNaC::iquo(rest, base)) {
    digits.push_back(GiNaC::irem(rest, base).to_long());
  }
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    result = result * 1'000'000'000 + *digit;
  }
  return result;
}

bool only_twos_and_fives(boost::multiprecision::cpp_int n) {
  for (const int p : {2, 5}) {
    while (n % p == 0) {
      n /= p;
    }
  }
  return n == 1;
}

/// |value|: integers and small fractions as such, the rest with up to 17 digits.
std::string magnitude_text(const numeric& value) {
  const boost::multiprecision::cpp_int p = integer(value.numer());
  const boost::multiprecision::cpp_int q = integer(value.denom());
  if (q == 1 && p < 1'000'000'000) {
    return p.str();
  }
  if (q < 1000 && p < 1000 && !only_twos_and_fives(q)) {
    return fmt::format("{}/{}", p.str(), q.str());
  }
  return fmt::format("{}", static_cast<double>(Digits(p.str()) / Digits(q.str())));
}

std::string monomial_text(const Ring& ring, const Monomial& monomial) {
  std::string result;
  for (const auto& [variable, exponent] : monomial) {
    const std::string& name = ring.variables()[variable].name;
    const char* times = result.empty() ? "" : "*";
    result += exponent == 1 ? fmt::format("{}{}", times, name)
                            : fmt::format("{}{}^{}", times, name, exponent);
  }
  return result;
}

std::string term_text(const Ring& ring, const Monomial& monomial, const numeric& coefficient) {
  const std::string factors = monomial_text(ring, monomial);
  std::string number = magnitude_text(coefficient);
  if (factors.empty()) {
    return number;
  }
  return number == "1" ? factors : fmt::format("{}*{}", number, factors);
}

}  // namespace

Polynomial polynomial(const Ring& ring, const Expanded& value) {
  Polynomial result;
  if (GiNaC::is_a<GiNaC::add>(value.value())) {
    for (const ex& term : value.value()) {
      add_term(ring, term, result);
    }
  } else {
    add_term(ring, value.value(), result);
  }
  return result;
}

std::string to_text(const Ring& ring, const Polynomial& value, std::size_t most) {
  if (value.size() > most) {
    return fmt::format("({} terms)", value.size());
  }
  std::vector<std::pair<Monomial, numeric>> terms(value.begin(), value.end());
  if (!terms.empty() && terms.front().first.empty()) {  // the constant last
    std::rotate(terms.begin(), terms.begin() + 1, terms.end());
  }
  std::string result;
  for (const auto& [monomial, coefficient] : terms) {
    const bool negative = coefficient.is_negative();
    const std::string text = term_text(ring, monomial, coefficient);
    if (result.empty()) {
      result = fmt::format("{}{}", negative ? "-" : "", text);
    } else {
      result += fmt::format(" {} {}", negative ? "-" : "+", text);
    }
  }
  return result.empty() ? "0" : result;
}

}  // namespace treedyn::expansion
