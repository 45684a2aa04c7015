#include "in_scalar.hpp"

#include <utility>

#include "lost_pivots.hpp"
#include "program/ones.hpp"

namespace treedyn {

Programs in_scalar(Programs programs, const Model& model, emit::Scalar scalar) {
  const program::IsOne is_one = [scalar](const Real& value) {
    return emit::rounds_to_one(value, scalar);
  };
  for (program::Function& function : programs.functions) {
    function = program::without_ones(function, is_one);
  }
  for (program::Staged& staged : programs.staged) {
    staged = program::without_ones(std::move(staged), is_one);
  }
  programs = with_tested_pivots(std::move(programs), model, scalar);
  for (program::Stepper& stepper : programs.steppers) {
    stepper = program::without_ones(std::move(stepper), programs.staged, is_one);
  }
  return programs;
}

}  // namespace treedyn
