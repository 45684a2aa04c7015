#include "accuracy/states.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/transformed.hpp"
#include "program/random.hpp"

namespace treedyn::accuracy {

namespace {

/// The float in the range next to a number in it.
double in_float(double x, double low, double high) {
  auto value = static_cast<float>(x);
  if (static_cast<double>(value) > high) {
    value = std::nextafter(value, -std::numeric_limits<float>::infinity());
  } else if (static_cast<double>(value) < low) {
    value = std::nextafter(value, std::numeric_limits<float>::infinity());
  }
  return static_cast<double>(value);
}

/// A seed for every argument of every state.
std::uint64_t seed(const std::string& argument, int number) {
  std::uint64_t result = static_cast<std::uint64_t>(number) + 1;
  for (const char c : argument) {
    result = program::scramble(result ^ static_cast<unsigned char>(c));
  }
  return result;
}

std::string names(const std::vector<std::string>& joints, std::size_t of) {
  const std::vector<std::string> words = transformed(joints, shown);
  return joints.size() == of ? "any joint" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

States::States(const model::Tree& tree) : dof_(static_cast<std::size_t>(tree.dof())) {
  for (const int k : tree.coordinates) {
    const model::Joint& joint = tree.links[static_cast<std::size_t>(k)].joint;
    const model::Limits& limits = joint.limits;
    const auto bound = [&](const std::optional<Real>& limit, std::vector<std::string>& without) {
      const double value = limit ? std::abs(static_cast<double>(*limit)) : 0;
      if (value == 0) {
        without.push_back(joint.name);
      }
      return value == 0 ? Range{} : Range{-value, value};
    };
    const double usual = joint.turns() ? std::numbers::pi : 1;
    joints_.push_back(joint.name);
    turns_.push_back(joint.turns());
    const Range between{limits.lower ? static_cast<double>(*limits.lower) : 0,
                        limits.upper ? static_cast<double>(*limits.upper) : 0};
    const bool stated = limits.lower && limits.upper && between.low < between.high;
    position_.push_back(stated ? between : Range{-usual, usual});
    if (!stated) {
      without_position_.push_back(joint.name);
    }
    speed_.push_back(bound(limits.velocity, without_speed_));
    effort_.push_back(bound(limits.effort, without_effort_));
  }
}

const std::vector<States::Range>* States::ranges_of(const std::string& argument) const {
  return argument == "q"                        ? &position_
         : argument == "qd"                     ? &speed_
         : argument == "tau" || argument == "b" ? &effort_
                                                : nullptr;
}

Inputs States::operator()(const program::Signature& signature, int number) const {
  Inputs result;
  for (const program::Array& array : signature.inputs) {
    const std::vector<Range>* const ranges = ranges_of(array.name);
    program::Random random(seed(array.name, number));
    std::vector<double> values;
    for (std::size_t i = 0; i < static_cast<std::size_t>(array.size); ++i) {
      const Range range = ranges == nullptr ? Range{} : (*ranges)[i];
      const double part = (random.symmetric() + 1) / 2;
      values.push_back(
          in_float(range.low + part * (range.high - range.low), range.low, range.high));
    }
    result.push_back(std::move(values));
  }
  return result;
}

std::vector<Interval> States::ranges(const program::Signature& signature) const {
  std::vector<Interval> result;
  for (const program::Array& array : signature.inputs) {
    const std::vector<Range>* const ranges = ranges_of(array.name);
    for (std::size_t i = 0; i < static_cast<std::size_t>(array.size); ++i) {
      const Range range = ranges == nullptr ? Range{} : (*ranges)[i];
      result.push_back(outwards(range.low, range.high));
    }
  }
  return result;
}

bool States::is_assumed(const std::string& argument, std::size_t i, bool as_it_is) const {
  const std::vector<std::string>* const without = argument == "q"    ? &without_position_
                                                  : argument == "qd" ? &without_speed_
                                                  : ranges_of(argument) != nullptr
                                                      ? &without_effort_
                                                      : nullptr;
  if (without == nullptr) {
    return true;
  }
  const bool stated = std::find(without->begin(), without->end(), joints_[i]) == without->end();
  return !stated && !(argument == "q" && turns_[i] && !as_it_is);
}

std::string States::assumed(const program::Signature& signature, const Dependence& on) const {
  std::vector<std::string> words;
  int first = 0;
  for (const program::Array& array : signature.inputs) {
    std::vector<std::string> joints;
    for (int i = 0; i < array.size; ++i) {
      const auto n = static_cast<std::size_t>(i);
      if (on.inputs.contains(first + i) &&
          is_assumed(array.name, n, on.as_they_are.contains(first + i))) {
        joints.push_back(n < dof_ ? joints_[n] : "");
      }
    }
    first += array.size;
    if (!joints.empty()) {
      words.push_back(ranges_of(array.name) == nullptr
                          ? array.name
                          : fmt::format("{} of {}", array.name, names(joints, dof_)));
    }
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string States::missing() const {
  std::vector<std::string> words;
  const auto add = [&](const std::vector<std::string>& joints, const char* what,
                       const char* instead) {
    if (!joints.empty()) {
      words.push_back(fmt::format("of {} for {} (taken: {})", what, names(joints, dof_), instead));
    }
  };
  add(without_position_, "position", "-pi to pi rad, -1 to 1 m");
  add(without_speed_, "speed", "-1 to 1 rad/s or m/s");
  add(without_effort_, "effort", "-1 to 1 N m or N");
  return words.empty() ? "" : fmt::format("the model states no limits {}", fmt::join(words, ", "));
}

}  // namespace treedyn::accuracy
