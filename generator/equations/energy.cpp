#include "equations/energy.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "block/rewrite.hpp"

namespace treedyn::equations {
namespace {

using block::Expression;
using block::Kind;

bool is_number(const Expression& e) { return e.shape() == block::Shape{}; }

/// True if every term of e begins (or ends) with the symbol.
bool has_at_end(const Expression& e, bool begins, std::string_view name) {
  const std::vector<Expression>& x = e.operands();
  switch (e.kind()) {
    case Kind::kLeaf:
      return is_leaf(e, name);
    case Kind::kSum:
      return std::ranges::all_of(x,
                                 [&](const auto& term) { return has_at_end(term, begins, name); });
    case Kind::kProduct:
      return has_at_end(begins ? x.front() : x.back(), begins, name);
    case Kind::kTranspose:
      return has_at_end(x.front(), !begins, name);
    default:
      return has_at_end(x.front(), begins, name);
  }
}

bool has_cross_products(const Expression& e) {
  return e.kind() == Kind::kSkew || e.kind() == Kind::kSkewTranspose ||
         std::ranges::any_of(e.operands(), has_cross_products);
}

bool is_kinetic(const Expression& e) {
  return has_at_end(e, true, "q̇") && has_at_end(e, false, "q̇");
}

bool is_potential(const Expression& e) {
  return (has_at_end(e, true, "g") || has_at_end(e, false, "g")) && holds(e, "m^d") &&
         !holds(e, "z^d") && !has_cross_products(e);
}

}  // namespace

bool has_form_of_energy(const Expression& number) {
  const std::vector<Expression>& x = number.operands();
  switch (number.kind()) {
    case Kind::kNamed:
    case Kind::kScaled:
    case Kind::kTranspose:
      return has_form_of_energy(x.front());
    case Kind::kSum:
      return std::ranges::all_of(x, has_form_of_energy);
    case Kind::kProduct: {  // numbers in front or behind do not count
      const auto first = std::ranges::find_if_not(x, is_number);
      const auto last = std::find_if_not(x.rbegin(), x.rend(), is_number).base();
      if (last - first < 1) {
        return std::ranges::any_of(x, has_form_of_energy);
      }
      const Expression inner = product_of(first, last);
      return is_kinetic(inner) || is_potential(inner);
    }
    default:
      return false;
  }
}

}  // namespace treedyn::equations
