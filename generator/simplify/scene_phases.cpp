#include "simplify/scene_phases.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "simplify/scene_names.hpp"

namespace treedyn::simplify {

using model::Event;
using model::EventKind;
using model::Scene;

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool includes(const std::vector<int>& all, const std::vector<int>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

PhaseState resting(const Scene& scene, const std::vector<PhaseState>& states, int phase,
                   std::vector<int> active) {
  const PhaseState& plain = states[index(phase)];
  const auto named = [&](int number) {
    const std::string more = number > 1 ? fmt::format("_at_rest_{}", number) : "_at_rest";
    return PhaseState{phase, active, plain.ending + more,
                      to_identifier(scene.phases[index(phase)].name + more)};
  };
  const auto is_taken = [&](const PhaseState& state) {
    return std::any_of(states.begin(), states.end(), [&](const PhaseState& other) {
      return other.identifier == state.identifier || other.ending == state.ending;
    });
  };
  int number = 1;
  while (is_taken(named(number))) {
    ++number;
  }
  return named(number);
}

}  // namespace

bool is_watched(const Event& event, const std::vector<int>& active) {
  const bool rests = event.impact && !event.impact->constraints.empty() &&
                     includes(active, event.impact->constraints);
  const bool reacts = event.kind != EventKind::kReaction ||
                      std::find(active.begin(), active.end(), event.constraint) != active.end();
  return !rests && reacts;
}

bool rebounds(const Event& event) {
  return event.impact && !event.impact->constraints.empty() && event.impact->restitution > 0;
}

bool may_rest(const Event& event) { return rebounds(event) && event.impact->rest_below > 0; }

std::vector<int> active_behind(const Scene& scene, const Event& event, bool at_rest) {
  std::vector<int> active = scene.phases[index(event.then)].active;
  if (at_rest) {
    const std::vector<int> before = active;
    active.clear();
    std::set_union(before.begin(), before.end(), event.impact->constraints.begin(),
                   event.impact->constraints.end(), std::back_inserter(active));
  }
  return active;
}

int find_state(const std::vector<PhaseState>& states, int phase, const std::vector<int>& active) {
  const auto found = std::find_if(states.begin(), states.end(), [&](const PhaseState& state) {
    return state.phase == phase && state.active == active;
  });
  return found == states.end() ? -1 : static_cast<int>(found - states.begin());
}

std::vector<PhaseState> phase_states(const Scene& scene, bool at_rest) {
  std::vector<PhaseState> states;
  for (std::size_t k = 0; k < scene.phases.size(); ++k) {
    states.push_back({static_cast<int>(k), scene.phases[k].active, phase_name(scene, k, ""),
                      to_identifier(scene.phases[k].name), scene.phases[k].forces});
  }
  for (std::size_t k = 0; at_rest && k < states.size(); ++k) {
    for (const Event& event : scene.phases[index(states[k].phase)].until) {
      if (!may_rest(event) || !is_watched(event, states[k].active)) {
        continue;
      }
      const std::vector<int> active = active_behind(scene, event, true);
      if (find_state(states, event.then, active) < 0) {
        states.push_back(resting(scene, states, event.then, active));
      }
    }
  }
  return states;
}

}  // namespace treedyn::simplify
