// Ascending lists as sets.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace treedyn {

/// What is in a or in b. \pre ascending; O(n)
inline std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> result;
  std::ranges::set_union(a, b, std::back_inserter(result));
  return result;
}

/// What is in a, but not in b. \pre ascending; O(n)
inline std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> result;
  std::ranges::set_difference(a, b, std::back_inserter(result));
  return result;
}

}  // namespace treedyn
