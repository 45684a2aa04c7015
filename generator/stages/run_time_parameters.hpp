// What depends on numbers that are known at run time only.
#pragma once

#include "program/programs.hpp"
#include "request/read_model.hpp"

namespace treedyn {

/// What depends on such numbers only becomes a function of its own, and an argument of the others.
/// Nothing happens without such numbers.
/// \throws InputError for a function of a user that has a name which the result needs
void separate_parameters(const Model& model, const Request& request, program::Programs& programs);

/// \throws InputError for a parameter of the scene that none of all its functions depends on
void require_use_of_parameters(const Model& model, const Request& request,
                               const program::Programs& programs);

}  // namespace treedyn
