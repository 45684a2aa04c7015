// How large a model may be before functions of it would take hours or gigabytes.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"
#include "model/tree.hpp"

namespace treedyn {

/// \throws InputError that states the limit, if the model has too many joints, paths to the ground
/// that are too long in all (the operations of a mass matrix), or too many points on such paths.
void require_size(const model::Tree& tree, const std::vector<model::Point>& points,
                  const Location& where);

/// Numbers of the model are too many decades apart for `what`.
/// \throws InputError naming the mass, length, inertia or multiplier that is farthest from 1
[[noreturn]] void refuse_decades(const model::Tree& tree, const std::string& what);

}  // namespace treedyn
