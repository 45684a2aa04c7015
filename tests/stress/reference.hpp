// What generated functions should give, by the block equations in 50 digits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "stress/robot.hpp"

namespace treedyn::stress {

/// Functions that are compared; the last is that of the scene.
inline const std::vector<std::string> kFunctions = {"mass_matrix",      "bias_force",
                                                    "gravity_force",    "inverse_dynamics",
                                                    "forward_dynamics", "constrained_dynamics"};

/// The first output of every function; of constrained_dynamics qdd.
using Results = std::map<std::string, Values>;
Results reference(const Robot& robot);

/// The smallest pivot of J A^-1 J^T with its diagonal scaled to one, those of dependent rows (which
/// are zero in 50 digits) left out; 1 without rows.
Real smallest_pivot(const Robot& robot);

/// For every value the sum of the sizes of what is added up on the way to it: roundings change it
/// by multiples of this. Forces by the recursion of Newton and Euler with norms in place of
/// vectors; accelerations by these forces and |A^-1|; with rows, also by the reactions, over the
/// smallest pivot.
Results sizes(const Robot& robot, const Results& truth);

/// True if rows that depend on others repeat them: no other row asks for what cannot be.
bool is_consistent(const Robot& robot);

}  // namespace treedyn::stress
