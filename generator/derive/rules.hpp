// The rules of the derivation, by the names that `info --derivation` quotes.
#pragma once

#include <span>
#include <string_view>

namespace treedyn::derive {

/// EQUATIONS.md's block expressions become recursions by these and nothing else. N = D - E.
enum class Rule {
  kRates,
  kValueRates,
  kDistribute,
  kSums,
  kTransposes,
  kSkewPasses,
  kMerge,
  kJacobi,
  kTwiceTurned,
  kCrossWords,
  kTelescope,
  kComponents,
  kBlownUp,
  kUnits,
  kRowOfUnit,
  kMeet,
  kSymmetric,
  kComposites,
  kPlaceSums,
  kKinds,
  kCommon,
  kParameters,
  kPlaces,
  kStart,
  kFathers,
  kPseudoInertia,
  kComposite,
  kSquare,
  kTwice,
  kTurned,
  kRelative,
  kMomentum,
  kElimination,
  kYields,
  kFactors,
  kTriangles,
  kReactions,
  kLeast,
  kTrunk,
};

struct RuleRow {
  Rule rule;
  std::string_view name;
  std::string_view text;
};

/// One row each, in the order of the enumeration.
std::span<const RuleRow> rules();
const RuleRow& row_of(Rule rule);

}  // namespace treedyn::derive
