#include "formulate/scene_loops.hpp"

#include <algorithm>
#include <span>

#include "common/index.hpp"
#include "formulate/constrained.hpp"
#include "formulate/scene_rank.hpp"
#include "formulate/scene_steps.hpp"
#include "model/loops.hpp"
#include "model/scene_facts.hpp"
#include "program/interpret.hpp"

namespace treedyn::formulate {

namespace {

using model::Constraint;
using model::Scene;
using Values = std::vector<Real>;

/// True if the rows of some phase in which it acts depend on each other.
bool is_redundant(const Scene& scene, const ScenePositions& positions, int constraint) {
  return std::ranges::any_of(scene.phases, [&](const model::Phase& phase) {
    if (std::ranges::find(phase.active, constraint) == phase.active.end()) {
      return false;
    }
    const program::OrdinaryRows ordinary = positions.ordinary(phase.active);
    return ordinary.holds && ordinary.rank < rows_of(scene, phase.active);
  });
}

/// The anchors of all constraints at the initial state, and where each one's begin.
class InitialPlaces {
 public:
  explicit InitialPlaces(Scene scene) : scene_(std::move(scene)) {
    scene_.stepping.drift = model::Drift::kBaumgarte;
    Values q = scene_.q0;
    q.resize(to_index(scene_.tree.dof()));
    const Values t = {scene_.t0};
    if (anchor_offset(scene_, static_cast<int>(scene_.constraints.size())) > 0) {
      const program::Function anchors = anchor_function(scene_);
      std::vector<std::span<const Real>> inputs = {q, t};
      inputs.resize(anchors.signature.inputs.size());
      values_ = program::interpret<Real>(anchors, inputs);
    }
  }

  [[nodiscard]] Values of(int constraint) const {
    const auto first = values_.begin() + anchor_offset(scene_, constraint);
    return {first, first + anchor_size(scene_, constraint)};
  }

 private:
  Scene scene_;
  Values values_;
};

}  // namespace

void settle_loops(Scene& scene) {
  if (!step_method(scene) || scene.stepping.drift != model::Drift::kProjection) {
    return;
  }
  std::vector<int> loops;
  for (int c = 0; c < static_cast<int>(scene.constraints.size()); ++c) {
    const Constraint& constraint = scene.constraints[to_index(c)];
    if (constraint.kind != model::ConstraintKind::kJoined && constraint.accelerations.empty() &&
        model::stays(scene, c) && model::closes_loop(scene, c)) {
      loops.push_back(c);
    }
  }
  if (loops.empty()) {
    return;
  }
  const ScenePositions positions(scene);
  const InitialPlaces places(scene);
  for (const int c : loops) {
    if (is_redundant(scene, positions, c)) {
      scene.constraints[to_index(c)].loop = places.of(c);
    }
  }
}

}  // namespace treedyn::formulate
