// Periods, rates and branches of smooth motions.
#include <algorithm>

#include <Eigen/Geometry>

#include "hard/special.hpp"

namespace treedyn::hard {

namespace {

using Scene = const model::Scene&;
using Dynamics = Source&;
using Entry = const support::Json&;

Eigen::Vector3d omega_body(Run& run) {
  const simulation::LinkState& last = run.pose().links().back();
  return last.R.transpose() * last.omega;
}

/// From rest to the second rest.
Values period(Scene s, Dynamics d, Entry) {
  const double start = static_cast<double>(s.t0);
  const auto speed = [](Run& run) {
    return run.qd()[0];
  };
  return {crossings(s, d, start + (end_of(s) - start) / 5, speed).at(1) - start};
}

/// Twice the time between two changes of sign of the spin that is largest at first.
Values flip_period(Scene s, Dynamics d, Entry) {
  Run first(s, d);
  Eigen::Index axis = 0;
  omega_body(first).cwiseAbs().maxCoeff(&axis);
  const std::vector<double> flips =
      crossings(s, d, end_of(s), [axis](Run& run) { return omega_body(run)[axis]; });
  return {2 * (flips.at(1) - flips.at(0))};
}

/// Rate of the azimuth of the last link's z axis about the vertical.
Values precession(Scene s, Dynamics d, Entry) {
  Run run(s, d);
  const Eigen::Vector3d up = -simulation::vector_of(s.gravity).normalized();
  const simulation::LinkState& top = run.pose().links().back();
  const Eigen::Vector3d e = top.R.col(2);
  return {e.cross(top.omega.cross(e)).dot(up) / (1 - e.dot(up) * e.dot(up))};
}

/// Largest angle between the links named link* and the first of them, at any time.
Values links_parallel(Scene s, Dynamics d, Entry) {
  std::vector<std::size_t> links;
  for (std::size_t k = 0; k < s.tree.links.size(); ++k) {
    if (s.tree.links[k].name.starts_with("link")) {
      links.push_back(k);
    }
  }
  Run run(s, d);
  double largest = 0;
  run.observer = [&] {
    const auto& states = run.pose().links();
    for (const std::size_t k : links) {
      const Eigen::Matrix3d E = states[k].R.transpose() * states[links.front()].R;
      largest = std::max(largest, (E - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff());
    }
  };
  run.advance_to(run.end());
  return {largest};
}

/// When the first link first is parallel to the coupler that follows it.
Values singular_time(Scene s, Dynamics d, Entry) {
  const auto g = [](Run& run) {
    const auto& states = run.pose().links();
    return states[0].R.col(2).cross(states[1].R.col(0)).dot(states[0].R.col(1));
  };
  const double start = static_cast<double>(s.t0);
  return {crossings(s, d, start + (end_of(s) - start) / 10, g).at(0)};
}

}  // namespace

std::vector<SpecialRow> motion_quantities() {
  return {
      {"period", period},
      {"period_of_body_angular_velocity", flip_period},
      {"omega_body",
       [](Scene s, Dynamics d, Entry entry) {
         Run run(s, d);
         run.advance_to(entry.at("time").get<double>());
         return values_of(omega_body(run));
       }},
      {"qdd_float_with_wrapped_angle_and_local_origin",
       [](Scene s, Dynamics d, Entry) {
         return values_of(Run(s, d).solution().qdd);
       }},
      {"precession_rate", precession},
      {"links_parallel", links_parallel},
      {"first_singular_time", singular_time},
  };
}

}  // namespace treedyn::hard
