#include "optimise/constants.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace treedyn::optimise {

int ConstantTable::find_or_add(const Real& value) {
  TREEDYN_EXPECT(value >= 0 && value != 0);
  const auto key = static_cast<double>(value.seen());
  for (auto it = table_.lower_bound(key * (1 - 1e-14));
       it != table_.end() && it->first <= key * (1 + 1e-14); ++it) {
    if (identical(this->value(it->second), value)) {
      return it->second;
    }
  }
  const auto index = static_cast<int>(values_.size());
  values_.push_back(value);
  table_.emplace(key, index);
  return index;
}

int ConstantTable::product(int a, int b) {
  const auto [place, is_new] = products_.try_emplace(std::minmax(a, b), 0);
  if (is_new) {
    place->second = find_or_add(value(a) * value(b));
  }
  return place->second;
}

}  // namespace treedyn::optimise
