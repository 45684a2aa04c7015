// Numbers of a tree that are known at run time only.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::model {

/// What may be declared of a link: "mass", "com", "inertia".
const std::array<const char*, 3>& quantity_names();

/// The parameters that a declaration stands for: 1, 3 or 6, in the order of their components.
/// \param link  kGround for gravity
std::vector<Parameter> parameters_of(const Tree& tree, int link, ParameterKind quantity);

/// "kg", "m", "kg m^2", "m/s^2"
const char* unit(const Parameter& parameter);
/// "mass of link forearm": what it is, with the name of the link as the file writes it.
std::string meaning(const Tree& tree, const Parameter& parameter);

/// The number that the tree or gravity (m/s^2, base frame) has.
Real nominal(const Tree& tree, const Vector3& gravity, const Parameter& parameter);
/// Sets it, in a tensor both entries.
void set(Tree& tree, Vector3& gravity, const Parameter& parameter, const Real& value);

}  // namespace treedyn::model
