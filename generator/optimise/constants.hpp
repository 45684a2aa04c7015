// The numbers of a program, each stored once.
#pragma once

#include <map>
#include <vector>

#include "common/index.hpp"
#include "common/real.hpp"

namespace treedyn::optimise {

/// Positive numbers in order of their first appearance; two that agree to 38 digits are one.
class ConstantTable {
 public:
  /// The index of `value`. \pre it is seen as no negative number, and not 0
  int find_or_add(const Real& value);
  [[nodiscard]] const Real& value(int index) const { return values_[to_index(index)]; }
  [[nodiscard]] int size() const { return static_cast<int>(values_.size()); }
  /// The index of a product, kept because passes ask again and again.
  int product(int a, int b);

 private:
  std::vector<Real> values_;
  std::multimap<double, int> table_;
  std::map<std::pair<int, int>, int> products_;
};

}  // namespace treedyn::optimise
