// How numbers that are known at run time only are made of run-time parameters.
#pragma once

#include <cstdint>
#include <span>

#include "common/real.hpp"

namespace treedyn {

enum class RecipeKind : std::uint8_t {
  kNumber,
  kParameter,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kSqrt,
  kSin,
  kCos
};

/// Operands of recipes among a and b.
constexpr int operands(RecipeKind kind) {
  return kind <= RecipeKind::kParameter ? 0 : kind <= RecipeKind::kDivide ? 2 : 1;
}

/// One operation on the results of earlier recipes. kNumber: `value`. kParameter: a = its index.
/// A negative operand is the negative of the result.
struct Recipe {
  RecipeKind kind = RecipeKind::kNumber;
  int a = 0;
  int b = 0;
  Digits value = 0;
};

/// The recipe behind a number that `Real::recipe` gave. \pre number > 0
const Recipe& recipe(int number);

/// The recipe of numbers whose recipes nobody will ask for, only whether they have any.
inline constexpr int kUnknownRecipe = 0x7FFFFFFF;

/// \param index  -1: kUnknownRecipe
int recipe_of_parameter(int index);
/// The recipe of an operation; 0 if neither number has one, unknown if one is. Recipes live as long
/// as the program: there are as many as operations on such numbers.
int recipe_of(RecipeKind kind, const Real& a, const Real& b);
/// The same of a function of one number.
int recipe_of(RecipeKind kind, const Real& a);

/// The number that a recipe makes of parameters.
Real evaluated(int number, std::span<const Real> parameters);

}  // namespace treedyn
