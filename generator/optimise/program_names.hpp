// What passes call the parts of programs.
#pragma once

#include "program/copy.hpp"
#include "program/fingerprint.hpp"
#include "program/function.hpp"
#include "program/limb_code.hpp"
#include "program/residue.hpp"

namespace treedyn::optimise {

namespace residue = program::residue;

using program::Array;
using program::copy_hints;
using program::copy_of;
using program::Cost;
using program::Expr;
using program::Function;
using program::Graph;
using program::Hint;
using program::kFixedArrays;
using program::Kind;
using program::kLimbInputs;
using program::kLimbRow;
using program::kLimbValues;
using program::kTrunkValues;
using program::LimbClass;
using program::LimbCode;
using program::LimbJoint;
using program::LimbPhase;
using program::Limbs;
using program::Node;
using program::Random;
using program::Ref;
using program::Rounding;
using program::sample_function;
using program::sample_input;
using program::scramble;
using program::Signature;
using program::tie;

}  // namespace treedyn::optimise
