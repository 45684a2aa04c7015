// What every effect of a scene costs.
#pragma once

#include <string>
#include <vector>

#include "pipeline.hpp"

namespace treedyn {

/// Operations of a function with and without an effect.
struct Price {
  std::string effect;
  std::string function;
  program::Cost with;
  program::Cost without;  ///< zero if the function is not there without the effect
};

/// The prices of the effects that the scene names: one row for every function whose operations
/// change, and one, without a change, for an effect that changes none. Formulates the scene once
/// for each effect.
std::vector<Price> effect_prices(const Model& model, const Request& request,
                                 const program::Programs& programs);

/// Operations that one closed contact adds to constrained_dynamics.
struct ContactPrice {
  std::string contact;
  program::Cost cost;
};
std::vector<ContactPrice> contact_prices(const program::Programs& programs);

}  // namespace treedyn
