#include "block/pattern.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "common/index.hpp"

namespace treedyn::block {
namespace {

using Rows = std::vector<std::vector<int>>;

std::vector<int> row(const Pattern& a, int i) {
  std::vector<int> result;
  for (int block = a.begin(i); block < a.end(i); ++block) {
    result.push_back(a.column(block));
  }
  return result;
}

std::vector<int> positions(const std::vector<bool>& present) {
  std::vector<int> result;
  for (std::size_t j = 0; j < present.size(); ++j) {
    if (present[j]) {
      result.push_back(static_cast<int>(j));
    }
  }
  return result;
}

}  // namespace

Pattern::Pattern(int cols, const Rows& columns_of_row) : cols_(cols) {
  for (const std::vector<int>& columns : columns_of_row) {
    column_.insert(column_.end(), columns.begin(), columns.end());
    start_.push_back(static_cast<int>(column_.size()));
  }
}

int Pattern::find(int i, int j) const {
  const auto first = column_.begin() + begin(i);
  const auto last = column_.begin() + end(i);
  const auto found = std::lower_bound(first, last, j);
  return found != last && *found == j ? static_cast<int>(found - column_.begin()) : -1;
}

Pattern transpose(const Pattern& a) {
  Rows rows(to_index(a.cols()));
  a.visit([&](int i, int j, int) { rows[to_index(j)].push_back(i); });
  return {a.rows(), rows};
}

Pattern unite(const Pattern& a, const Pattern& b) {
  Rows rows(to_index(a.rows()));
  for (int i = 0; i < a.rows(); ++i) {
    const std::vector<int> x = row(a, i);
    const std::vector<int> y = row(b, i);
    std::ranges::set_union(x, y, std::back_inserter(rows[to_index(i)]));
  }
  return {a.cols(), rows};
}

Pattern product(const Pattern& a, const Pattern& b) {
  Rows rows(to_index(a.rows()));
  std::vector<bool> present(to_index(b.cols()));
  const auto mark_row = [&](int k, int /*block*/) {
    b.visit_row(k, [&](int j, int /*block*/) { present[to_index(j)] = true; });
  };
  for (int i = 0; i < a.rows(); ++i) {
    present.assign(present.size(), false);
    a.visit_row(i, mark_row);
    rows[to_index(i)] = positions(present);
  }
  return {b.cols(), rows};
}

Pattern diagonal(int n) {
  Rows rows(to_index(n));
  for (int i = 0; i < n; ++i) {
    rows[to_index(i)] = {i};
  }
  return {n, rows};
}

Pattern full(int rows, int cols) {
  std::vector<int> all(to_index(cols));
  std::iota(all.begin(), all.end(), 0);
  return {cols, Rows(to_index(rows), all)};
}

Pattern reachability(const Index& index) {
  Rows rows(to_index(index.links()));
  for (int i = 0; i < index.links(); ++i) {
    const int f = index.father[to_index(i)];
    if (f >= 0) {
      rows[to_index(i)] = rows[to_index(f)];  // fathers come first, so the columns ascend
    }
    rows[to_index(i)].push_back(i);
  }
  return {index.links(), rows};
}

std::string to_text(const Pattern& pattern) {
  std::string result;
  for (int i = 0; i < pattern.rows(); ++i) {
    std::string line(to_index(pattern.cols()), '.');
    for (const int j : row(pattern, i)) {
      line[to_index(j)] = 'x';
    }
    result += line + '\n';
  }
  return result;
}

}  // namespace treedyn::block
