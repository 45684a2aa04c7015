// Points of a scene in the coordinates in which its equations of motion are solved.
#pragma once

#include <map>
#include <vector>

#include "formulate/derived.hpp"
#include "formulate/functions.hpp"
#include "model/scene.hpp"

namespace treedyn::formulate {

/// An acceleration as a function of the accelerations x that are solved for: the sum of
/// columns[k] x_k plus gamma.
struct MotionMap {
  std::map<int, Vec3> columns;
  Vec3 gamma;
};

/// The coordinates x and the frame F in which points are described.
///
/// With the trunk of a free base as one body, x is that of a TrunkSystem and F the trunk's frame:
/// the columns of the trunk are a unit matrix and a lever. Otherwise x = qdd and F the base frame.
class SceneFrame {
 public:
  /// \param velocity_products  false: gamma is zero
  /// \pre by_trunk: every point is on the ground, the trunk or a limb, no joint is a mimic joint
  SceneFrame(const Task& task, bool by_trunk, bool velocity_products);

  [[nodiscard]] bool by_trunk() const { return by_trunk_; }
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
  void place_limbs();
  [[nodiscard]] Vec3 to_frame(int link, const Vec3& v) const;
  [[nodiscard]] MotionMap in_base(const model::Point& point, bool turning) const;
  void add(int joint, const Vec3& column, MotionMap& map) const;

  const Task& task_;
  const Kinematics& k_;
  bool by_trunk_;
  bool velocity_products_;
  std::vector<Mat3> rotation_;   ///< link -> trunk
  std::vector<Motion> motions_;  ///< of the links while the trunk does not accelerate
};

}  // namespace treedyn::formulate
