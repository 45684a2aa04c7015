// The blocks of a derived column: numbers, vectors and tensors in frames.
#pragma once

#include <vector>

#include "common/index.hpp"
#include "formulate/link_kinematics.hpp"

namespace treedyn::formulate {

/// The base frame, where a link's frame is expected.
inline constexpr int kBase = model::kGround;

/// A vector as a sum of parts in different frames; none: zero.
struct Part {
  int frame = kBase;
  Vec3 value;
};
using Parts = std::vector<Part>;

struct Tensor {
  int frame = kBase;
  Mat3 value;
  bool symmetric = false;  ///< known to be
};

/// One of the three.
struct Block {
  Expr number;
  Parts vector;
  Tensor tensor;
};
using Blocks = std::vector<Block>;  ///< for every link or point

bool is_zero(const Vec3& v);
inline Mat3 transposed(const Mat3& m) { return {column(m, 0), column(m, 1), column(m, 2)}; }

/// Carries vectors and tensors between frames.
class FrameChanges {
 public:
  FrameChanges(const Kinematics& kinematics, Way way);

  [[nodiscard]] bool in_base() const { return way_ == Way::kInBase; }
  [[nodiscard]] Vec3 moved(const Vec3& v, int from, int to) const;
  [[nodiscard]] Tensor moved(const Tensor& t, int to) const;
  /// The sum of the parts in one frame.
  [[nodiscard]] Vec3 in(const Parts& parts, int frame) const;
  /// a + factor * b, part by part.
  void add(Parts& a, const Parts& b, Expr factor) const;

 private:
  [[nodiscard]] bool is_above(int i, int of) const;
  /// The part that stands deepest goes to the father, where it meets others, until all are above
  /// `frame`.
  [[nodiscard]] Parts risen(Parts parts, int frame) const;
  [[nodiscard]] int depth(int i) const { return i == kBase ? 0 : depth_[to_index(i)]; }

  const Kinematics& kinematics_;
  Way way_;
  std::vector<int> depth_;
  std::vector<Mat3> rotation_;  ///< link frame -> base frame, unless kToRoot
};

/// Rotations of points, link frame -> base frame, row-major, 9 P.
std::vector<Expr> point_rotations(const Kinematics& kinematics,
                                  const std::vector<model::Point>& points);

}  // namespace treedyn::formulate
