// R11: time derivatives of block expressions along qd.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "block/block.hpp"

namespace treedyn::equations {

/// A leaf whose rate nobody knows: f_b, tau, an input of a user.
class NoRate : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is not known of leaves beyond equations/symbols.hpp: nothing for a constant.
using Rates = std::map<std::string, std::optional<block::Expression>>;

/// dX/dt by the product rule and the rates of the leaves: D, σ, m are constant; z and s turn with
/// the father and s takes the father's slide; l, t, c and J turn with their links, slides add their
/// speed; the rate of q̇ is q̈. Of a single number y^T M y with M = M^T it is 2 y^T M dot(y) + y^T
/// dot(M) y.
/// \param rates  of leaves that equations/symbols.hpp does not know, by name
/// \throws NoRate
block::Expression dot(const block::Expression& e, const Rates& rates = {});

/// dX/dt where P_i of a sliding joint may be anywhere on its axis (F1): l = 0, s has the own slide.
/// \param e  with what `dot` has made of s, l and t
block::Expression with_free_places(const block::Expression& e);

/// The rates of the leaves of e that are not constant. \throws NoRate
std::map<std::string, block::Expression> leaf_rates(const block::Expression& e, const Rates& rates);

}  // namespace treedyn::equations
