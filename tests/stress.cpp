// stress [--minutes M] [--seed S] [--robots K] [--keep DIR]: generated code of random robots and
// constraints with parameters over twelve decades, in double and float, against 50 digits.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "stress/batch.hpp"
#include "support/process.hpp"

namespace treedyn::stress {
namespace {

/// Robots of one translation unit.
constexpr int kBatch = 20;
constexpr int kDecades = 12;
/// Relative change of all parameters and inputs by which conditions are measured, and how often.
const Real kChange("1e-15");
constexpr int kChanges = 6;
/// Every value passes through so many roundings at most for every joint; each counts as one change
/// of a parameter or an input by a unit roundoff.
constexpr double kRoundings = 10;
/// A pivot this many unit roundoffs large can be told from zero.
constexpr double kPivot = 1000;

struct Options {
  double minutes = 0;  ///< 0: `robots` robots
  std::uint64_t seed = 1;
  int robots = kBatch;
  std::string keep;
};

/// An error in units of what `kRoundings` roundings may make.
struct Worst {
  double ratio = 0;
  std::string function;
  std::string values;  ///< of the element: found, true, condition
};

double unit(const std::string& scalar) {
  return scalar == "float" ? static_cast<double>(std::numeric_limits<float>::epsilon()) / 2
                           : std::numeric_limits<double>::epsilon() / 2.0;
}

/// Values in 50 digits and, for every element, its change when all numbers change by 1 of
/// themselves, to first order, and the sizes of what is added up on the way.
struct Truth {
  Results value;
  Results condition;
};

Truth truth_of(const Robot& robot) {
  Truth truth{reference(robot), {}};
  for (const auto& [name, values] : truth.value) {
    truth.condition[name] = Values(values.size(), 0);
  }
  support::Dice dice(7);
  for (int k = 0; k < kChanges; ++k) {
    const Results changed = reference(perturbed(robot, kChange, dice));
    for (auto& [name, condition] : truth.condition) {
      for (std::size_t i = 0; i < condition.size(); ++i) {
        const Real change = abs(changed.at(name)[i] - truth.value[name][i]) / kChange;
        condition[i] = std::max(condition[i], change);
      }
    }
  }
  for (const auto& [name, values] : sizes(robot, truth.value)) {
    Values& condition = truth.condition.at(name);
    std::transform(condition.begin(), condition.end(), values.begin(), condition.begin(),
                   [](const Real& a, const Real& b) { return a + b; });
  }
  return truth;
}

Worst worst_of(const Robot& robot, const Truth& truth, const Batch& batch,
               const std::string& scalar) {
  Worst worst;
  const double rounding = kRoundings * static_cast<double>(robot.q.size()) * unit(scalar);
  const double tiny =
      scalar == "float" ? static_cast<double>(std::numeric_limits<float>::min()) : 1e-290;
  for (const std::string& name : kFunctions) {
    const std::vector<double> x = batch.call(robot, name);
    const Values& y = truth.value.at(name);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Real allowed = rounding * (truth.condition.at(name)[k] + abs(y[k])) + tiny;
      const double ratio =
          std::isfinite(x[k]) ? static_cast<double>(Real(abs(x[k] - y[k]) / allowed)) : HUGE_VAL;
      if (!(ratio <= worst.ratio)) {
        worst = {ratio, name,
                 fmt::format("{}: {:.9g}, in truth {:.9g}, condition {:.3g}", k, x[k],
                             static_cast<double>(y[k]),
                             static_cast<double>(truth.condition.at(name)[k]))};
      }
    }
  }
  return worst;
}

bool is_decidable(const Robot& robot, const std::string& scalar) {
  return smallest_pivot(robot) > kPivot * static_cast<double>(robot.q.size()) * unit(scalar) &&
         is_consistent(robot);
}

struct Found {
  Robot robot;
  std::string scalar;
  Worst worst;
};

/// The worst of one robot, compiled alone.
Worst alone(const Robot& robot, const std::string& scalar) {
  return is_decidable(robot, scalar)
             ? worst_of(robot, truth_of(robot), Batch({robot}, scalar), scalar)
             : Worst{};
}

/// Fewer links, constraints and springs, as long as the error stays beyond what is allowed.
Found minimised(Found found) {
  for (bool shrinks = true; shrinks;) {
    shrinks = false;
    for (const Robot& less : smaller(found.robot)) {
      const Worst worst = alone(less, found.scalar);
      if (worst.ratio > 1) {
        found = {less, found.scalar, worst};
        shrinks = true;
        break;
      }
    }
  }
  return found;
}

class Stress {
 public:
  explicit Stress(const Options& options) : options_(options), dice_(options.seed) {}

  int run() {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 60;
    };
    while (options_.minutes > 0 ? elapsed() < options_.minutes : made_ < options_.robots) {
      one_batch();
    }
    report();
    return found_.empty() && compared_ > 0 ? 0 : 1;
  }

 private:
  void one_batch() {
    std::vector<Robot> robots;
    for (int k = 0; k < kBatch; ++k) {
      robots.push_back(consistent(fmt::format("r{}_{}", options_.seed, made_++)));
    }
    for (const std::string scalar : {"double", "float"}) {
      std::vector<Robot> some;
      std::copy_if(robots.begin(), robots.end(), std::back_inserter(some),
                   [&](const Robot& robot) { return is_decidable(robot, scalar); });
      skipped_ += robots.size() - some.size();
      compare(some, scalar);
    }
  }

  /// Without the constraints that no motion meets together.
  Robot consistent(const std::string& name) {
    Robot robot = random_robot(name, kDecades, dice_);
    while (!is_consistent(robot)) {
      robot.scene.constraints.pop_back();
      robot.scene.phases.front().active.pop_back();
    }
    return robot;
  }

  void compare(const std::vector<Robot>& robots, const std::string& scalar) {
    const Batch batch(robots, scalar);
    for (const Robot& robot : robots) {
      const Worst worst = worst_of(robot, truth_of(robot), batch, scalar);
      ++compared_;
      Worst& largest = largest_[scalar];
      largest = worst.ratio > largest.ratio ? worst : largest;
      if (!(worst.ratio <= 1)) {
        std::cout << fmt::format("{} in {}: {} errs by {:.2g} times what is allowed: {}",
                                 robot.name, scalar, worst.function, worst.ratio, worst.values)
                  << std::endl;
        found_.push_back({robot, scalar, worst});
      }
    }
  }

  void report() {
    for (const auto& [scalar, worst] : largest_) {
      std::cout << fmt::format("{}: at most {:.2g} of what is allowed, in {}\n", scalar,
                               worst.ratio, worst.function);
    }
    std::cout << fmt::format("{} compared, {} left out: rows that rounding decides, {} failed\n",
                             compared_, skipped_, found_.size());
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return a.worst.ratio > b.worst.ratio; });
    for (std::size_t k = 0; !options_.keep.empty() && k < std::min<std::size_t>(found_.size(), 5);
         ++k) {
      keep(minimised(found_[k]));
    }
  }

  void keep(const Found& found) const {
    const Truth truth = truth_of(found.robot);
    const std::string& name = kFunctions.back();
    Real size = 0;
    for (std::size_t k = 0; k < found.robot.q.size(); ++k) {
      size = std::max(size, Real(truth.condition.at(name)[k] + abs(truth.value.at(name)[k])));
    }
    const Real roundings = kRoundings * Real(found.robot.q.size());
    const std::filesystem::path file =
        std::filesystem::path(options_.keep) / (found.robot.name + ".json");
    support::write_file(
        file, case_text(found.robot, truth.value.at(name),
                        fmt::format("stress: {} in {} errs by {:.2g} times what is allowed",
                                    found.worst.function, found.scalar, found.worst.ratio),
                        roundings * size * unit("double"), roundings * size * unit("float")));
    std::cout << fmt::format("{}: {} links, {} in {}, {:.2g}\n", file.string(),
                             found.robot.q.size(), found.worst.function, found.scalar,
                             found.worst.ratio);
  }

  Options options_;
  support::Dice dice_;
  int made_ = 0;
  std::size_t compared_ = 0;
  std::size_t skipped_ = 0;
  std::map<std::string, Worst> largest_;
  std::vector<Found> found_;
};

/// Nothing for words that are not options.
std::optional<Options> options_of(const std::vector<std::string>& words) {
  Options result;
  if (words.size() % 2 != 0) {
    return std::nullopt;
  }
  for (std::size_t k = 0; k < words.size(); k += 2) {
    const std::string& value = words[k + 1];
    if (words[k] == "--minutes") {
      result.minutes = std::stod(value);
    } else if (words[k] == "--seed") {
      result.seed = std::stoull(value);
    } else if (words[k] == "--robots") {
      result.robots = std::stoi(value);
    } else if (words[k] == "--keep") {
      result.keep = value;
    } else {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace
}  // namespace treedyn::stress

int main(int argc, char** argv) {
  try {
    const auto options = treedyn::stress::options_of({argv + 1, argv + argc});
    if (options) {
      return treedyn::stress::Stress(*options).run();
    }
    std::cerr << "stress: expected --minutes M, --seed S, --robots K, --keep DIR\n";
  } catch (const std::exception& error) {
    std::cerr << "stress: " << error.what() << '\n';
  }
  return 2;
}
