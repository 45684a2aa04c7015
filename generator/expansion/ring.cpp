#include "expansion/ring.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "expansion/rational.hpp"

namespace treedyn::expansion {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

/// n = square^2 * rest with rest free of squares; false if n is too large to try.
bool split_square(const numeric& n, numeric& square, unsigned long& rest) {
  constexpr long kLargest = 1'000'000'000;
  if (n > kLargest) {
    return false;
  }
  long remaining = n.to_long();
  long root = 1;
  for (long p = 2; p * p <= remaining; ++p) {
    while (remaining % (p * p) == 0) {
      remaining /= p * p;
      root *= p;
    }
  }
  square = numeric(root);
  rest = static_cast<unsigned long>(remaining);
  return true;
}

}  // namespace

ex Ring::add(const std::string& name) {
  const GiNaC::symbol symbol(name);
  index_.emplace(symbol, variables_.size());
  variables_.push_back({name, symbol, false, {}});
  return symbol;
}

ex Ring::add(const std::string& name, const ex& square) {
  ex symbol = add(name);
  variables_.back().has_square = true;
  variables_.back().square = square;
  return symbol;
}

ex Ring::root(unsigned long radicand) {
  const std::string name = fmt::format("sqrt({})", radicand);
  for (const Variable& variable : variables_) {
    if (variable.name == name) {
      return variable.symbol;
    }
  }
  return add(name, numeric(radicand));
}

ex Ring::constant(const Real& value) {
  if (const auto rational = nearby_rational(value)) {
    return *rational;
  }
  // value^2 = p/q: value = sqrt(p q) / q
  const auto square = nearby_rational(value * value);
  numeric whole;
  unsigned long radicand = 0;
  if (square && split_square(square->numer() * square->denom(), whole, radicand)) {
    const numeric factor = whole / square->denom();
    return (value < 0 ? -factor : factor) * root(radicand);
  }
  return binary_fraction(value);
}

std::size_t Ring::index(const ex& symbol) const {
  const auto found = index_.find(symbol);
  TREEDYN_EXPECT(found != index_.end());
  return found->second;
}

// True if the term had a square to replace.
bool Ring::reduce_term(const ex& term, ex& result) const {
  bool changed = false;
  result = 1;
  const bool product = GiNaC::is_a<GiNaC::mul>(term);
  const std::size_t factors = product ? term.nops() : 1;
  for (std::size_t n = 0; n < factors; ++n) {
    const ex factor = product ? term.op(n) : term;
    if (!GiNaC::is_a<GiNaC::power>(factor)) {
      result *= factor;
      continue;
    }
    const Variable& variable = variables_[index(factor.op(0))];
    const int exponent = GiNaC::ex_to<numeric>(factor.op(1)).to_int();
    if (!variable.has_square) {
      result *= factor;
      continue;
    }
    changed = true;
    result *= GiNaC::pow(variable.square, exponent / 2) * GiNaC::pow(factor.op(0), exponent % 2);
  }
  return changed;
}

ex Ring::reduce(const ex& expanded) const {
  if (!GiNaC::is_a<GiNaC::add>(expanded)) {
    ex result;
    return reduce_term(expanded, result) ? reduce(result.expand()) : expanded;
  }
  GiNaC::exvector kept;
  GiNaC::exvector replaced;
  for (const ex& term : expanded) {
    ex result;
    if (reduce_term(term, result)) {
      replaced.push_back(result.expand());
    } else {
      kept.push_back(term);
    }
  }
  if (replaced.empty()) {
    return expanded;
  }
  const ex again = reduce(ex(GiNaC::add(replaced)).expand());
  return ex(GiNaC::add(kept)) + again;
}

}  // namespace treedyn::expansion
