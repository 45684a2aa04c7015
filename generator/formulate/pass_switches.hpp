// The transformations that make a formulation cheap, each with a switch, so that its gain can be
// shown.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "formulate/variant.hpp"
#include "program/function.hpp"

namespace treedyn::model {
struct Tree;
}

namespace treedyn::formulate {

struct Options;

/// In the order in which they build on each other. Link frames with z as joint axis, merged fixed
/// bodies and exact zeros and ones are not passes: without them there is no formulation.
enum class Pass : std::uint8_t {
  kNormals,
  kRegrouping,
  kPseudoInertia,
  kColumn,
  kParallel,
  kSums,
  kTrunk,
  kAlgebra,
  kSearch,
};

struct PassInfo {
  Pass pass;
  const char* name;  ///< of the command line
  const char* what;
};

const std::vector<PassInfo>& passes();

/// Turns the choices of a variant back that belong to passes that are switched off.
void switch_off(const std::vector<Pass>& without, Variant& variant);

/// One row of the table of gains: the cost of a function with this pass and all before it.
struct PassCost {
  std::string pass;
  program::Cost cost;
};

/// \param made  the function as the options have it
std::vector<PassCost> pass_costs(const std::function<program::Function(const Options&)>& made,
                                 const Options& options);

}  // namespace treedyn::formulate
