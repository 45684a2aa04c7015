#include <algorithm>
#include <cstdlib>

#include "optimise/kept.hpp"
#include "optimise/passes.hpp"

namespace treedyn::optimise {

namespace {

/// Operands further apart than this in one list are not paired.
constexpr std::size_t kNearCandidates = 48;
constexpr int kMostRounds = 30;

/// Operand pair of an item; x <= |y|, y negative if a sum has them with different signs.
struct Pair {
  Ref x = 0;
  Ref y = 0;
  int item = 0;
  [[nodiscard]] std::uint64_t key() const {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U) |
           static_cast<std::uint32_t>(y);
  }
};

/// All items with one pair: a range of the sorted pairs.
struct Group {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::uint64_t rank = 0;
};

Pair make_pair(Ref a, Ref b, int item) {
  if (std::abs(b) < std::abs(a)) {
    std::swap(a, b);
  }
  return a < 0 ? Pair{-a, -b, item} : Pair{a, b, item};
}

/// Kept for the next network.
struct SharingLists {
  std::vector<int> count;
  std::vector<Pair> pairs;
  std::vector<Group> groups;
  std::vector<Ref> candidates;
  std::vector<int> items;
};

class Sharing {
 public:
  Sharing(Network& network, Kind kind, std::uint64_t seed)
      : network_(network), kind_(kind), seed_(seed) {}

  int run() {
    int saved = 0;
    for (int round = 0; round < kMostRounds; ++round) {
      const int gain = share_round();
      saved += gain;
      if (gain == 0) {
        break;
      }
    }
    return saved;
  }

 private:
  void count_operands();
  void collect();
  void add_pairs(const std::vector<Ref>& candidates, int item);
  void group();
  int share_round();
  int share_group(const Group& group);
  int replace(const std::vector<int>& items, Ref x, Ref y);
  /// The places of the pair in an item, or false.
  bool find(int item, Ref x, Ref y, std::size_t& i, std::size_t& j) const;

  Network& network_;
  Kind kind_;
  std::uint64_t seed_;
  SharingLists& lists_ = kept_by_thread<SharingLists>();
  std::vector<int>& count_ = lists_.count;
  std::vector<Pair>& pairs_ = lists_.pairs;
  std::vector<Group>& groups_ = lists_.groups;
};

/// In how many items of this kind an operand occurs.
void Sharing::count_operands() {
  count_.assign(static_cast<std::size_t>(network_.size()), 0);
  for (int k = 1; k < network_.size(); ++k) {
    if (network_.item(k).kind == kind_) {
      for (const Ref operand : network_.operands(k)) {
        ++count_[program::node_index(operand)];
      }
    }
  }
}

void Sharing::collect() {
  pairs_.clear();
  std::vector<Ref>& candidates = lists_.candidates;
  for (int k = 1; k < network_.size(); ++k) {
    if (network_.item(k).kind != kind_) {
      continue;
    }
    candidates.clear();
    for (const Ref operand : network_.operands(k)) {
      if (count_[program::node_index(operand)] > 1) {
        candidates.push_back(operand);
      }
    }
    add_pairs(candidates, k);
  }
}

void Sharing::add_pairs(const std::vector<Ref>& candidates, int item) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(candidates.size(), i + kNearCandidates); ++j) {
      if (kind_ == Kind::kMultiply || std::abs(candidates[i]) != std::abs(candidates[j])) {
        pairs_.push_back(make_pair(candidates[i], candidates[j], item));
      }
    }
  }
}

void Sharing::group() {
  std::ranges::sort(pairs_, [](const Pair& p, const Pair& q) {
    return p.key() != q.key() ? p.key() < q.key() : p.item < q.item;
  });
  const auto same = [](const Pair& p, const Pair& q) {
    return p.key() == q.key() && p.item == q.item;
  };
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end(), same), pairs_.end());
  groups_.clear();
  for (std::size_t i = 0; i < pairs_.size();) {
    std::size_t j = i + 1;
    while (j < pairs_.size() && pairs_[j].key() == pairs_[i].key()) {
      ++j;
    }
    if (j - i > 1) {
      groups_.push_back({i, j, tie(pairs_[i].key(), seed_)});
    }
    i = j;
  }
  std::ranges::sort(groups_, [](const Group& a, const Group& b) {
    const std::size_t na = a.end - a.begin;
    const std::size_t nb = b.end - b.begin;
    return na != nb ? na > nb : a.rank < b.rank;
  });
}

bool Sharing::find(int item, Ref x, Ref y, std::size_t& i, std::size_t& j) const {
  const auto operands = network_.operands(item);
  for (i = 0; i < operands.size() && std::abs(operands[i]) != x; ++i) {
  }
  for (j = 0; j < operands.size() && (j == i || std::abs(operands[j]) != std::abs(y)); ++j) {
  }
  return i < operands.size() && j < operands.size() &&
         ((operands[i] < 0) != (operands[j] < 0)) == (y < 0);
}

/// Replaces the pair in all items by one item; returns the operations saved.
int Sharing::replace(const std::vector<int>& items, Ref x, Ref y) {
  const auto two = std::ranges::find_if(items, [&](int k) { return network_.item(k).size == 2; });
  const Ref pair[] = {x, y};
  const int shared = two != items.end() ? *two : network_.append(kind_, pair);
  const auto saved = static_cast<int>(items.size()) - 1;
  std::size_t i = 0;
  std::size_t j = 0;
  find(shared, x, y, i, j);
  const bool negative = network_.operands(shared)[i] < 0;
  for (const int k : items) {
    if (k == shared) {
      continue;
    }
    find(k, x, y, i, j);
    const auto operands = network_.operands(k);
    operands[i] = (operands[i] < 0) != negative ? -shared : shared;
    std::swap(operands[j], operands.back());
    network_.shorten(k, network_.item(k).size - 1);
  }
  return saved;
}

/// Shares a pair if all its items still have it; a later round takes the others.
int Sharing::share_group(const Group& group) {
  const Pair& pair = pairs_[group.begin];
  std::vector<int>& items = lists_.items;
  items.clear();
  for (std::size_t p = group.begin; p < group.end; ++p) {
    std::size_t i = 0;
    std::size_t j = 0;
    if (!find(pairs_[p].item, pair.x, pair.y, i, j)) {
      return 0;
    }
    items.push_back(pairs_[p].item);
  }
  return replace(items, pair.x, pair.y);
}

int Sharing::share_round() {
  count_operands();
  collect();
  group();
  int saved = 0;
  for (const Group& group : groups_) {
    saved += share_group(group);
  }
  return saved;
}

}  // namespace

int share_pairs(Network& network, Kind kind, std::uint64_t seed) {
  return Sharing(network, kind, seed).run();
}

}  // namespace treedyn::optimise
