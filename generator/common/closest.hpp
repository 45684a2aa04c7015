// "did you mean": the known word that a mistyped one is closest to.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/transformed.hpp"

namespace treedyn {

bool is_known(std::string_view word, const std::vector<std::string_view>& known);

/// The known word that differs from `word` by at most two letters that are wrong, missing, added or
/// exchanged with their neighbour (one in words of up to four letters); the first of the closest;
/// empty if there is none. Words of more than 64 bytes resemble none.
std::string closest(std::string_view word, const std::vector<std::string_view>& known);

/// " (did you mean 'x'?)", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

/// "a, b, ..", as messages show them, at most eight.
std::string some_names(const std::vector<std::string_view>& all);

/// The member `name` of every item; the views are into the list.
template <class List>
std::vector<std::string_view> names_of(const List& list) {
  return transformed(list, [](const auto& item) -> std::string_view { return item.name; });
}

/// The first item whose member `name` that is.
template <class List>
std::optional<int> index_of(const List& list, std::string_view name) {
  const auto found =
      std::ranges::find_if(list, [name](const auto& item) { return item.name == name; });
  return found == list.end() ? std::nullopt : std::optional(static_cast<int>(found - list.begin()));
}

}  // namespace treedyn
