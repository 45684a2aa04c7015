// hard_cases [--strict] DIR...: the simulator against `expected` of the case files,
// hard_cases/SCHEMA.md.

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "description/scene_reader.hpp"
#include "hard/quantities.hpp"

namespace treedyn::hard {
namespace {

using support::Json;
using support::Report;

/// What a quantity is evaluated at: its time, the beginning or the end of the motion.
double time_of(const Json& entry, const Run& run) {
  if (entry.contains("time")) {
    return entry.at("time").get<double>();
  }
  const std::string name = entry.at("quantity").get<std::string>();
  const bool at_the_end = entry.contains("event") || name == "finite" ||
                          name == "energy_drift_rel" || name == "constraint_violation_max";
  return at_the_end ? run.end() : run.start();
}

double error_of(const Json& entry, const Values& x, const Values& expected) {
  double error = x.size() == expected.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(x.size(), expected.size()); ++k) {
    const double e = std::fabs(x[k] - expected[k]);
    error = e <= std::numeric_limits<double>::max() ? std::max(error, e)
                                                    : std::numeric_limits<double>::infinity();
  }
  return entry.contains("tol_relative_to") ? error / support::max_abs(expected) : error;
}

/// One case under test.
class Case {
 public:
  Case(const std::filesystem::path& file, const Json& data, Report& report, bool strict)
      : scene_(description::read_scene(file.string())),
        dynamics_(program_dynamics(scene_)),
        run_(scene_, *dynamics_),
        data_(data),
        report_(report),
        strict_(strict) {}

  void check() {
    std::vector<Json> entries = data_.at("expected").get<std::vector<Json>>();
    std::stable_sort(entries.begin(), entries.end(), [this](const Json& a, const Json& b) {
      return time_of(a, run_) < time_of(b, run_);
    });
    for (const Json& entry : entries) {
      if (!entry.at("tol_double").is_null()) {
        check_entry(entry);
      }
    }
    report_.note("simulator", "worst/tolerance", worst_, 1);
  }

 private:
  void check_entry(const Json& entry) {
    const auto name = entry.at("quantity").get<std::string>();
    std::optional<Values> values;
    if (const Special special = special_quantity(name)) {
      values = special(scene_, *dynamics_, entry);
    } else {
      run_.advance_to(time_of(entry, run_));
      values = known_quantity(name, entry, scene_, run_);
    }
    if (!values) {
      unchecked(name);
      return;
    }
    const double error = error_of(entry, *values, support::flat(entry.at("value")));
    const double tolerance = entry.at("tol_double").get<double>();
    worst_ = std::max(worst_, error == 0 ? 0 : error / tolerance);
    report_.note("simulator", name, error, tolerance);
  }

  void unchecked(const std::string& name) {
    if (strict_) {
      report_.fail(fmt::format("{} is not checked", name));
    } else {
      report_.note("simulator", name + " unchecked", 0, 0);
    }
  }

  model::Scene scene_;
  std::unique_ptr<simulation::Dynamics> dynamics_;
  Run run_;
  const Json& data_;
  Report& report_;
  bool strict_;
  double worst_ = 0;
};

}  // namespace
}  // namespace treedyn::hard

int main(int argc, char** argv) {
  std::vector<std::string> folders(argv + 1, argv + argc);
  const auto strict = std::find(folders.begin(), folders.end(), "--strict");
  const bool is_strict = strict != folders.end();
  if (is_strict) {
    folders.erase(strict);
  }
  if (std::any_of(folders.begin(), folders.end(),
                  [](const std::string& word) { return word.starts_with("--"); })) {
    std::cerr << "hard_cases: unknown option; expected --strict and folders\n";
    return 2;
  }
  return treedyn::support::run_cases(
      folders, [is_strict](const std::filesystem::path& file, const treedyn::support::Json& data,
                           treedyn::support::Report& report) {
        treedyn::hard::Case(file, data, report, is_strict).check();
      });
}
