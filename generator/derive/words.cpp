#include "derive/words.hpp"

#include <algorithm>

#include "block/print.hpp"
#include "block/rewrite.hpp"
#include "derive/columns.hpp"
#include "derive/value.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::Kind;
using Words = std::vector<Word>;

/// More words than asked for.
struct TooMany {};

/// "D-E" and "E-σ" are symbols of their own.
bool is_symbol(const Expression& e) {
  const std::string text = block::print(e);
  return text == "D - E" || text == "D^T - E" || text == "E - σ";
}

class Opener {
 public:
  explicit Opener(std::size_t most) : most_(most) {}

  [[nodiscard]] Words open(const Expression& e) const;

 private:
  [[nodiscard]] Words sum(const std::vector<Expression>& terms) const;
  [[nodiscard]] Words product(const std::vector<Expression>& factors) const;
  [[nodiscard]] Words skew(const Expression& e) const;

  std::size_t most_;
};

Words Opener::product(const std::vector<Expression>& factors) const {
  Words result = {{}};
  for (const Expression& f : factors) {
    const Words tails = open(f);
    if (result.size() * tails.size() > most_) {
      throw TooMany{};
    }
    Words longer;
    for (const Word& tail : tails) {
      for (const Word& head : result) {
        Word word = head;
        word.factor = multiply(head.factor, tail.factor);
        word.factors.insert(word.factors.end(), tail.factors.begin(), tail.factors.end());
        longer.push_back(std::move(word));
      }
    }
    result = std::move(longer);
  }
  return result;
}

void transpose(Word& word) {
  std::ranges::reverse(word.factors);
  for (Expression& f : word.factors) {
    f = f.kind() == Kind::kTranspose ? f.operands().front() : block::transpose(f);
  }
}

Words Opener::sum(const std::vector<Expression>& terms) const {
  Words result;
  for (const Expression& term : terms) {
    Words inner = open(term);
    if (result.size() + inner.size() > most_) {
      throw TooMany{};
    }
    std::move(inner.begin(), inner.end(), std::back_inserter(result));
  }
  return result;
}

/// R2: Λ stands at the only vector of a word.
Words Opener::skew(const Expression& e) const {
  Words result = open(e.operands().front());
  for (Word& word : result) {
    const auto vectors = std::ranges::count_if(word.factors, is_vector);
    const bool crossed = std::ranges::any_of(word.factors, [](const Expression& f) {
      return f.shape().rows.size == 3 && f.shape().cols.size == 3;
    });
    if (vectors != 1 || crossed) {
      return {{{}, {e}}};
    }
    const auto v = std::ranges::find_if(word.factors, is_vector);
    *v = e.kind() == Kind::kSkew ? block::skew(*v) : block::skew_transpose(*v);
  }
  return result;
}

Words Opener::open(const Expression& e) const {
  switch (e.kind()) {
    case Kind::kNamed:
      return open(e.operands().front());
    case Kind::kScaled: {
      Words result = open(e.operands().front());
      for (Word& word : result) {
        word.factor = multiply(word.factor, e.node().factor);
      }
      return result;
    }
    case Kind::kSum: {
      if (is_symbol(e)) {
        return {{{}, {e}}};
      }
      return sum(e.operands());
    }
    case Kind::kProduct:
      return product(e.operands());
    case Kind::kTranspose: {
      if (e.operands().front().kind() == Kind::kLeaf) {
        return {{{}, {e}}};
      }
      Words result = open(e.operands().front());
      std::ranges::for_each(result, transpose);
      return result;
    }
    case Kind::kSkew:
    case Kind::kSkewTranspose:
      return skew(e);
    default:
      return {{{}, {e}}};
  }
}

}  // namespace

std::optional<std::vector<Word>> words(const Expression& e, std::size_t most) {
  try {
    return Opener(most).open(e);
  } catch (const TooMany&) {
    return std::nullopt;
  }
}

namespace {

bool is_wrapped(const Expression& e) {
  return e.kind() == Kind::kTranspose || e.kind() == Kind::kSkew ||
         e.kind() == Kind::kSkewTranspose;
}

/// A symbol, whatever Λ and transposes stand around it; "" for others.
std::string symbol_in(const Expression& e) {
  return is_wrapped(e)             ? symbol_in(e.operands().front())
         : e.kind() == Kind::kLeaf ? e.node().name
                                   : "";
}

/// True if the joints to which [begin, end) leads from a vector turn: D or D - E, then σ.
template <class Iterator>
bool turns(Iterator begin, Iterator end, bool transposed) {
  begin = std::find_if(begin, end, [](const Expression& f) { return symbol_in(f) != "W"; });
  const std::string reach = begin == end ? "" : block::print(*begin);
  const bool up = reach == "D" || reach == "D - E" || reach == "(D^T - E)^T";
  const bool down = reach == "D^T" || reach == "D^T - E" || reach == "(D - E)^T";
  if (transposed ? !down : !up) {
    return false;
  }
  const auto after = std::find_if_not(++begin, end, is_diagonal);
  return std::any_of(begin, after, [](const Expression& f) { return symbol_in(f) == "σ"; });
}

bool refers_to_places(const std::vector<Expression>& word);

/// \param transposed  e^T stands there
bool any_refers(const Expression& e, bool transposed, const std::vector<Expression>& before,
                const std::vector<Expression>& after) {
  constexpr std::size_t kMost = 10000;
  auto all = words(e, kMost);
  return !all || std::any_of(all->begin(), all->end(), [&](Word& inner) {
    if (transposed) {
      transpose(inner);
    }
    std::vector<Expression> word = before;
    word.insert(word.end(), inner.factors.begin(), inner.factors.end());
    word.insert(word.end(), after.begin(), after.end());
    return refers_to_places(word);
  });
}

bool refers_to_places(const std::vector<Expression>& word) {
  for (auto f = word.begin(); f != word.end(); ++f) {
    const std::string symbol = symbol_in(*f);
    const Expression* inner = &*f;
    bool transposed = false;
    for (; is_wrapped(*inner); inner = &inner->operands().front()) {
      transposed = transposed != (inner->kind() == Kind::kTranspose);
    }
    if (inner->kind() == Kind::kDiagonal) {
      if (any_refers(inner->operands().front(), false, {}, {})) {
        return true;
      }
      continue;
    }
    if (is_wrapped(*f) && symbol.empty() && !is_symbol(*inner)) {  // Λ(X)
      return any_refers(*inner, transposed, {word.begin(), f}, {f + 1, word.end()});
    }
    const bool ends = f + 1 != word.end() && symbol_in(*(f + 1)).starts_with("1_");
    if ((symbol == "s^d" || symbol == "l^d" || symbol == "t^d") && !ends &&
        !turns(f + 1, word.end(), false) &&
        !turns(std::make_reverse_iterator(f), word.rend(), true)) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool refers_to_places(const Expression& e) { return any_refers(e, false, {}, {}); }

std::string to_text(const Word& word) {
  const Expression whole = product_of(word.factors.begin(), word.factors.end());
  return block::print(word.factor == block::Ratio{} ? whole : word.factor * whole);
}

}  // namespace treedyn::derive
