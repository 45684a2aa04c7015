// Derived values in frames: from sums along the tree and steps of links to expressions.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "derive/derive.hpp"
#include "equations/user.hpp"
#include "simplify/factor.hpp"
#include "simplify/functions.hpp"

namespace treedyn::simplify {

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

/// An equation of EQUATIONS.md for some points.
std::vector<Expr> values_at(const Task& task, const std::string& name,
                            const std::vector<model::Point>& points, Way way);

/// Operations of every value of the derivation, before any search.
std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options);

/// The row of a function table. \pre `function` outlives it.
Recipe derived_recipe(const std::shared_ptr<const Derived>& function);

}  // namespace treedyn::simplify
