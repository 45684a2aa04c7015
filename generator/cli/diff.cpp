#include "cli/diff.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "common/identifier.hpp"

namespace treedyn {

namespace {

using Lines = std::vector<std::string_view>;

constexpr std::ptrdiff_t kContext = 3;
/// Beyond so many changed lines the rest counts as replaced: time and memory grow with the square.
constexpr std::ptrdiff_t kMostChanges = 2000;

/// Lines with their line feeds.
Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t length = end == std::string_view::npos ? text.size() : end + 1;
    lines.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

/// Which lines of either text have no partner in the other one.
struct Marks {
  std::vector<bool> removed;
  std::vector<bool> added;
};

/// Myers' greedy search on old[begin, old_end) and new[begin, new_end).
class Search {
 public:
  Search(const Lines& a, const Lines& b) : a_(a), b_(b) {
    marks_.removed.assign(a.size(), false);
    marks_.added.assign(b.size(), false);
    while (begin_ < std::min(a.size(), b.size()) && a[begin_] == b[begin_]) {
      ++begin_;
    }
    std::size_t tail = 0;
    while (tail < std::min(a.size(), b.size()) - begin_ &&
           a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) {
      ++tail;
    }
    n_ = static_cast<std::ptrdiff_t>(a.size() - tail - begin_);
    m_ = static_cast<std::ptrdiff_t>(b.size() - tail - begin_);
  }

  Marks run() {
    const std::ptrdiff_t most = std::min(n_ + m_, kMostChanges);
    std::vector<std::ptrdiff_t> furthest(static_cast<std::size_t>(2 * most + 3), 0);
    const auto at = [&](std::ptrdiff_t k) -> std::ptrdiff_t& {
      return furthest[static_cast<std::size_t>(k + most + 1)];
    };
    std::vector<std::vector<std::ptrdiff_t>> history;
    for (std::ptrdiff_t d = 0; d <= most; ++d) {
      history.emplace_back(furthest.begin() + (most + 1 - d - 1),
                           furthest.begin() + (most + 2 + d + 1));
      for (std::ptrdiff_t k = -d; k <= d; k += 2) {
        const bool down = k == -d || (k != d && at(k - 1) < at(k + 1));
        std::ptrdiff_t x = down ? at(k + 1) : at(k - 1) + 1;
        while (x < n_ && x - k < m_ && same(x, x - k)) {
          ++x;
        }
        at(k) = x;
        if (x >= n_ && x - k >= m_) {
          trace_back(history, d);
          return std::move(marks_);
        }
      }
    }
    mark_all();
    return std::move(marks_);
  }

 private:
  [[nodiscard]] bool same(std::ptrdiff_t x, std::ptrdiff_t y) const {
    return x >= 0 && y >= 0 &&
           a_[begin_ + static_cast<std::size_t>(x)] == b_[begin_ + static_cast<std::size_t>(y)];
  }

  void mark_all() {
    const auto from = static_cast<std::ptrdiff_t>(begin_);
    std::fill_n(marks_.removed.begin() + from, n_, true);
    std::fill_n(marks_.added.begin() + from, m_, true);
  }

  /// history[d] holds the furthest x before round d on the diagonals -d-1 .. d+1.
  void trace_back(const std::vector<std::vector<std::ptrdiff_t>>& history, std::ptrdiff_t rounds) {
    std::ptrdiff_t x = n_;
    std::ptrdiff_t y = m_;
    for (std::ptrdiff_t d = rounds; d > 0; --d) {
      const auto& furthest = history[static_cast<std::size_t>(d)];
      const auto at = [&](std::ptrdiff_t k) {
        return furthest[static_cast<std::size_t>(k + d + 1)];
      };
      const std::ptrdiff_t k = x - y;
      const bool down = k == -d || (k != d && at(k - 1) < at(k + 1));
      const std::ptrdiff_t before_k = down ? k + 1 : k - 1;
      x = at(before_k);
      y = x - before_k;
      if (down) {
        marks_.added[begin_ + static_cast<std::size_t>(y)] = true;
      } else {
        marks_.removed[begin_ + static_cast<std::size_t>(x)] = true;
      }
    }
  }

  const Lines& a_;
  const Lines& b_;
  Marks marks_;
  std::size_t begin_ = 0;
  std::ptrdiff_t n_ = 0;
  std::ptrdiff_t m_ = 0;
};

/// One line of the diff before it is cut into hunks.
struct Edit {
  char sign;
  std::string_view line;
};

std::vector<Edit> edits(const Lines& a, const Lines& b) {
  const Marks marks = Search(a, b).run();
  std::vector<Edit> result;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && marks.removed[i]) {
      result.push_back({'-', a[i++]});
    } else if (j < b.size() && marks.added[j]) {
      result.push_back({'+', b[j++]});
    } else {
      result.push_back({' ', a[i++]});
      ++j;
    }
  }
  return result;
}

std::string range(std::size_t start, std::size_t count) {
  return count == 1 ? std::to_string(start + 1)
                    : fmt::format("{},{}", count == 0 ? start : start + 1, count);
}

/// The text of edits[begin, end), which start at these lines of the two texts.
std::string hunk(const std::vector<Edit>& edits, std::size_t begin, std::size_t end,
                 std::size_t old_line, std::size_t new_line) {
  std::string body;
  std::size_t old_count = 0;
  std::size_t new_count = 0;
  for (std::size_t k = begin; k < end; ++k) {
    old_count += edits[k].sign != '+' ? 1U : 0U;
    new_count += edits[k].sign != '-' ? 1U : 0U;
    body += edits[k].sign;
    body += edits[k].line;
    body += edits[k].line.ends_with('\n') ? "" : "\n\\ No newline at end of file\n";
  }
  return fmt::format("@@ -{} +{} @@\n{}", range(old_line, old_count), range(new_line, new_count),
                     body);
}

}  // namespace

std::string unified_diff(std::string_view old_text, std::string_view new_text,
                         const std::string& old_label, const std::string& new_label) {
  if (old_text == new_text) {
    return {};
  }
  const std::vector<Edit> all = edits(lines_of(old_text), lines_of(new_text));
  std::vector<bool> shown(all.size(), false);
  const auto size = static_cast<std::ptrdiff_t>(all.size());
  for (std::ptrdiff_t k = 0; k < size; ++k) {
    if (all[static_cast<std::size_t>(k)].sign != ' ') {
      std::fill(shown.begin() + std::max<std::ptrdiff_t>(k - kContext, 0),
                shown.begin() + std::min(k + kContext + 1, size), true);
    }
  }
  std::string result = fmt::format("--- {}\n+++ {}\n", old_label, new_label);
  std::size_t old_line = 0;
  std::size_t new_line = 0;
  for (std::size_t k = 0; k < all.size();) {
    std::size_t end = k;
    while (end < all.size() && shown[end]) {
      ++end;
    }
    if (end > k) {
      result += hunk(all, k, end, old_line, new_line);
    }
    for (end = std::max(end, k + 1); k < end; ++k) {
      old_line += all[k].sign != '+' ? 1U : 0U;
      new_line += all[k].sign != '-' ? 1U : 0U;
    }
  }
  return result;
}

namespace {

bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f'); }

/// Letters, digits, points and the signs of exponents from `begin` on: a number or a word.
std::size_t end_of_word(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  const bool number = is_digit(text[begin]);
  for (; end < text.size(); ++end) {
    const bool sign = number && (text[end] == '-' || text[end] == '+') && text[end - 1] == 'e';
    if (!is_word_byte(text[end]) && !sign && !(number && text[end] == '.')) {
      break;
    }
  }
  return std::max(end, begin + 1);
}

bool is_literal(std::string_view word) {
  constexpr std::size_t kSha256 = 64;
  const bool decimal =
      is_digit(word.front()) && word.find_first_of(".ex") != std::string_view::npos;
  return decimal || (word.size() == kSha256 && std::ranges::all_of(word, is_hexadecimal));
}

}  // namespace

std::string without_literals(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t sign = text.front() == '-' && text.size() > 1 && is_digit(text[1]) ? 1 : 0;
    const std::size_t end = end_of_word(text, sign);
    const std::string_view word = text.substr(0, end);
    result += is_literal(word.substr(sign)) ? std::string_view("#") : word;
    text.remove_prefix(end);
  }
  return result;
}

int changed_lines(std::string_view old_text, std::string_view new_text) {
  const std::vector<Edit> all = edits(lines_of(old_text), lines_of(new_text));
  const auto lines = [&](char sign) {
    return static_cast<int>(std::ranges::count(all, sign, &Edit::sign));
  };
  return std::max(lines('+'), lines('-'));
}

}  // namespace treedyn
