#include "derive/words.hpp"

#include <algorithm>

#include "block/print.hpp"
#include "derive/columns.hpp"
#include "derive/value.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::Kind;
using Words = std::vector<Word>;

/// More words than asked for.
struct TooMany {};

bool is_vector(const Expression& f) { return f.shape().rows.size == 3 && f.shape().cols.size == 1; }

/// "D-E" and "E-σ" are symbols of their own.
bool is_symbol(const Expression& e) {
  const std::string text = block::print(e);
  return text == "D - E" || text == "D^T - E" || text == "E - σ";
}

class Opener {
 public:
  explicit Opener(std::size_t most) : most_(most) {}

  Words open(const Expression& e) const;

 private:
  Words product(const std::vector<Expression>& factors) const;
  Words transposed(Words inner) const;
  Words skew(const Expression& e) const;

  std::size_t most_;
};

Words Opener::product(const std::vector<Expression>& factors) const {
  Words result = {{}};
  for (const Expression& f : factors) {
    Words longer;
    for (const Word& tail : open(f)) {
      for (const Word& head : result) {
        Word word = head;
        word.factor = multiply(head.factor, tail.factor);
        word.factors.insert(word.factors.end(), tail.factors.begin(), tail.factors.end());
        longer.push_back(std::move(word));
      }
    }
    if (longer.size() > most_) {
      throw TooMany{};
    }
    result = std::move(longer);
  }
  return result;
}

Words Opener::transposed(Words inner) const {
  for (Word& word : inner) {
    std::reverse(word.factors.begin(), word.factors.end());
    for (Expression& f : word.factors) {
      f = f.kind() == Kind::kTranspose ? f.operands().front() : block::transpose(f);
    }
  }
  return inner;
}

/// R2: Λ stands at the only vector of a word.
Words Opener::skew(const Expression& e) const {
  Words result = open(e.operands().front());
  for (Word& word : result) {
    const auto vectors = std::count_if(word.factors.begin(), word.factors.end(), is_vector);
    const bool crossed = std::any_of(
        word.factors.begin(), word.factors.end(),
        [](const Expression& f) { return f.shape().rows.size == 3 && f.shape().cols.size == 3; });
    if (vectors != 1 || crossed) {
      return {{{}, {e}}};
    }
    const auto v = std::find_if(word.factors.begin(), word.factors.end(), is_vector);
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
      Words result;
      for (const Expression& term : e.operands()) {
        Words inner = open(term);
        std::move(inner.begin(), inner.end(), std::back_inserter(result));
      }
      return result;
    }
    case Kind::kProduct:
      return product(e.operands());
    case Kind::kTranspose:
      return e.operands().front().kind() == Kind::kLeaf ? Words{{{}, {e}}}
                                                        : transposed(open(e.operands().front()));
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

std::string to_text(const Word& word) {
  Expression whole = word.factors.front();
  for (std::size_t k = 1; k < word.factors.size(); ++k) {
    whole = whole * word.factors[k];
  }
  return block::print(word.factor == block::Ratio{} ? whole : word.factor * whole);
}

}  // namespace treedyn::derive
