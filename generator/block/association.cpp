#include "block/association.hpp"

#include "common/index.hpp"

namespace treedyn::block {
namespace {

constexpr long long kNever = 1LL << 50;

struct Partial {
  Factor matrix;
  long long cost = 0;
  int last_of_left = 0;
};

long long terms(const Pattern& a, const Pattern& b) {
  long long result = 0;
  for (int block = 0; block < a.blocks(); ++block) {
    result += b.end(a.column(block)) - b.begin(a.column(block));
  }
  return result;
}

int scalar_products(const Factor& a, const Factor& b) {
  const int a_size = a.height * a.width;
  const int b_size = b.height * b.width;
  return a_size == 1 ? b_size : b_size == 1 ? a_size : a.height * a.width * b.width;
}

/// \return `kNever` if numbers that the size rule blows up are not yet numbers
long long cost(const Factor& a, const Factor& b) {
  const bool has_number = a.height * a.width == 1 || b.height * b.width == 1;
  if (!has_number && a.width != b.height) {
    return kNever;
  }
  if (a.path_sum || b.path_sum) {
    return a.path_sum ? b.pattern.blocks() : a.pattern.blocks();
  }
  return terms(a.pattern, b.pattern) * scalar_products(a, b);
}

Factor multiplied(const Factor& a, const Factor& b) {
  return {product(a.pattern, b.pattern), a.height * a.width == 1 ? b.height : a.height,
          b.height * b.width == 1 ? a.width : b.width, false};
}

class Table {
 public:
  explicit Table(const std::vector<Factor>& factors) : n_(static_cast<int>(factors.size())) {
    entries_.resize(to_index(n_ * n_));
    for (int i = 0; i < n_; ++i) {
      entry(i, i).matrix = factors[to_index(i)];
    }
    for (int length = 2; length <= n_; ++length) {
      for (int first = 0; first + length <= n_; ++first) {
        fill(first, first + length - 1);
      }
    }
  }

  void collect(int first, int last, std::vector<Split>& order) {
    if (first == last) {
      return;
    }
    const int middle = entry(first, last).last_of_left;
    collect(first, middle, order);
    collect(middle + 1, last, order);
    order.push_back({first, middle + 1});
  }

 private:
  Partial& entry(int first, int last) { return entries_[to_index(first * n_ + last)]; }

  void fill(int first, int last) {
    Partial& best = entry(first, last);
    best.cost = -1;
    for (int middle = last - 1; middle >= first; --middle) {
      const Partial& left = entry(first, middle);
      const Partial& right = entry(middle + 1, last);
      const long long total = left.cost + right.cost + cost(left.matrix, right.matrix);
      if (best.cost < 0 || total < best.cost) {
        best.cost = total;
        best.last_of_left = middle;
      }
    }
    const int middle = best.last_of_left;
    best.matrix = multiplied(entry(first, middle).matrix, entry(middle + 1, last).matrix);
  }

  int n_;
  std::vector<Partial> entries_;
};

}  // namespace

std::vector<Split> associate(const std::vector<Factor>& factors) {
  std::vector<Split> order;
  Table(factors).collect(0, static_cast<int>(factors.size()) - 1, order);
  return order;
}

}  // namespace treedyn::block
