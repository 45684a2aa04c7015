// Equations of users on random robots, for tests.
#pragma once

#include <string>
#include <vector>

#include "derive/derive.hpp"
#include "engine/user_function.hpp"
#include "equations/user.hpp"
#include "formulate/derived.hpp"
#include "program/interpret.hpp"
#include "support/random_tree.hpp"

namespace treedyn::support {

using Numbers = std::vector<Real>;

/// A robot, points on it and states of it.
struct UserRobot {
  explicit UserRobot(const TreeShape& shape, std::uint64_t seed = 7) : dice(seed) {
    tree = random_tree(shape, dice);
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      tree.links[i].joint.name = "joint" + std::to_string(i);
      tree.links[i].name = "link" + std::to_string(i);
      tree.links[i].joint.identifier = tree.links[i].joint.name;
      tree.frames.push_back(
          {tree.links[i].name, static_cast<int>(i), {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}});
    }
    points = random_points(tree, 3, dice);
    points.front().link = tree.size() - 1;
    points.back().link = model::kGround;
    for (std::size_t p = 0; p < points.size(); ++p) {
      points[p].name = points[p].identifier = "point" + std::to_string(p);
    }
  }

  Numbers random(int count) {
    const std::vector<double> numbers = dice.numbers(static_cast<std::size_t>(count), 2);
    return {numbers.begin(), numbers.end()};
  }
  [[nodiscard]] int size(const block::Side& side) const {
    return side.size * (side.set == block::Set::kLinks    ? tree.size()
                        : side.set == block::Set::kPoints ? static_cast<int>(points.size())
                                                          : 1);
  }
  [[nodiscard]] equations::UserEquation read(
      const std::string& value, const std::vector<model::InputText>& inputs = {}) const {
    model::EquationText text;
    text.name = "asked";
    text.value = value;
    text.inputs = inputs;
    return equations::read_equations({text}, tree, points).front();
  }
  std::vector<Numbers> inputs(const equations::UserEquation& equation) {
    std::vector<Numbers> result;
    for (const equations::UserArgument& argument : equation.arguments) {
      result.push_back(random(size(argument.side)));
    }
    return result;
  }
  /// By the engine.
  [[nodiscard]] Numbers expected(const equations::UserEquation& equation,
                                 const std::vector<Numbers>& at) const {
    return engine::UserFunction<Real>(equation, tree, points, gravity)(at);
  }
  [[nodiscard]] formulate::Options options() const {
    formulate::Options result;
    result.gravity = gravity;
    result.points = points;
    return result;
  }
  /// The program that the equation derives to, before any search.
  [[nodiscard]] program::Function derived(const equations::UserEquation& equation,
                                          formulate::Way way) const {
    const auto function =
        formulate::derived(equation, tree.size(), static_cast<int>(points.size()));
    formulate::Variant variant = formulate::plain_variant(tree);
    variant.way = way;
    return formulate::build(tree, formulate::derived_recipe(function), options(), variant);
  }
  /// The program that solves an equation, zero for q̈, by R9.
  [[nodiscard]] program::Function solved(const equations::UserEquation& equation) const {
    const formulate::Derived system{equation, derive::derive(equation.expression, false, false),
                                    std::nullopt};
    const auto function =
        std::make_shared<const formulate::Derived>(formulate::solved(system, "q̈"));
    return formulate::build(tree, formulate::derived_recipe(function), options(),
                            formulate::plain_variant(tree));
  }
  static Numbers run(const program::Function& function, const std::vector<Numbers>& at) {
    const std::vector<std::span<const Real>> spans(at.begin(), at.end());
    return program::interpret<Real>(function, spans);
  }

  Dice dice;
  model::Tree tree;
  std::vector<model::Point> points;
  model::Vector3 gravity{Real(1), Real(2), Real("-9.81")};
};

/// Largest difference, relative to the largest value.
inline Real distance(const Numbers& a, const Numbers& b) {
  Real largest("1e-10");
  Real difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t n = 0; n < a.size() && n < b.size(); ++n) {
    largest = std::max(largest, Real(abs(b[n])));
    difference = std::max(difference, Real(abs(a[n] - b[n])));
  }
  return difference / largest;
}

}  // namespace treedyn::support
