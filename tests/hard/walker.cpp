// Quantities of a two-legged walker on a limit cycle: joints hip x, hip z, leg A, leg B.
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <Eigen/Eigenvalues>

#include "hard/special.hpp"

namespace treedyn::hard {

namespace {

using Events = std::vector<simulation::EventRecord>;
using simulation::Vector;

/// Steps after which only the cycle is left; even, so that the legs have their first parts again.
constexpr std::size_t kCycle = 40;

Events events_of(const model::Scene& scene, Source& source, std::size_t count) {
  Run run(scene, source);
  const double part = static_cast<double>(scene.duration) / 10;
  for (std::size_t k = 1; run.events().size() < count && k <= 10 * count; ++k) {
    run.advance_to(run.start() + part * static_cast<double>(k));
  }
  if (run.events().size() < count) {
    throw std::runtime_error("the walker falls");
  }
  return run.events();
}

const simulation::EventRecord& last(const Events& events) { return events[kCycle - 1]; }

/// Distance of the feet when the swinging one lands.
double step_length(const model::Scene& scene, const simulation::EventRecord& event) {
  const model::Phase& phase = scene.phases[static_cast<std::size_t>(event.phase)];
  const int stance = scene.constraints[static_cast<std::size_t>(phase.active.front())].point;
  simulation::Pose pose(scene.tree, scene.gravity);
  pose.update(event.q, event.qd_after);
  const auto at = [&](int k) {
    const model::Point& point = scene.points[static_cast<std::size_t>(k)];
    return pose.point(point.link, simulation::vector_of(point.at));
  };
  return (at(phase.until.front().point) - at(stance)).norm();
}

/// The state just after a landing from stance angle and rates of both legs; the hip is where the
/// stance foot is on its place.
model::Scene started(const model::Scene& scene, const Eigen::Vector3d& z) {
  model::Scene result = scene;
  const Vector q = (Vector(4) << 0, 0, z[0], -z[0]).finished();
  const Vector qd = (Vector(4) << 0, 0, z[1], z[2]).finished();
  simulation::Pose pose(scene.tree, scene.gravity);
  pose.update(q, qd);
  const auto& active = scene.phases[static_cast<std::size_t>(scene.start_phase)].active.front();
  const model::Constraint& foot = scene.constraints[static_cast<std::size_t>(active)];
  const model::Point& point = scene.points[static_cast<std::size_t>(foot.point)];
  const Eigen::Vector3d p = pose.point(point.link, simulation::vector_of(point.at));
  const simulation::LinkState& leg = pose.links()[static_cast<std::size_t>(point.link)];
  const Eigen::Vector3d v = leg.v + leg.omega.cross(p - leg.O);
  const Eigen::Vector3d c =
      simulation::VectorValue(foot.curve.position).at(static_cast<double>(scene.t0));
  result.q0 = {c[0] - p[0], c[2] - p[2], z[0], -z[0]};
  result.qd0 = {-v[0], -v[2], z[1], z[2]};
  return result;
}

/// One step; the legs change places.
Eigen::Vector3d return_map(const model::Scene& scene, Source& source, const Eigen::Vector3d& z) {
  const simulation::EventRecord event = events_of(started(scene, z), source, 1).front();
  return {event.q[3], event.qd_after[3], event.qd_after[2]};
}

/// Moduli, in the order of size that `expected` has.
Values eigenvalues(const model::Scene& scene, Source& source, const support::Json& entry) {
  constexpr double kStep = 1e-6;
  const simulation::EventRecord cycle = last(events_of(scene, source, kCycle));
  const Eigen::Vector3d z(cycle.q[2], cycle.qd_after[2], cycle.qd_after[3]);
  Eigen::Matrix3d J;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(k);
    J.col(k) = (return_map(scene, source, z + d) - return_map(scene, source, z - d)) / (2 * kStep);
  }
  const Eigen::Vector3d moduli = Eigen::EigenSolver<Eigen::Matrix3d>(J).eigenvalues().cwiseAbs();
  Values sorted(moduli.begin(), moduli.end());
  std::sort(sorted.begin(), sorted.end());
  const Values expected = support::flat(entry.at("value"));
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  Values result(sorted.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    result[order.at(k)] = sorted[k];
  }
  return result;
}

double deviation(const Events& events) {
  const simulation::EventRecord& now = events[9];
  const simulation::EventRecord& cycle = last(events);
  return std::max((now.q.tail(2) - cycle.q.tail(2)).cwiseAbs().maxCoeff(),
                  (now.qd_after.tail(2) - cycle.qd_after.tail(2)).cwiseAbs().maxCoeff());
}

using Scene = const model::Scene&;
using Dynamics = Source&;
using Entry = const support::Json&;

}  // namespace

std::vector<SpecialRow> walker_quantities() {
  return {
      {"fixed_point_stance_angle",
       [](Scene s, Dynamics d, Entry) {
         return Values{last(events_of(s, d, kCycle)).q[2]};
       }},
      {"fixed_point_rates",
       [](Scene s, Dynamics d, Entry) {
         return values_of(last(events_of(s, d, kCycle)).qd_after.tail(2));
       }},
      {"step_period",
       [](Scene s, Dynamics d, Entry) {
         const Events events = events_of(s, d, kCycle);
         return Values{last(events).time - events[kCycle - 2].time};
       }},
      {"state_before_impact_q",
       [](Scene s, Dynamics d, Entry) {
         return values_of(events_of(s, d, 1).front().q);
       }},
      {"impact_impulse",
       [](Scene s, Dynamics d, Entry) {
         return values_of(events_of(s, d, 1).front().impulse);
       }},
      {"step_length",
       [](Scene s, Dynamics d, Entry) {
         return Values{step_length(s, last(events_of(s, d, kCycle)))};
       }},
      {"return_map_eigenvalues", eigenvalues},
      {"after_10_steps_deviation",
       [](Scene s, Dynamics d, Entry) {
         return Values{deviation(events_of(s, d, kCycle))};
       }},
      {"published_zstar",
       [](Scene s, Dynamics d, Entry) {
         const simulation::EventRecord e = last(events_of(s, d, kCycle));
         return Values{-e.q[2], -e.qd_after[2], e.q[3] - e.q[2], e.qd_after[3] - e.qd_after[2]};
       }},
  };
}

}  // namespace treedyn::hard
