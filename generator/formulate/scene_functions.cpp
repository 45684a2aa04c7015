#include "formulate/scene_functions.hpp"

#include <algorithm>
#include <deque>
#include <functional>

#include "common/index.hpp"
#include "common/parallel.hpp"
#include "common/transformed.hpp"
#include "formulate/constrained_inverse.hpp"
#include "formulate/scene_formulator.hpp"
#include "formulate/scene_names.hpp"
#include "formulate/scene_phases.hpp"
#include "formulate/scene_steps.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

/// The functions of a scene that are wanted, formulated at the same time.
class SceneTasks {
 public:
  SceneTasks(const model::Scene& given, const Options& options,
             const std::vector<std::string>& wanted)
      : formulator_(given, options),
        options_(options),
        wanted_(wanted),
        steps_(step_method(scene()) && is_wanted("step")),
        states_(phase_states(scene(), steps_)),
        names_(impacts_of(scene())) {
    add_rows();
    for (const PhaseState& state : states_) {
      add_phase(state);
    }
    add_events();
  }
  SceneTasks(const SceneTasks&) = delete;  // tasks refer to members
  SceneTasks& operator=(const SceneTasks&) = delete;

  [[nodiscard]] SceneFunctions run();

 private:
  [[nodiscard]] const model::Scene& scene() const { return formulator_.scene(); }
  [[nodiscard]] bool is_wanted(const std::string& name) const {
    return wanted_.empty() || std::ranges::find(wanted_, name) != wanted_.end();
  }
  void add_rows();
  void add_phase(const PhaseState& state);
  void add_events();
  [[nodiscard]] std::vector<program::Staged> staged_at(
      const std::vector<std::size_t>& places) const;

  /// \return its place among `functions`
  template <class Function, class Make>
  std::size_t add(std::deque<Function>& functions, Make make) {
    tasks_.emplace_back([&function = functions.emplace_back(), make] { function = make(); });
    return functions.size() - 1;
  }

  const SceneFormulator formulator_;
  const Options& options_;
  const std::vector<std::string>& wanted_;
  const bool steps_;
  const std::vector<PhaseState> states_;
  const std::vector<ImpactName> names_;
  std::deque<program::Function> plain_;  ///< whose elements stay where they are
  std::deque<program::Staged> staged_;
  std::vector<std::size_t> dynamics_;  ///< places in `staged_`
  std::vector<std::size_t> impacts_;
  std::vector<std::function<void()>> tasks_;
};

void SceneTasks::add_rows() {
  if (formulator_.rows() > 0 && is_wanted("reaction_jacobian_transpose")) {
    add(plain_, [this] { return formulator_.jacobian(); });
  }
  if (formulator_.rows() > 0 && is_wanted("reaction_bias_acceleration")) {
    add(plain_, [this] { return formulator_.bias(); });
  }
}

void SceneTasks::add_phase(const PhaseState& state) {
  if (steps_ || is_wanted("constrained_dynamics")) {
    dynamics_.push_back(
        add(staged_, [this, &state] { return formulator_.constrained_dynamics(state); }));
  }
  const bool declared = state.active == scene().phases[to_index(state.phase)].active;
  const bool inverse = wanted_.empty() ? !joints_without_drive(scene(), state.active).empty()
                                       : is_wanted("constrained_inverse_dynamics");
  if (declared && inverse) {
    add(staged_, [this, &state] { return formulator_.inverse_dynamics(state); });
  }
}

/// Impacts and contacts.
void SceneTasks::add_events() {
  for (const ImpactName& impact : names_) {
    if (steps_ || is_wanted("impact")) {
      impacts_.push_back(add(staged_, [this, &impact] { return formulator_.impact(impact); }));
    }
  }
  for (std::size_t k = 0; k < scene().contacts.size() && is_wanted("contact_force"); ++k) {
    add(staged_, [this, k] { return formulator_.contact_force(k); });
  }
}

std::vector<program::Staged> SceneTasks::staged_at(const std::vector<std::size_t>& places) const {
  return transformed(places, [&](std::size_t place) { return staged_[place]; });
}

SceneFunctions SceneTasks::run() {
  run_all(tasks_);
  SceneFunctions result;
  if (steps_) {
    result.steppers.push_back(
        make_stepper(scene(), options_, states_, staged_at(dynamics_), staged_at(impacts_)));
  }
  result.plain.assign(plain_.begin(), plain_.end());
  result.staged.assign(staged_.begin(), staged_.end());
  for (program::Staged& function : result.staged) {
    function.signature.status = true;
  }
  return result;
}

}  // namespace

SceneFunctions scene_functions(const model::Scene& given, const Options& options,
                               const std::vector<std::string>& wanted) {
  return SceneTasks(given, options, wanted).run();
}

}  // namespace treedyn::formulate
