// Derived values in frames: from sums along the tree and steps of links to expressions.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "derive/derive.hpp"
#include "equations/user.hpp"
#include "formulate/functions.hpp"
#include "formulate/numbers.hpp"

namespace treedyn::formulate {

/// A function: its equation and what it derives to.
struct Derived {
  equations::UserEquation equation;
  derive::Derivation derivation;
  std::optional<derive::Derivation> to_root;  ///< the same by the rows of points, read backwards
  bool keeps_joints;      ///< the result refers to the places P_i of sliding joints
  bool regroups = false;  ///< of inertial parameters masses and first moments alone occur
};

using DerivedFunctions = std::vector<std::shared_ptr<const Derived>>;

std::shared_ptr<const Derived> derived(const equations::UserEquation& equation, int links,
                                       int points, bool keeps_joints = true);

/// The expressions of the function, row-major.
std::vector<Expr> build_derived(const Task& task, const Derived& function, Way way);

/// An equation of EQUATIONS.md. \pre `name` stands in equations/table.cpp.
std::shared_ptr<const Derived> derived(const std::string& name);
/// A sum of them.
std::shared_ptr<const Derived> derived_part(const std::string& name,
                                            const block::Expression& expression);

/// What a linear system, a column that is zero for the unknown numbers of links, derives to by R9.
/// \throws std::domain_error if it does not act
Derived solved(const Derived& system, const std::string& unknown);

/// The same of an equation of EQUATIONS.md, in the frames of the task's variant.
std::vector<Expr> build_equation(const Task& task, const std::string& name);

/// The columns of A for the joints of the limbs and the composite body of the trunk of a free base.
struct Trunk {
  /// Force and moment that a unit acceleration of a joint needs, at the trunk's origin, in its
  /// frame.
  struct Column {
    int joint = 0;
    Vec3 force;
    Vec3 moment;
  };
  SparseSymmetric limbs;        ///< A between joints of the limbs
  std::vector<Column> columns;  ///< joints of the limbs, descending
  Expr mass;                    ///< of everything that moves
  Vec3 moment;                  ///< its first moment about the trunk's origin
  Mat3 inertia;                 ///< its inertia tensor there
};
/// \pre the base is free and the variant takes the trunk as one body
Trunk trunk_of_mass_matrix(const Task& task);

/// Drive force of joint i along +z of its normal frame.
using JointForce = std::function<Expr(int)>;

/// qdd of the links' joints by R9. \param system  "forward_dynamics", or another that is solved
std::vector<Expr> articulated_forward_dynamics(const Task& task, const Derived& system,
                                               const JointForce& force);

/// The 6x6 inertia [mass coupling^T; coupling tensor] with which the trunk of a free base resists,
/// its limbs free to move, and its bias wrench, in its frame.
struct ArticulatedTrunk {
  Mat3 tensor;
  Mat3 coupling;
  Mat3 mass;
  Wrench bias;
};
/// The trunk's acceleration, angular and linear.
using TrunkSolution = std::function<std::array<Vec3, 2>(const ArticulatedTrunk&)>;
/// qdd of the limbs' joints of a free base, the base joints' zero. \param omega as for trunk_bias
std::vector<Expr> limb_accelerations(const Task& task, const Vec3& omega, const JointForce& force,
                                     const TrunkSolution& solve);

/// How a link moves, in its frame.
struct Motion {
  Vec3 alpha;  ///< angular acceleration
  Vec3 a;      ///< acceleration of the origin
  Mat3 Omega;  ///< Lambda(alpha) + Lambda(omega)^2
};

/// What the limbs and the trunk of a free base need when nothing accelerates: the velocity products
/// alone.
struct TrunkBias {
  std::vector<Expr> tau;  ///< joints of the limbs; the base joints' entries are zero
  Wrench trunk;           ///< on the trunk, at its origin, in its frame
};
/// From (3). \param omega angular velocity of the trunk in its frame
TrunkBias trunk_bias(const Task& task, const Vec3& omega);
/// Motions of the trunk and of the limbs of a free base in the same state; those before are empty.
std::vector<Motion> limb_motions(const Task& task, const Vec3& omega);

/// An equation of EQUATIONS.md for some points.
std::vector<Expr> values_at(const Task& task, const std::string& name,
                            const std::vector<model::Point>& points, Way way);

/// Operations of every value of the derivation, before any search.
std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options);

/// The row of a function table. \pre `function` outlives it.
Recipe derived_recipe(const std::shared_ptr<const Derived>& function);

}  // namespace treedyn::formulate
