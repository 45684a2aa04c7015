// Numbers of a tree that are known at run time only.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::model {

/// Components of vectors and of symmetric tensors.
inline constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
inline constexpr std::array<const char*, 6> kEntries = {"xx", "xy", "xz", "yy", "yz", "zz"};

/// A kind of parameters, by the name with which it is declared, and one of its components or all.
struct Declared {
  ParameterKind quantity = ParameterKind::kMass;
  std::optional<int> component;
};

/// Of "mass", "com", "inertia", "offset", "at", "gravity", with ".x" or ".xx" behind it of one
/// component. Nothing for other words.
std::optional<Declared> find_quantity(std::string_view name);

/// The parameters that a declaration stands for: 1, 3 or 6, in the order of their components.
/// \param link  as in Parameter
std::vector<Parameter> parameters_of(const Tree& tree, int link, const Declared& declared);

/// "kg", "m", "kg m^2", "m/s^2"; "" of a scene, whose parameters have any
const char* unit(const Parameter& parameter);
/// "mass of link forearm": what it is, with the name of the link as the file writes it.
std::string meaning(const Tree& tree, const Parameter& parameter);
/// The moving link it belongs to, as the file writes it; "" of gravity and of points on the ground.
std::string link_name(const Tree& tree, const Parameter& parameter);

/// The number that the tree or gravity (m/s^2, base frame) has.
Real nominal(const Tree& tree, const Vector3& gravity, const Parameter& parameter);
/// Sets it, in a tensor both entries. A parameter of a scene stands in no tree: nothing happens.
void set(Tree& tree, Vector3& gravity, const Parameter& parameter, const Real& value);

/// Those of `points` that are points of the tree with parameters: their numbers here and there.
std::vector<std::pair<std::size_t, std::size_t>> points_with_parameters(
    const Tree& tree, const std::vector<Point>& points);

/// True if no parameter is the model's own.
bool of_scene_alone(const Tree& tree);
/// True if a parameter is a length: then it enters positions, and functions without mass.
bool has_lengths(const Tree& tree);

}  // namespace treedyn::model
