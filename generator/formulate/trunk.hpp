// R13: the joints of a free base give way to the axes of its trunk's frame.
#pragma once

#include <utility>
#include <vector>

#include "formulate/blocks.hpp"
#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// Joints 0..5 move the trunk in every way: along the axes of its own frame its velocity is B qd,
/// its acceleration less that of free fall is x = B qdd + gamma - g, and B^T f = tau. The equations
/// hold for x and f in the tree that the trunk sees: Kinematics::from_trunk. Singular where B is.
class Trunk {
 public:
  /// \param way  kInBase: by its rotation matrix, which other vectors need too; kToRoot
  /// \pre has_trunk, every joint has its own coordinate
  explicit Trunk(const Task& task, Way way = Way::kToRoot);
  Trunk(const Trunk&) = delete;  // `seen` is of its own kinematics

  /// The task in the tree that the trunk sees.
  [[nodiscard]] const Task& seen() const { return seen_; }
  /// A vector of the base frame, and g, in the trunk's frame.
  [[nodiscard]] Vec3 direction(const Vec3& base) const {
    return triads_[0].frames.moved(base, kBase, kTrunkLink);
  }
  [[nodiscard]] Vec3 free_fall() const { return direction(-k_.ground_acceleration()); }

  /// The first six of joints' values become those along the axes, or the other way round.
  [[nodiscard]] std::vector<Expr> velocities(std::vector<Expr> qd) const;
  [[nodiscard]] std::vector<Expr> joint_velocities(std::vector<Expr> x) const;
  [[nodiscard]] std::vector<Expr> joint_accelerations(std::vector<Expr> x) const;
  [[nodiscard]] std::vector<Expr> forces(std::vector<Expr> tau) const;

 private:
  /// Three joints of a kind, and the frame where one unknown after the other can be eliminated.
  struct Triad {
    int first = 0;
    int frame = 0;
    FrameChanges frames;
    Mat3 axes;  ///< one a row
  };
  [[nodiscard]] Triad triad(int first, int frame, Way way) const;
  [[nodiscard]] Kinematics from_trunk() const;
  [[nodiscard]] std::vector<Expr> to_joints(std::vector<Expr> x,
                                            const std::array<Vec3, 2>& more) const;
  [[nodiscard]] Vec3 along_axes(const Triad& triad, const std::vector<Expr>& x) const;
  [[nodiscard]] Vec3 with_signs(const Triad& triad, Vec3 v) const;

  const Task& task_;
  const Kinematics& k_;
  std::array<Triad, 2> triads_;
  Kinematics kinematics_;
  Task seen_;
};

/// What forward dynamics adds for the trunk, each with the operations of all that it needs, before
/// any search.
/// \param impact  of changes of velocities, without forces
std::vector<std::pair<const char*, program::Cost>> trunk_lines(const model::Tree& tree,
                                                               const Options& options, bool impact);

}  // namespace treedyn::formulate
