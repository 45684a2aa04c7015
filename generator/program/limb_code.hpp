// A function whose limbs share code.
#pragma once

#include <memory>
#include <vector>

#include "program/limbs.hpp"

namespace treedyn::program {

/// What the limbs of a class compute between two steps of the trunk. Inputs: the values of the
/// trunk (kTrunkValues), the limb's constants, the limb's values; output: the limb's values, of
/// which those that the phase does not compute stay as they are.
struct LimbPhase {
  int limb_class = 0;
  int stage = 0;
  Function function;
};

inline constexpr const char* kTrunkValues = "trunk";
inline constexpr const char* kLimbRow = "constants";
inline constexpr const char* kLimbValues = "limb";

/// The trunk's code, which is everything that does not belong to one limb alone, and the phases of
/// the limbs: stage 0 of the trunk, stage 0 of all limbs, stage 1 of the trunk, ...
///
/// `trunk` has the arguments of the function; behind its inputs the values of limb after limb (all
/// classes), behind its outputs the trunk's values for the limbs and the joint values of every
/// limb.
struct LimbCode {
  Function trunk;
  std::vector<LimbPhase> phases;  ///< by stage, then class
  Limbs limbs;                    ///< with the columns that the phases use

  /// A value of a limb: element of an argument of its joint, which the trunk passes on, or what
  /// some phase makes.
  struct Value {
    int argument = -1;
    int position = 0;  ///< place of the joint in the limb
    int stage = -1;    ///< of the phase
  };
  std::vector<std::vector<Value>> values;  ///< by class; those of joints first

  /// Number of arguments that are inputs of the function.
  [[nodiscard]] int arguments() const;
  /// Stage of the trunk in which element `element` of its input `array` is there.
  [[nodiscard]] int level(int array, int element) const;
};

/// The same values without shared code; its `limb_code` is `code`.
Function flat(std::shared_ptr<const LimbCode> code, const Signature& signature);

/// Operations of one call: those of a phase count once a limb.
Cost cost(const LimbCode& code);

}  // namespace treedyn::program
