// Derived values in frames: from sums along the tree and steps of links to expressions.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "derive/derive.hpp"
#include "equations/user.hpp"
#include "formulate/blocks.hpp"
#include "formulate/functions.hpp"
#include "formulate/joint_numbers.hpp"

namespace treedyn::formulate {

/// A function: its equation and what it derives to.
struct Derived {
  equations::UserEquation equation;
  derive::Derivation derivation;
  std::optional<derive::Derivation> to_root;  ///< the same by the rows of points, read backwards
  bool keeps_joints = false;  ///< the result refers to the places P_i of sliding joints
  bool regroups = false;      ///< inertial parameters may move to the father
  bool fixed_length = true;   ///< lengths occur whose unit is the metre
};

using DerivedFunctions = std::vector<std::shared_ptr<const Derived>>;

std::shared_ptr<const Derived> derived(const equations::UserEquation& equation, int links,
                                       int points);
/// The same of regrouped parameters (EQUATIONS.md 8) if its results do not feel them in this tree,
/// by 50 digits at random states; `function` else. Costs two formulations without search.
std::shared_ptr<const Derived> regrouped(const model::Tree& tree,
                                         const std::shared_ptr<const Derived>& function,
                                         const Options& options);

/// The expressions of the function, row-major.
/// \param frame  of vectors
std::vector<Expr> build_derived(const Task& task, const Derived& function, Way way,
                                int frame = kBase);

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

/// An equation of EQUATIONS.md for some points. \param frame  of vectors
std::vector<Expr> values_at(const Task& task, const std::string& name,
                            const std::vector<model::Point>& points, Way way, int frame = kBase);

/// A function of forces at points, which stand for its arguments f and n.
std::vector<Expr> build_loaded(const Task& task, const Derived& function, const PointLoads& loads,
                               Way way);

/// gamma_n of a point, by what its gamma_f is made of. \pre `point` moves
Vec3 angular_bias(const Task& task, const model::Point& point);

/// Operations of every value of the derivation in link frames, before any search; behind them those
/// of no value: angles, places and what joints that move together add up.
std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options);

/// The row of a function table. \pre `function` outlives it.
Recipe derived_recipe(const std::shared_ptr<const Derived>& function);

}  // namespace treedyn::formulate
