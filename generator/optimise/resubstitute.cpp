#include "optimise/resubstitute.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "common/index.hpp"
#include "optimise/samples.hpp"

namespace treedyn::optimise {

namespace {

/// In networks of more items the search for pairs ends where it has found none for so many items
/// in a row; fewer, by the cube of the size, in larger ones: none beyond 63000.
constexpr int kManyItems = 4000;
/// Pairs of operands are tried in sums and products of at most so many.
constexpr std::size_t kLongestShortened = 24;
/// A sum may be this much smaller than its terms.
constexpr double kMostCancellation = 16;

/// The items that outputs need, operands first; operands may come after users in the network.
std::vector<int> order_of_evaluation(const Network& network) {
  std::vector<bool> seen(to_index(network.size()), false);
  std::vector<int> order;
  std::vector<int> stack;
  const auto open = [&](Ref a) {
    if (a != 0 && !seen[program::node_index(a)]) {
      stack.push_back(std::abs(a));
    }
  };
  std::ranges::for_each(network.outputs(), open);
  while (!stack.empty()) {
    const int k = stack.back();
    if (!seen[program::node_index(k)]) {
      seen[program::node_index(k)] = true;
      stack.push_back(-k);  // its operands first
      std::ranges::for_each(network.operands(k), open);
      continue;
    }
    stack.pop_back();
    if (k < 0) {
      order.push_back(-k);
    }
  }
  return order;
}

class Resubstitution {
 public:
  Resubstitution(Network& network, Quotients quotients, double amplification)
      : network_(network), samples_(network), most_amplification_(amplification) {
    if (quotients == Quotients::kApart) {
      note_quotients();
    }
    for (int k = 0; k < network.size(); ++k) {
      reference_.push_back(samples_.errors(k));
      has_recipes_ |= k > 0 && network.is_constant(k) && network.magnitude(k).recipe() != 0;
    }
  }

  int run();

 private:
  [[nodiscard]] Sample sample(Ref a) const { return samples_.sample(a); }
  /// True if `item` instead of k does not amplify rounding.
  [[nodiscard]] bool is_accurate(int item, int k) const {
    return within(samples_.errors(item), reference_[program::node_index(k)], most_amplification_);
  }
  /// An item that pays and is free of cycles as an operand of a new form of `k`.
  Ref find_operand(double first, double second, int k);
  void note_quotients();
  /// True if k is no quotient, nor made of one, and `item` is.
  [[nodiscard]] bool brings_quotient(int k, int item) const {
    return !of_quotient_.empty() && !of_quotient_[program::node_index(k)] &&
           of_quotient_[program::node_index(item)];
  }
  bool may_use(int k, int item);
  int exclusive_operations(int k);
  void mark_dependents(int k);

  bool replace_equal(int k);
  bool replace_by_pair(int k);
  bool shorten(int k);
  [[nodiscard]] bool may_pair(int k, int x) const;
  std::optional<Ref> pair_for(int k, int x);
  std::optional<Ref> sum_for(int k, int x, int sign);
  std::optional<Ref> product_for(int k, int x);
  std::optional<Ref> multiple_for(int k, int x);
  bool sets_operands(int k, std::span<const Ref> operands);
  void replace(int k, Ref value);
  void refresh();
  std::optional<Ref> append(Kind kind, std::array<Ref, 2> operands, int k);

  Network& network_;
  SampleTable samples_;
  double most_amplification_;
  std::vector<ErrorBounds> reference_;  ///< of the items at the start
  std::vector<int> order_;              ///< of evaluation
  std::vector<int> uses_;
  std::vector<bool> of_quotient_;  ///< of the items at the start; empty: it does not matter
  std::vector<bool> exclusive_;    ///< needed by the item at hand alone
  std::vector<bool> dependent_;    ///< needs the item at hand
  int marked_ = 0;                 ///< the item that dependent_ belongs to
  bool has_recipes_ = false;       ///< some numbers are known at run time only
};

/// After operands have changed.
void Resubstitution::refresh() {
  order_ = order_of_evaluation(network_);
  samples_.update_errors(order_);
  uses_.assign(to_index(network_.size()), 0);
  const auto use = [this](Ref a) {
    ++uses_[program::node_index(a)];
  };
  std::ranges::for_each(network_.outputs(), use);
  for (const int k : order_) {
    std::ranges::for_each(network_.operands(k), use);
  }
  marked_ = 0;
}

void Resubstitution::mark_dependents(int k) {
  if (marked_ == k) {
    return;
  }
  marked_ = k;
  dependent_.assign(to_index(network_.size()), false);
  dependent_[program::node_index(k)] = true;
  for (const int item : order_) {
    if (std::ranges::any_of(network_.operands(item), [this](Ref operand) {
          return dependent_[program::node_index(operand)];
        })) {
      dependent_[program::node_index(item)] = true;
    }
  }
}

void Resubstitution::note_quotients() {
  of_quotient_.assign(to_index(network_.size()), false);
  for (const int k : order_of_evaluation(network_)) {
    of_quotient_[program::node_index(k)] =
        network_.item(k).kind == Kind::kDivide ||
        std::ranges::any_of(network_.operands(k), [this](Ref operand) {
          return of_quotient_[program::node_index(operand)];
        });
  }
}

bool Resubstitution::may_use(int k, int item) {
  if (brings_quotient(k, item) || exclusive_[program::node_index(item)] ||
      (uses_[program::node_index(item)] == 0 && !network_.operands(item).empty())) {
    return false;
  }
  mark_dependents(k);
  return !dependent_[program::node_index(item)];
}

Ref Resubstitution::find_operand(double first, double second, int k) {
  return samples_.find(first, second, [&](int item) { return may_use(k, item); });
}

/// The operations that vanish with `k`; marks the items, k first, that only k needs.
int Resubstitution::exclusive_operations(int k) {
  exclusive_.assign(to_index(network_.size()), false);
  std::vector<std::size_t> used;  // and not any more
  std::vector<int> open{k};
  exclusive_[program::node_index(k)] = true;
  int total = 0;
  while (!open.empty()) {
    const int item = open.back();
    open.pop_back();
    total += program::is_arithmetic(network_.item(item).kind) ? network_.item(item).size - 1 : 0;
    for (const Ref operand : network_.operands(item)) {
      if (operand == 0) {
        continue;
      }
      const std::size_t at = program::node_index(operand);
      used.push_back(at);
      if (--uses_[at] == 0 && !network_.operands(operand).empty()) {
        exclusive_[at] = true;
        open.push_back(std::abs(operand));
      }
    }
  }
  std::ranges::for_each(used, [this](std::size_t at) { ++uses_[at]; });
  return total;
}

/// A new form of k, unless it amplifies rounding.
std::optional<Ref> Resubstitution::append(Kind kind, std::array<Ref, 2> operands, int k) {
  bool negative = false;
  if (kind == Kind::kMultiply) {
    negative = (operands[0] < 0) != (operands[1] < 0);
    operands = {std::abs(operands[0]), std::abs(operands[1])};
  }
  const int made = network_.append(kind, operands, network_.item(k).position);
  if (!of_quotient_.empty()) {
    of_quotient_.resize(to_index(made) + 1, false);
    of_quotient_.back() = std::ranges::any_of(
        operands, [this](Ref operand) { return of_quotient_[program::node_index(operand)]; });
  }
  samples_.append(made);
  if (!is_accurate(made, k)) {
    return std::nullopt;
  }
  return negative ? -made : made;
}

/// The users of k use `value` instead: k becomes a sum of one term.
void Resubstitution::replace(int k, Ref value) {
  network_.set_kind(k, Kind::kAdd);
  network_.set_operands(k, std::span(&value, 1));
  refresh();
}

/// Uses an earlier item with the same value. \pre operands come before users
bool Resubstitution::replace_equal(int k) {
  Ref same = 0;
  if (!samples_.is_zero(k)) {
    same = samples_.find(samples_.fast(k)[0], samples_.fast(k)[1], [&](int item) {
      return item < k && is_accurate(item, k) && !brings_quotient(k, item);
    });
    if (same == 0 || !identical(sample(same), sample(k))) {
      return false;
    }
  }
  network_.set_kind(k, Kind::kAdd);
  network_.set_operands(k, std::span(&same, 1));
  return true;
}

std::optional<Ref> Resubstitution::sum_for(int k, int x, int sign) {
  const auto& a = samples_.fast(k);
  const auto& b = samples_.fast(x);
  if (std::abs(b[0]) > kMostCancellation * std::abs(a[0]) ||
      std::abs(b[1]) > kMostCancellation * std::abs(a[1])) {
    return std::nullopt;
  }
  const Ref y = find_operand(a[0] - sign * b[0], a[1] - sign * b[1], k);
  if (y == 0 || program::node_index(y) == program::node_index(x) || !may_use(k, x) ||
      !identical(sample(y) + sample(sign * x), sample(k))) {
    return std::nullopt;
  }
  return append(Kind::kAdd, {sign * x, y}, k);
}

std::optional<Ref> Resubstitution::product_for(int k, int x) {
  const auto& a = samples_.fast(k);
  const auto& b = samples_.fast(x);
  if (b[0] == 0 || b[1] == 0) {
    return std::nullopt;
  }
  const Ref y = find_operand(a[0] / b[0], a[1] / b[1], k);
  if (y == 0 || !may_use(k, x) || !identical(sample(y) * sample(x), sample(k))) {
    return std::nullopt;
  }
  return append(Kind::kMultiply, {x, y}, k);
}

std::optional<Ref> Resubstitution::multiple_for(int k, int x) {
  const auto& a = samples_.fast(k);
  const auto& b = samples_.fast(x);
  if (b[0] == 0 || b[1] == 0 || !close(a[0] * b[1], a[1] * b[0]) || network_.is_constant(x) ||
      !may_use(k, x)) {
    return std::nullopt;
  }
  const Real ratio = sample(k).first / sample(x).first;
  if (has_recipes_ && !identical(ratio.plain(), Real(ratio.seen()))) {
    return std::nullopt;  // it may be another one at run time, or have no bounds
  }
  if (!identical(Real(ratio * sample(x).second), sample(k).second)) {
    return std::nullopt;
  }
  const int constant = network_.append_constant(abs(ratio));
  samples_.append(constant);
  return append(Kind::kMultiply, {ratio < 0 ? -constant : constant, x}, k);
}

/// False only if `pair_for` finds nothing: without a branch, since it is asked of all pairs.
bool Resubstitution::may_pair(int k, int x) const {
  const auto& a = samples_.fast(k);
  const auto& b = samples_.fast(x);
  unsigned found = samples_.may_find(a[0] - b[0]);
  found |= samples_.may_find(a[0] + b[0]);
  found |= samples_.may_find(a[0] / b[0]);  // infinite or no number by zero: `pair_for` refuses it
  found |= close(a[0] * b[1], a[1] * b[0]);
  return found != 0;
}

std::optional<Ref> Resubstitution::pair_for(int k, int x) {
  for (const int sign : {1, -1}) {
    if (const auto sum = sum_for(k, x, sign)) {
      return sum;
    }
  }
  if (const auto product = product_for(k, x)) {
    return product;
  }
  return multiple_for(k, x);
}

/// Changes nothing if that would amplify rounding.
bool Resubstitution::sets_operands(int k, std::span<const Ref> operands) {
  const std::vector<Ref> old(network_.operands(k).begin(), network_.operands(k).end());
  network_.set_operands(k, operands);
  samples_.update_errors(std::span(&k, 1));
  if (is_accurate(k, k)) {
    return true;
  }
  network_.set_operands(k, old);
  samples_.update_errors(std::span(&k, 1));
  return false;
}

/// Two terms of a long sum, or factors of a long product, that have the value of another item.
bool Resubstitution::shorten(int k) {
  const Kind kind = network_.item(k).kind;
  const std::vector<Ref> operands(network_.operands(k).begin(), network_.operands(k).end());
  if ((kind != Kind::kAdd && kind != Kind::kMultiply) || operands.size() < 3 ||
      operands.size() > kLongestShortened) {
    return false;
  }
  exclusive_.assign(to_index(network_.size()), false);
  for (std::size_t i = 0; i < operands.size(); ++i) {
    for (std::size_t j = i + 1; j < operands.size(); ++j) {
      const Sample a = sample(operands[i]);
      const Sample b = sample(operands[j]);
      const Sample value = kind == Kind::kAdd ? a + b : a * b;
      const Ref same = find_operand(static_cast<double>(value.first.seen()),
                                    static_cast<double>(value.second.seen()), k);
      if (same == 0 || !identical(sample(same), value) || (kind == Kind::kMultiply && same < 0)) {
        continue;
      }
      std::vector<Ref> rest = operands;
      rest[i] = same;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
      if (sets_operands(k, rest)) {
        refresh();
        return true;
      }
    }
  }
  return false;
}

/// k from one operation on two others, if k costs more.
bool Resubstitution::replace_by_pair(int k) {
  const int known = samples_.known();
  for (int x = 1; x <= known; ++x) {
    if (!may_pair(k, x) || x == k || exclusive_[program::node_index(x)] || samples_.is_zero(x)) {
      continue;  // a zero has no multiples: its sample is rounding
    }
    if (const auto value = pair_for(k, x)) {
      replace(k, *value);
      return true;
    }
  }
  return false;
}

int Resubstitution::run() {
  const int known = samples_.known();
  int replaced = 0;
  for (int k = 1; k <= known; ++k) {
    replaced += !network_.operands(k).empty() && replace_equal(k) ? 1 : 0;
  }
  refresh();
  for (int k = 1; k <= known; ++k) {
    while (uses_[program::node_index(k)] > 0 && shorten(k)) {
      ++replaced;
    }
  }
  const double crowd = std::max(1.0, static_cast<double>(known) / kManyItems);
  const int patience = static_cast<int>(kManyItems / (crowd * crowd * crowd));
  for (int k = 1, left = patience; k <= known && left > 0; ++k) {
    if (uses_[program::node_index(k)] > 0 && exclusive_operations(k) > 1) {
      const bool pays = replace_by_pair(k);
      replaced += pays ? 1 : 0;
      left = pays ? patience : left - 1;
    }
  }
  return replaced;
}

}  // namespace

int resubstitute(Network& network, Quotients quotients, double amplification) {
  return Resubstitution(network, quotients, amplification).run();
}

}  // namespace treedyn::optimise
