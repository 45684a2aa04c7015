// What follows from the words of a scene alone, for whoever formulates, proves or writes it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/step_method.hpp"
#include "model/scene.hpp"

namespace treedyn::model {

/// The scene's integrator if there is code for a step of it.
std::optional<StepMethod> step_method(const Scene& scene);
/// Names of the integrators for which there is.
std::vector<std::string> step_method_names();

/// True if Baumgarte's correction, the one that is part of the equations, acts on a constraint:
/// where the scene asks for it, and, unless it asks for none, on closed loops that a step goes
/// round.
bool is_stabilised(const Scene& scene, int constraint);
/// True if it acts in every phase and no event moves its place: one that is let go, such as a foot,
/// begins to act again where it lands.
bool stays(const Scene& scene, int constraint);
/// True if an event pins it, or begins a phase in which it acts behind one in which it does not:
/// then not the initial state alone decides where its rows hold.
bool is_placed_by_events(const Scene& scene, int constraint);
/// True if it is drawn to where the initial state of the scene has it, Constraint::loop.
bool has_place(const Scene& scene, int constraint);
/// Its alpha, 1/s: that of the scene; of loops never more than half of what a step resolves.
Real stabilisation_rate(const Scene& scene);

/// Values that say where a constraint began to act: the position of its point (3, base frame, m;
/// less that of a curve), the rotation of the point's link (9, row-major) or the position of its
/// joint (1); 0 if its rows know, or need not know, where they are.
int anchor_size(const Scene& scene, int constraint);
/// Where they stand in the array of all constraints; of the number of constraints, its size.
int anchor_offset(const Scene& scene, int constraint);
/// True if one of the constraints has an anchor.
bool has_anchor(const Scene& scene, const std::vector<int>& constraints);

/// True if the rows of a constraint are about angles, and its reactions are moments.
bool is_angular(const Tree& tree, const Constraint& constraint);

/// The first of `rows` that holds the point of a touch-down along the normal of its plane, -1:
/// none.
int floor_of(const Scene& scene, const Event& event, const std::vector<int>& rows);

/// True if its rows move: along a curve, or by accelerations.
bool is_led(const Constraint& constraint);

/// Constraints of an impact that do not act behind it, ascending: what a rebound comes to rest on.
/// \pre event.impact
std::vector<int> struck(const Scene& scene, const Event& event);

/// True if the impact of a touch-down, or what begins to act behind it, stops its point.
/// \param before, behind  what acts, ascending
bool stops_point(const Scene& scene, const Event& event, const std::vector<int>& before,
                 const std::vector<int>& behind);

/// The value of a variable at a point of the scene.
using AtPoint = std::function<double(int point, const Variable& variable)>;
/// "drive of joint 'elbow'": what acts and has no value at a state; empty if there is none.
/// \param state  q and behind it qd
/// \param at_point  position and velocity there; none: laws that ask for them are left out
std::string without_value(const Scene& scene, double time, const std::vector<double>& state,
                          const AtPoint& at_point = nullptr);

/// Joints without a drive: all that the scene does not call actuated; where it names drives, all
/// joints but theirs; else the six joints of a free base.
std::vector<int> passive_joints(const Scene& scene);

/// True for a touch-down whose impact would strike constraints that act already: it does not
/// happen. \param active  ascending
bool strikes_what_acts(const Event& event, const std::vector<int>& active);

}  // namespace treedyn::model
