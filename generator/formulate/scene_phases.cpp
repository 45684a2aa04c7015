#include "formulate/scene_phases.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "common/index.hpp"
#include "common/sorted.hpp"
#include "formulate/geometry.hpp"
#include "formulate/scene_names.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

using model::Event;
using model::EventKind;
using model::Scene;

namespace {

/// What ends the rest of those constraints that came to it unasked.
std::vector<Event> lift_offs(const Scene& scene, int phase, const std::vector<int>& resting) {
  std::vector<Event> result;
  for (const model::Phase& other : scene.phases) {
    for (const Event& event : other.until) {
      if (!rests_unasked(scene, event)) {
        continue;
      }
      const int floor = model::struck(scene, event).front();
      const auto is_known = [&](const Event& known) {
        return known.constraint == floor;
      };
      if (!std::ranges::binary_search(resting, floor) || std::ranges::any_of(result, is_known)) {
        continue;
      }
      Event lift_off;
      lift_off.kind = EventKind::kReaction;
      lift_off.constraint = floor;
      lift_off.plane.normal = event.plane.normal;
      lift_off.then = phase;
      lift_off.goes_on = true;
      result.push_back(lift_off);
    }
  }
  return result;
}

PhaseState resting(const Scene& scene, const std::vector<PhaseState>& states, int phase,
                   const std::vector<int>& rests) {
  const PhaseState& plain = states[to_index(phase)];
  const auto named = [&](int number) {
    const std::string more = number > 1 ? fmt::format("_at_rest_{}", number) : "_at_rest";
    return PhaseState{phase,
                      united(plain.active, rests),
                      plain.ending + more,
                      to_identifier(scene.phases[to_index(phase)].name + more),
                      plain.forces,
                      lift_offs(scene, phase, without(rests, plain.active))};
  };
  const auto is_taken = [&](const PhaseState& state) {
    return std::ranges::any_of(states, [&](const PhaseState& other) {
      return other.identifier == state.identifier || other.ending == state.ending;
    });
  };
  int number = 1;
  while (is_taken(named(number))) {
    ++number;
  }
  return named(number);
}

/// All states in which joints stick or slip and these constraints rest.
void add_resting(const Scene& scene, int phase, const std::vector<int>& rests,
                 std::vector<PhaseState>& states) {
  int ways = 1;
  for (std::size_t k = 0; k < scene.sticking.size(); ++k) {
    ways *= 3;
  }
  for (int way = 0; way < ways; ++way) {
    states.push_back(resting(scene, states, phase - phase % ways + way, rests));
  }
}

}  // namespace

bool is_watched(const Event& event, const std::vector<int>& active) {
  const bool reacts = event.kind != EventKind::kReaction ||
                      std::ranges::find(active, event.constraint) != active.end();
  return !strikes_what_acts(event, active) && reacts;
}

bool strikes(const Event& event) { return event.impact && !event.impact->constraints.empty(); }

bool rebounds(const Event& event) { return strikes(event) && event.impact->restitution > 0; }

bool rests_unasked(const Scene& scene, const Event& event) {
  if (event.kind != EventKind::kHeight || !rebounds(event) || event.impact->restitution == 1 ||
      event.impact->rest_below > 0) {
    return false;
  }
  const std::vector<int> rows = model::struck(scene, event);
  return step_method(scene) && rows.size() == 1 && model::floor_of(scene, event, rows) >= 0;
}

bool may_rest(const Scene& scene, const Event& event) {
  return strikes(event) && (event.impact->rest_below > 0 || rests_unasked(scene, event));
}

std::vector<int> active_behind(const Scene& scene, const PhaseState& state, const Event& event,
                               bool at_rest) {
  std::vector<int> active = scene.phases[to_index(event.then)].active;
  if (at_rest) {
    active = united(active, event.impact->constraints);
  }
  if (event.goes_on) {
    std::vector<int> rest = without(state.active, scene.phases[to_index(state.phase)].active);
    if (event.kind == EventKind::kReaction) {
      rest = without(rest, {event.constraint});
    }
    active = united(active, rest);
  }
  return active;
}

std::vector<Event> events_of(const Scene& scene, const PhaseState& state) {
  std::vector<Event> events = scene.phases[to_index(state.phase)].until;
  events.insert(events.end(), state.lift_offs.begin(), state.lift_offs.end());
  return events;
}

int find_state(const std::vector<PhaseState>& states, int phase, const std::vector<int>& active) {
  const auto found = std::ranges::find_if(states, [&](const PhaseState& state) {
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
    for (const Event& event : events_of(scene, states[k])) {
      const bool rests = may_rest(scene, event);
      if ((!rests && !event.goes_on) || !is_watched(event, states[k].active)) {
        continue;
      }
      const std::vector<int> active = active_behind(scene, states[k], event, rests);
      if (find_state(states, event.then, active) < 0) {
        add_resting(scene, event.then, without(active, scene.phases[to_index(event.then)].active),
                    states);
      }
    }
  }
  return states;
}

}  // namespace treedyn::formulate
