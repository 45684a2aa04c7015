#include "hard/special.hpp"

#include <map>

namespace treedyn::hard {

std::vector<double> crossings(const model::Scene& scene, simulation::Dynamics& dynamics, double end,
                              const Function& g) {
  Run run(scene, dynamics);
  double before = g(run);
  double time = run.start();
  std::vector<std::pair<double, double>> brackets;
  run.observer = [&] {
    const double now = g(run);
    if (before * now < 0) {
      brackets.emplace_back(time, run.simulator().time());
    }
    before = now != 0 ? now : before;
    time = run.simulator().time();
  };
  run.advance_to(end);
  std::vector<double> result;
  for (auto [low, high] : brackets) {
    const double first = value_at(scene, dynamics, low, g);
    for (double middle = (low + high) / 2; low < middle && middle < high;
         middle = (low + high) / 2) {
      (value_at(scene, dynamics, middle, g) * first > 0 ? low : high) = middle;
    }
    result.push_back(high);
  }
  return result;
}

double value_at(const model::Scene& scene, simulation::Dynamics& dynamics, double time,
                const Function& g) {
  Run run(scene, dynamics);
  run.advance_to(time);
  return g(run);
}

Special special_quantity(const std::string& name) {
  static const std::map<std::string, Special> table = [] {
    std::map<std::string, Special> result;
    for (const auto& rows :
         {walker_quantities(), impact_quantities(), motion_quantities(), contact_quantities()}) {
      result.insert(rows.begin(), rows.end());
    }
    return result;
  }();
  const auto row = table.find(name);
  return row == table.end() ? nullptr : row->second;
}

}  // namespace treedyn::hard
