// Cells by robot, function and contestant, in the order in which they were measured.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "benchmark/cell.hpp"

namespace treedyn::benchmark {

/// The different values of a member, in order of first appearance.
inline std::vector<std::string> values(const std::vector<Cell>& cells, std::string Cell::*member) {
  std::vector<std::string> result;
  for (const Cell& cell : cells) {
    if (std::find(result.begin(), result.end(), cell.*member) == result.end()) {
      result.push_back(cell.*member);
    }
  }
  return result;
}

/// Null if the contestant cannot express the function.
inline const Cell* find(const std::vector<Cell>& cells, const std::string& robot,
                        const std::string& function, const std::string& contestant) {
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return cell.robot == robot && cell.function == function && cell.contestant == contestant;
  });
  return found == cells.end() ? nullptr : &*found;
}

/// True for what the ratio of the tables compares with: neither ours nor the block form.
inline bool is_engine(const std::string& contestant) {
  return contestant.rfind("treedyn", 0) != 0 && contestant != "block form";
}

}  // namespace treedyn::benchmark
