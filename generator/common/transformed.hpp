// What is made of the items of a list, one by one.
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace treedyn {

/// `of` every item, in their order. \param of  a function of an item, or a member
/// \tparam Value  void: what `of` returns
template <class Value = void, class Items, class Of>
auto transformed(const Items& items, Of of) {
  using Made = std::remove_cvref_t<std::invoke_result_t<Of&, decltype(*std::begin(items))>>;
  std::vector<std::conditional_t<std::is_void_v<Value>, Made, Value>> result;
  result.reserve(static_cast<std::size_t>(std::size(items)));
  for (const auto& item : items) {
    result.emplace_back(std::invoke(of, item));
  }
  return result;
}

}  // namespace treedyn
