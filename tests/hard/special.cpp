#include "hard/special.hpp"

#include <boost/math/tools/roots.hpp>
#include <map>

namespace treedyn::hard {

std::vector<double> crossings(const model::Scene& scene, Source& source, double end,
                              const Function& g) {
  Run run(scene, source);
  double before = g(run);
  double time = run.start();
  std::vector<std::pair<double, double>> brackets;
  run.observer = [&] {
    const double now = g(run);
    if (before * now < 0) {
      brackets.emplace_back(time, run.time());
    }
    before = now != 0 ? now : before;
    time = run.time();
  };
  run.advance_to(end);
  std::vector<double> result;
  for (const auto& [low, high] : brackets) {
    const auto at = [&](double t) {
      return value_at(scene, source, t, g);
    };
    const double first = at(low);
    const double last = at(high);
    if (first * last >= 0) {  // landing there moves the zero beyond one of the ends
      result.push_back(first == 0 ? low : high);
      continue;
    }
    std::uintmax_t calls = 100;
    const boost::math::tools::eps_tolerance<double> closest(52);
    result.push_back(
        boost::math::tools::toms748_solve(at, low, high, first, last, closest, calls).second);
  }
  return result;
}

double value_at(const model::Scene& scene, Source& source, double time, const Function& g) {
  Run run(scene, source);
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
