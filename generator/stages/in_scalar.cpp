#include <utility>

#include "emit/staged_text.hpp"
#include "program/ones.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

/// By so much pivots of ordinary states exceed what passes for rounding if a bound of it is to do.
constexpr double kOrdinaryMargin = 1e3;

}  // namespace

program::Programs in_scalar(program::Programs programs, const Model& model, emit::Scalar scalar) {
  const program::IsOne is_one = [scalar](const Real& value) {
    return emit::rounds_to_one(value, scalar);
  };
  for (program::Function& function : programs.functions) {
    function = program::without_ones(function, is_one);
  }
  for (program::Staged& staged : programs.staged) {
    staged = program::without_ones(std::move(staged), is_one);
    for (program::RowSolve& solve : staged.solves) {
      solve.by_product = solve.product > kOrdinaryMargin * emit::pivot_rounding(solve.rows, scalar);
      solve.twice = emit::is_measured_twice(solve, scalar);
    }
  }
  programs = with_tested_pivots(std::move(programs), model, scalar);
  for (program::Stepper& stepper : programs.steppers) {
    stepper = program::without_ones(std::move(stepper), programs.staged, is_one);
  }
  return programs;
}

}  // namespace treedyn
