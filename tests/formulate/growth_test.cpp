// How operation counts grow with the robot: linear for bias force and inverse dynamics, as the sum
// of depths for the mass matrix. The test prints them.
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "equations/user.hpp"
#include "formulate/derived.hpp"
#include "formulate/formulate.hpp"
#include "formulate/geometry.hpp"

namespace treedyn::formulate {
namespace {

int chain(int i) { return i - 1; }
int binary_tree(int i) { return i == 0 ? model::kGround : (i - 1) / 2; }

/// Revolute joints about z, y and x in turn along a path, offsets of two lengths, a centre of mass
/// off the axes and three different moments of inertia.
model::Tree robot(int (*father_of)(int), int size) {
  model::Tree tree;
  tree.name = tree.identifier = "robot";
  for (int i = 0; i < size; ++i) {
    model::Link link;
    link.father = father_of(i);
    const int depth = i == 0 ? 0 : model::depths(tree)[static_cast<std::size_t>(link.father)];
    link.joint.axis[static_cast<std::size_t>(2 - depth % 3)] = 1;
    link.joint.rotation = identity();
    link.joint.offset =
        i == 0 ? model::Vector3{} : model::Vector3{i % 2 == 0 ? Real("0.1") : 0, 0, Real("0.3")};
    link.inertia.mass = 1 + Real(i) / 100;
    link.inertia.com = {Real("0.02"), Real("-0.01"), Real("0.15")};
    link.inertia.about_com = {Real("0.02"), 0, 0, 0, Real("0.03"), 0, 0, 0, Real("0.01")};
    tree.links.push_back(link);
    tree.drives.push_back({i, 1, 0});
    tree.coordinates.push_back(i);
  }
  return tree;
}

int sum_of_depths(const model::Tree& tree) {
  int sum = 0;
  for (const int depth : model::depths(tree)) {
    sum += depth;
  }
  return sum;
}

int operations(const model::Tree& tree, const char* function) {
  Options options;
  options.gravity = {0, 0, Real("-9.81")};
  options.effort = 0;
  return program::cost(formulated(tree, function, options)).total();
}

struct Row {
  int size;
  int depths;
  int mass_matrix;
  int bias_force;
  int inverse_dynamics;
};

std::vector<Row> growth(int (*father_of)(int), const char* name) {
  std::vector<Row> rows;
  fmt::print("| {} N | sum of depths | A | B | tau |\n|---|---|---|---|---|\n", name);
  for (int size = 4; size <= 128; size *= 2) {
    const model::Tree tree = robot(father_of, size);
    rows.push_back({size, sum_of_depths(tree), operations(tree, "mass_matrix"),
                    operations(tree, "bias_force"), operations(tree, "inverse_dynamics")});
    const Row& row = rows.back();
    fmt::print("| {} | {} | {} | {} | {} |\n", row.size, row.depths, row.mass_matrix,
               row.bias_force, row.inverse_dynamics);
  }
  return rows;
}

/// What a doubling adds, per unit of `measure`, is the same for the last two doublings, 10 % for
/// the ends of the tree.
void expect_proportional(const std::vector<Row>& rows, int Row::*cost, int Row::*measure) {
  const auto slope = [&](std::size_t k) {
    return static_cast<double>(rows[k].*cost - rows[k - 1].*cost) /
           static_cast<double>(rows[k].*measure - rows[k - 1].*measure);
  };
  const std::size_t last = rows.size() - 1;
  EXPECT_NEAR(slope(last) / slope(last - 1), 1, 0.1);
}

TEST(Growth, IsLinearInTheLinksOfAChainAndTheSumOfItsDepths) {
  const std::vector<Row> rows = growth(chain, "chain");
  expect_proportional(rows, &Row::bias_force, &Row::size);
  expect_proportional(rows, &Row::inverse_dynamics, &Row::size);
  expect_proportional(rows, &Row::mass_matrix, &Row::depths);
}

TEST(Growth, IsLinearInTheLinksOfABinaryTreeAndTheSumOfItsDepths) {
  const std::vector<Row> rows = growth(binary_tree, "binary tree");
  expect_proportional(rows, &Row::bias_force, &Row::size);
  expect_proportional(rows, &Row::inverse_dynamics, &Row::size);
  expect_proportional(rows, &Row::mass_matrix, &Row::depths);
}

/// What is measured from a centre that all links make, and sums of which the algebra finds more in
/// frames of links than in the base, though they cost less there before it: 10 % for the ends.
TEST(Growth, OfEquationsOfUsersIsLinearInTheLinksOfAChain) {
  std::vector<model::EquationText> texts;
  for (const auto& [name, value] :
       {std::pair("com", "T(ones) * m_d * r / (T(ones) * m_d * ones)"),
        std::pair("spread", "T(r - ones * com) * m_d * (r - ones * com)"),
        std::pair("moment",
                  "T(ones) * (Lam(diagb(r)) * m_d * (dot(J_v * qd) - g) + dot(J_d * omega))")}) {
    model::EquationText& text = texts.emplace_back();
    text.name = name;
    text.value = value;
  }
  std::map<std::string, std::vector<int>> counts;
  for (const int size : {8, 16, 32}) {
    const model::Tree tree = robot(chain, size);
    for (const equations::UserEquation& equation : equations::read_equations(texts, tree, {})) {
      Options options;
      options.gravity = {0, 0, Real("-9.81")};
      options.effort = 0;
      const auto function = regrouped(tree, derived(equation, size, 0), options);
      counts[equation.name].push_back(program::cost(formulated(tree, function, options)).total());
    }
  }
  for (const auto& [name, count] : counts) {
    fmt::print("{} of 8, 16, 32 links: {} {} {}\n", name, count[0], count[1], count[2]);
    EXPECT_NEAR(static_cast<double>(count[2] - count[1]) / (2 * (count[1] - count[0])), 1, 0.1)
        << name;
  }
}

}  // namespace
}  // namespace treedyn::formulate
