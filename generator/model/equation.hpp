// Equations of users as files write them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/real.hpp"

namespace treedyn::model {

/// A column that a user declares: one block, or one for every link or point.
struct InputText {
  std::string name;
  std::string per;  ///< "link", "point", or empty: one block
  int size = 1;     ///< 1 or 3 numbers a block
  Location where;
};

struct EquationText {
  std::string name;
  std::string value;  ///< a block expression
  std::string doc;    ///< one line, may be empty
  std::vector<InputText> inputs;
  Location where;                                        ///< of the name
  std::function<Location(std::size_t)> value_at;         ///< the place of a character of `value`
  std::vector<std::pair<std::string, Real>> parameters;  ///< of the file
};

}  // namespace treedyn::model
