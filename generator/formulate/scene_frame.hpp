// Points of a scene in the coordinates in which its equations of motion are solved.
#pragma once

#include <map>

#include "formulate/derived.hpp"
#include "formulate/trunk.hpp"
#include "model/scene.hpp"

namespace treedyn::formulate {

/// An acceleration as a function of the accelerations x that are solved for: the sum of
/// columns[k] x_k plus gamma.
struct MotionMap {
  std::map<int, Vec3> columns;
  Vec3 gamma;
};

/// The coordinates x and the frame F in which points are described: those of a Trunk and its frame,
/// or qdd and the base frame.
class SceneFrame {
 public:
  /// \param velocity_products  false: gamma is zero
  /// \param trunk  null: none; no point is on a link above it
  SceneFrame(const Task& task, bool velocity_products, const Trunk* trunk = nullptr);

  /// Number of the coordinates.
  [[nodiscard]] int dof() const { return task_.tree.dof(); }
  /// Acceleration of a point, in F; in the trunk's frame that against free fall.
  [[nodiscard]] MotionMap point(const model::Point& point) const;
  /// Angular acceleration of the link of a point, in F.
  [[nodiscard]] MotionMap turning(const model::Point& point) const;
  /// A vector of the base frame in F.
  [[nodiscard]] Vec3 direction(const model::Vector3& base) const;
  [[nodiscard]] Vec3 direction(const Vec3& base) const;
  /// What `point` leaves out: g in F, or zero.
  [[nodiscard]] Vec3 free_fall() const;

 private:
  [[nodiscard]] MotionMap motion(const model::Point& point, bool turning) const;

  const Task& task_;
  bool velocity_products_;
  const Trunk* trunk_;
};

}  // namespace treedyn::formulate
