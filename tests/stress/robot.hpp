// Random robots with random constraints, over many decades.
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "support/random_tree.hpp"

namespace treedyn::stress {

using Values = std::vector<Real>;

struct Spring {
  int joint = 0;
  Real stiffness = 0;
  Real damping = 0;
  Real rest = 0;
};

/// A robot in one state; every number of the state is exact in float.
struct Robot {
  std::string name;
  model::Scene scene;           ///< one phase, in which all constraints act
  std::vector<Spring> springs;  ///< of the scene
  Values q, qd, tau;
};

/// \param decades  parameters lie within this many powers of ten of each other
Robot random_robot(const std::string& name, int decades, support::Dice& dice);

/// The robot with every parameter and input changed by at most `change` of itself, signs at random.
/// Equal rows stay equal.
Robot perturbed(const Robot& robot, const Real& change, support::Dice& dice);

/// What is left without one constraint, spring, or the last link and all that hangs on it.
std::vector<Robot> smaller(const Robot& robot);

/// A case of hard_cases/SCHEMA.md that expects the accelerations of 50 digits.
std::string case_text(const Robot& robot, const Values& qdd, const std::string& source,
                      const Real& tol_double, const Real& tol_float);

}  // namespace treedyn::stress
