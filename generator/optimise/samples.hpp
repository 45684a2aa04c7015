// Values of the items of a network at two pseudo-random points.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "common/index.hpp"
#include "optimise/network.hpp"
#include "optimise/rounding_guard.hpp"

namespace treedyn::optimise {

/// A value at two points.
struct Sample {
  Real first = 0;
  Real second = 0;
  Sample operator-() const { return {-first, -second}; }
  friend Sample operator+(const Sample& a, const Sample& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Sample operator*(const Sample& a, const Sample& b) {
    return {a.first * b.first, a.second * b.second};
  }
  friend Sample operator/(const Sample& a, const Sample& b) {
    return {a.first / b.first, a.second / b.second};
  }
};

inline bool identical(const Sample& a, const Sample& b) {
  return identical(a.first, b.first) && identical(a.second, b.second);
}

/// Equal but for rounding in double: by this part.
inline constexpr double kTolerance = 1e-13;
inline bool close(double a, double b) { return std::abs(a - b) <= kTolerance * std::abs(b); }

/// The samples of all items, and a table to find items by them.
class SampleTable {
 public:
  /// \pre `network` is normalised; it outlives the table
  explicit SampleTable(const Network& network);

  /// Takes in item `k`, which was appended to the network; `find` does not find it.
  void append(int k);
  [[nodiscard]] Sample sample(Ref a) const {
    const Sample& found = samples_[program::node_index(a)];
    return a < 0 ? -found : found;
  }
  /// The sample of an item, in double.
  [[nodiscard]] const std::array<double, 2>& fast(int k) const { return fast_[to_index(k)]; }
  /// What rounding in double leaves in the item, as it is computed now.
  [[nodiscard]] const ErrorBounds& errors(Ref a) const { return errors_[program::node_index(a)]; }
  /// After operands have changed. \param order  items in use, operands before their users
  void update_errors(std::span<const int> order);
  /// True if the value is zero but for rounding at 50 digits: somewhere in it sums cancel
  /// completely.
  [[nodiscard]] bool is_zero(Ref a) const { return zero_[program::node_index(a)]; }
  /// The number of items that `find` can find: 1 to this.
  [[nodiscard]] int known() const { return static_cast<int>(table_.size()); }
  /// False only if `find` finds nothing with this first value: most searches end here.
  [[nodiscard]] bool may_find(double first) const {
    return present_[bit_of(leading_bits(std::abs(first)))];
  }
  /// The first item with the given values or their negatives that passes `accept(item)`, or 0.
  template <class Accept>
  Ref find(double first, double second, Accept accept) const;

 private:
  /// Magnitude at the first point, to search by.
  struct Entry {
    double magnitude = 0;
    int item = 0;
  };
  /// Magnitudes that share exponent and 22 leading bits, by the last of these bits.
  static constexpr std::size_t kBits = std::size_t{1} << 18U;
  static std::uint64_t leading_bits(double magnitude) {
    return std::bit_cast<std::uint64_t>(magnitude) >> 30U;
  }
  static std::size_t bit_of(std::uint64_t leading) {
    return static_cast<std::size_t>(leading) & (kBits - 1);
  }
  void note_magnitude(double magnitude);
  [[nodiscard]] Sample evaluate(int k) const;
  [[nodiscard]] double error_at(std::size_t point, int k) const;
  [[nodiscard]] bool vanishes(int k) const;
  [[nodiscard]] bool is_rounding(int k) const;

  const Network& network_;
  std::vector<Sample> samples_;
  std::vector<std::array<double, 2>> fast_;
  std::vector<ErrorBounds> errors_;
  std::vector<bool> zero_;
  std::vector<Entry> table_;
  /// By `bit_of`: a magnitude in the table is close to one that has it.
  std::vector<bool> present_;
};

template <class Accept>
Ref SampleTable::find(double first, double second, Accept accept) const {
  if (!may_find(first)) {
    return 0;
  }
  const double least = std::abs(first) * (1 - kTolerance);
  const double most = std::abs(first) * (1 + kTolerance);
  auto it = std::ranges::lower_bound(table_, least, {}, &Entry::magnitude);
  for (; it != table_.end() && it->magnitude <= most; ++it) {
    const auto& known = fast(it->item);
    const bool negative = (known[0] < 0) != (first < 0);
    if (close(second, negative ? -known[1] : known[1]) && accept(it->item)) {
      return negative ? -it->item : it->item;
    }
  }
  return 0;
}

}  // namespace treedyn::optimise
