// How large a model may be before functions of it would take hours or gigabytes.
#pragma once

#include <vector>

#include "common/error.hpp"
#include "model/tree.hpp"

namespace treedyn {

/// \throws InputError that states the limit, if the model has too many joints, paths to the ground
/// that are too long in all (the operations of a mass matrix), or too many points on such paths.
void require_size(const model::Tree& tree, const std::vector<model::Point>& points,
                  const Location& where);

}  // namespace treedyn
