// What the effects of a scene cost, and that numbers are known at run time only.
#pragma once

#include <string>
#include <vector>

#include "pipeline.hpp"

namespace treedyn {

/// Operations of a function with and without something.
struct Price {
  std::string of;  ///< an effect, or a declaration, "forearm.com"
  std::string function;
  program::Cost with;
  program::Cost without;  ///< zero if the function is not there without it
};

/// The prices of the effects that the scene names: one row for every function whose operations
/// change, and one, without a change, for an effect that changes none. Formulates the scene once
/// for each effect.
std::vector<Price> effect_prices(const Model& model, const Request& request,
                                 const program::Programs& programs);

/// The same of declarations of run-time parameters; formulates the model once for each of them.
/// \param programs  of the model, separated
std::vector<Price> parameter_prices(const Model& model, const Request& request,
                                    const program::Programs& programs);

/// Operations that one closed contact adds to constrained_dynamics.
struct ContactPrice {
  std::string contact;
  program::Cost cost;
};
std::vector<ContactPrice> contact_prices(const program::Programs& programs);

}  // namespace treedyn
