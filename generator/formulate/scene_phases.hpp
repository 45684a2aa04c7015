// The phases between which a generated step changes, rest included.
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"

namespace treedyn::formulate {

/// A phase with the constraints that act: as the scene has it, or one in which a slow rebound has
/// come to rest.
struct PhaseState {
  int phase = 0;
  std::vector<int> active;                     ///< ascending
  std::string ending;                          ///< of names of functions: "", "_left", "_at_rest"
  std::string identifier;                      ///< left, left_at_rest
  std::vector<model::JointForce> forces = {};  ///< of its own
  std::vector<model::Event> lift_offs = {};    ///< beside the events of the phase
};

/// The phases of the scene, and behind them those at rest that a step may reach; where joints stick
/// one for each of their ways, in the order of those of the scene.
std::vector<PhaseState> phase_states(const model::Scene& scene, bool at_rest);

/// A touch-down whose impact would strike constraints that act already does not happen, nor does
/// what waits for the reaction of one that does not act.
bool is_watched(const model::Event& event, const std::vector<int>& active);
/// True if there is an impact; true if it gives speed back; true if it may come to rest as well;
/// true if that is not said of it, but a step takes small rebounds of a point that loses speed
/// back: then the point lifts off where the floor would pull.
bool strikes(const model::Event& event);
bool rebounds(const model::Event& event);
bool may_rest(const model::Scene& scene, const model::Event& event);
bool rests_unasked(const model::Scene& scene, const model::Event& event);
/// The constraints that act behind an event of a state.
std::vector<int> active_behind(const model::Scene& scene, const PhaseState& state,
                               const model::Event& event, bool at_rest);
/// The events of the phase, and lift-offs of what came to rest.
std::vector<model::Event> events_of(const model::Scene& scene, const PhaseState& state);
/// The number of a state; -1 if there is none.
int find_state(const std::vector<PhaseState>& states, int phase, const std::vector<int>& active);

}  // namespace treedyn::formulate
