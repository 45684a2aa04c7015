// Rounding errors of functions beside what they cost.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/states.hpp"
#include "emit/sincos.hpp"
#include "emit/unit.hpp"
#include "engine/reference.hpp"
#include "program/interpret.hpp"

namespace treedyn::accuracy {

/// The largest error of one kind and where it is.
struct Worst {
  double error = 0;    ///< infinite where a value is none
  std::string output;  ///< "A[7]"; empty: no error in any state
  int state = 0;
};

/// Errors of a function over some states.
struct Errors {
  Worst scaled;  ///< relative to the natural scale of the value, see engine::Exact
  Worst ulps;    ///< in units in the last place of the value; zeros to 30 digits are left out
};

/// How code computes.
struct Arithmetic {
  emit::Scalar scalar = emit::Scalar::kDouble;
  emit::Sincos sincos = emit::Sincos::kPair;
};

/// What errors of a function do not exceed. Proven over all ranges of the arguments, a part of the
/// scale at their ends; or running, a part of the scale in the state of the largest scaled error
/// and proven there alone.
struct Bound {
  double error = 0;      ///< infinite where a value may be none
  std::string output;    ///< "A[7]"; empty: every output is exact
  double sampled = 0;    ///< the largest error over the states, a part of the same scale
  std::string assumed;   ///< see States::assumed; empty: the model states all limits it needs
  std::string obstacle;  ///< "a divisor may be zero": why it is a running one; empty: proven
};

/// What comes of a function in some arithmetic.
struct Measured {
  Errors errors;
  program::Cost cost;           ///< of a call in this scalar
  std::vector<double> largest;  ///< error of every output over all states
  Bound bound = {};             ///< see `bounded`
};

/// States and what a function should return in them, and the ranges that they are from.
struct Truth {
  std::vector<Inputs> inputs;
  std::vector<engine::Exact> exact;
  std::vector<Interval> ranges = {};  ///< of every element of the arguments
  std::vector<double> scales = {};    ///< where every element is at the larger end of its range
  std::function<std::string(const Dependence&)> assumed = {};  ///< see States::assumed
};

/// Of the states 0 to `count` - 1.
Truth truth_of(const program::Signature& signature, const States& states, int count,
               const std::function<engine::Exact(const Inputs&)>& reference);

/// The values of a function, its operations executed one by one in T, as generated code without
/// contraction to fused multiply-adds does: the same bits. Sines and cosines are those of the
/// source, or (`libm`) correctly rounded, which a good C library nearly reaches.
/// \pre factors that T rounds to one are gone (`program::without_ones`)
template <class T>
std::vector<T> executed(const program::Function& function, const Inputs& inputs,
                        emit::Sincos sincos);

/// O(states x operations).
Measured measured(const program::Function& function, const Arithmetic& how, const Truth& truth);

/// What `measured` found cannot be larger than this, see OutputError and `bounds_over`.
/// \param function  as for `measured`; \param truth  of `truth_of`
Bound bounded(const program::Function& function, const Arithmetic& how, const Truth& truth,
              const Measured& measured);

/// One way to make a function.
struct FunctionRow {
  std::string function;
  std::string option;  ///< "as asked for", "without sums", ..
  Measured in_float;
  Measured in_double;
};

/// All of a model.
struct FunctionStudy {
  std::string model;
  int states = 0;
  std::string missing;  ///< limits, see States
  std::vector<FunctionRow> rows;
  /// A state that the first row of a function names.
  struct Named {
    std::string function;
    int state = 0;
    std::vector<std::pair<std::string, std::string>> values;  ///< "q", "[0.1, -2]"
  };
  std::vector<Named> named;
};

std::string functions_text(const FunctionStudy& study);
std::string functions_json(const FunctionStudy& study);

/// "A[7]" for the output value number k.
std::string output_name(const program::Signature& signature, std::size_t k);

/// {"scaled": {..}, "ulp": {..}, "bound": {..}}
std::string errors_json(const Measured& measured);

}  // namespace treedyn::accuracy
