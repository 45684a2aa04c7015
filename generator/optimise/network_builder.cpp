#include "optimise/network_builder.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "common/error.hpp"
#include "optimise/kept.hpp"
#include "program/interpret.hpp"

namespace treedyn::optimise {

namespace {

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 29U);
}

std::uint64_t hash_operands(Kind kind, std::span<const Ref> operands) {
  std::uint64_t hash = static_cast<std::uint64_t>(kind) + 1;
  for (const Ref operand : operands) {
    hash = mix(hash, static_cast<std::uint32_t>(operand));
  }
  return hash;
}

std::uint64_t hash_leaf(const Item& leaf) {
  const std::uint64_t element =
      leaf.kind == Kind::kInput ? static_cast<std::uint32_t>(leaf.size) : 0;
  return mix(mix(static_cast<std::uint64_t>(leaf.kind) + 1, static_cast<std::uint32_t>(leaf.first)),
             element);
}

bool by_magnitude(Ref a, Ref b) {
  return std::abs(a) != std::abs(b) ? std::abs(a) < std::abs(b) : a < b;
}

/// The table of the last builder that is gone: soon the next one comes.
struct SpareTable {
  std::vector<Ref> table;
};

}  // namespace

NetworkBuilder::NetworkBuilder(std::shared_ptr<ConstantTable> constants, std::size_t expected)
    : network_(std::move(constants)) {
  network_.reserve(expected, 3 * expected);
  table_.swap(kept_by_thread<SpareTable>().table);
  table_.assign(std::bit_ceil(std::max<std::size_t>(64, 2 * expected)), 0);
}

NetworkBuilder::~NetworkBuilder() { table_.swap(kept_by_thread<SpareTable>().table); }

std::uint64_t NetworkBuilder::hash_of(Ref item) const {
  const Item& known = network_.item(item);
  return known.kind == Kind::kConstant || known.kind == Kind::kInput
             ? hash_leaf(known)
             : hash_operands(known.kind, network_.operands(item));
}

void NetworkBuilder::grow() {
  std::vector<Ref> old(2 * table_.size(), 0);
  old.swap(table_);
  for (const Ref item : old) {
    if (item != 0) {
      std::size_t slot = hash_of(item) & (table_.size() - 1);
      while (table_[slot] != 0) {
        slot = (slot + 1) & (table_.size() - 1);
      }
      table_[slot] = item;
    }
  }
}

template <class Equal, class Append>
Ref NetworkBuilder::find(std::uint64_t hash, Equal equal, Append append) {
  if (2 * static_cast<std::size_t>(network_.size()) > table_.size()) {
    grow();
  }
  std::size_t slot = hash & (table_.size() - 1);
  for (; table_[slot] != 0; slot = (slot + 1) & (table_.size() - 1)) {
    if (equal(table_[slot])) {
      return table_[slot];
    }
  }
  return table_[slot] = append();
}

Ref NetworkBuilder::find_or_append(Kind kind, std::span<const Ref> operands, int position) {
  return find(
      hash_operands(kind, operands),
      [&](Ref known) {
        return network_.item(known).kind == kind &&
               std::ranges::equal(network_.operands(known), operands);
      },
      [&] { return network_.append(kind, operands, position); });
}

Ref NetworkBuilder::leaf(const Item& leaf) {
  return find(
      hash_leaf(leaf),
      [&](Ref k) {
        const Item& known = network_.item(k);
        return known.kind == leaf.kind && known.first == leaf.first &&
               (known.kind == Kind::kConstant || known.size == leaf.size);
      },
      [&] { return network_.append_leaf(leaf); });
}

Ref NetworkBuilder::constant(const Real& value) {
  if (value == 0) {
    return 0;
  }
  const Ref magnitude = leaf({Kind::kConstant, network_.constants().find_or_add(abs(value)), 0, 0});
  return value < 0 ? -magnitude : magnitude;
}

/// x + x becomes 2 x, x - x vanishes.
void NetworkBuilder::merge_equal_terms(std::vector<Ref>& terms) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < terms.size();) {
    const Ref x = std::abs(terms[i]);
    int count = 0;
    for (; i < terms.size() && std::abs(terms[i]) == x; ++i) {
      count += terms[i] < 0 ? -1 : 1;
    }
    Ref term = x;
    if (std::abs(count) > 1) {
      std::vector<Ref> factors{constant(Real(std::abs(count))), x};
      term = product(factors, kNoPosition);
    }
    if (count != 0) {
      terms[kept++] = count < 0 ? -term : term;
    }
  }
  terms.resize(kept);
}

/// Replaces the constants by their sum.
void NetworkBuilder::add_constants(std::vector<Ref>& terms) {
  Real total = 0;
  Real scale = 0;
  std::erase_if(terms, [&](Ref term) {
    if (!network_.is_constant(term)) {
      return false;
    }
    const Real& value = network_.magnitude(term);
    total += term < 0 ? Real(-value) : value;
    scale = larger(scale, value);
    return true;
  });
  if (!negligible(total, scale)) {
    terms.push_back(constant(total));
  }
}

/// Of terms in order: true if nothing is to be merged.
bool NetworkBuilder::are_canonical(const std::vector<Ref>& terms) const {
  const auto is_constant = [&](Ref term) {
    return network_.is_constant(term);
  };
  const auto are_equal = [](Ref a, Ref b) {
    return std::abs(a) == std::abs(b);
  };
  return std::ranges::adjacent_find(terms, are_equal) == terms.end() &&
         std::ranges::count_if(terms, is_constant) < 2;
}

Ref NetworkBuilder::sum(std::vector<Ref>& terms, int position) {
  std::erase(terms, 0);
  if (!std::ranges::is_sorted(terms, by_magnitude)) {
    std::ranges::sort(terms, by_magnitude);
  }
  while (!are_canonical(terms)) {
    merge_equal_terms(terms);
    add_constants(terms);
    std::ranges::sort(terms, by_magnitude);
  }
  if (terms.size() < 2) {
    return terms.empty() ? 0 : terms.front();
  }
  const bool negative = terms.front() < 0;
  if (negative) {
    std::ranges::for_each(terms, [](Ref& term) { term = -term; });
  }
  const Ref result = find_or_append(Kind::kAdd, terms, position);
  return negative ? -result : result;
}

/// Merges the constants among ascending positive factors. False if there was nothing to merge.
bool NetworkBuilder::multiply_constants(std::vector<Ref>& factors) {
  int index = -1;
  int count = 0;
  for (const Ref factor : factors) {
    if (network_.is_constant(factor)) {
      ++count;
      const int next = network_.item(factor).first;
      index = index < 0 ? next : network_.constants().product(index, next);
    }
  }
  const bool is_one = count > 0 && network_.constants().value(index) == 1;
  if (count < 2 && !is_one) {
    return false;
  }
  std::erase_if(factors, [&](Ref factor) { return network_.is_constant(factor); });
  if (!is_one || factors.empty()) {
    factors.push_back(leaf({Kind::kConstant, index, 0, 0}));
  }
  return true;
}

/// c1 (c2 x): the factors c1, c2, x. False for other products.
bool NetworkBuilder::unpack_scaled(std::vector<Ref>& factors) const {
  const Ref scaled = network_.is_constant(factors[0]) ? factors[1] : factors[0];
  const auto inner = network_.operands(scaled);
  if (!(network_.is_constant(factors[0]) || network_.is_constant(factors[1])) ||
      network_.item(scaled).kind != Kind::kMultiply || inner.size() != 2 ||
      !(network_.is_constant(inner[0]) || network_.is_constant(inner[1]))) {
    return false;
  }
  const Ref constant = factors[0] + factors[1] - scaled;
  factors = {constant, inner[0], inner[1]};
  return true;
}

Ref NetworkBuilder::product(std::vector<Ref>& factors, int position) {
  bool negative = false;
  for (Ref& factor : factors) {
    if (factor == 0) {
      return 0;
    }
    negative = negative != (factor < 0);
    factor = std::abs(factor);
  }
  const bool scaled =
      std::ranges::any_of(factors, [&](Ref factor) { return network_.is_constant(factor); });
  if (scaled && !multiply_constants(factors) && factors.size() == 2 && unpack_scaled(factors)) {
    multiply_constants(factors);
  }
  std::ranges::sort(factors);
  TREEDYN_EXPECT(!factors.empty());
  const Ref result =
      factors.size() == 1 ? factors.front() : find_or_append(Kind::kMultiply, factors, position);
  return negative ? -result : result;
}

Ref NetworkBuilder::quotient(Ref a, Ref b, int position) {
  TREEDYN_EXPECT(b != 0);
  if (a == 0) {
    return 0;
  }
  if (std::abs(a) == std::abs(b)) {
    return constant((a < 0) == (b < 0) ? 1 : -1);
  }
  if (network_.is_constant(b)) {
    std::vector<Ref> factors{a, constant(1 / network_.magnitude(b))};
    const Ref result = product(factors, position);
    return b < 0 ? -result : result;
  }
  const Ref operands[] = {std::abs(a), std::abs(b)};
  const Ref result = find_or_append(Kind::kDivide, operands, position);
  return (a < 0) != (b < 0) ? -result : result;
}

Ref NetworkBuilder::function(Kind kind, Ref a, int position) {
  if (a == 0) {
    return kind == Kind::kCos ? constant(1) : 0;
  }
  if (network_.is_constant(a)) {  // made so by terms that cancelled
    const Real& magnitude = network_.magnitude(a);
    const Real x = a < 0 ? Real(-magnitude) : magnitude;
    return constant(program::elementary(kind, x));
  }
  const bool even = kind == Kind::kCos;
  const bool odd = kind == Kind::kSin;
  const Ref operand = even || odd ? std::abs(a) : a;
  const Ref result = find_or_append(kind, std::span(&operand, 1), position);
  return odd && a < 0 ? -result : result;
}

Network NetworkBuilder::finish(std::vector<Ref> outputs) {
  network_.outputs() = std::move(outputs);
  return std::move(network_);
}

}  // namespace treedyn::optimise
