// The block equations of a tree as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::expansion {

struct DumpOptions {
  std::vector<std::string> functions;  ///< names of equations::table(); empty: all
  int most_links = 3;                  ///< larger trees show no entries
  std::size_t most_terms = 40;         ///< longer entries are counted
  int most_blocks = 80;                ///< wider zero patterns are counted
};

/// What `treedyn info --equations` prints: D with its zero blocks ('.'), then for every function
/// its block equation, the definitions it uses, its zero pattern and, for a small tree, its
/// entries (terms that are rounding left out). The same text on every run and machine. \pre the
/// functions are names of equations::table().
std::string dump(const model::Tree& tree, std::span<const model::Point> points,
                 const model::Vector3& gravity, const DumpOptions& options);

}  // namespace treedyn::expansion
