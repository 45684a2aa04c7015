// The programs against the equations, exactly: what a function computes, carried out with
// polynomials in sines, cosines, slides and rates, is the expansion of its block equation. Every
// difference is the zero polynomial. Mechanisms and models whose numbers are decimals and whose
// axes are coordinate axes, so that the constants of the programs are exact.
#include <algorithm>

#include <gtest/gtest.h>

#include "derive/exact_options.hpp"
#include "derive/turning.hpp"
#include "description/read.hpp"
#include "equations/equations.hpp"
#include "equations/table.hpp"
#include "expansion/expansion.hpp"
#include "formulate/derived.hpp"
#include "formulate/trunk.hpp"
#include "program/interpret.hpp"
#include "support/random_tree.hpp"

namespace treedyn {
namespace {

using expansion::Expanded;
using support::chain;

/// A fraction of elements of the ring.
struct Fraction {
  Fraction() = default;
  explicit Fraction(Expanded number) : value(std::move(number)) {}
  explicit Fraction(int number) : value(number) {}

  Expanded value;
  Expanded below{1};

  [[nodiscard]] bool is_zero() const { return value.is_zero(); }

  friend Fraction operator+(Fraction a, const Fraction& b) {
    const bool same = a.below == b.below;
    a.value = same ? a.value + b.value : a.value * b.below + b.value * a.below;
    a.below = same ? a.below : a.below * b.below;
    return a;
  }
  friend Fraction operator*(Fraction a, const Fraction& b) {
    a.value = a.value * b.value;
    a.below = a.below * b.below;
    return a;
  }
  friend Fraction operator/(Fraction a, const Fraction& b) {
    a.value = a.value * b.below;
    a.below = a.below * b.value;
    return a;
  }
  friend Fraction operator-(Fraction a) {
    a.value = -a.value;
    return a;
  }
  friend Fraction operator-(Fraction a, const Fraction& b) { return std::move(a) + -b; }
};

int to_int(const Fraction& integer) {
  return GiNaC::ex_to<GiNaC::numeric>(integer.value.value()).to_int();
}

using Exact = support::Turning<Fraction>;

/// The ring of the expansion that a program is compared with; decimals need no other variables.
const expansion::Ring* ring = nullptr;

}  // namespace

template <>
Exact program::from_real<Exact>(const Real& value) {
  static expansion::Ring decimals;
  return Exact(Fraction(Expanded(*ring, decimals.constant(value))));
}

namespace {

struct Mechanism {
  const char* name;
  support::TreeShape shape;
  const char* file = nullptr;               ///< below models/, instead of a random one
  std::vector<std::string_view> dear = {};  ///< functions whose polynomials take minutes
};
void PrintTo(const Mechanism& mechanism, std::ostream* stream) { *stream << mechanism.name; }

/// Turns by quarters, axes along x, y or z, numbers of two digits.
model::Tree decimal_tree(const support::TreeShape& shape, support::Dice& dice) {
  const auto decimal = [&] {
    return Real(dice.below(199) - 99) / 100;
  };
  model::Tree tree = support::random_tree(shape, dice);
  for (model::Link& link : tree.links) {
    const auto first = static_cast<std::size_t>(dice.below(3));
    const std::size_t second = (first + 1 + static_cast<std::size_t>(dice.below(2))) % 3;
    const std::size_t third = 3 - first - second;
    model::Matrix3 R{};
    R[first] = dice.below(2) == 0 ? 1 : -1;
    R[3 + second] = dice.below(2) == 0 ? 1 : -1;
    const bool even = (second + 3 - first) % 3 == 1;
    R[6 + third] = R[first] * R[3 + second] * (even ? 1 : -1);
    link.joint.rotation = R;
    link.joint.axis = {};
    link.joint.axis[static_cast<std::size_t>(dice.below(3))] = dice.below(2) == 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      link.joint.offset[k] = decimal();
      link.inertia.com[k] = decimal();
      link.inertia.about_com[4 * k] = 1 + decimal() / 4;
    }
    link.inertia.mass = 2 + decimal();
    const Real xy = decimal() / 10;
    link.inertia.about_com[1] = link.inertia.about_com[3] = xy;
  }
  return tree;
}

class Programs : public testing::TestWithParam<Mechanism> {
 protected:
  Programs()
      : dice_(5),
        tree_(GetParam().file != nullptr
                  ? description::read_model(
                        std::string(TREEDYN_SOURCE_DIR "/models/") + GetParam().file, {})
                  : decimal_tree(GetParam().shape, dice_)),
        options_(support::exact_options(tree_, 0)) {}

  [[nodiscard]] Exact input(const expansion::Expansion& e, const formulate::Recipe& recipe,
                            int array, int k) const {
    const std::string_view name =
        equations::find_function(recipe.name)->inputs[static_cast<std::size_t>(array)].name;
    const auto i = static_cast<std::size_t>(k);
    if (name == "q") {
      const bool turns = tree_.links[i].joint.type == model::JointType::kRevolute;
      return turns ? Exact::angle(k) : of(e.position(i));
    }
    return of(name == "qd"    ? e.rate(i)
              : name == "qdd" ? e.acceleration(i)
              : name == "f"   ? e.force(i)
                              : e.moment(i));
  }

  static Exact of(const Expanded& number) { return Exact(Fraction(number)); }

  static Exact trigonometric(const expansion::Expansion& e, program::Kind kind,
                             const Exact& angle) {
    EXPECT_TRUE(angle.value.is_zero());
    return support::trigonometric(
        kind, angle, [&](int joint) { return Fraction(e.sine(to_index(joint))); },
        [&](int joint) { return Fraction(e.cosine(to_index(joint))); });
  }

  /// Entry by entry.
  [[nodiscard]] bool is(const expansion::Expansion& e, const formulate::Recipe& recipe,
                        const program::Function& function,
                        const block::Expression& expression) const {
    ring = &e.ring();
    const auto values = program::node_values<Exact>(
        function.graph, function.outputs,
        [&](int array, int k) { return input(e, recipe, array, k); },
        [&](program::Kind kind, const Exact& angle) { return trigonometric(e, kind, angle); });
    const expansion::Entries expected = e.expand(expression);
    bool equal = function.outputs.size() == expected.values.size();
    for (std::size_t n = 0; equal && n < expected.values.size(); ++n) {
      const program::Ref output = function.outputs[n];
      const Exact& x = values[program::node_index(output)];
      equal = ((output < 0 ? -x : x).value - Fraction(expected.values[n])).is_zero();
    }
    return equal;
  }

  void expect_equations() const {
    const expansion::Expansion expansion(tree_, options_.points, options_.gravity);
    for (const equations::Equation& equation : equations::table()) {
      if (std::ranges::find(GetParam().dear, equation.name) != GetParam().dear.end()) {
        continue;
      }
      const formulate::Recipe& recipe = formulate::recipe_of(std::string(equation.name));
      const program::Function function = formulate::formulated(tree_, recipe.name, options_);
      EXPECT_TRUE(is(expansion, recipe, function, *equation.expression)) << equation.name;
    }
  }

  support::Dice dice_;
  model::Tree tree_;
  formulate::Options options_;
};

TEST_P(Programs, AreTheirEquations) { expect_equations(); }

/// Those of models/ that are small enough for polynomials.
class Models : public Programs {};

TEST_P(Models, AreTheirEquations) { expect_equations(); }

INSTANTIATE_TEST_SUITE_P(Committed, Models,
                         testing::Values(Mechanism{"two_link", {}, "two_link.yaml"},
                                         Mechanism{"polar", {}, "polar.yaml"},
                                         Mechanism{"compass_walker", {}, "compass_walker.yaml"},
                                         Mechanism{"puma560", {}, "puma560.yaml"},
                                         Mechanism{"quadruped", {}, "quadruped.yaml"},
                                         Mechanism{"drop", {}, "scenes/drop.model.yaml"},
                                         Mechanism{"four_bar", {}, "scenes/four_bar.model.yaml"},
                                         Mechanism{"pendulum", {}, "scenes/pendulum.model.yaml"},
                                         Mechanism{"panda",
                                                   {},
                                                   "panda.yaml",
                                                   {"mass_matrix", "bias_force", "inverse_dynamics",
                                                    "kinetic_energy"}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Programs, AreTheirEquationsInEveryFrame) {
  const expansion::Expansion expansion(tree_, options_.points, options_.gravity);
  for (const equations::Equation& equation : equations::table()) {
    const formulate::Recipe& recipe = formulate::recipe_of(std::string(equation.name));
    for (const formulate::Way way :
         {formulate::Way::kToRoot, formulate::Way::kInLinks, formulate::Way::kInBase}) {
      formulate::Variant variant = formulate::plain_variant(tree_);
      variant.way = way;
      for (formulate::LinkVariant& link : variant.links) {
        link.angle = formulate::FrameAngle::kKeep;
      }
      const program::Function function = formulate::build(tree_, recipe, options_, variant);
      EXPECT_TRUE(is(expansion, recipe, function, *equation.expression))
          << equation.name << " way " << static_cast<int>(way);
    }
  }
}

TEST_P(Programs, AreNoOtherEquations) {
  const expansion::Expansion expansion(tree_, options_.points, options_.gravity);
  equations::Attached wrong = equations::points();
  wrong.t_d = -wrong.t_d;
  const formulate::Recipe& recipe = formulate::recipe_of("force_jacobian_transpose");
  const bool turns = GetParam().shape.types.find('R') != std::string::npos;
  EXPECT_EQ(is(expansion, recipe, formulate::formulated(tree_, recipe.name, options_),
               equations::force_jacobian_transpose(wrong)),
            !turns);
}

/// Leaves whose pivots are powers of 2, so that the constants of the programs are exact.
class Solved : public Programs {
 protected:
  Solved() {
    for (model::Link& link : tree_.links) {
      const auto i = static_cast<int>(&link - tree_.links.data());
      if (std::none_of(tree_.links.begin(), tree_.links.end(),
                       [i](const model::Link& son) { return son.father == i; })) {
        const Real half("0.5");
        link.inertia = {2, {half, half, -half}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
      }
    }
  }

  /// The outputs for an argument that comes last.
  [[nodiscard]] std::vector<Fraction> outputs(const expansion::Expansion& e,
                                              const std::string& name,
                                              const std::vector<Expanded>& last) const {
    ring = &e.ring();
    const formulate::Recipe& recipe = formulate::recipe_of(name);
    const program::Function function = formulate::formulated(tree_, recipe.name, options_);
    const auto is_last = [&](int array) {
      return !last.empty() &&
             array + 1 == static_cast<int>(equations::find_function(name)->inputs.size());
    };
    const auto values = program::node_values<Exact>(
        function.graph, function.outputs,
        [&](int array, int k) {
          return is_last(array) ? of(last[to_index(k)]) : input(e, recipe, array, k);
        },
        [&](program::Kind kind, const Exact& angle) { return trigonometric(e, kind, angle); });
    std::vector<Fraction> result;
    for (const program::Ref output : function.outputs) {
      const Fraction& x = values[program::node_index(output)].value;
      EXPECT_FALSE(x.below.is_zero());
      result.push_back(output < 0 ? -x : x);
    }
    return result;
  }
  void expect_inverse(formulate::ForwardDynamics method);
  [[nodiscard]] std::vector<Expanded> accelerations(const expansion::Expansion& e) const {
    std::vector<Expanded> qdd;
    for (std::size_t k = 0; k < tree_.links.size(); ++k) {
      qdd.push_back(e.acceleration(k));
    }
    return qdd;
  }
};

/// Row i, column j of a product of square matrices.
template <class A, class B>
Fraction entry(const std::vector<A>& a, const std::vector<B>& b, std::size_t n, std::size_t i,
               std::size_t j) {
  Fraction sum(0);
  for (std::size_t k = 0; k < n; ++k) {
    sum = sum + Fraction(a[i * n + k]) * Fraction(b[k * n + j]);
  }
  return sum;
}

bool equal(const Fraction& a, const Fraction& b) { return (a - b).is_zero(); }

/// q̈ of the program for τ of (1), fractions: numerator - q̈ * denominator is zero.
void Solved::expect_inverse(formulate::ForwardDynamics method) {
  options_.forward_dynamics = method;
  const expansion::Expansion e(tree_, options_.points, options_.gravity);
  ring = &e.ring();
  const std::vector<Fraction> qdd =
      outputs(e, "forward_dynamics", e.expand(equations::inverse_dynamics()).values);
  for (std::size_t i = 0; i < qdd.size(); ++i) {
    EXPECT_TRUE(equal(qdd[i], Fraction(e.acceleration(i)))) << i;
  }
}

TEST_P(Solved, FactorsMultiplyToTheMassMatrix) {
  const expansion::Expansion e(tree_, options_.points, options_.gravity);
  ring = &e.ring();
  const std::vector<Expanded> A = e.expand(equations::mass_matrix()).values;
  const std::vector<Fraction> all = outputs(e, "mass_matrix_factor", {});
  const std::size_t n = tree_.links.size();
  std::vector<Fraction> upper(n * n);  // L^T Δ
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_TRUE(equal(all[i * n + i], Fraction(1)));
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_TRUE(k <= i || all[i * n + k].value.is_zero());
      upper[k * n + i] = all[i * n + k] * all[n * n + i];
    }
  }
  for (std::size_t i = 0; i < n * n; ++i) {
    EXPECT_TRUE(equal(entry(upper, all, n, i / n, i % n), Fraction(A[i]))) << i;
  }
}

TEST_P(Solved, SolutionsOfTheMassMatrixSolve) {
  const expansion::Expansion e(tree_, options_.points, options_.gravity);
  ring = &e.ring();
  const std::vector<Expanded> A = e.expand(equations::mass_matrix()).values;
  const std::vector<Expanded> b = accelerations(e);
  const std::vector<Fraction> x = outputs(e, "mass_matrix_solve", b);
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) {
    Fraction sum(0);
    for (std::size_t k = 0; k < n; ++k) {
      sum = sum + Fraction(A[i * n + k]) * x[k];
    }
    EXPECT_TRUE(equal(sum, Fraction(b[i]))) << i;
  }
}

TEST_P(Solved, InversesOfTheMassMatrixInvertIt) {
  const expansion::Expansion e(tree_, options_.points, options_.gravity);
  ring = &e.ring();
  const std::vector<Expanded> A = e.expand(equations::mass_matrix()).values;
  const std::vector<Fraction> X = outputs(e, "mass_matrix_inverse", {});
  const std::size_t n = tree_.links.size();
  for (std::size_t i = 0; i < n * n; ++i) {
    EXPECT_TRUE(equal(entry(A, X, n, i / n, i % n), Fraction(i / n == i % n ? 1 : 0))) << i;
  }
}

TEST_P(Solved, ArticulatedBodiesInvertInverseDynamics) {
  expect_inverse(formulate::ForwardDynamics::kArticulated);
}

TEST_P(Solved, FactorsOfTheMassMatrixInvertInverseDynamics) {
  expect_inverse(formulate::ForwardDynamics::kFactor);
}

/// Six joints at the root that move a link in every way, and a limb.
class Trunks : public Programs {
 protected:
  Trunks() {
    for (std::size_t i = 0; i <= formulate::kTrunkLink; ++i) {
      model::Link& link = tree_.links[i];
      link.joint.rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      link.joint.axis = {};
      link.joint.axis[i < 3 ? i : 5 - i] = i % 2 == 0 ? 1 : -1;
      link.joint.offset = i == 0 ? link.joint.offset : model::Vector3{};
      link.inertia = i < formulate::kTrunkLink ? model::Inertia{} : link.inertia;
    }
  }

  /// What `builder` makes of q, q̇ and `last`.
  std::vector<Fraction> values(const expansion::Expansion& e, const formulate::Builder& builder,
                               const std::vector<Fraction>& last) {
    formulate::Recipe recipe = formulate::recipe_of("inverse_dynamics");
    recipe.freedom.trunk = true;
    recipe.build = builder;
    formulate::Variant variant = formulate::plain_variant(tree_);
    for (formulate::LinkVariant& link : variant.links) {
      link.angle = formulate::FrameAngle::kKeep;  // others turn by more than quarters
    }
    const program::Function f = formulate::build(tree_, recipe, options_, variant);
    const auto values = program::node_values<Exact>(
        f.graph, f.outputs,
        [&](int array, int k) {
          return array == 2 ? Exact(last[to_index(k)]) : input(e, recipe, array, k);
        },
        [&](program::Kind kind, const Exact& angle) { return trigonometric(e, kind, angle); });
    std::vector<Fraction> result;
    for (const program::Ref output : f.outputs) {
      const Fraction& x = values[program::node_index(output)].value;
      result.push_back(output < 0 ? -x : x);
    }
    return result;
  }
};

std::vector<program::Expr> last_argument(const formulate::Task& task) {
  std::vector<program::Expr> result;
  for (int k = 0; k < task.tree.dof(); ++k) {
    result.push_back(task.kinematics.argument(2, k));
  }
  return result;
}

/// R13: for any x, (1) for the joints' q̈ is B^T of (1) for the tree that the trunk sees.
TEST_P(Trunks, SeeTheEquationsOfTheirJoints) {
  ASSERT_TRUE(formulate::has_trunk(tree_));
  const expansion::Expansion e(tree_, options_.points, options_.gravity);
  ring = &e.ring();
  std::vector<Fraction> x;
  for (std::size_t k = 0; k < tree_.links.size(); ++k) {
    x.emplace_back(e.acceleration(k));
  }
  const auto joints = [](const formulate::Task& task) {
    return formulate::Trunk(task).joint_accelerations(last_argument(task));
  };
  const auto force = [](const formulate::Task& task) {
    return formulate::build_equation(task, "inverse_dynamics");
  };
  const std::vector<Fraction> tau = values(e, force, values(e, joints, x));
  const std::vector<Fraction> f = values(
      e,
      [](const formulate::Task& task) {
        return formulate::Trunk(task).forces(last_argument(task));
      },
      tau);
  const std::vector<Fraction> seen = values(
      e,
      [&](const formulate::Task& task) {
        const formulate::Trunk trunk(task);
        return force(trunk.seen());
      },
      x);
  ASSERT_EQ(seen.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_TRUE(equal(f[i], seen[i])) << i;
    EXPECT_FALSE(equal(f[i], x[i])) << i;
  }
}

TEST_P(Trunks, HaveJointsAtRightAngles) {
  model::Tree askew = tree_;
  askew.links[1].joint.axis = {Real("0.6"), Real("0.8"), 0};
  EXPECT_TRUE(model::has_free_base(askew));
  EXPECT_FALSE(formulate::has_trunk(askew));
  model::Tree parallel = tree_;
  parallel.links[4].joint.axis = parallel.links[3].joint.axis;
  EXPECT_FALSE(formulate::has_trunk(parallel));
}

INSTANTIATE_TEST_SUITE_P(
    Mechanisms, Trunks,
    testing::Values(Mechanism{"LimbR", chain("PPPRRRR")}, Mechanism{"LimbP", chain("PPPRRRP")},
                    Mechanism{"LimbsRP", {{-1, 0, 1, 2, 3, 4, 5, 5}, "PPPRRRRP"}}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Mechanisms, Solved,
                         testing::Values(Mechanism{"RR", chain("RR")}, Mechanism{"RP", chain("RP")},
                                         Mechanism{"PR", chain("PR")},
                                         Mechanism{"TreeRPP", {{-1, 0, 0}, "RPP"}}),
                         [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Mechanisms, Programs,
    testing::Values(Mechanism{"RRR", chain("RRR")}, Mechanism{"RRP", chain("RRP")},
                    Mechanism{"RPR", chain("RPR")}, Mechanism{"RPP", chain("RPP")},
                    Mechanism{"PRR", chain("PRR")}, Mechanism{"PRP", chain("PRP")},
                    Mechanism{"PPR", chain("PPR")}, Mechanism{"PPP", chain("PPP")},
                    Mechanism{"TreeRRR", {{-1, 0, 0}, "RRR"}},
                    Mechanism{"TreePRP", {{-1, 0, 0}, "PRP"}},
                    Mechanism{"ForestRRP", {{-1, -1, 1}, "RRP"}}, Mechanism{"RPRP", chain("RPRP")},
                    Mechanism{"PRRP", chain("PRRP")},
                    Mechanism{"TreeRPRP", {{-1, 0, 0, 1}, "RPRP"}},
                    Mechanism{"ForestPRPR", {{-1, 0, -1, 2}, "PRPR"}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn
