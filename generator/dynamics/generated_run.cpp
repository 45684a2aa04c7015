#include "dynamics/generated_run.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "common/index.hpp"
#include "formulate/scene_steps.hpp"
#include "program/interpret.hpp"
#include "simulation/column_names.hpp"

namespace treedyn {

namespace {

using simulation::Vector;
using Values = GeneratedStep::Values;

/// One run: what the step is given and what is noted.
class Run {
 public:
  Run(const model::Scene& scene, GeneratedStep& step, simulation::Simulator& simulator,
      double output_step)
      : scene_(scene),
        step_(step),
        simulator_(simulator),
        states_(formulate::phase_states(scene, true)),
        start_(static_cast<double>(scene.t0)),
        h_(static_cast<double>(scene.stepping.step)),
        count_(std::lround(static_cast<double>(scene.duration) / h_)),
        output_step_(output_step),
        steps_(step.stepper().phases.size()) {
    begin_motion(scene_, simulator_.q(), simulator_.qd(), step_);
  }

  /// Calls `show` with the reactions of every row of the table.
  bool go(const simulation::ShowState& show, const simulation::LookAtState& look,
          const simulation::Progress& progress);
  /// What it found and took beside a recording of its rows and events.
  [[nodiscard]] GeneratedRun counted(simulation::Recording recording) const;

 private:
  void place(long k, const Values& q, const Values& qd, int state);
  [[nodiscard]] std::vector<double> reactions(int state) const;
  void note_status(int status, double time);
  [[nodiscard]] bool was_struck() const;
  void note_events(double time, int before, const Values& qd_before);
  [[nodiscard]] int state() const {
    return step_.has("phase") ? static_cast<int>(step_.at("phase")[0]) : scene_.start_phase;
  }
  [[nodiscard]] double time(long k) const { return start_ + static_cast<double>(k) * h_; }

  const model::Scene& scene_;
  GeneratedStep& step_;
  simulation::Simulator& simulator_;
  std::vector<formulate::PhaseState> states_;
  double start_;
  double h_;
  long count_;
  double output_step_;
  std::vector<StatusRecord> statuses_;
  std::vector<program::StepCount> steps_;  ///< in each phase of the step
};

void Run::place(long k, const Values& q, const Values& qd, int state) {
  const formulate::PhaseState& now = states_[to_index(state)];
  simulator_.place(time(k), vector_of(q), vector_of(qd), now.phase, now.active);
}

/// Of all constraints; zero where they do not act.
std::vector<double> Run::reactions(int state) const {
  const std::vector<int>& active = states_[to_index(state)].active;
  std::vector<double> result;
  std::size_t row = 0;
  for (std::size_t c = 0; c < scene_.constraints.size(); ++c) {
    const std::size_t rows = scene_.constraints[c].rows();
    const bool acts = std::ranges::find(active, static_cast<int>(c)) != active.end();
    for (std::size_t k = 0; k < rows; ++k) {
      result.push_back(acts ? static_cast<double>(step_.at("lambda")[row + k]) : 0);
    }
    row += acts ? rows : 0;
  }
  return result;
}

void Run::note_status(int status, double time) {
  for (int bit = 1; bit <= status; bit *= 2) {
    if ((status & bit) == 0) {
      continue;
    }
    const auto same = std::ranges::find(statuses_, bit, &StatusRecord::bit);
    if (same == statuses_.end()) {
      statuses_.push_back({bit, 1, time});
    } else {
      ++same->count;
    }
  }
}

/// True if an impact was in the last step.
bool Run::was_struck() const {
  std::vector<bool> strikes;
  for (const program::StepPhase& phase : step_.stepper().phases) {
    for (const program::StepEvent& event : phase.events) {
      strikes.push_back(!event.outcome.impact.empty() ||
                        (event.rest && !event.rest->impact.empty()));
    }
  }
  return std::ranges::any_of(
      step_.events(), [&](const SteppedEvent& event) { return strikes[to_index(event.number)]; });
}

/// By the names of what happened, and of the state at rest that no phase of the scene is.
void Run::note_events(double time, int before, const Values& qd_before) {
  std::vector<std::string> names;
  for (const program::StepPhase& phase : step_.stepper().phases) {
    for (const program::StepEvent& event : phase.events) {
      names.push_back(event.brief);
    }
  }
  std::string name;
  for (const SteppedEvent& event : step_.events()) {
    name += (name.empty() ? "" : ", ") + names[to_index(event.number)];
  }
  name = name.empty() ? "change of phase" : name;
  const formulate::PhaseState& now = states_[to_index(state())];
  if (to_index(state()) >= scene_.phases.size()) {
    name += fmt::format(" ({})", now.identifier);
  }
  simulator_.note({time,
                   states_[to_index(before)].phase,
                   name,
                   now.phase,
                   vector_of(step_.at("q")),
                   vector_of(qd_before),
                   vector_of(step_.at("qd")),
                   {}});
}

GeneratedRun Run::counted(simulation::Recording recording) const {
  const program::Stepper& stepper = step_.stepper();
  GeneratedRun result;
  result.recording = std::move(recording);
  result.recording.cost = {};
  result.statuses = statuses_;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const program::StepPhase& phase = stepper.phases[k];
    result.recording.cost.steps += steps_[k].steps;
    result.recording.cost.evaluations += program::step_evaluations(stepper, steps_[k]);
    result.operations += steps_[k].steps * program::least_step_cost(stepper, phase).total();
    const std::vector<program::Cost> costs = program::repeated_costs(stepper, phase);
    for (std::size_t what = 0; what < std::min(costs.size(), steps_[k].repeated.size()); ++what) {
      result.operations += steps_[k].repeated[what] * costs[what].total();
    }
  }
  return result;
}

bool Run::go(const simulation::ShowState& show, const simulation::LookAtState& look,
             const simulation::Progress& progress) {
  long shown = 0;  // rows of the table
  bool changed = false;
  for (long k = 0; k <= count_; ++k) {
    const Values q = step_.at("q");
    const Values qd = step_.at("qd");
    const int before = state();
    if (step_.has("t")) {
      step_.at("t")[0] = static_cast<long double>(time(k));
    }
    const int status = step_.call();
    const bool due =
        (static_cast<double>(k) + 1e-6) * h_ >= static_cast<double>(shown) * output_step_;
    place(k, q, qd, before);
    look();
    if (due || changed || k == count_) {
      show(reactions(before));
      shown += due ? 1 : 0;
    }
    if (k == count_) {
      break;
    }
    note_status(status, time(k));
    steps_[step_.has("phase") ? to_index(before) : 0] += {1, step_.repeated(), step_.repeated()};
    const Vector next = vector_of(step_.at("q"));
    if (!next.allFinite() || !vector_of(step_.at("qd")).allFinite()) {
      std::vector<double> last(q.begin(), q.end());
      last.insert(last.end(), qd.begin(), qd.end());
      throw std::runtime_error(simulation::not_finite(scene_, time(k + 1), last));
    }
    changed = state() != before;
    Vector after(2 * next.size());
    after << next, vector_of(step_.at("qd"));
    simulator_.follow(h_, after, changed || was_struck());
    if (changed || !step_.events().empty()) {
      note_events(time(k + 1), before, qd);
    }
    if (!progress(static_cast<double>(k + 1) / static_cast<double>(count_))) {
      return false;
    }
  }
  return true;
}

}  // namespace

Vector vector_of(const Values& values) {
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  return Eigen::Map<const Extended>(values.data(), static_cast<Eigen::Index>(values.size()))
      .cast<double>();
}

void begin_motion(const model::Scene& scene, const Vector& q, const Vector& qd,
                  GeneratedStep& step) {
  step.at("q").assign(q.begin(), q.end());
  step.at("qd").assign(qd.begin(), qd.end());
  Values& tau = step.at("tau");
  for (std::size_t k = 0; k < scene.tau.size(); ++k) {
    tau[k] = static_cast<long double>(scene.tau[k]);
  }
  for (const char* name : {"steps", "begun", "rest"}) {
    if (step.has(name)) {
      std::ranges::fill(step.at(name), 0);
    }
  }
  if (step.has("phase")) {
    step.at("phase")[0] = scene.start_phase;
  }
  if (step.has("anchor")) {
    const program::Function anchors = formulate::anchor_function(scene);
    const std::vector<double> at(q.begin(), q.end());
    const std::vector<std::vector<double>> inputs = {at, {static_cast<double>(scene.t0)}};
    const std::vector<std::span<const double>> spans(inputs.begin(), inputs.end());
    const std::vector<double> values = program::interpret<double>(anchors, spans);
    step.at("anchor").assign(values.begin(), values.end());
  }
}

GeneratedRun run_generated(const model::Scene& scene, GeneratedStep& step,
                           simulation::Simulator& simulator, double output_step,
                           const simulation::Progress& progress) {
  Run run(scene, step, simulator, output_step);
  return run.counted(simulation::record_states(
      scene, simulator,
      [&](const simulation::ShowState& show, const simulation::LookAtState& look) {
        return run.go(show, look, progress);
      }));
}

std::vector<std::string> status_lines(const std::vector<StatusRecord>& statuses) {
  std::vector<std::string> lines;
  for (const StatusRecord& status : statuses) {
    const std::string more =
        status.count == 1 ? "" : fmt::format(" and in {} later steps", status.count - 1);
    lines.push_back(fmt::format("the step at t = {:.6g} s{} returned {}", status.first, more,
                                status_names(status.bit)));
  }
  return lines;
}

}  // namespace treedyn
