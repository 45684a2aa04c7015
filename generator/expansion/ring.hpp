// The variables of the expanded equations, and the relations between them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <ginac/ginac.h>

#include "common/real.hpp"

namespace treedyn::expansion {

/// Polynomials in named variables; a variable may have a square that is a polynomial in earlier
/// ones: s^2 = 1 - c^2 for a sine, r^2 = 2 for a root. Every element then has one normal form, in
/// which such a variable stands at most to the first power.
class Ring {
 public:
  struct Variable {
    std::string name;
    GiNaC::symbol symbol;
    bool has_square = false;
    GiNaC::ex square;
  };

  /// A new variable; its name is unique by agreement of the callers.
  GiNaC::ex add(const std::string& name);
  GiNaC::ex add(const std::string& name, const GiNaC::ex& square);

  /// `value` as an element: a rational number if one with up to 20 digits explains all 50 digits, a
  /// rational times the root of an integer (a variable, "sqrt(3)") if its square is one, else the
  /// decimals themselves as a rational number.
  GiNaC::ex constant(const Real& value);

  [[nodiscard]] const std::vector<Variable>& variables() const { return variables_; }
  /// Position of a symbol among the variables. \pre it is one of them.
  [[nodiscard]] std::size_t index(const GiNaC::ex& symbol) const;

  /// The normal form of an expanded polynomial (expanded again).
  [[nodiscard]] GiNaC::ex reduce(const GiNaC::ex& expanded) const;

 private:
  [[nodiscard]] bool reduce_term(const GiNaC::ex& term, GiNaC::ex& result) const;
  GiNaC::ex root(unsigned long radicand);

  std::vector<Variable> variables_;
  std::map<GiNaC::ex, std::size_t, GiNaC::ex_is_less> index_;  // looked up, never iterated
};

}  // namespace treedyn::expansion
