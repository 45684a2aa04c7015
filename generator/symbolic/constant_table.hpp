// The parameters behind `Constants`.
#pragma once

#include "symbolic/constant.hpp"
#include "symbolic/parser.hpp"

namespace treedyn::symbolic {

struct Constants::Table {
  Names names;
};

}  // namespace treedyn::symbolic
