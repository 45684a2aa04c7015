// The frame of the data-driven programs of INTERFACE.md 6: folders of case files, one line a case.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace treedyn::support {

using Json = nlohmann::json;

/// |x - y| <= relative * max|y| over a quantity; |x - y| <= absolute where max|y| < `floor`.
struct Tolerance {
  double relative = 1e-12;
  double absolute = 1e-12;
  double floor = 1e-9;
};

double max_abs(const std::vector<double>& values);

/// max|x - y| / max|y|, or max|x - y| where max|y| < floor; infinity for different sizes or a NaN.
double error_of(const std::vector<double>& x, const std::vector<double>& y,
                const Tolerance& tolerance);

/// All numbers of a (nested) list, in order.
std::vector<double> flat(const Json& list);

/// What one case showed: the largest error of every quantity and what failed.
class Report {
 public:
  /// \param source    what computed `x`: "engine", "code"
  /// \param quantity  name of the quantity as the line shows it
  void compare(const std::string& source, const std::string& quantity, const std::vector<double>& x,
               const std::vector<double>& expected, const Tolerance& tolerance);
  /// An error that was computed already, and the largest that passes.
  void note(const std::string& source, const std::string& quantity, double error, double largest);
  /// How it was computed, at the end of the line.
  void remark(const std::string& text) { remark_ = text; }
  void fail(const std::string& message) { failures_.push_back(message); }
  [[nodiscard]] bool passed() const { return failures_.empty() && !errors_.empty(); }
  /// "passed c01_pendulum  A 1.1e-16  B 0", and one more line for everything that failed.
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  std::vector<std::pair<std::string, double>> errors_;
  std::vector<std::string> failures_;
  std::string remark_;
};

using Check = std::function<void(const std::filesystem::path& file, const Json& data, Report&)>;

/// Runs `check` on every *.json of the folders in `arguments` (sorted by name), `jobs` at a time,
/// and prints the reports in order and "N passed, N failed".
/// \return 0 if all passed and there was one, else 1; an exception fails its case.
int run_cases(const std::vector<std::string>& arguments, const Check& check, unsigned jobs = 1);

}  // namespace treedyn::support
