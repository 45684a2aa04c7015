// Expanded polynomials in an order of our own: what leaves GiNaC.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <ginac/ginac.h>

#include "expansion/expanded.hpp"
#include "expansion/ring.hpp"

namespace treedyn::expansion {

/// Powers of variables: (position in the ring, exponent > 0), positions ascending.
using Monomial = std::vector<std::pair<std::size_t, int>>;

/// Terms by monomial: the same polynomial always has the same terms in the same order.
using Polynomial = std::map<Monomial, GiNaC::numeric>;

Polynomial polynomial(const Ring& ring, const Expanded& value);

/// "0.5*c_elbow*qd_elbow^2 - 1/3": terms in the order of their monomials, the constant last; "0" if
/// there are none. More than `most` terms are counted instead: "(312 terms)".
std::string to_text(const Ring& ring, const Polynomial& value, std::size_t most);

}  // namespace treedyn::expansion
