// The forces of a scene as expressions: drives, springs, friction and loads; EQUATIONS.md (8), 6.5.
#pragma once

#include <memory>
#include <vector>

#include "formulate/functions.hpp"
#include "formulate/scene_values.hpp"

namespace treedyn::formulate {

/// Numbers of the input arrays of a scene function; -1: not there.
struct SceneArrays {
  int q = 0;
  int qd = 1;
  int tau = 2;
  int mu = -1;  ///< multipliers of the rows
  int t = -1;
  int anchor = -1;  ///< where constraints began to act
};

/// What acts on a scene's tree besides gravity, velocity products and reactions.
class SceneForces {
 public:
  SceneForces(const Task& task, const SceneArrays& arrays);

  /// Force of a joint: the argument tau and what the scene adds.
  [[nodiscard]] Expr joint(int joint) const;
  [[nodiscard]] PointLoads loads() const;
  /// Variables of expressions that belong to no point.
  [[nodiscard]] const Meaning& meaning() const { return meaning_; }
  /// Position and velocity of a point, base frame.
  [[nodiscard]] Vec3 position(int point) const;
  [[nodiscard]] Vec3 velocity(int point) const;
  /// Angular velocity of the link of a point, base frame.
  [[nodiscard]] Vec3 angular_velocity(int point) const;

 private:
  [[nodiscard]] Expr input(int array, int element) const;
  [[nodiscard]] Vec3 load(const model::PointLaw& law) const;

  const Task& task_;
  const model::Scene& scene_;
  SceneArrays arrays_;
  Meaning meaning_;
  std::unique_ptr<Kinematics> moving_;  ///< with qd, where the task's velocity products are off
};

/// True if a component depends on time.
bool depends_on_time(const model::VectorExpression& v);
/// True if some force of the scene, or a row of these constraints, depends on time.
bool uses_time(const model::Scene& scene, const std::vector<int>& active);

}  // namespace treedyn::formulate
