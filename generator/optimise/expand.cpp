#include <cstdlib>

#include "optimise/passes.hpp"

namespace treedyn::optimise {

namespace {

/// Longer sums are not multiplied out.
constexpr int kLongestSum = 8;

/// Operand number `place` of `user` can be taken apart: merged into the user, or multiplied out.
struct Choice {
  int user = 0;
  int place = 0;
};

class Expansion {
 public:
  explicit Expansion(Network& network) : network_(network) { collect(uses(network)); }

  void expand(Random& random) {
    if (choices_.empty()) {
      return;
    }
    const int pick = random.below(static_cast<int>(choices_.size()));
    const Choice choice = choices_[static_cast<std::size_t>(pick)];
    if (choice.place < 0) {
      multiply_out(choice.user, random);
    } else if (choice.place < network_.item(choice.user).size) {
      merge(choice.user, choice.place);
    }
  }

 private:
  void collect(const std::vector<int>& count);
  void merge(int user, int place);
  void multiply_out(int product, Random& random);

  Network& network_;
  std::vector<Choice> choices_;
};

void Expansion::collect(const std::vector<int>& count) {
  for (int k = 1; k < network_.size(); ++k) {
    const Kind kind = network_.item(k).kind;
    if (count[static_cast<std::size_t>(k)] == 0 ||
        (kind != Kind::kAdd && kind != Kind::kMultiply)) {
      continue;
    }
    const auto operands = network_.operands(k);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const Item& operand = network_.item(operands[i]);
      if (operand.kind == kind) {
        choices_.push_back({k, static_cast<int>(i)});
      } else if (kind == Kind::kMultiply && operand.kind == Kind::kAdd &&
                 operand.size <= kLongestSum) {
        choices_.push_back({k, -1});
      }
    }
  }
}

/// Writes the operands of an operand of the same kind in its place.
void Expansion::merge(int user, int place) {
  std::vector<Ref> operands(network_.operands(user).begin(), network_.operands(user).end());
  const Ref part = operands[static_cast<std::size_t>(place)];
  if (network_.item(part).kind != network_.item(user).kind) {
    return;  // changed by an earlier step
  }
  operands.erase(operands.begin() + place);
  for (const Ref operand : network_.operands(part)) {
    operands.push_back(program::with_sign(operand, part));
  }
  network_.set_operands(user, operands);
}

/// x (a + b) becomes x a + x b, for one of the sums among the factors.
void Expansion::multiply_out(int product, Random& random) {
  std::vector<Ref> factors(network_.operands(product).begin(), network_.operands(product).end());
  std::vector<std::size_t> sums;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (network_.item(factors[i]).kind == Kind::kAdd) {
      sums.push_back(i);
    }
  }
  if (network_.item(product).kind != Kind::kMultiply || sums.empty()) {
    return;
  }
  const auto place = sums[static_cast<std::size_t>(random.below(static_cast<int>(sums.size())))];
  const Ref sum = factors[place];
  std::vector<Ref> terms(network_.operands(sum).begin(), network_.operands(sum).end());
  for (Ref& term : terms) {
    factors[place] = std::abs(term);
    term = program::with_sign(network_.append(Kind::kMultiply, factors), term);
  }
  network_.set_operands(product, terms);
  network_.set_kind(product, Kind::kAdd);
}

}  // namespace

void expand_at_random(Network& network, Random& random, int count) {
  Expansion expansion(network);
  for (int i = 0; i < count; ++i) {
    expansion.expand(random);
  }
}

}  // namespace treedyn::optimise
