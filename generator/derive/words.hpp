// R0 and R2: an expression as a sum of words, products of symbols.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "block/block.hpp"

namespace treedyn::derive {

/// factor * f1 f2 .. fn: symbols, their transposes, Λ of one, and what R4 takes whole.
struct Word {
  block::Ratio factor;
  std::vector<block::Expression> factors;
};

/// The words of an expression; nothing if there are more than `most`.
std::optional<std::vector<Word>> words(const block::Expression& e, std::size_t most);

std::string to_text(const Word& word);

/// False if the value is the same wherever P_i of a sliding joint i is on its axis: vectors from
/// P_i (s^d, l^d, t^d) stand in the words of turning joints (σ) or end at points, where P_i is no
/// more.
bool refers_to_places(const block::Expression& e);

}  // namespace treedyn::derive
