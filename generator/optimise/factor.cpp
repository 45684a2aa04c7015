#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "optimise/passes.hpp"

namespace treedyn::optimise {

namespace {

/// Term number `term` of a sum has the factor `factor`.
struct Occurrence {
  Ref factor = 0;
  int term = 0;
  bool saves = false;  ///< the product exists for this sum alone, so a multiplication vanishes
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const Occurrence&) const = default;
};

class Factoring {
 public:
  Factoring(Network& network, std::uint64_t seed)
      : network_(network), uses_(uses(network)), seed_(seed) {}

  int run() {
    int saved = 0;
    for (int k = 1; k < network_.size(); ++k) {  // includes the sums that this loop appends
      while (network_.item(k).kind == Kind::kAdd && uses_[program::node_index(k)] > 0) {
        const int gain = factor_once(k);
        if (gain == 0) {
          break;
        }
        saved += gain;
      }
    }
    return saved;
  }

 private:
  void collect(int sum);
  int best_group(std::size_t& begin, std::size_t& end) const;
  int factor_once(int sum);
  Ref without(Ref term, Ref factor);
  int append(Kind kind, std::span<const Ref> operands) {
    uses_.push_back(1);
    return network_.append(kind, operands);
  }

  Network& network_;
  std::vector<int> uses_;
  std::uint64_t seed_;
  std::vector<Occurrence> found_;
};

/// The factors of all terms, equal factors together.
void Factoring::collect(int sum) {
  found_.clear();
  const auto terms = network_.operands(sum);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Ref term = std::abs(terms[i]);
    const int number = static_cast<int>(i);
    if (network_.item(term).kind != Kind::kMultiply || uses_[program::node_index(term)] != 1) {
      found_.push_back({term, number, false});
      continue;
    }
    const auto factors = network_.operands(term);
    for (std::size_t f = 0; f < factors.size(); ++f) {
      if (std::find(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(f),
                    factors[f]) == factors.begin() + static_cast<std::ptrdiff_t>(f)) {
        found_.push_back({factors[f], number, true});
      }
    }
  }
  std::ranges::sort(found_);
}

/// The range of occurrences that saves most; the number of multiplications saved.
int Factoring::best_group(std::size_t& begin, std::size_t& end) const {
  int best = 0;
  std::tuple<int, int, std::uint64_t> best_rank{};
  for (std::size_t i = 0; i < found_.size();) {
    std::size_t j = i;
    int gain = -1;
    for (; j < found_.size() && found_[j].factor == found_[i].factor; ++j) {
      gain += found_[j].saves ? 1 : 0;
    }
    const Ref factor = found_[i].factor;
    const std::tuple rank{gain, network_.is_constant(factor) ? 0 : 1,
                          ~tie(static_cast<std::uint64_t>(factor), seed_)};
    if (gain > 0 && (best == 0 || rank > best_rank)) {
      best = gain;
      best_rank = rank;
      begin = i;
      end = j;
    }
    i = j;
  }
  return best;
}

/// What remains of a term: the other factors, or one.
Ref Factoring::without(Ref term, Ref factor) {
  const Ref sign = term < 0 ? -1 : 1;
  if (std::abs(term) == factor) {
    uses_.push_back(1);
    return sign * network_.append_constant(1);
  }
  auto factors = network_.operands(term);
  const auto place = std::ranges::find(factors, factor);
  std::rotate(place, place + 1, factors.end());
  network_.shorten(term, network_.item(term).size - 1);
  return sign * (network_.item(term).size == 1 ? network_.operands(term).front() : std::abs(term));
}

int Factoring::factor_once(int sum) {
  collect(sum);
  std::size_t begin = 0;
  std::size_t end = 0;
  const int gain = best_group(begin, end);
  if (gain == 0) {
    return 0;
  }
  const Ref factor = found_[begin].factor;
  std::vector<Ref> inner;
  std::vector<Ref> outer(network_.operands(sum).begin(), network_.operands(sum).end());
  for (std::size_t i = begin; i < end; ++i) {
    Ref& term = outer[static_cast<std::size_t>(found_[i].term)];
    inner.push_back(without(term, factor));
    term = 0;
  }
  std::erase(outer, 0);
  const Ref product[] = {factor, append(Kind::kAdd, inner)};
  if (outer.empty()) {
    network_.set_operands(sum, product);
    network_.set_kind(sum, Kind::kMultiply);
  } else {
    outer.push_back(append(Kind::kMultiply, product));
    network_.set_operands(sum, outer);
  }
  return gain;
}

}  // namespace

int factor_sums(Network& network, std::uint64_t seed) { return Factoring(network, seed).run(); }

}  // namespace treedyn::optimise
