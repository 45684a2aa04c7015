// Numbers of a robot as the choice of a formulation sees them.
#pragma once

#include <memory>

#include "formulate/formulate.hpp"
#include "model/scene.hpp"

namespace treedyn::formulate {

/// A robot and options whose numbers are seen as stand-ins (common/real.hpp).
struct Seen {
  model::Tree tree;
  Options options;
  std::shared_ptr<const model::Scene> scene = nullptr;  ///< that of the options
};

/// Every mass, length, angle, inertia and gravity is seen as a number that only its place in the
/// tree decides (link, quantity, component): robots of one structure get one formulation. Zero, one
/// and minus one and multiples of 15 degrees are seen as they are; numbers of one quantity that are
/// equal or opposite stay so in one link and in links that are alike (`similar_links`), angles and
/// distances of joints in the whole robot; rotations keep their zeros, ones and equal entries. Of
/// an offset between two axes that meet, or lie across or along parallel ones, that stays so
/// instead of its components. Signs decide nothing: of equal and opposite numbers the first is seen
/// as a positive one. Of lengths below a micrometre and angles below a milliradian the order of
/// magnitude is seen; rotations that no three angles describe are seen as they are. Numbers that
/// are known at run time only have recipes (`Tree::parameters`). Numbers of a scene are seen in the
/// same way; its exponents, step and times stay, and of numbers of one meaning (scene_numbers.hpp)
/// equal ones stay equal in the whole scene. O(N).
Seen with_stand_ins(const model::Tree& tree, const Options& options);

/// Only what is known at run time is seen as other numbers.
Seen with_parameters(const model::Tree& tree, const Options& options);

/// Of numbers that are seen as others only what is seen: enough to compare costs, at half the
/// price. O(N)
Seen stand_ins_alone(const model::Tree& tree, const Options& options);
/// Of them the numbers themselves; what is known at run time only stays so. O(N)
Seen numbers_alone(const model::Tree& tree, const Options& options);

/// Run-time parameter `index` of a scene's tree, which looks like no other number.
Real run_time_number(int index, const Real& nominal);
/// The scene whose parameters have these values; all its numbers are fixed. O(numbers)
model::Scene with_values(const model::Scene& scene, const std::vector<Real>& parameters);

}  // namespace treedyn::formulate
