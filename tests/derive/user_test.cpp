// Equations of users: what is derived is what the engine evaluates, and what is wrong is refused.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "block/print.hpp"
#include "derive/user_robot.hpp"
#include "equations/joint_sums.hpp"

namespace treedyn {
namespace {

using support::Numbers;
using support::TreeShape;
using support::UserRobot;

const Real kExact("1e-40");  // 50 digits, a few thousand operations

/// Where all joints turn units refuse less.
const std::vector<TreeShape>& turning_shapes() {
  static const std::vector<TreeShape> kShapes = {{{-1, 0, 1}, "RRR"},
                                                 {{-1, 0, 0, 1, -1, 3}, "RRRRRR"}};
  return kShapes;
}

const std::vector<TreeShape>& shapes() {
  static const std::vector<TreeShape> kShapes = {
      {{-1, 0, 1}, "RPR"}, {{-1, 0, 0, 1, -1}, "RRPRP"}, {{-1, 0, 1, 1, 3, 2}, "PRRRPR"}};
  return kShapes;
}

void expect_derived(const std::string& text, const std::vector<TreeShape>& on,
                    const std::vector<model::InputText>& inputs = {}) {
  for (const TreeShape& shape : on) {
    UserRobot robot(shape);
    const auto equation = robot.read(text, inputs);
    const auto at = robot.inputs(equation);
    const Numbers expected = robot.expected(equation, at);
    for (const formulate::Way way :
         {formulate::Way::kToRoot, formulate::Way::kInLinks, formulate::Way::kInBase}) {
      const program::Function function = robot.derived(equation, way);
      EXPECT_LT(support::distance(UserRobot::run(function, at), expected), kExact)
          << text << " of " << shape.types << " way " << static_cast<int>(way);
    }
  }
}

class Derived : public testing::TestWithParam<const char*> {};

TEST_P(Derived, IsWhatTheEngineEvaluatesInAllKindsOfFrames) {
  expect_derived(GetParam(), shapes());
}

class DerivedOfTurningJoints : public testing::TestWithParam<const char*> {};

TEST_P(DerivedOfTurningJoints, IsWhatTheEngineEvaluatesInAllKindsOfFrames) {
  expect_derived(GetParam(), turning_shapes());
}

INSTANTIATE_TEST_SUITE_P(
    Symbols, Derived,
    testing::Values("D * sigma * qd", "N * sigma * qd", "T(D) * sigma * qd",
                    "T(N) * (E - sigma) * qd", "sigma * qd", "(E - sigma) * qd", "z_d * qd",
                    "s_d * ones", "s_d", "l_d * ones", "c_d * ones", "t_d * ones_P",
                    "T(z_d) * J_d * z_d * qd", "qd_d * tau", "D_P * z_d * sigma * qd", "W * ones_P",
                    "T(W) * D * sigma * qd", "g", "f_b", "T(W) * z_d * sigma * qd", "r", "p", "v",
                    "omega", "B", "G", "C * f_b + H * n_b", "gamma_f", "gamma_n", "K * omega",
                    "A * qdd + B + G"));

INSTANTIATE_TEST_SUITE_P(Matrices, Derived,
                         testing::Values("D", "A", "C", "H", "J_v", "J_w", "l_D", "c_fD", "t_fD",
                                         "K", "dot(A)", "T(J_v) * m_d * dot(J_v)",
                                         "T(ones) * m_d * J_v", "m_d * D * T(D)", "J_d", "W",
                                         "Lam(c_fD)", "T(Lam(c_fD))", "R(link1) * T(R(joint2))",
                                         "s_d * D - D * s_d", "l_D - l_d * D"));

INSTANTIATE_TEST_SUITE_P(
    Operations, Derived,
    testing::Values(
        "T(qd) * tau", "1/2 * T(qd) * A * qd", "T(at(link1)) * tau", "at(joint2)",
        "under(link1) * qd", "above(link2) * qd", "T(at_point(point0)) * v", "diagb(omega) * qd",
        "T(diagb(omega)) * omega", "Lam(diagb(omega)) * J_d * omega", "LamT(s_d) * omega",
        "T(Lam(diagb(r)) * J_v) * omega", "Lam(T(ones) * m_d * r) * T(ones) * omega",
        "Lam(r) * T(ones) * omega", "T(Lam(r)) * omega", "qd * T(qd) * tau", "sqrt(2) * qd",
        "qd * pi / 3", "0 * qd", "T(ones) * m_d * r / (T(ones) * m_d * ones)",
        "-D * sigma * (qd - -qd)", "Lam(LamT(c_fD) * z_d) * omega", "T(LamT(J_v)) * omega",
        "T(ones) * r + T(ones_P) * p", "Lam(Lam(c_fD) * z_d * sigma * D) * omega",
        "R(link1) * T(at(link1)) * omega", "T(qd) * (A * qdd + B)", "T(W) * J_d * omega",
        "D_P * Lam(diagb(omega)) * J_d * omega", "D_P * LamT(LamT(s_d) * N * z_d * sigma) * omega",
        "T(W) * diagb(D * sigma * qd) * (LamT(c_d) * D * Lam(diagb(N * omega)) * omega)",
        "(T(r) * r) * R(link1)", "dot((T(r) * r) * R(link1))", "T(r) * r * R(link1)",
        "T(r) * r * R(link1) * (T(ones) * J_v)", "T(ones) * J_v * (T(r) * r)",
        "T(ones) * m_d * J_v / (T(ones) * m_d * ones)", "r * T(r) * J_v",
        "(T(ones) * m_d * r) * T(T(ones) * m_d * r) * T(ones) * J_w", "B * T(qd)", "qd * T(B)",
        "B * T(B)", "A * qd * T(qd) * A", "J_v * qd * T(qd)", "T(ones) * m_d * r * T(B)",
        "qd * T(J_v * qd) * m_d * J_v", "omega * T(f_b) * T(C)",
        "T(T(D) * omega) * J_d * T(D) * omega", "T(omega) * LamT(c_d) * T(D) * omega",
        "T(tau) * sigma * T(z_d) * Lam(s_d) * J_d * T(N) * omega", "T(W) * Lam(c_fD) * W * p",
        "Lam(diagb(v)) * D_P * W * n_b", "D_P * Lam(z_d) * W * p",
        "D_P * Lam(Lam(diagb(r)) * c_fD) * W * gamma_f", "T(W) * D * Lam(c_fD) * W * p"));

INSTANTIATE_TEST_SUITE_P(
    NumbersOfVectorsTimesVectors, DerivedOfTurningJoints,
    testing::Values("A * omega", "A * r", "A * J_v", "A * c_d", "T(r) * A", "A * D * s_d",
                    "T(A) * A * omega", "T(J_v) * m_d * J_v * omega", "T(r) * A * qd",
                    "qd * T(qd) * A * r", "T(qd) * A * qd * T(ones) * r", "T(omega) * A * omega",
                    "Lam(A * c_d) * omega", "T(Lam(A * c_d)) * omega",
                    "Lam(Lam(c_fD) * z_d * A) * omega", "diagb(A * r) * A * qd",
                    "T(l_D * A) * omega", "T(J_w) * J_d * J_w * W * p + A * r",
                    "(A + T(A)) * omega", "(T(J_w) * J_d * J_w + A) * omega",
                    "(T(J_w) * J_d * J_w * Lam(diagb(r)) + A * Lam(c_d)) * omega", "0 * A * omega",
                    "T(ones) * A * Lam(diagb(r)) * omega", "C * D_P * J_w * omega",
                    "T(A * s_d) * K * omega"));

INSTANTIATE_TEST_SUITE_P(
    SymmetricMatrices, DerivedOfTurningJoints,
    testing::Values("C * T(C)", "H * T(H)", "T(T(ones) * m_d * J_v / 3) * (T(ones) * m_d * J_v)",
                    "qd * T(qd)", "G * T(G)", "T(J_w) * ones * T(ones) * J_w", "D * T(D)",
                    "ones * T(ones)", "T(D) * D", "D + T(D)", "T(D) * m_d * D",
                    "T(J_v) * m_d * J_v", "A * A", "N * T(N)", "T(N) * N", "T(D) * W * T(W) * D",
                    "N * T(N) + T(N) * N", "D * T(D) * D * T(D)", "T(D) * D * T(D) * D",
                    "T(J_w) * under(link1) * J_w", "T(D) * (ones * T(ones)) * D",
                    "diagb(qd) * T(D) * D * diagb(qd)"));

INSTANTIATE_TEST_SUITE_P(Rates, Derived,
                         testing::Values("dot(s_d) * ones", "dot(l_d) * ones", "dot(c_d) * ones",
                                         "dot(t_d) * ones_P", "dot(z_d) * qd", "dot(J_v) * qd",
                                         "dot(J_v * qd)", "dot(J_d * omega)", "dot(v)", "dot(r)",
                                         "dot(dot(r))", "dot(m_d) * qd", "dot(qd_d) * qd",
                                         "dot(R(link2))", "dot(B)"));

/// Composites on both sides of what is not symmetric, with rates of places and without.
INSTANTIATE_TEST_SUITE_P(
    Enclosed, Derived,
    testing::Values(
        "T(J_v) * m_d * dot(J_v) + T(J_w) * J_d * dot(J_w) + 1/2 * T(J_w) * (Lam(diagb(omega)) * "
        "J_d - J_d * Lam(diagb(omega)) - Lam(diagb(J_d * omega))) * J_w",
        "T(dot(J_v)) * m_d * J_v + T(J_w) * Lam(diagb(omega)) * J_d * J_w",
        "T(dot(J_v)) * m_d * dot(J_v)", "T(J_w) * J_d * Lam(diagb(omega)) * J_d * J_w",
        "T(J_v) * m_d * Lam(diagb(J_v * qd)) * J_w",
        "T(Lam(c_fD) * z_d * sigma) * m_d * dot(Lam(c_fD)) * z_d * sigma",
        "T(J_v) * m_d * Lam(diagb(dot(s_d) * ones)) * J_w",
        "T(J_w) * Lam(D * dot(s_d) * N) * m_d * J_w"));

INSTANTIATE_TEST_SUITE_P(RatesOfSymmetricMatrices, Derived,
                         testing::Values("dot(diagb(qd) * A * diagb(qd))", "dot(T(l_d) * l_d)",
                                         "dot(T(s_d) * s_d)", "dot(T(s_d + l_d) * (s_d + l_d))",
                                         "dot(T(s_d * D) * m_d * s_d * D)",
                                         "dot(sigma * A * sigma)", "dot(T(J_v) * m_d * J_v)",
                                         "dot(T(J_w) * J_d * J_w)", "dot(T(D) * m_d * D)",
                                         "dot(T(z_d) * J_d * z_d)",
                                         "dot(T(J_v - J_v * sigma) * m_d * J_v * (E - sigma))",
                                         "dot(3 * A)", "dot(-A)", "dot(dot(A))"));

/// A rate, and what the product rule makes of it.
struct RateByHand {
  const char* rate;
  const char* by_hand;
};
void PrintTo(const RateByHand& rate, std::ostream* out) { *out << rate.rate; }

class RateOfNumber : public testing::TestWithParam<RateByHand> {};

TEST_P(RateOfNumber, IsThatOfTheProductRule) {
  const auto& [rate, by_hand] = GetParam();
  for (const TreeShape& shape : shapes()) {
    UserRobot robot(shape);
    const auto both = robot.read("(" + std::string(rate) + ") - (" + by_hand + ")");
    const auto at = robot.inputs(both);
    EXPECT_LT(abs(robot.expected(both, at).front()), kExact) << shape.types;
    const auto alone = robot.read(rate);
    EXPECT_GT(abs(robot.expected(alone, robot.inputs(alone)).front()), Real("1e-6"));
  }
  expect_derived(rate, shapes());
}

INSTANTIATE_TEST_SUITE_P(
    QuadraticForms, RateOfNumber,
    testing::Values(
        RateByHand{"dot(1/2 * T(qd) * A * qd)", "T(qd) * A * qdd + 1/2 * T(qd) * dot(A) * qd"},
        RateByHand{"dot(T(omega) * J_d * omega)",
                   "2 * T(omega) * J_d * dot(omega) + T(omega) * dot(J_d) * omega"},
        RateByHand{"dot(T(r) * J_d * r / 3)",
                   "2/3 * T(r) * J_d * dot(r) + 1/3 * T(r) * dot(J_d) * r"},
        RateByHand{"dot(T(r) * m_d * r)", "T(dot(r)) * m_d * r + T(r) * m_d * dot(r)"},
        RateByHand{"dot(T(omega) * T(J_d) * omega / 2)",
                   "T(omega) * J_d * dot(omega) + 1/2 * T(omega) * dot(J_d) * omega"},
        RateByHand{"dot(T(A * qd) * qd)", "2 * T(qd) * A * qdd + T(qd) * dot(A) * qd"},
        RateByHand{"dot(-T(v) * v)", "-T(dot(v)) * v - T(v) * dot(v)"},
        RateByHand{"dot(T(qd) * (sigma * qd_d) * qd)",
                   "2 * T(qdd) * sigma * qd_d * qd + T(qd) * sigma * dot(qd_d) * qd"},
        RateByHand{"dot(T(J_v * qd) * m_d * under(link1) * J_v * qd)",
                   "2 * T(J_v * qd) * under(link1) * m_d * dot(J_v * qd)"},
        RateByHand{"dot(T(qd) * (T(J_v) * m_d * J_v + 2 * T(J_w) * J_d * J_w) * qd)",
                   "2 * T(J_v * qd) * m_d * dot(J_v * qd) + 4 * T(omega) * J_d * dot(omega)"},
        RateByHand{"dot(T(J_v * qd) * m_d * r)",
                   "T(dot(J_v * qd)) * m_d * r + T(J_v * qd) * m_d * dot(r)"},
        RateByHand{"dot(dot(T(r) * m_d * r))",
                   "2 * T(dot(r)) * m_d * dot(r) + 2 * T(r) * m_d * dot(dot(r))"},
        RateByHand{"dot(T(qd) * T(J_v) * m_d * J_v * qd * T(r) * r)",
                   "2 * T(J_v * qd) * m_d * dot(J_v * qd) * T(r) * r + "
                   "2 * T(J_v * qd) * m_d * J_v * qd * T(r) * dot(r)"}));

/// Operations for a chain of six turning joints, before any search.
int cost_of(const char* text) {
  UserRobot robot({{-1, 0, 1, 2, 3, 4}, "RRRRRR"});
  return program::cost(robot.derived(robot.read(text), formulate::Way::kInLinks)).total();
}

/// The columns of x y^T share x and y.
TEST(Derived, TakesTheFactorsOfColumnsTimesRowsOnce) {
  const int B = cost_of("B");
  EXPECT_LE(cost_of("B * T(qd)"), B + 36);
  EXPECT_LE(cost_of("qd * T(B)"), B + 36);
  EXPECT_LE(cost_of("T(at(link1)) * r * T(B)"), cost_of("T(at(link1)) * r") + B + 3 * 6);
}

/// The two halves of the rate of an energy are one.
TEST(Rates, OfEnergiesCostWhatPowersDo) {
  const auto cost = cost_of;
  const int power = cost("T(qd) * (A * qdd + B)");
  for (const char* const energy :
       {"dot(1/2 * T(qd) * A * qd)", "dot(T(qd) * A * qd)", "dot(1/3 * T(A * qd) * qd)",
        "dot(1/2 * (T(J_v * qd) * m_d * J_v * qd + T(omega) * J_d * omega))"}) {
    EXPECT_LE(cost(energy), power + power / 20) << energy;
  }
}

model::EquationText text_of(const char* name, const char* value,
                            const std::vector<model::InputText>& inputs = {}) {
  model::EquationText text;
  text.name = name;
  text.value = value;
  text.inputs = inputs;
  return text;
}

/// Numbers with names are factors, not what stands behind them.
TEST(Rates, OfPowersOfNumbersShareThem) {
  UserRobot robot(turning_shapes()[0]);
  std::vector<model::EquationText> texts = {text_of("e0", "T(qd) * qd")};
  for (int k = 1; k < 10; ++k) {
    const std::string before = "e" + std::to_string(k - 1);
    texts.push_back(text_of(("e" + std::to_string(k)).c_str(), (before + " * " + before).c_str()));
  }
  texts.push_back(text_of("rate", "dot(e9)"));
  const auto read = equations::read_equations(texts, robot.tree, robot.points);
  const auto cost = [&](const equations::UserEquation& equation) {
    return program::cost(robot.derived(equation, formulate::Way::kInLinks)).total();
  };
  EXPECT_LE(cost(read.back()), cost(read[9]) + 20);
}

TEST(Rates, OfTheMassMatrixTakeItsComposites) {
  const TreeShape chain = {{-1, 0, 1, 2, 3, 4, 5, 6}, "RRRRRRRR"};
  UserRobot robot(chain);
  const auto equation = robot.read("dot(A)");
  ASSERT_TRUE(equation.rate_of.has_value());
  const auto derived = formulate::derived(equation, 8, 2);
  EXPECT_TRUE(derived->derivation.values.acted().contains(derive::Rule::kValueRates));
  const int A = program::cost(robot.derived(robot.read("A"), formulate::Way::kInLinks)).total();
  const int rate = program::cost(robot.derived(equation, formulate::Way::kInLinks)).total();
  EXPECT_LT(rate, 4 * A);
  EXPECT_FALSE(robot.read("dot(A) * qd").rate_of.has_value());
}

TEST(Derived, TakesColumnsOfTheUser) {
  UserRobot robot(shapes()[1]);
  const auto equation = robot.read(
      "gain * C * v_ref + T(J_w) * diagb(x) * ones * axis",
      {{"gain", "", 1, {}}, {"v_ref", "point", 3, {}}, {"x", "link", 1, {}}, {"axis", "", 3, {}}});
  ASSERT_EQ(equation.arguments.size(), 5U);
  EXPECT_EQ(equation.arguments[0].name, "q");
  EXPECT_EQ(equation.arguments[1].name, "gain");
  const auto at = robot.inputs(equation);
  EXPECT_LT(support::distance(UserRobot::run(robot.derived(equation, formulate::Way::kToRoot), at),
                              robot.expected(equation, at)),
            kExact);
}

TEST(Derived, MultipliesVectorsOfTheUserByNumbersMadeOfVectors) {
  for (const char* text :
       {"(T(qd) * A * qd) * axis", "T(axis) * (T(qd) * A * qd)", "A * x", "T(x) * A * x"}) {
    expect_derived(text, turning_shapes(), {{"axis", "", 3, {}}, {"x", "link", 3, {}}});
  }
}

/// The size rule by hand.
/// A vector of the user stands on both sides of a sum over links, and alone.
TEST(Derived, ProjectsOnAVectorOfTheUser) {
  for (const char* const text :
       {"T(x) * (x * T(qd) * tau + x * T(qd) * B)", "T(x) * (x * T(qd) * (tau - G) + x * power)"}) {
    expect_derived(text, turning_shapes(), {{"x", "", 3, {}}, {"power", "", 1, {}}});
  }
}

TEST(Engine, MultipliesVectorsByNumbersMadeOfVectors) {
  UserRobot robot(turning_shapes()[1]);
  const auto product = robot.read("T(J_w) * J_d * J_w * r");
  const auto at = robot.inputs(product);
  const Numbers X = robot.expected(robot.read("T(J_w) * J_d * J_w"), at);
  const Numbers r = robot.expected(robot.read("r"), at);
  const auto n = static_cast<std::size_t>(robot.tree.size());
  Numbers by_hand(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        by_hand[3 * i + k] += X[i * n + j] * r[3 * j + k];
      }
    }
  }
  EXPECT_LT(support::distance(robot.expected(product, at), by_hand), kExact);
}

/// Frames of links come from q: without it everything stays in the base.
TEST(Derived, StaysInTheBaseFrameWithoutJointPositions) {
  for (const char* text : {"diagb(D * g)", "D * g", "Lam(diagb(N * g)) * x", "gain * W * f_b",
                           "T(D) * diagb(y) * g"}) {
    expect_derived(text, shapes(),
                   {{"gain", "", 1, {}}, {"x", "link", 3, {}}, {"y", "link", 1, {}}});
  }
}

/// E9: s_i = 0 for links on the base.
TEST(Engine, HasNoVectorFromTheBaseToLinksOnIt) {
  UserRobot robot(shapes()[1]);
  const auto equation = robot.read("s_d * ones");
  const Numbers s = robot.expected(equation, robot.inputs(equation));
  for (int i = 0; i < robot.tree.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(s[static_cast<std::size_t>(3 * i + k)] == 0,
                robot.tree.links[static_cast<std::size_t>(i)].father == model::kGround);
    }
  }
}

TEST(Derived, TellsNumbersApartThatAgreeInTwelveDigits) {
  UserRobot robot(shapes()[0]);
  const auto equation = robot.read("1234567890123.25 * qd - 1234567890123.75 * qd");
  const auto at = robot.inputs(equation);
  const Numbers x = UserRobot::run(robot.derived(equation, formulate::Way::kToRoot), at);
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_LT(abs(x[k] + at[0][k] / 2), kExact);
  }
}

/// Division by what a tree decides takes the masses of the tree that is evaluated.
TEST(Engine, DividesByTheMassesOfItsTree) {
  UserRobot robot(shapes()[0]);
  const auto equation = robot.read("1 / (T(ones) * m_d * ones / 2)");
  model::Tree heavier = robot.tree;
  Real sum = 0;
  for (model::Link& link : heavier.links) {
    link.inertia.mass += 3;
    sum += link.inertia.mass;
  }
  const Numbers x = engine::UserFunction<Real>(equation, heavier, robot.points, robot.gravity)({});
  EXPECT_LT(abs(x.front() * sum - 2), kExact);
}

/// Names within an equation mean what they mean there, whoever uses it.
TEST(Equations, KeepTheMeaningOfTheirNamesWhereOthersUseThem) {
  const UserRobot robot(shapes()[0]);
  model::EquationText inner = text_of("inner", "gain * T(ones) * m_d * r");
  inner.parameters = {{"gain", Real(2)}};
  const model::EquationText outer = text_of("outer", "gain * inner", {{"gain", "", 1, {}}});
  const auto read = equations::read_equations({inner, outer}, robot.tree, robot.points);
  EXPECT_EQ(block::print(read[1].expression), "gain inner");
  const auto of_inner = std::ranges::find(read[1].expression.operands(), "inner",
                                          [](const auto& e) { return e.node().name; });
  ASSERT_NE(of_inner, read[1].expression.operands().end());
  EXPECT_EQ(block::print_definition(*of_inner), "inner = 2 1_N^T m^d r");

  const auto message = [&](const std::vector<model::EquationText>& texts) -> std::string {
    try {
      equations::read_equations(texts, robot.tree, robot.points);
    } catch (const InputError& error) {
      return error.message();
    }
    return "accepted";
  };
  EXPECT_EQ(message({text_of("one", "k * T(ones) * m_d * ones", {{"k", "", 1, {}}}),
                     text_of("two", "T(k) * k * one", {{"k", "", 3, {}}})}),
            "equation 'two': uses an equation with an input 'k' of another shape; expected one "
            "array of that name");
  model::EquationText weight = text_of("weight", "g * T(ones) * m_d * ones");
  weight.parameters = {{"g", Real("9.81")}};
  EXPECT_EQ(message({weight}),
            "equation 'weight': 'g' is a parameter and a symbol; expected different names");
  std::vector<model::EquationText> doubled = {text_of("e0", "T(ones) * m_d * r")};
  std::vector<std::string> names;
  for (int k = 1; k < 24; ++k) {
    names.push_back("e" + std::to_string(k));
    doubled.push_back(
        text_of(names.back().c_str(),
                ("e" + std::to_string(k - 1) + " + e" + std::to_string(k - 1)).c_str()));
  }
  EXPECT_EQ(message(doubled).substr(0, 53),  // the first that is too large when read alone
            "equation 'e10' uses others too deeply or too often; e");
}

struct Refusal {
  const char* value;
  int column;
  const char* message;
};

/// In messages of tests.
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << '"' << refusal.value << '"'; }

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithThePlaceAndTheReason) {
  const UserRobot robot(shapes()[0]);
  model::EquationText text;
  text.name = "asked";
  text.value = GetParam().value;
  text.value_at = [](std::size_t offset) {
    return Location{"mine.yaml", 3, 12 + static_cast<int>(offset)};
  };
  try {
    equations::read_equations({text}, robot.tree, robot.points);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().column, 12 + GetParam().column) << error.what();
    EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().message));
    EXPECT_THAT(error.what(), testing::HasSubstr("; expected "));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Refused,
    testing::Values(Refusal{"J_v * qd + f_b", 9, "does not conform"},
                    Refusal{"T(ones) * tau", 8, "adds N to N m"},
                    Refusal{"A * qdd + qd", 8, "adds 1/s to N m"},
                    Refusal{"momentum", 0, "there is no symbol 'momentum'"},
                    Refusal{"asked * 2", 0, "uses itself"}, Refusal{"dot(tau)", 0, "is not known"},
                    Refusal{"under(nobody) * qd", 0, "there is no link or joint 'nobody'"},
                    Refusal{"at_point(x)", 0, "there is no point 'x'"},
                    Refusal{"qd / qd", 3, "divides by a block"}, Refusal{"qd / 0", 3, "by zero"},
                    Refusal{"D * ", 4, "ends too early"}, Refusal{"(D * m_d", 0, "expected ')'"},
                    Refusal{"qd ^ 2", 3, "to a power"}, Refusal{"Lam(qd)", 0, "3-vectors"},
                    Refusal{"diagb(D)", 0, "expected a column"},
                    Refusal{"sin(qd)", 0, "takes 'sin' of a block expression"},
                    Refusal{"exp(qd)", 0, "there is no function"},
                    Refusal{"qd qd", 3, "unexpected 'qd'"},
                    Refusal{"1 + qd", 2, "does not conform"}, Refusal{"", 0, "ends too early"},
                    Refusal{"2 $ qd", 2, "unexpected '$'"}));

TEST(Refused, PowersThatNestTooDeeply) {
  std::string text = "1";
  for (int k = 0; k < 9000; ++k) {
    text += "^1";
  }
  EXPECT_THROW(UserRobot(shapes()[0]).read(text + " * qd"), InputError);
}

TEST(Derived, CountsNoJointsWhereJointsMimicOthers) {
  UserRobot robot(shapes()[0]);
  robot.tree.drives[2] = {1, Real(2), Real("0.1")};
  robot.tree.coordinates = {0, 1};
  for (const char* const text :
       {"T(at(joint2)) * G", "T(at(joint1)) * A * at(joint1)", "T(qd) * A * at(joint2)",
        "T(at(joint2)) * sigma * (A * qdd + B)", "T(at(joint1)) * C * f_b",
        "T(at(link1)) * J_v * at(joint1)", "T(at(joint1)) * (E - sigma) * (G + B)",
        "T(at(joint1)) * diagb(G) * at(joint1)"}) {
    EXPECT_TRUE(equations::picks_joints(robot.read(text).expression)) << text;
    EXPECT_TRUE(equations::picks_joints(transpose(robot.read(text).expression))) << text;
  }
  for (const char* const text :
       {"T(qd) * A * qd", "T(qd) * (A * qdd + B)", "T(qd) * G", "T(at(link1)) * J_v * qd",
        "T(ones) * m_d * dot(J_v) * qd", "T(ones) * m_d * r", "T(qd) * dot(A) * qd",
        "T(at(joint2)) * qd", "T(qd) * C * f_b", "T(C) * qd", "gamma_f", "T(at(link1)) * omega",
        "1/2 * T(qd) * (T(J_v) * m_d * under(link1) * J_v) * qd", "-T(g) * m_d * r",
        "T(at(joint1)) * sigma * qd_d * G"}) {
    EXPECT_FALSE(equations::picks_joints(robot.read(text).expression)) << text;
    EXPECT_FALSE(equations::picks_joints(transpose(robot.read(text).expression))) << text;
  }
  const UserRobot turning(turning_shapes()[0]);
  for (const char* const text : {"T(qd) * qd_d * A * qd", "T(qd) * diagb(G) * qd"}) {
    EXPECT_FALSE(equations::picks_joints(turning.read(text).expression)) << text;
  }
  EXPECT_TRUE(equations::counts_joints(robot.read("A * qd")));
  EXPECT_TRUE(equations::counts_joints(robot.read("T(qd) * tau")));
  auto equation = robot.read("T(ones) * m_d * J_v * qd");
  EXPECT_FALSE(equations::counts_joints(equation));
  std::vector<Numbers> at = {robot.random(2), robot.random(2)};
  EXPECT_LT(support::distance(UserRobot::run(robot.derived(equation, formulate::Way::kToRoot), at),
                              robot.expected(equation, at)),
            kExact);
}

TEST(Units, AreWorkedOutFromTheLeaves) {
  const UserRobot robot(shapes()[0]);
  EXPECT_EQ(robot.read("A").unit, "kg m^2|kg m|kg");
  EXPECT_EQ(robot.read("B").unit, "N m|N");
  EXPECT_EQ(robot.read("C").unit, "m|1");
  EXPECT_EQ(robot.read("T(qd) * tau").unit, "W");
  EXPECT_EQ(robot.read("1/2 * T(qd) * A * qd").unit, "J");
  EXPECT_EQ(robot.read("T(ones) * m_d * J_v * qd").unit, "kg m/s");
  EXPECT_EQ(robot.read("dot(J_v) * qd").unit, "m/s^2");
  EXPECT_EQ(robot.read("dot(m_d) * r + m_d * J_v * qd").unit, "kg m/s");
  EXPECT_EQ(robot.read("J_v").unit, "m|1");
}

TEST(Units, AreJoulesOfWhatHasTheFormOfAnEnergy) {
  const UserRobot robot({{-1, 0, 1}, "RRR"});
  for (const char* text :
       {"1/2 * T(qd) * (T(J_v) * m_d * J_v + T(J_w) * J_d * J_w) * qd",
        "T(omega) * J_d * omega / 2", "1/2 * T(J_v * qd) * m_d * J_v * qd", "-T(g) * m_d * r",
        "T(r) * m_d * g", "1/2 * T(qd) * A * qd - T(g) * m_d * r", "sqrt(2) * (T(qd) * A * qd)"}) {
    EXPECT_EQ(robot.read(text).unit, "J") << text;
  }
  for (const char* text :
       {"T(at(joint1)) * tau", "T(ones) * tau", "T(at(joint1)) * B", "T(at(joint1)) * G",
        "T(ones) * G", "T(at(joint1)) * A * qdd", "1/2 * T(qd) * A * qd + T(at(joint1)) * tau"}) {
    EXPECT_EQ(robot.read(text).unit, "N m") << text;
  }
  EXPECT_EQ(robot.read("tau").unit, "N m");
}

TEST(Rates, AreKnownOfTheSymbolsThatDotMeets) {
  const UserRobot robot(turning_shapes()[0]);
  EXPECT_TRUE(robot.read("A").rates.empty());
  EXPECT_TRUE(robot.read("dot(D * m_d) * qd").rates.empty());
  const auto rates = robot.read("T(J_v) * m_d * dot(J_v)").rates;
  std::vector<std::string> names;
  std::ranges::transform(rates, std::back_inserter(names),
                         [](const auto& row) { return row.first; });
  EXPECT_EQ(names, (std::vector<std::string>{"c^d", "l^d", "s^d", "z^d"}));
}

}  // namespace
}  // namespace treedyn
