#include "support/cases.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <iostream>
#include <limits>

#include <fmt/format.h>

#include "support/process.hpp"

namespace treedyn::support {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> case_files(const std::vector<std::string>& folders) {
  std::vector<fs::path> result;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder)) {
      std::cerr << "no folder " << folder << '\n';
      return {};
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") {
        files.push_back(entry.path());
      }
    }
    std::sort(files.begin(), files.end());
    result.insert(result.end(), files.begin(), files.end());
  }
  return result;
}

Report run_case(const fs::path& file, const Check& check) {
  Report report;
  try {
    check(file, Json::parse(read_file(file)), report);
  } catch (const std::exception& error) {
    report.fail(error.what());
  }
  return report;
}

/// The reports of files[k], files[k + jobs], files[k + 2 jobs], ..
void run_share(const std::vector<fs::path>& files, const Check& check, std::size_t first,
               std::size_t jobs, std::vector<std::promise<Report>>& reports) {
  for (std::size_t k = first; k < files.size(); k += jobs) {
    reports[k].set_value(run_case(files[k], check));
  }
}

}  // namespace

double max_abs(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) {
    result = std::isnan(value) ? value : std::max(result, std::fabs(value));
  }
  return result;
}

double error_of(const std::vector<double>& x, const std::vector<double>& y,
                const Tolerance& tolerance) {
  double largest = x.size() == y.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
    const double error = std::fabs(x[k] - y[k]);
    largest = error <= std::numeric_limits<double>::max() ? std::max(largest, error)
                                                          : std::numeric_limits<double>::infinity();
  }
  const double scale = max_abs(y);
  return scale < tolerance.floor ? largest : largest / scale;
}

std::vector<double> flat(const Json& list) {
  if (!list.is_array()) {
    return {list.get<double>()};
  }
  std::vector<double> result;
  for (const Json& item : list) {
    const std::vector<double> part = flat(item);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

void Report::compare(const std::string& source, const std::string& quantity,
                     const std::vector<double>& x, const std::vector<double>& expected,
                     const Tolerance& tolerance) {
  const bool small = max_abs(expected) < tolerance.floor;
  note(source, quantity, error_of(x, expected, tolerance),
       small ? tolerance.absolute : tolerance.relative);
}

void Report::note(const std::string& source, const std::string& quantity, double error,
                  double largest) {
  const auto known = std::find_if(errors_.begin(), errors_.end(),
                                  [&](const auto& entry) { return entry.first == quantity; });
  if (known == errors_.end()) {
    errors_.emplace_back(quantity, error);
  } else {
    known->second = std::max(known->second, error);
  }
  if (!(error <= largest)) {
    fail(fmt::format("{}: {} differs by {:.2g}, allowed {:.2g}", source, quantity, error, largest));
  }
}

std::string Report::text(const std::string& name) const {
  std::string result = fmt::format("{} {:<24}", passed() ? "passed" : "FAILED", name);
  for (const auto& [quantity, error] : errors_) {
    result += fmt::format("  {} {:.1e}", quantity, error);
  }
  result += remark_.empty() ? "" : fmt::format("  [{}]", remark_);
  for (const std::string& failure : failures_) {
    result += "\n       " + failure;
  }
  return result;
}

int run_cases(const std::vector<std::string>& arguments, const Check& check, unsigned jobs) {
  const std::vector<fs::path> files = case_files(arguments);
  std::vector<std::promise<Report>> reports(files.size());
  std::vector<std::future<void>> workers;
  for (unsigned k = 0; k < jobs; ++k) {
    workers.push_back(
        std::async(std::launch::async, [&, k] { run_share(files, check, k, jobs, reports); }));
  }
  std::size_t passed = 0;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Report report = reports[k].get_future().get();
    passed += report.passed() ? 1U : 0U;
    std::cout << report.text(files[k].stem().string()) << std::endl;
  }
  std::cout << passed << " passed, " << files.size() - passed << " failed" << std::endl;
  return passed == files.size() && passed > 0 ? 0 : 1;
}

}  // namespace treedyn::support
