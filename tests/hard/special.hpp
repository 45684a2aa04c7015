// Tools of the quantities that need runs of their own.
#pragma once

#include "hard/quantities.hpp"

namespace treedyn::hard {

using Function = std::function<double(Run&)>;

/// The time at which the scene ends.
inline double end_of(const model::Scene& scene) {
  return static_cast<double>(scene.t0) + static_cast<double>(scene.duration);
}

/// The times at which `g` changes its sign on the way to `end`, to the resolution of time.
std::vector<double> crossings(const model::Scene& scene, Source& source, double end,
                              const Function& g);
/// g at a time.
double value_at(const model::Scene& scene, Source& source, double time, const Function& g);

using SpecialRow = std::pair<std::string, Special>;
std::vector<SpecialRow> walker_quantities();
std::vector<SpecialRow> impact_quantities();
std::vector<SpecialRow> motion_quantities();
std::vector<SpecialRow> contact_quantities();

}  // namespace treedyn::hard
