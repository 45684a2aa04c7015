// Expression frames: the frames in which the recursions of EQUATIONS.md 7 are written down.
#pragma once

#include <map>
#include <vector>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/frames.hpp"
#include "formulate/rotation.hpp"
#include "formulate/spatial.hpp"
#include "program/limbs.hpp"

namespace treedyn::formulate {

/// Where the inputs of a function stand: the array numbers of q, qd, qdd, tau; -1: not an input
/// (zero).
struct Inputs {
  int q = 0;
  int qd = -1;
  int qdd = -1;
  int tau = -1;
};

/// Forces at points and moments on their links, base frame; one each for every point.
struct PointLoads {
  std::vector<model::Point> points;
  std::vector<Vec3> f;
  std::vector<Vec3> n;
};

/// Limbs that share code while a formulation is written, and the table of their constants.
struct SharedLimbs {
  std::vector<LimbLinks> links;  ///< by class
  program::Limbs table;

  /// By link: class, limb and place in the limb; class -1: no limb.
  struct Place {
    int limb_class = -1;
    int limb = 0;
    int position = 0;
  };
  std::vector<Place> places;
};
/// \pre `normal` is the normal form with these limbs.
SharedLimbs shared_limbs(const model::Tree& tree, const NormalTree& normal,
                         const std::vector<LimbLinks>& links);

/// The kinematics of a tree in expression frames.
///
/// A run of parallel axes shares one frame, which carries the sum of the angles up to the run's
/// `cut`; so the rotation between a link and its father is at most one compound rotation, and none
/// inside a run.
class Kinematics {
 public:
  /// \param limbs  their joint values and what differs in their constants become leaves; null: none
  Kinematics(Graph& graph, const model::Tree& tree, const NormalTree& normal,
             const Variant& variant, const Inputs& inputs, SharedLimbs* limbs = nullptr);

  /// R13: the same tree as its trunk sees it. Joints 0..5 slide along and turn about the axes of
  /// the trunk's frame, from where they are, in free fall, on a ground that turns like the trunk.
  /// \param omega  of the trunk, in its frame
  [[nodiscard]] Kinematics from_trunk(const Vec3& omega) const;
  [[nodiscard]] bool is_from_trunk() const { return is_from_trunk_; }
  /// The same with these forces of joints, by coordinate, for the argument.
  [[nodiscard]] Kinematics with_forces(const std::vector<Expr>& forces) const;
  /// The same with forces at points, for the arguments f and n. \pre `loads` outlives the result
  [[nodiscard]] Kinematics with_loads(const PointLoads& loads) const;
  /// Null: they are arguments.
  [[nodiscard]] const PointLoads* loads() const { return loads_; }

  [[nodiscard]] int size() const { return static_cast<int>(normal_.links.size()); }
  [[nodiscard]] const NormalLink& link(int i) const { return normal_.links[to_index(i)]; }
  [[nodiscard]] const LinkVariant& choice(int i) const { return variant_.links[to_index(i)]; }
  [[nodiscard]] const Variant& variant() const { return variant_; }
  [[nodiscard]] Graph& graph() const { return graph_; }
  [[nodiscard]] SharedLimbs* limbs() const { return limbs_; }

  /// Element k of an argument of the function that has one element a coordinate.
  [[nodiscard]] Expr argument(int array, int k) const;
  [[nodiscard]] const Inputs& inputs() const { return inputs_; }
  /// The value of the joint of link i from an array with one element a coordinate; zero where not
  /// an input.
  [[nodiscard]] Expr of_joint(int i, int array) const;
  /// The value of coordinate k as an element of a result, from that of the joint of its link.
  [[nodiscard]] Expr result(int k, Expr of_joint) const;

  /// The joint's speed along +z of the normal frame; zero where not an input.
  [[nodiscard]] Expr speed(int i) const {
    const Expr x = of_joint(i, inputs_.qd);
    return link(i).sign > 0 ? x : -x;
  }

  /// The slide of a prismatic joint along +z of its normal frame.
  [[nodiscard]] Expr displacement(int i) const;

  /// -g in the base frame: the acceleration of a ground that replaces gravity.
  [[nodiscard]] Vec3 ground_acceleration() const;
  /// Angular velocity of the ground, there.
  [[nodiscard]] const Vec3& ground_turning() const { return ground_turning_; }

  /// s'_i (convention B of EQUATIONS.md 1.1) in the father's expression frame, with the slide.
  [[nodiscard]] const Vec3& offset(int i) const { return offset_[to_index(i)]; }
  /// The same without the slide.
  [[nodiscard]] const Vec3& joint_offset(int i) const { return joint_offset_[to_index(i)]; }
  /// True if link i shares the expression frame of its father.
  [[nodiscard]] bool shares_frame(int i) const {
    return head_[to_index(i)] != i && head_[to_index(i)] >= 0;
  }

  [[nodiscard]] Vec3 to_father(int i, const Vec3& v) const;
  [[nodiscard]] Vec3 from_father(int i, Vec3 v) const;
  [[nodiscard]] Mat3 to_father_symmetric(int i, const Mat3& s) const;
  [[nodiscard]] Mat3 to_father_general(int i, const Mat3& h) const;
  /// The joint axis in the father's expression frame.
  [[nodiscard]] Vec3 axis_in_father(int i) const;

  /// What a link is to the equations of motion, about the origin of its expression frame.
  struct Body {
    Expr mass;
    Vec3 moment;  ///< first
    Mat3 tensor;  ///< second moments Ψ, or inertia tensor tr(Ψ) E_3 - Ψ
  };
  /// Of link i alone, with its second moments.
  [[nodiscard]] const Body& body(int i) const;
  /// The same with its inertia tensor.
  [[nodiscard]] const Body& body_with_inertia_tensor(int i) const;
  /// A point or direction given in the model's frame of link i, in the link's expression frame.
  [[nodiscard]] Vec3 point(int i, const Vector3& at) const;
  /// A symmetric tensor given in the model's frame of link i, in the link's expression frame.
  [[nodiscard]] Mat3 tensor_of(int i, const Matrix3& of_model) const;
  [[nodiscard]] Mat3 orientation(int i) const;  ///< model frame of link i -> expression frame

 private:
  void find_runs();
  void place_frames();
  void place_link(int i);
  /// Links written so far.
  using Bodies = std::map<int, Body>;
  const Body& written(int i, Bodies& bodies, Matrix3 (*tensor)(const NormalLink&)) const;
  /// Vectors and symmetric tensors of the normal frame of link i in its expression frame.
  [[nodiscard]] Vec3 in_frame(int i, const Vec3& v) const;
  [[nodiscard]] Mat3 in_frame_symmetric(int i, const Mat3& m) const;
  [[nodiscard]] std::vector<PlaneRotation> turn_of_frame(int i) const;
  [[nodiscard]] Angle joint_angle(int i) const;
  /// The number of link i, given those of its peers: a leaf where they are not all the same.
  [[nodiscard]] Expr own(int i, const std::vector<Real>& values) const;
  [[nodiscard]] Vec3 own_vector(int i, Vector3 NormalLink::*vector) const;
  [[nodiscard]] Mat3 own_matrix(int i, Matrix3 (*matrix)(const NormalLink&)) const;
  /// Link i and the links at its place in the other limbs; i alone if it belongs to no limb.
  [[nodiscard]] std::vector<int> peers(int i) const;
  template <class Of>
  [[nodiscard]] auto of_peers(int i, Of of) const;
  [[nodiscard]] bool is_parallel(int i) const;
  [[nodiscard]] bool is_of_limb(int i) const {
    return limbs_ != nullptr && limbs_->places[to_index(i)].limb_class >= 0;
  }
  [[nodiscard]] Real multiplier(int i) const {
    return is_of_limb(i) ? Real(1) : tree_.drives[to_index(i)].multiplier;
  }
  [[nodiscard]] Angle father_angle(int i) const;
  [[nodiscard]] Angle first_angle(int i) const;
  [[nodiscard]] Angle last_angle(int i) const;
  [[nodiscard]] Expr coordinate(int array, int k) const;
  /// Appends the rotation about `axis` by `angle` of link i unless it is the identity.
  template <class AngleOf>
  void append(std::vector<PlaneRotation>& steps, std::size_t axis, int i, AngleOf angle) const;
  /// \param angles  of link i and its peers
  [[nodiscard]] CosineAndSine cosine_and_sine(int i, const std::vector<Angle>& angles) const;
  [[nodiscard]] CosineAndSine of_turn(int i, const std::vector<Angle>& angles) const;
  /// sum of coefficient * u[coordinate] + turn, the sum formed before the sine
  [[nodiscard]] CosineAndSine of_sum(int i, const std::vector<Angle>& angles) const;
  /// The same by addition theorems: four more operations for an angle, no rounded sum.
  [[nodiscard]] CosineAndSine of_products(int i, const std::vector<Angle>& angles) const;
  [[nodiscard]] const Angle& own(int i, const std::vector<Angle>& angles) const;
  template <class Number>
  [[nodiscard]] Expr number_of(int i, const std::vector<Angle>& angles, Number number) const;

  Graph& graph_;
  const model::Tree& tree_;
  const NormalTree& normal_;
  const Variant& variant_;
  Inputs inputs_;
  SharedLimbs* limbs_;
  std::vector<int> head_;  ///< first link of the run of parallel axes; -1 for prismatic joints
  std::vector<std::vector<int>> run_;  ///< members of the run, at its head
  std::vector<Angle> frame_angle_;  ///< expression frame -> normal frame: turn of the link about z
  std::vector<Angle> run_angle_;    ///< the turn that the frame of a run carries, at its head
  std::vector<Vec3> offset_;
  std::vector<Vec3> joint_offset_;
  mutable Bodies bodies_;
  mutable Bodies bodies_with_inertia_tensor_;
  /// Between a link and its father, outermost first; none inside a run of parallel axes.
  std::vector<std::vector<PlaneRotation>> rotations_;
  bool is_from_trunk_ = false;
  Vec3 ground_turning_;
  std::vector<Expr> forces_;
  const PointLoads* loads_ = nullptr;
};

template <class Of>
auto Kinematics::of_peers(int i, Of of) const {
  return transformed(peers(i), of);
}

}  // namespace treedyn::formulate
