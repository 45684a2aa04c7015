#include "formulate/scene_sticking.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "common/index.hpp"

namespace treedyn::formulate {

namespace {

using model::Event;
using model::EventKind;
using model::Expression;
using model::Phase;
using model::Scene;

/// What a joint does, in the order of phases.
enum SlipWay { kRests, kForth, kBack };
constexpr std::array<const char*, 3> kWayNames = {"sticks", "forth", "back"};

/// A joint whose friction sticks.
struct Sticking {
  int joint = 0;
  Real force = 0;
  int row = 0;  ///< the constraint that holds it
};

std::vector<Sticking> sticking_joints(const Scene& scene) {
  std::vector<Sticking> result;
  for (const model::DryFriction& friction : scene.frictions) {
    const auto same = std::ranges::find(result, friction.joint, &Sticking::joint);
    if (same == result.end()) {
      result.push_back({friction.joint, friction.force, 0});
    } else {
      same->force += friction.force;
    }
  }
  return result;
}

/// Makes the phases of one scene.
class PhaseMaker {
 public:
  PhaseMaker(Scene& scene, std::vector<Sticking> joints)
      : scene_(scene), before_(scene.phases), joints_(std::move(joints)), ways_(1) {
    for (Sticking& sticking : joints_) {
      model::Constraint row;
      row.name = fmt::format("friction of {}", scene.tree.moved_by(sticking.joint).joint.name);
      row.kind = model::ConstraintKind::kJoint;
      row.joint = sticking.joint;
      row.accelerations = {Expression(Real(0))};
      row.sticks = true;
      sticking.row = static_cast<int>(scene.constraints.size());
      scene.constraints.push_back(std::move(row));
      scene.sticking.push_back(sticking.joint);
      ways_ *= 3;
    }
  }

  void run() {
    scene_.phases.clear();
    for (const Phase& phase : before_) {
      for (int ways = 0; ways < ways_; ++ways) {
        scene_.phases.push_back(made(phase, ways));
      }
    }
    scene_.start_phase = ways_ * scene_.start_phase;
    for (std::size_t k = 0, place = 1; k < joints_.size(); ++k, place *= 3) {
      const std::vector<Real>& qd = scene_.qd0;
      const Real speed =
          to_index(joints_[k].joint) < qd.size() ? qd[to_index(joints_[k].joint)] : Real(0);
      scene_.start_phase += static_cast<int>(place) * (speed > 0   ? kForth
                                                       : speed < 0 ? kBack
                                                                   : kRests);
    }
  }

 private:
  [[nodiscard]] Phase made(const Phase& phase, int ways) const {
    Phase result = phase;
    for (Event& event : result.until) {
      event.then = ways_ * event.then;
    }
    const auto first = static_cast<int>(ways_ * (&phase - before_.data()));
    int place = 1;
    for (const Sticking& sticking : joints_) {
      const auto way = static_cast<SlipWay>(ways / place % 3);
      result.name +=
          fmt::format("_{}_{}", scene_.tree.moved_by(sticking.joint).joint.name, kWayNames[way]);
      add(sticking, way, {first + ways - place * way, place}, result);
      place *= 3;
    }
    // what friction decides comes first: reactions of joints that it cannot hold tell nothing
    const auto own = static_cast<std::ptrdiff_t>(phase.until.size());
    std::rotate(result.until.begin(), result.until.begin() + own, result.until.end());
    return result;
  }

  /// Phases that differ by the way of one joint.
  struct Ways {
    int first;
    int place;
    [[nodiscard]] int at(SlipWay way) const { return first + place * way; }
  };

  static void add(const Sticking& sticking, SlipWay way, const Ways& ways, Phase& phase) {
    if (way == kRests) {
      phase.active.push_back(sticking.row);
      for (const SlipWay next : {kForth, kBack}) {
        Event event;
        event.kind = EventKind::kReaction;
        event.constraint = sticking.row;
        event.plane.normal[0] = next == kForth ? 1 : -1;
        event.plane.height = sticking.force;
        event.then = ways.at(next);
        event.goes_on = true;
        phase.until.push_back(event);
      }
      return;
    }
    const Real sign = way == kForth ? 1 : -1;
    phase.forces.push_back({sticking.joint, -sign * sticking.force});
    Event event;
    event.kind = EventKind::kExpression;
    event.value =
        Expression(sign) * Expression(model::Variable{model::Quantity::kVelocity, sticking.joint});
    event.then = ways.at(kRests);
    event.stops = sticking.joint;
    event.goes_on = true;
    phase.until.push_back(event);
  }

  Scene& scene_;
  const std::vector<Phase> before_;
  std::vector<Sticking> joints_;
  int ways_;
};

/// Different identifiers for all phases.
void name_apart(Scene& scene) {
  for (std::size_t k = 0; k < scene.phases.size(); ++k) {
    const auto taken = [&] {
      return std::any_of(scene.phases.begin(),
                         scene.phases.begin() + static_cast<std::ptrdiff_t>(k),
                         [&](const Phase& other) {
                           return to_identifier(other.name) == to_identifier(scene.phases[k].name);
                         });
    };
    while (taken()) {
      scene.phases[k].name += "_2";
    }
  }
}

}  // namespace

std::size_t sticking_phases(const Scene& scene) {
  std::size_t result = scene.phases.size();
  for (std::size_t k = 0; k < sticking_joints(scene).size() && result <= kMostStickingPhases; ++k) {
    result *= 3;
  }
  return result;
}

void forget_sticking(Scene& scene) {
  int ways = 1;
  std::string suffix;
  for (const int joint : scene.sticking) {
    suffix += fmt::format("_{}_{}", scene.tree.moved_by(joint).joint.name, kWayNames[kRests]);
    ways *= 3;
  }
  std::vector<Phase> phases;
  for (std::size_t k = 0; k < scene.phases.size(); k += to_index(ways)) {
    Phase phase = scene.phases[k];
    if (phase.name.ends_with(suffix)) {
      phase.name.resize(phase.name.size() - suffix.size());
    }
    std::erase_if(phase.active, [&](int c) { return scene.constraints[to_index(c)].sticks; });
    std::erase_if(phase.until, [](const Event& event) { return event.goes_on; });
    for (Event& event : phase.until) {
      event.then /= ways;
    }
    phase.forces.clear();
    phases.push_back(std::move(phase));
  }
  scene.phases = std::move(phases);
  scene.start_phase /= ways;
  scene.sticking.clear();
  std::erase_if(scene.constraints, [](const model::Constraint& row) { return row.sticks; });
}

void settle_sticking(Scene& scene) {
  std::vector<Sticking> joints = sticking_joints(scene);
  if (!joints.empty() && scene.sticking.empty()) {
    PhaseMaker(scene, std::move(joints)).run();
    name_apart(scene);
  }
}

}  // namespace treedyn::formulate
