#include <map>
#include <stdexcept>

#include "hard/quantities.hpp"

namespace treedyn::hard {

namespace {

using simulation::Vector;

/// What a quantity may look at.
struct Context {
  const support::Json& entry;
  const model::Scene& scene;
  Run& run;
};

Eigen::Vector3d upward(const model::Scene& scene) {
  const Eigen::Vector3d g = simulation::vector_of(scene.gravity);
  return g.norm() > 0 ? Eigen::Vector3d(-g / g.norm()) : Eigen::Vector3d(0, 0, 1);
}

/// Sum over the force rows of the component against gravity.
double total_vertical(const Context& c, const Vector& reactions) {
  const simulation::Constraints& rows = c.run.system().constraints();
  double sum = 0;
  for (int k = 0; k < reactions.size(); ++k) {
    const auto row = static_cast<std::size_t>(rows.constraint(k));
    const bool force = c.scene.constraints[row].kind == model::ConstraintKind::kPoint;
    sum += force ? reactions[k] * rows.direction(k).dot(upward(c.scene)) : 0;
  }
  return sum;
}

/// The same of the impulses of all constraints.
double total_vertical_impulse(const Context& c) {
  const Vector impulse = c.run.motion().strike_all().impulse;
  double sum = 0;
  Eigen::Index row = 0;
  for (const model::Constraint& constraint : c.scene.constraints) {
    for (std::size_t k = 0; k < constraint.rows(); ++k, ++row) {
      sum +=
          constraint.kind == model::ConstraintKind::kPoint
              ? impulse[row] * simulation::vector_of(constraint.directions[k]).dot(upward(c.scene))
              : 0;
    }
  }
  return sum;
}

const simulation::EventRecord& event_of(const Context& c) {
  const simulation::EventRecord* const event = c.run.event(c.entry.at("event").get<std::size_t>());
  if (event == nullptr) {
    throw std::runtime_error("an event is missing");
  }
  return *event;
}

Values point_of(const Context& c) {
  const std::vector<double> at = support::flat(c.entry.at("point"));
  return values_of(
      c.run.pose().point(c.entry.at("body").get<int>() - 1, Eigen::Vector3d(at.data())));
}

using Evaluate = Values (*)(const Context&);

const std::map<std::string, Evaluate>& table() {
  static const std::map<std::string, Evaluate> result = {
      {"q",
       [](const Context& c) {
         return values_of(c.run.q());
       }},
      {"qd",
       [](const Context& c) {
         return values_of(c.run.qd());
       }},
      {"qdd",
       [](const Context& c) {
         return values_of(c.run.solution().qdd);
       }},
      {"lambda",
       [](const Context& c) {
         return values_of(c.run.solution().lambda);
       }},
      {"lambda_min_norm",
       [](const Context& c) {
         return values_of(c.run.solution().lambda);
       }},
      {"rank",
       [](const Context& c) {
         return Values{double(c.run.motion().rank())};
       }},
      {"point", point_of},
      {"energy",
       [](const Context& c) {
         return Values{c.run.energy()};
       }},
      {"kinetic_energy",
       [](const Context& c) {
         return Values{c.run.pose().kinetic_energy()};
       }},
      {"energy_drift_rel",
       [](const Context& c) {
         return Values{c.run.energy_drift()};
       }},
      {"linear_momentum",
       [](const Context& c) {
         return values_of(c.run.pose().linear_momentum());
       }},
      {"angular_momentum_about_origin",
       [](const Context& c) {
         return values_of(c.run.pose().angular_momentum());
       }},
      {"constraint_violation_max",
       [](const Context& c) {
         return Values{c.run.violation()};
       }},
      {"constraint_acceleration_residual",
       [](const Context& c) {
         return Values{c.run.motion().residual()};
       }},
      {"total_vertical_reaction",
       [](const Context& c) {
         return Values{total_vertical(c, c.run.solution().lambda)};
       }},
      {"total_vertical_impulse",
       [](const Context& c) {
         return Values{total_vertical_impulse(c)};
       }},
      {"impulses_min_norm",
       [](const Context& c) {
         return values_of(c.run.motion().strike_all().impulse);
       }},
      {"qd_after_impact",
       [](const Context& c) {
         return values_of(c.run.motion().strike_all().qd);
       }},
      {"qdd_after_impact",
       [](const Context& c) {
         return values_of(c.run.motion().strike_all().qdd);
       }},
      {"finite",
       [](const Context& c) {
         return Values{c.run.finite() ? 1.0 : 0.0};
       }},
      {"event_time",
       [](const Context& c) {
         return Values{event_of(c).time};
       }},
      {"q_at_event",
       [](const Context& c) {
         return values_of(event_of(c).q);
       }},
      {"qd_before_event",
       [](const Context& c) {
         return values_of(event_of(c).qd_before);
       }},
      {"qd_after_event",
       [](const Context& c) {
         return values_of(event_of(c).qd_after);
       }},
      {"impulse_at_event",
       [](const Context& c) {
         return values_of(event_of(c).impulse);
       }},
  };
  return result;
}

/// "q[3]" as "q" and 3; the index of the entry otherwise, 0 if there is none.
std::pair<std::string, std::size_t> split(const std::string& name, const support::Json& entry) {
  const std::size_t bracket = name.find('[');
  if (bracket != std::string::npos && name.back() == ']') {
    return {name.substr(0, bracket),
            std::stoul(name.substr(bracket + 1, name.size() - bracket - 2))};
  }
  return {name, entry.value("index", std::size_t{0})};
}

}  // namespace

std::optional<Values> known_quantity(const std::string& name, const support::Json& entry,
                                     const model::Scene& scene, Run& run) {
  const auto [base, index] = split(name, entry);
  const auto row = table().find(base);
  if (row == table().end()) {
    return std::nullopt;
  }
  const Values all = row->second({entry, scene, run});
  return index == 0 ? all : Values{all.at(index - 1)};
}

}  // namespace treedyn::hard
