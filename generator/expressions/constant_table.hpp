// The parameters behind `Constants`.
#pragma once

#include <string>
#include <vector>

#include "expressions/constant.hpp"
#include "expressions/parser.hpp"

namespace treedyn::expressions {

struct Constants::Table {
  /// Stands as a symbol among `names`.
  struct AtRunTime {
    std::string name;
    GiNaC::realsymbol symbol;
    Real number;
  };

  Names names;
  std::vector<AtRunTime> at_run_time;
};

}  // namespace treedyn::expressions
