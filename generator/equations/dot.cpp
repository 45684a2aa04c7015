#include "equations/dot.hpp"

#include <algorithm>

#include "block/rewrite.hpp"
#include "equations/quadratic.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {
namespace {

using block::diagb;
using block::Kind;
using block::skew;
using block::transpose;
using Rate = std::optional<Expression>;  ///< nothing: zero

Rate sum(const Rate& a, const Rate& b) { return a && b ? *a + *b : a ? a : b; }

Expression scaled(const block::Ratio& factor, const Expression& e) {
  return factor == block::Ratio{} ? e : factor * e;
}

/// Λ(diagb(ω)) X: X turns with ω.
Expression turning(const Expression& omega, const Expression& x) { return skew(diagb(omega)) * x; }

/// The rates of the symbols.
const std::map<std::string, Rate>& known_rates() {
  static const std::map<std::string, Rate> kTable = [] {
    const Expression w = z_d * sigma * qd;
    const Expression omega = D * w;
    const Expression omega_f = (D - E) * w;           // of the fathers
    const Expression slide = z_d * (E - sigma) * qd;  // speeds of slides
    const Expression of_points = transpose(W) * D * w;
    const Expression Lam = skew(diagb(omega));
    std::map<std::string, Rate> rates;
    rates.emplace("z^d", turning(omega_f, z_d));
    rates.emplace("s^d", block::named("dot(s^d)", turning(omega_f, s_d) + diagb(Pi * slide)));
    rates.emplace("l^d", block::named("dot(l^d)", turning(omega_f, l_d) + diagb(slide)));
    rates.emplace("c^d", turning(omega, c_d));
    rates.emplace("t^d",
                  block::named("dot(t^d)", turning(of_points, t_d) + diagb(transpose(W) * slide)));
    rates.emplace("J_c^d", Lam * J_d - J_d * Lam);
    rates.emplace("q̇", qdd);
    rates.emplace("q̇^d", diagb(qdd));
    for (const Expression& constant : {D, E, Pi, sigma, W, ones, ones_P, m_d, g}) {
      rates.emplace(constant.node().name, std::nullopt);
    }
    return rates;
  }();
  return kTable;
}

Rate rate(const Expression& e, const Rates& rates);

Rate of_leaf(const Expression& e, const Rates& rates) {
  const std::string& name = e.node().name;
  if (const auto own = rates.find(name); own != rates.end()) {
    return own->second;
  }
  const auto found = known_rates().find(name);
  if (found == known_rates().end()) {
    throw NoRate("the rate of " + name + " is not known; expected what q and qd decide");
  }
  return found->second;
}

/// (X Y Z)' = X' Y Z + X Y' Z + X Y Z'.
Rate of_product(const std::vector<Expression>& x, const Rates& rates) {
  Rate result;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Rate inner = rate(x[k], rates);
    if (!inner) {
      continue;
    }
    Expression term = k == 0 ? *inner : x[0];
    for (std::size_t n = 1; n < x.size(); ++n) {
      term = term * (n == k ? *inner : x[n]);
    }
    result = sum(result, term);
  }
  return result;
}

/// Half the rate of y^T M y: y^T M y' + ½ y^T M' y; of J' = Λ(ω) J - J Λ(ω) ½ y^T J' y is
/// -y^T J Λ(ω) y.
Rate of_form(const QuadraticForm& form, const Rates& rates) {
  const Expression left = transpose(form.y);
  const auto times_middle = [&](const Expression& x, const std::vector<Expression>& middle) {
    Expression result = left;
    for (const Expression& factor : middle) {
      result = result * factor;
    }
    return result * x;
  };
  Rate moving = rate(form.y, rates);
  Rate result;
  for (std::size_t k = 0; k < form.middle.size(); ++k) {
    if (block::is_leaf(form.middle[k], J_d.node().name)) {
      const Expression turned = skew(diagb(D * (z_d * sigma * qd))) * form.y;
      moving = moving ? *moving - turned : -turned;
    } else if (const Rate inner = rate(form.middle[k], rates)) {
      std::vector<Expression> middle = form.middle;
      middle[k] = *inner;
      result = sum(result, block::Ratio{1, 2} * times_middle(form.y, middle));
    }
  }
  return moving ? sum(times_middle(*moving, form.middle), result) : result;
}

/// What has one factor stays together: rules see it as if there were none.
Rate of_forms(const std::vector<QuadraticForm>& forms, const Rates& rates) {
  Rate result;
  std::vector<block::Ratio> done;
  for (const QuadraticForm& first : forms) {
    if (std::ranges::find(done, first.factor) != done.end()) {
      continue;
    }
    done.push_back(first.factor);
    Rate all;
    for (const QuadraticForm& form : forms) {
      all = form.factor == first.factor ? sum(all, of_form(form, rates)) : all;
    }
    result = all ? sum(result, scaled(block::multiply({2, 1}, first.factor), *all)) : result;
  }
  return result;
}

Rate rate(const Expression& e, const Rates& rates) {
  const std::vector<Expression>& x = e.operands();
  if (e.kind() == Kind::kLeaf) {
    return of_leaf(e, rates);
  }
  if (const auto forms = quadratic_forms(e)) {
    return of_forms(*forms, rates);
  }
  if (e.kind() == Kind::kProduct) {
    return of_product(x, rates);
  }
  if (e.kind() == Kind::kSum) {
    Rate result;
    for (const Expression& term : x) {
      result = sum(result, rate(term, rates));
    }
    return result;
  }
  const Rate inner = rate(x.front(), rates);
  return inner ? Rate(block::with_operand(e, *inner)) : std::nullopt;
}

}  // namespace

std::map<std::string, Expression> leaf_rates(const Expression& e, const Rates& rates) {
  std::map<std::string, Expression> result;
  if (const Rate own = e.kind() == Kind::kLeaf ? of_leaf(e, rates) : Rate{}) {
    result.emplace(e.node().name, *own);
  }
  for (const Expression& operand : e.operands()) {
    result.merge(leaf_rates(operand, rates));
  }
  return result;
}

Expression with_free_places(const Expression& e) {
  static const std::map<std::string, Expression> kRates = [] {
    const Expression w = z_d * sigma * qd;
    return std::map<std::string, Expression>{
        {"dot(s^d)", turning((D - E) * w, s_d) + diagb(z_d * (E - sigma) * qd)},
        {"dot(l^d)", 0 * l_d},
        {"dot(t^d)", turning(transpose(W) * D * w, t_d)}};
  }();
  return block::replaced(e, kRates);
}

Expression dot(const Expression& e, const Rates& rates) {
  const Rate result = rate(e, rates);
  return result ? *result : 0 * e;
}

}  // namespace treedyn::equations
