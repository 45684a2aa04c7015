// hard_cases [--scalar double|float] [--strict] [--except ID]... DIR...: `expected` of the case
// files, hard_cases/SCHEMA.md, against the simulator in double or the generated step and functions
// in float.

#include <algorithm>
#include <iostream>
#include <set>

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

/// How the program was called.
struct Options {
  std::string scalar = "double";
  bool strict = false;
  std::set<std::string> except;  ///< cases that are left out, by id
  std::vector<std::string> folders;
};

/// One case under test.
class Case {
 public:
  Case(const std::filesystem::path& file, const Json& data, Report& report, const Options& options)
      : options_(options),
        tolerance_("tol_" + options.scalar),
        scene_(description::read_scene(file.string())),
        source_(options.scalar == "float" ? generated_source("float") : simulator_source()),
        run_(scene_, *source_),
        data_(data),
        report_(report) {}

  void check() {
    std::vector<Json> entries = data_.at("expected").get<std::vector<Json>>();
    std::stable_sort(entries.begin(), entries.end(), [this](const Json& a, const Json& b) {
      return time_of(a, run_) < time_of(b, run_);
    });
    for (const Json& entry : entries) {
      if (entry.contains(tolerance_) && !entry.at(tolerance_).is_null()) {
        check_entry(entry);
      }
    }
    report_.note(options_.scalar, checked_ > 0 ? "worst/tolerance" : "NOTHING ASKED", worst_, 1);
    report_.remark(source_->cost());
  }

 private:
  void check_entry(const Json& entry) {
    const auto name = entry.at("quantity").get<std::string>();
    std::optional<Values> values;
    if (const Special special = special_quantity(name)) {
      values = special(scene_, *source_, entry);
    } else {
      run_.advance_to(time_of(entry, run_));
      values = known_quantity(name, entry, scene_, run_);
    }
    if (!values) {
      unchecked(name);
      return;
    }
    ++checked_;
    const double error = error_of(entry, *values, support::flat(entry.at("value")));
    const double tolerance = entry.at(tolerance_).get<double>();
    worst_ = std::max(worst_, error == 0 ? 0 : error / tolerance);
    report_.note(options_.scalar, name, error, tolerance);
  }

  void unchecked(const std::string& name) {
    if (options_.strict) {
      report_.fail(fmt::format("{} is not checked", name));
    } else {
      report_.note(options_.scalar, name + " unchecked", 0, 0);
    }
  }

  const Options& options_;
  std::string tolerance_;
  model::Scene scene_;
  std::unique_ptr<Source> source_;
  Run run_;
  const Json& data_;
  Report& report_;
  double worst_ = 0;
  int checked_ = 0;
};

/// Nothing for words that are neither options nor folders.
std::optional<Options> options_of(const std::vector<std::string>& words) {
  Options result;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "--strict") {
      result.strict = true;
    } else if (words[k] == "--scalar" && k + 1 < words.size()) {
      result.scalar = words[++k];
    } else if (words[k] == "--except" && k + 1 < words.size()) {
      result.except.insert(words[++k]);
    } else if (!words[k].starts_with("--")) {
      result.folders.push_back(words[k]);
    } else {
      return std::nullopt;
    }
  }
  const bool known = result.scalar == "double" || result.scalar == "float";
  return known ? std::optional(result) : std::nullopt;
}

}  // namespace
}  // namespace treedyn::hard

int main(int argc, char** argv) {
  const auto options = treedyn::hard::options_of({argv + 1, argv + argc});
  if (!options) {
    std::cerr << "hard_cases: expected --scalar double|float, --strict, --except ID and folders\n";
    return 2;
  }
  return treedyn::support::run_cases(
      options->folders, [&](const std::filesystem::path& file, const treedyn::support::Json& data,
                            treedyn::support::Report& report) {
        if (options->except.contains(file.stem().string())) {
          report.note(options->scalar, "LEFT OUT", 0, 0);
        } else {
          treedyn::hard::Case(file, data, report, *options).check();
        }
      });
}
