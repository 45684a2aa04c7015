// What it costs that numbers are known at run time only.
#pragma once

#include <string>
#include <vector>

#include "pipeline.hpp"

namespace treedyn {

/// Operations of a function with a declaration and without it.
struct ParameterPrice {
  std::string declared;  ///< "forearm.com"
  std::string function;
  program::Cost with;
  program::Cost without;
};

/// One row for every function whose operations change, and one, without a change, for a declaration
/// that changes none. Formulates the model once for each declaration.
/// \param programs  of the model, separated
std::vector<ParameterPrice> parameter_prices(const Model& model, const Request& request,
                                             const program::Programs& programs);

}  // namespace treedyn
