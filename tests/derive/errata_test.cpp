// The errata find themselves: (3) follows from (2) by R11 alone, the printed forms do not; and
// whatever stands in an equation arrives in the code that is derived from it.
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "derive/user_robot.hpp"
#include "equations/equations.hpp"
#include "equations/table.hpp"
#include "expansion/expansion.hpp"

namespace treedyn {
namespace {

using support::Numbers;
using support::TreeShape;
using support::UserRobot;

const std::string kT1 = "LamT(c_fD) * LamT(z_d * sigma * qd_d) * N";
const std::string kT2 = "D * LamT(z_d * (E - sigma) * qd_d) * N";
const std::string kInner = "LamT(c_fD) * z_d * sigma * qd_d * D";
const std::string kT3 = "LamT(" + kInner + " + LamT(c_fD) * diagb(N * z_d * sigma * qd))";
const std::string kGyro = "Lam(diagb(D * z_d * sigma * qd))";

std::string revolute(const std::string& K, const std::string& gyro) {
  return "sigma * T(z_d) * (-T(Lam(c_fD)) * m_d * (" + K +
         ") + T(D) * J_d * D * sigma * qd_d * LamT(z_d) * N + T(D) * " + gyro +
         " * J_d * D) * z_d * sigma * qd";
}
std::string prismatic(const std::string& K) {
  return "(E - sigma) * T(z_d) * T(D) * m_d * (" + K + ") * z_d * sigma * qd";
}
std::string bias(const std::string& K, const std::string& gyro = kGyro) {
  return revolute(K, gyro) + " + " + prismatic(K);
}

const std::string kK = kT1 + " + 2 * " + kT2 + " + " + kT3;
const std::string kE1 =
    kT1 + " + 2 * " + kT2 + " + LamT(" + kInner + " + LamT(c_fD) * N * sigma * z_d * qd_d)";
const std::string kE3 = "Lam(D * z_d * sigma * qd_d)";

/// J_v^T m dJ_v/dt qd + J_ω^T (J dJ_ω/dt qd + ω × J ω): what Lagrange makes of (2).
const std::string kFromTwo =
    "T(J_v) * m_d * dot(J_v) * qd + T(J_w) * (J_d * dot(J_w) * qd + Lam(diagb(omega)) * J_d * "
    "omega)";

class Errata : public testing::TestWithParam<TreeShape> {
 protected:
  Errata() : robot_(GetParam()), expansion_(robot_.tree, robot_.points, robot_.gravity) {}

  [[nodiscard]] block::Expression read(const std::string& text) const {
    return robot_.read(text).expression;
  }
  /// Every entry of the difference to (3), expanded, is the zero polynomial.
  [[nodiscard]] bool is_bias_force(const block::Expression& e) const {
    const expansion::Entries entries = expansion_.expand(e - equations::bias_force());
    return std::all_of(entries.values.begin(), entries.values.end(),
                       [](const expansion::Expanded& entry) { return entry.is_zero(); });
  }

  /// E2, T2 without mass and lever arm, which units would refuse.
  [[nodiscard]] block::Expression E2() const {
    return read(revolute(kT1 + " + " + kT3, kGyro) + " + " + prismatic(kK)) +
           read("sigma * T(z_d) * (2 * " + kT2 + ") * z_d * sigma * qd");
  }

  UserRobot robot_;
  expansion::Expansion expansion_;
};

TEST_P(Errata, CorrectedFormFollowsFromTheMassMatrix) {
  EXPECT_TRUE(is_bias_force(read(kFromTwo)));
  EXPECT_TRUE(is_bias_force(read(bias(kK))));
}

TEST_P(Errata, PrintedFormsDoNot) {
  EXPECT_FALSE(is_bias_force(read(bias(kE1))));          // E1
  EXPECT_FALSE(is_bias_force(read(bias(kK, kE3))));      // E3
  const std::string without_T3 = kT1 + " + 2 * " + kT2;  // E4, a reading that conforms
  EXPECT_FALSE(is_bias_force(read(revolute(kK, kGyro) + " + " + prismatic(without_T3))));
  EXPECT_FALSE(is_bias_force(E2()));
}

TEST_P(Errata, ShapesRefuseE4AndUnitsRefuseE2) {
  const std::string E4 = kT1 + " + 2 * " + kT2 + " + (" + kInner + ")";
  EXPECT_THROW(read(prismatic(E4)), InputError);
  const std::string E2 = "sigma * T(z_d) * (-T(Lam(c_fD)) * m_d * (" + kT1 + " + " + kT3 +
                         ") + 2 * " + kT2 + ") * z_d * sigma * qd";
  EXPECT_THROW(read(E2), InputError);
}

TEST_P(Errata, PlantedErrorsArriveInTheDerivedCode) {
  const auto right = robot_.read("B");
  const auto at = robot_.inputs(right);
  const Numbers B = robot_.expected(right, at);
  const std::string one_T2 = kT1 + " + " + kT2 + " + " + kT3;
  const std::string no_T1 = "2 * " + kT2 + " + " + kT3;
  for (const std::string& text :
       {bias(kE1), bias(kK, kE3), bias(one_T2), bias(no_T1), revolute(kK, kGyro)}) {
    const auto planted = robot_.read(text);
    const Numbers derived = UserRobot::run(robot_.derived(planted, formulate::Way::kToRoot), at);
    EXPECT_LT(support::distance(derived, robot_.expected(planted, at)), Real("1e-40"));
    EXPECT_GT(support::distance(derived, B), Real("1e-6"));
  }
  auto planted = right;
  planted.expression = E2();
  const Numbers derived = UserRobot::run(robot_.derived(planted, formulate::Way::kToRoot), at);
  EXPECT_LT(support::distance(derived, robot_.expected(planted, at)), Real("1e-40"));
  EXPECT_GT(support::distance(derived, B), Real("1e-6"));
}

TEST_P(Errata, PlantedErrorsArriveInTheDerivedMassMatrix) {
  const auto right = robot_.read("A");
  const auto at = robot_.inputs(right);
  const Numbers A = robot_.expected(right, at);
  const std::string lever = "-T(Lam(c_fD)) * m_d * J_v";
  const std::string turning = "T(D) * J_d * D * z_d * sigma";
  const std::string sliding = "(E - sigma) * T(z_d) * T(D) * m_d * J_v";
  const std::string head = "sigma * T(z_d) * (";
  const auto derived = [&](const std::string& text) {
    const auto equation = robot_.read(text);
    const Numbers result = UserRobot::run(robot_.derived(equation, formulate::Way::kToRoot), at);
    EXPECT_LT(support::distance(result, robot_.expected(equation, at)), Real("1e-40")) << text;
    return result;
  };
  EXPECT_LT(support::distance(derived(head + lever + " + " + turning + ") + " + sliding), A),
            Real("1e-40"));
  for (const std::string& text :
       {head + lever + " + 2 * " + turning + ") + " + sliding, head + lever + ") + " + sliding,
        head + lever + " + " + turning + ") + 2 * " + sliding, head + turning + ") + " + sliding,
        head + lever + " + " + turning + ")"}) {
    EXPECT_GT(support::distance(derived(text), A), Real("1e-6")) << text;
  }
}

TEST_P(Errata, PlantedErrorsArriveInTheDerivedKineticEnergy) {
  const auto right = robot_.read("1/2 * T(qd) * A * qd");
  const auto at = robot_.inputs(right);
  const Numbers T = robot_.expected(right, at);
  const std::string moving = "T(J_v) * m_d * J_v";
  const std::string turning = "T(J_w) * J_d * J_w";
  for (const auto& [text, planted] : std::vector<std::pair<std::string, bool>>{
           {"1/2 * T(qd) * (" + moving + " + " + turning + ") * qd", false},
           {"T(qd) * A * qd", true},
           {"1/2 * T(qd) * " + moving + " * qd", true},
           {"1/2 * T(qd) * (" + moving + " - " + turning + ") * qd", true},
           {"1/2 * T(qd) * (" + moving + " + T(J_w) * J_d * N * z_d * sigma) * qd", true},
           {"1/2 * T(qd) * (T(J_v) * m_d * LamT(c_fD) * z_d * sigma + " + turning + ") * qd", true},
           {"1/2 * T(qd) * sigma * A * qd", true}}) {
    const auto equation = robot_.read(text);
    const Numbers derived = UserRobot::run(robot_.derived(equation, formulate::Way::kToRoot), at);
    EXPECT_LT(support::distance(derived, robot_.expected(equation, at)), Real("1e-40")) << text;
    EXPECT_EQ(support::distance(derived, T) > Real("1e-6"), planted) << text;
  }
}

TEST_P(Errata, PlantedErrorsArriveInTheDerivedBiasOfPoints) {
  const auto of_points = [](std::string text) {
    for (const char* name : {"c_fD", " D * LamT"}) {
      const std::string other = name == std::string("c_fD") ? "t_fD" : " D_P * LamT";
      for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;
           at += other.size()) {
        text.replace(at, std::string(name).size(), other);
      }
    }
    return "(" + text + ") * z_d * sigma * qd";
  };
  const auto right = robot_.read("gamma_f");
  const auto at = robot_.inputs(right);
  const Numbers gamma = robot_.expected(right, at);
  const std::string twice = kT1 + " + 2 * " + kT2;
  for (const auto& [text, planted] :
       std::vector<std::pair<std::string, bool>>{{kK, false},
                                                 {kE1, true},
                                                 {twice, true},
                                                 {kT1 + " + 1 * " + kT2 + " + " + kT3, true},
                                                 {"2 * " + kT2 + " + " + kT3, true},
                                                 {twice + " - " + kT3, true},
                                                 {twice + " + LamT(" + kInner + ")", true}}) {
    const auto equation = robot_.read(of_points(text));
    const Numbers derived = UserRobot::run(robot_.derived(equation, formulate::Way::kToRoot), at);
    EXPECT_LT(support::distance(derived, robot_.expected(equation, at)), Real("1e-40")) << text;
    EXPECT_EQ(support::distance(derived, gamma) > Real("1e-6"), planted) << text;
  }
}

TEST_P(Errata, PlantedErrorsArriveInTheDerivedForwardDynamics) {
  const std::string lever = "-T(Lam(c_fD)) * m_d * J_v";
  const std::string turning = "T(D) * J_d * D * z_d * sigma";
  const std::string sliding = "(E - sigma) * T(z_d) * T(D) * m_d * J_v";
  const auto system = [&](const std::string& revolute_half, const std::string& B) {
    return robot_.read("(sigma * T(z_d) * (" + revolute_half + ") + " + sliding + ") * qdd + " + B +
                       " + G - tau");
  };
  const auto right = system(lever + " + " + turning, bias(kK));
  const auto at = robot_.inputs(right);
  const auto acceleration = static_cast<std::size_t>(
      std::find_if(right.arguments.begin(), right.arguments.end(),
                   [](const equations::UserArgument& a) { return a.name == "qdd"; }) -
      right.arguments.begin());
  const auto largest = [](const Numbers& numbers) {
    Real result = 0;
    for (const Real& x : numbers) {
      result = std::max(result, Real(abs(x)));
    }
    return result;
  };
  for (const auto& [text, planted] : std::vector<std::pair<equations::UserEquation, bool>>{
           {right, false},
           {system(lever + " + 2 * " + turning, bias(kK)), true},
           {system(lever, bias(kK)), true},
           {system(lever + " + " + turning, bias(kK, kE3)), true},
           {system(lever + " + " + turning, bias(kT1 + " + " + kT2 + " + " + kT3)), true},
           {system(lever + " + " + turning, "2 * B"), true},
           {system(lever + " + " + turning, "0 * B"), true}}) {
    auto with = at;
    with[acceleration] = UserRobot::run(robot_.solved(text), at);
    EXPECT_LT(largest(robot_.expected(text, with)), Real("1e-40")) << text.text;
    EXPECT_EQ(largest(robot_.expected(right, with)) > Real("1e-6"), planted) << text.text;
  }
  EXPECT_THROW(robot_.solved(robot_.read("A * qdd + " + sliding + " * qdd - tau")),
               std::domain_error);
}

INSTANTIATE_TEST_SUITE_P(Trees, Errata,
                         testing::Values(TreeShape{{-1, 0, 1}, "RPR"}, TreeShape{{-1, 0, 1}, "RRP"},
                                         TreeShape{{-1, 0, 0, 1}, "RRPP"}));

TEST(Table, NamesErrataThatEquationsMdExplains) {
  std::ifstream file(TREEDYN_SOURCE_DIR "/generator/equations/EQUATIONS.md");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (const equations::Equation& equation : equations::functions()) {
    std::stringstream errata{std::string(equation.errata)};
    for (std::string id; errata >> id;) {
      EXPECT_NE(text.find("\n| " + id + " | "), std::string::npos) << equation.name << " " << id;
    }
  }
}

}  // namespace
}  // namespace treedyn
