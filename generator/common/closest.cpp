#include "common/closest.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/decimal.hpp"

namespace treedyn {

namespace {

constexpr std::size_t kLongest = 64;

/// Damerau's distance of two words (optimal string alignment). \pre both have at most kLongest
/// bytes
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, kLongest + 1>, kLongest + 1> d{};
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + wrong});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

bool is_known(std::string_view word, const std::vector<std::string_view>& known) {
  return std::ranges::find(known, word) != known.end();
}

std::string closest(std::string_view word, const std::vector<std::string_view>& known) {
  std::string result;
  std::size_t least = word.size() <= 4 ? 2 : 3;
  for (const std::string_view other : known) {
    const bool comparable = word.size() > 1 && std::max(word.size(), other.size()) <= kLongest;
    const std::size_t far = comparable ? distance(word, other) : least;
    if (far < least) {
      least = far;
      result = other;
    }
  }
  return result;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string other = closest(word, known);
  return other.empty() ? "" : fmt::format(" (did you mean '{}'?)", shown(other));
}

std::string some_names(const std::vector<std::string_view>& all) {
  constexpr std::size_t kMost = 8;
  const auto shown_names = transformed(std::span(all).first(std::min(all.size(), kMost)), shown);
  return fmt::format("{}{}", fmt::join(shown_names, ", "), all.size() > kMost ? ", .." : "");
}

}  // namespace treedyn
