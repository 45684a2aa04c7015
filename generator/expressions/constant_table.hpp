// The parameters behind `Constants`.
#pragma once

#include "expressions/constant.hpp"
#include "expressions/parser.hpp"

namespace treedyn::expressions {

struct Constants::Table {
  Names names;
};

}  // namespace treedyn::expressions
