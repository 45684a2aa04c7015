#include "common/recipe.hpp"

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <tuple>

namespace treedyn {

namespace {

/// All recipes, each operation on the same operands once; for all threads.
class Recipes {
 public:
  int number(const Digits& value) {
    const std::scoped_lock lock(mutex_);
    return add({RecipeKind::kNumber, 0, 0, value});
  }
  int operation(RecipeKind kind, int a, int b) {
    const std::scoped_lock lock(mutex_);
    const auto [place, is_new] = known_.try_emplace({kind, a, b}, 0);
    if (is_new) {
      place->second = add({kind, a, b, 0});
    }
    return place->second;
  }
  [[nodiscard]] const Recipe& at(int number) const {
    const std::scoped_lock lock(mutex_);
    return recipes_[static_cast<std::size_t>(number)];
  }

 private:
  int add(const Recipe& recipe) {
    recipes_.push_back(recipe);
    return static_cast<int>(recipes_.size()) - 1;
  }

  mutable std::mutex mutex_;
  std::deque<Recipe> recipes_ = std::deque<Recipe>(1);  // number 0 is none
  std::map<std::tuple<RecipeKind, int, int>, int> known_;
};

Recipes& recipes() {
  static Recipes all;
  return all;
}

}  // namespace

const Recipe& recipe(int number) { return recipes().at(number); }

int recipe_of_parameter(int index) {
  return index < 0 ? kUnknownRecipe : recipes().operation(RecipeKind::kParameter, index, 0);
}

int recipe_of(RecipeKind kind, const Real& a, const Real& b) {
  if (a.recipe() == 0 && b.recipe() == 0) {
    return 0;
  }
  if (std::abs(a.recipe()) == kUnknownRecipe || std::abs(b.recipe()) == kUnknownRecipe) {
    return kUnknownRecipe;
  }
  const auto operand = [](const Real& x) {
    return x.recipe() != 0 ? x.recipe() : recipes().number(x.digits());
  };
  const int first = operand(a);
  return recipes().operation(kind, first, operand(b));
}

int recipe_of(RecipeKind kind, const Real& a) {
  return a.recipe() == 0 || std::abs(a.recipe()) == kUnknownRecipe
             ? std::abs(a.recipe())
             : recipes().operation(kind, a.recipe(), 0);
}

Real evaluated(int number, std::span<const Real> parameters) {
  if (number < 0) {
    return -evaluated(-number, parameters);
  }
  const Recipe& of = recipe(number);
  const auto a = [&] {
    return evaluated(of.a, parameters);
  };
  const auto b = [&] {
    return evaluated(of.b, parameters);
  };
  switch (of.kind) {
    case RecipeKind::kNumber:
      return of.value;
    case RecipeKind::kParameter:
      return parameters[static_cast<std::size_t>(of.a)];
    case RecipeKind::kAdd:
      return a() + b();
    case RecipeKind::kSubtract:
      return a() - b();
    case RecipeKind::kMultiply:
      return a() * b();
    case RecipeKind::kDivide:
      return a() / b();
    case RecipeKind::kSqrt:
      return sqrt(a());
    case RecipeKind::kSin:
      return sin(a());
    case RecipeKind::kCos:
      break;
  }
  return cos(a());
}

}  // namespace treedyn
