// Equations of users, as a user meets them.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "support/compiled.hpp"

namespace treedyn {
namespace {

const std::string kMomentum = TREEDYN_SOURCE_DIR "/models/equations/momentum.yaml";

TEST_F(Cli, GeneratesEquationsOfItsUser) {
  const std::vector<std::string> options = {"--equations", kMomentum, "--effort", "0", "-o", out()};
  std::vector<std::string> arguments = {"generate", kModel};
  arguments.insert(arguments.end(), options.begin(), options.end());
  ASSERT_EQ(treedyn(arguments).status, 0);
  const std::string header = read_file(file("two_link.hpp"));
  EXPECT_THAT(header, HasSubstr("/// linear momentum, base frame. value: 3 x 1.\n"));
  EXPECT_THAT(header, HasSubstr("void linear_momentum(const Scalar q[2], const Scalar qd[2], "
                                "Scalar value[3]) noexcept;"));
  EXPECT_THAT(header, HasSubstr("--equations momentum.yaml"));
  EXPECT_THAT(header, HasSubstr("void mass_matrix("));  // beside the default functions
  arguments[0] = "check";
  EXPECT_EQ(treedyn(arguments).status, 0);
  EXPECT_THAT(read_file(file("two_link.json")),
              HasSubstr("\"unit\": \"kg m/s\", \"rows\": 3, \"columns\": 1"));
}

/// A pendulum of 2 kg on a rod of 0.5 m about z: p = m l qd (-sin q, cos q, 0).
TEST_F(Cli, ComputesTheMomentumOfAPendulum) {
  const std::string model = scratch("pendulum.yaml");
  write_file(model,
             "name: pendulum\nlinks:\n  - name: bob\n    father: ground\n    joint: {name: pivot, "
             "type: revolute, axis: [0, 0, 1]}\n    mass: 2\n    com: [0.5, 0, 0]\n"
             "    inertia: [0, 0, 0, 0, 0, 0.1]\n"
             "equations:\n  - {name: momentum, value: T(ones) * m_d * J_v * qd}\n"
             "  - {name: spin, value: T(ones) * (Lam(diagb(r)) * m_d * J_v + J_d * J_w) * qd}\n"
             "  - {name: weight, value: T(ones) * m_d * ones}\n");
  for (const char* scalar : {"double", "float"}) {
    const auto code = support::generate_and_compile(
        model, {"--functions", "momentum,spin,weight", "--effort", "0", "--scalar", scalar});
    const double q = 0.7;
    const double qd = 3;
    const auto p = code.call("momentum", {{q}, {qd}});
    EXPECT_NEAR(p[0], -qd * std::sin(q), 1e-6);
    EXPECT_NEAR(p[1], qd * std::cos(q), 1e-6);
    EXPECT_NEAR(p[2], 0, 1e-6);
    EXPECT_NEAR(code.call("spin", {{q}, {qd}})[2], qd * (0.1 + 2 * 0.25), 1e-6);
    EXPECT_NEAR(code.call("weight", {})[0], 2, 1e-6);
  }
}

/// Numbers that are products of vectors stay numbers, whatever stands beside them: r^T r of a link
/// with its rotation, before and behind, by the product rule by hand.
TEST_F(Cli, KeepsInnerProductsTogether) {
  const std::string equations = scratch("products.yaml");
  write_file(equations,
             "equations:\n  - {name: by_hand, value: R(forearm) * dot(T(r) * r) + "
             "dot(R(forearm)) * (T(r) * r)}\n"
             "  - {name: behind, value: dot(R(forearm) * (T(r) * r))}\n"
             "  - {name: before, value: dot((T(r) * r) * R(forearm))}\n"
             "  - {name: row, value: T(Lam(T(ones_P) * t_d)) * (T(r) * z_d) * r}\n"
             "  - {name: matrix, value: dot(J_d * (T(J_v) * m_d * J_v))}\n"
             "  - {name: of_a, value: dot(J_d * A)}\n");
  const auto code = support::generate_and_compile(
      kModel, {"--equations", equations, "--functions", "by_hand,behind,before,row,matrix,of_a",
               "--effort", "0"});
  const support::CompiledModel::Inputs state = {{0.7, -0.4}, {1.3, 2.1}};
  const auto expected = code.call("by_hand", state);
  for (const char* const form : {"behind", "before"}) {
    const auto values = code.call(form, state);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(values[k], expected[k], 1e-13) << form << k;  // some roundings of some 10 m^2/s
    }
  }
}

/// A link's name goes before that of a joint.
TEST_F(Cli, FindsLinksBeforeJointsInEquations) {
  const std::string model = scratch("twice.yaml");
  write_file(
      model,
      "name: twice\nlinks:\n  - name: a\n    father: ground\n    joint: {name: b, type: "
      "revolute, axis: [0, 0, 1]}\n    mass: 2\n    com: [0.5, 0, 0]\n"
      "    inertia: [0, 0, 0, 0, 0, 0.1]\n  - name: b\n    father: a\n    joint: {name: c, "
      "type: revolute, axis: [0, 1, 0], offset: [1, 0, 0]}\n    mass: 5\n    com: [0.5, 0, 0]\n"
      "    inertia: [0, 0, 0, 0.1, 0, 0.1]\n"
      "equations:\n  - {name: of_b, value: T(at(b)) * m_d * ones}\n"
      "  - {name: of_c, value: T(at(c)) * m_d * ones}\n");
  const auto code =
      support::generate_and_compile(model, {"--functions", "of_b,of_c", "--effort", "0"});
  EXPECT_EQ(code.call("of_b", {})[0], 5);
  EXPECT_EQ(code.call("of_c", {})[0], 5);
}

TEST_F(Cli, RefusesAWrongEquationInOneLine) {
  const std::string equations = scratch("mine.yaml");
  write_file(equations, "equations:\n  - name: mixed\n    value: A * qdd + qd\n");
  const Outcome outcome = treedyn({"generate", kModel, "--equations", equations, "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            equations + ":3:20: equation 'mixed': adds 1/s to N m; expected terms of one unit\n");
  EXPECT_FALSE(fs::exists(out()));
  const auto message = [&](const std::string& equation) {
    write_file(equations, "equations:\n  - {name: mine, " + equation + "}\n");
    return treedyn({"generate", kModel, "--equations", equations, "-o", out()}).err;
  };
  EXPECT_THAT(message("inputs: [{name: a}], value: a * qd + a * qdd"),
              HasSubstr("adds 1/s^2 to 1/s, times the same inputs; expected"));
  EXPECT_THAT(message("inputs: [{name: a, per: link}], value: T(qd) * a * a + T(qdd) * a * a"),
              HasSubstr("times the same inputs"));
  EXPECT_EQ(message("inputs: [{name: a}, {name: b}], value: a * qd + b * qdd"), "");
  EXPECT_THAT(message("inputs: [{name: a}], value: tau - a * qd + qd"), HasSubstr("1/s to N m"));
  EXPECT_THAT(message("inputs: [{name: a}], value: a * qd + tau + qd"), HasSubstr("1/s to N m"));
  EXPECT_EQ(message("inputs: [{name: a}], value: G - a * qd"), "");
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("value  2, N m"));
  EXPECT_THAT(message("value: G - 10 * q"), HasSubstr("'q' (positions of joints are an input"));
  EXPECT_THAT(message("value: J_v^T * qd"), HasSubstr("'T' (a transpose is T(X))"));
  EXPECT_THAT(message("value: T(at(tip)) * ones"), HasSubstr("'tip' (of points: at_point)"));
  for (const char* value :
       {">-\n      A * qdd +\n      qd * nothing", "|\n      A * qdd +\n\n      qd * nothing",
        "A * qdd +\n      qd * nothing", "\"A * qdd +\n      qd * nothing\""}) {
    write_file(equations, fmt::format("equations:\n  - name: mixed\n    value: {}\n", value));
    const std::string text = read_file(equations);
    const std::string before = text.substr(0, text.find("nothing"));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    EXPECT_THAT(treedyn({"generate", kModel, "--equations", equations, "-o", out()}).err,
                HasSubstr(fmt::format("{}:{}:12: equation 'mixed': there is no symbol 'nothing'",
                                      equations, line)));
  }
  expect_usage_error(
      treedyn({"generate", kModel, "--equations", kMomentum, "--functions", "mixed", "-o", out()}),
      "there is no function 'mixed'");
  write_file(equations, "equations:\n  - {name: mass_matrix, value: A}\n");
  EXPECT_THAT(treedyn({"generate", kModel, "--equations", equations, "-o", out()}).err,
              HasSubstr("taken"));
}

TEST_F(Cli, RefusesEquationsThatItCannotCarry) {
  const std::string equations = scratch("mine.yaml");
  const auto message = [&](const std::string& text) {
    write_file(equations, text);
    const Outcome outcome = treedyn({"generate", kModel, "--equations", equations, "-o", out()});
    EXPECT_EQ(outcome.status, 1) << text;
    EXPECT_FALSE(fs::exists(out()));
    return outcome.err.substr(std::min(outcome.err.size(), equations.size()));
  };
  const auto value = [&](const std::string& text) {
    return message("equations:\n  - {name: mine, value: \"" + text + "\"}\n");
  };
  const auto repeated = [](const std::string& factor, int times) {
    std::string result;
    for (int k = 0; k < times; ++k) {
      result += factor + "*";
    }
    return result;
  };
  EXPECT_THAT(value("1/997*E + 1/991*E + 1/983*E + 1/977*E"),
              testing::AllOf(testing::StartsWith(":2:"), HasSubstr("make the fraction")));
  EXPECT_THAT(value(repeated("2*D", 32) + "ones"), HasSubstr("make the fraction"));
  EXPECT_THAT(value(repeated("(D+E)", 40) + "ones"), HasSubstr("expected less than 2^31"));
  EXPECT_THAT(value(repeated("(E+sigma)*(D-2*N)", 16) + "E"),
              HasSubstr("expected fewer factors that are sums"));
  EXPECT_THAT(value(repeated("E", 200) + "E"),
              HasSubstr("multiplies 201 matrices in one product; expected at most 200"));
  EXPECT_THAT(value("sqrt(-1)*A"), HasSubstr("has a constant that is nan; expected a real number"));
  EXPECT_THAT(message("equations:\n  - {name: eb, value: A}\n"
                      "  - {name: ea, value: eb*G, inputs: [{name: eb}]}\n"),
              HasSubstr("input 'eb' of equation 'ea' has the name of an equation"));
  EXPECT_THAT(message("parameters: 5\nequations:\n  - {name: ea, value: G}\n"),
              HasSubstr("parameters: is no mapping; expected name: value"));
  EXPECT_THAT(message("parameters: {a: [1]}\nequations:\n  - {name: ea, value: G}\n"),
              HasSubstr("parameter 'a' has no value"));
  write_file(equations, "equations:\n  - {name: mine, value: T(ones_P)*p}\n");
  EXPECT_THAT(treedyn({"outputs", TREEDYN_SOURCE_DIR "/models/puma560.yaml", "--equations",
                       equations, "-o", out()})
                  .err,
              HasSubstr("equation 'mine' needs points and the model has none"));
}

/// Float is warned of where it loses digits, not where there is an error.
TEST_F(Cli, RefusesAConstantBeyondFloatInOneLine) {
  const std::string equations = scratch("mine.yaml");
  write_file(equations, "equations:\n  - {name: mine, value: 1e300*A}\n");
  const Outcome outcome = treedyn({"generate", kModel, "--equations", equations, "--functions",
                                   "mine", "--effort", "0", "--scalar", "float", "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("two_link.yaml: the constant 1e+300, made of numbers"));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}

/// Numbers in front, fractions or not, change nothing of what they multiply.
TEST_F(Cli, TakesAnyNumberInFrontOfAnEnergy) {
  const auto operations = [&](const std::string& number) {
    const std::string equations = scratch("mine.yaml");
    write_file(equations, "parameters: {half: 1/2}\nequations:\n  - {name: mine, value: " + number +
                              "*T(qd)*A*qd}\n");
    const std::string text =
        treedyn({"info", kModel, "--equations", equations, "--functions", "mine"}).out;
    const std::size_t row = text.find("qd  ", text.find("mine"));
    return text.substr(row, text.find('\n', row) - row);
  };
  const std::string known = operations("1/2");
  EXPECT_THAT(known, HasSubstr(" mul, "));
  EXPECT_EQ(operations("0.3712"), known);
  EXPECT_EQ(operations("half"), known);
}

TEST_F(Cli, TellsReservedNamesOfEquations) {
  const std::string equations = scratch("reserved.yaml");
  write_file(equations, "equations:\n  - {name: class, value: A}\n");
  EXPECT_THAT(treedyn({"generate", kModel, "--equations", equations, "-o", out()}).err,
              HasSubstr("equation 'class' has a name that is taken"));
  expect_usage_error(
      treedyn({"generate", kModel, "--equations", equations, "--functions", "class", "-o", out()}),
      "class is a reserved word and no name of a function");
}

/// Equations with this name, or with an input of this name.
std::string equations_named(const std::string& name, bool is_input) {
  return is_input ? "equations:\n  - {name: foo, value: " + name +
                        " * T(ones) * m_d * r, inputs: [{name: " + name + "}]}\n"
                  : "equations:\n  - {name: foo, value: A}\n  - {name: " + name + ", value: A}\n";
}

TEST_F(Cli, RefusesNamesThatGeneratedCodeHasWithSomeOptions) {
  const std::string equations = scratch("names.yaml");
  std::istringstream names(
      "kDigest kStep kMassMatrixRow kLanes Scalar two_link_Scalar status phase "
      "joint_shoulder point_tip status_rank_lost sine_cosine sines_cosines sine check "
      "known_q self_test update_parameters Parameters derived forward_dynamics_checked "
      "mass_matrix_1 foo_0 impact_landing step h TWO_LINK_DIGEST NOINLINE");
  for (std::string name; names >> name;) {
    for (const bool is_input : {false, true}) {
      write_file(equations, equations_named(name, is_input));
      const Outcome outcome =
          treedyn({"generate", kModel, "--equations", equations, "--effort", "0", "-o", out()});
      EXPECT_EQ(outcome.status, 1) << name;
      EXPECT_THAT(outcome.err, HasSubstr((is_input ? "input '" : "equation '") + name +
                                         "' has a name that is taken; expected another one\n"));
    }
  }
}

/// Every function, type, namespace and constant of the source, but for those of the model.
std::set<std::string> names_at_begin_of_lines(const std::string& text) {
  static const std::regex kNamed(
      "\n(?:template <.*>\n)?(?:\\[\\[.*\\]\\] )?"
      "(?:(?:inline|constexpr|static|const|using|struct) )*(?:[A-Za-z<>]+ )?"
      "([A-Za-z_0-9]+)(?:\\(|\\[| = | \\{|;)");
  static const std::regex kOfModel(".*_[kmlhIgwGp][0-9]+");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), kNamed); at != std::sregex_iterator();
       ++at) {
    const std::string name = (*at)[1];
    if (!std::regex_match(name, kOfModel)) {
      names.insert(name);
    }
  }
  return names;
}

/// A step with contact, events and an implicit method has nearly all helpers.
TEST_F(Cli, RefusesWhatGeneratedCodeDefines) {
  const std::string equations = scratch("names.yaml");
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/compass_walk.yaml";
  ASSERT_EQ(treedyn({"generate", "--scene", scene, "--integrator", "sdirk2", "--effort", "0",
                     "--sincos", "pair", "-o", out()})
                .status,
            0);
  std::set<std::string> names = names_at_begin_of_lines(read_file(file("compass_walk.cpp")));
  names.erase("compass_walk");  // the namespace
  EXPECT_GT(names.size(), 50U);
  EXPECT_EQ(names.count("find_event") + names.count("sine_cosine") + names.count("kTurns"), 3U);
  for (const std::string& name : names) {
    write_file(equations, equations_named(name, false));
    const Outcome outcome =
        treedyn({"info", kModel, "--equations", equations, "--derivation", "foo"});
    EXPECT_THAT(outcome.err, HasSubstr("has a name that is taken")) << name;
  }
}

/// Names of locals give way, those of functions in C get a prefix.
TEST_F(Cli, CompilesOddNamesThatAreFree) {
  const std::vector<std::string> names = {
      "error", "state",    "place",       "wrong",   "noexcept_x",  "w",   "p_s_shoulder",
      "sines", "cosines",  "p_s_elbow",   "s_elbow", "neg_value",   "t_1", "two_link_x",
      "x",     "two_link", "link1_I1",    "limb_1",  "q_next",      "kP",  "trunk",
      "fill",  "value_0",  "joint_power", "F_N",     "step_length", "a",   "a_b"};
  std::string as_equations = "equations:\n";
  std::string as_inputs = "equations:\n";
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string& first = names[(k + 5) % names.size()];
    const std::string& second = names[(k + 11) % names.size()];
    as_equations += "  - {name: " + names[k] + ", value: J_v * qd}\n";
    as_inputs += fmt::format(
        "  - {{name: of_{0}, value: {0} * {1} * {2} * T(ones) * m_d * J_v * qd, inputs: "
        "[{{name: {0}}}, {{name: {1}}}, {{name: {2}}}]}}\n",
        names[k], first, second);
  }
  const std::string equations = scratch("odd.yaml");
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--checked", "--self-test"},
                                             {"--layout", "packed"},
                                             {"--lanes", "4"},
                                             {"--sincos", "pair"},
                                             {"--language", "c99", "--self-test", "--checked"}}) {
    for (const std::string& text : {as_equations, as_inputs}) {
      write_file(equations, text);
      std::vector<std::string> command = {"generate", kModel, "--equations", equations,
                                          "--effort", "0",    "-o",          out()};
      command.insert(command.end(), options.begin(), options.end());
      const Outcome outcome = treedyn(command);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const bool c = options[1] == "c99";
      const Outcome compiled = c ? support::run({TREEDYN_CXX, "-x", "c", "-std=c99",
                                                 "-fsyntax-only", file("two_link.c").string()})
                                 : support::run({TREEDYN_CXX, "-std=c++17", "-Wno-psabi",
                                                 "-fsyntax-only", file("two_link.cpp").string()});
      EXPECT_EQ(compiled.status, 0) << options[0] << compiled.err;
    }
  }
}

TEST_F(Cli, NamesPackedMatricesOnce) {
  const std::string equations = scratch("matrices.yaml");
  write_file(equations,
             "equations:\n  - {name: of_lefts, value: J_v}\n  - {name: ofLefts, value: J_v}\n");
  const std::vector<std::string> command = {"generate", kModel, "--equations", equations,
                                            "--effort", "0",    "-o",          out()};
  EXPECT_EQ(treedyn(command).status, 0);
  std::vector<std::string> packed = command;
  packed.insert(packed.end(), {"--layout", "packed"});
  const Outcome refused = treedyn(packed);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err,
              HasSubstr("matrices.yaml:3:12: equation 'ofLefts': with --layout packed "
                        "another matrix has a table kOfLeftsRow, too; expected another name\n"));
  packed.insert(packed.end(), {"--functions", "ofLefts", "--language", "c99"});
  ASSERT_EQ(treedyn(packed).status, 0);
  EXPECT_THAT(read_file(file("two_link.h")),
              HasSubstr("static const int TWO_LINK_OF_LEFTS_ROW[6] = {"));
  EXPECT_THAT(read_file(file("two_link.h")),
              HasSubstr("(TWO_LINK_OF_LEFTS_ROW[k], TWO_LINK_OF_LEFTS_COLUMN[k])"));
}

TEST_F(Cli, ShowsTheRatesOfSymbols) {
  const std::string coriolis = TREEDYN_SOURCE_DIR "/models/equations/coriolis.yaml";
  const Outcome outcome =
      treedyn({"info", kModel, "--equations", coriolis, "--derivation", "coriolis_matrix"});
  EXPECT_THAT(outcome.out, HasSubstr("rules that acted (N = D - E)\n  R11  dot: "));
  EXPECT_THAT(outcome.out, HasSubstr("\n       dot(z^d) = Λ(diagb("));
}

TEST_F(Cli, SaysWhatIsNotThere) {
  const std::string equations = scratch("zeros.yaml");
  write_file(equations, "equations:\n  - {name: zeros, value: qd - qd}\n");
  EXPECT_THAT(treedyn({"info", kModel, "--equations", equations, "--derivation", "zeros"}).out,
              HasSubstr("\nrecursion: none, every value is zero\n"));
  write_file(equations,
             "equations:\n  - {name: zeros, value: D*s_d*ones}\n");  // no offset of roots
  EXPECT_THAT(treedyn({"info", kModel, "--equations", equations, "--derivation", "zeros"}).out,
              HasSubstr("  s_0^d = s^d diagb(Π 1_N)\n  zeros = D s_0^d 1_N\n"));
}

TEST_F(Cli, ShowsHowCodeComesAbout) {
  const Outcome outcome = treedyn({"info", kModel, "--derivation", "bias_force"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("equation (3); errata of the print mended: E1"));
  EXPECT_THAT(outcome.out, HasSubstr("R5 "));
  EXPECT_THAT(outcome.out, HasSubstr("ω = D w  <- R1\n"));
  EXPECT_THAT(outcome.out, HasSubstr("D^T "));
  EXPECT_THAT(
      treedyn({"info", kModel, "--equations", kMomentum, "--derivation", "linear_momentum"}).out,
      HasSubstr("linear_momentum = 1_N^T m^d J_v q̇"));
  const Outcome solved = treedyn({"info", kModel, "--derivation", "forward_dynamics"});
  EXPECT_THAT(solved.out, HasSubstr("equation (1) for q̈, zero there"));
  EXPECT_THAT(solved.out, HasSubstr("\n  R9   A x = r: "));
  EXPECT_THAT(solved.out, HasSubstr("I^A = I^d + sum of "));
  EXPECT_THAT(solved.out, HasSubstr("q̈ = w - L' q̈, from the root"));
  EXPECT_THAT(solved.out, testing::Not(HasSubstr("R13")));
  EXPECT_THAT(solved.out, HasSubstr("two ways: by articulated bodies, by the factor of A; "));
  const auto by = [](const char* way) {
    return treedyn({"info", kModel, "--derivation", "forward_dynamics", "--forward-dynamics", way})
        .out;
  };
  EXPECT_THAT(by("factor"), testing::Not(testing::AnyOf(HasSubstr("two ways"), HasSubstr("I^A"))));
  EXPECT_THAT(by("articulated"), HasSubstr("I^A = I^d + sum of "));
  EXPECT_THAT(by("articulated"), HasSubstr("  q̈ = "));
  EXPECT_THAT(by("articulated"), HasSubstr("m^d E_3"));  // E is the pseudo-inertia
  EXPECT_THAT(by("articulated"), HasSubstr("(E-σ) "));
  EXPECT_THAT(by("articulated"),
              testing::Not(testing::AnyOf(HasSubstr("two ways"), HasSubstr("L' q̈"))));
  const Outcome seen = treedyn({"info", TREEDYN_SOURCE_DIR "/models/biped.yaml", "--base", "axes",
                                "--derivation", "forward_dynamics"});
  EXPECT_THAT(seen.out, HasSubstr("\n  R13  joints at the root that move a link in every way"));
  EXPECT_THAT(seen.out, HasSubstr("f = B^-T τ, force and moment on it  <- R13\n"));
  const Outcome factored = treedyn({"info", kModel, "--derivation", "mass_matrix_factor"});
  EXPECT_THAT(factored.out, HasSubstr("equation 7.4 for L, zero there"));
  EXPECT_THAT(factored.out, HasSubstr("\n  R12  A = A^T"));
  EXPECT_THAT(factored.out, HasSubstr("a = A - L'^T a, from the leaves"));
  const Outcome rows = treedyn({"info", kModel, "--derivation", "constrained_dynamics"});
  EXPECT_THAT(rows.out, HasSubstr("equation (8),(12) for q̈ and λ, zero there"));
  EXPECT_THAT(rows.out, HasSubstr("\n  J^T = C S_f + H S_n\n"));
  EXPECT_THAT(rows.out, HasSubstr("\n  R12'' A x = r + J^T λ"));
  EXPECT_THAT(rows.out, HasSubstr("λ, zero there; errata of the print mended: E1 E2 E3 E4 E5 E6 "));
  EXPECT_THAT(rows.out, HasSubstr("x8 = x2 - x7\n"));
  EXPECT_THAT(rows.out, HasSubstr(" λ of K_λ λ = x8  <- R12''\n"));
  const Outcome least = treedyn({"info", kModel, "--derivation", "constrained_inverse_dynamics"});
  EXPECT_THAT(least.out, HasSubstr("equation (8),(12) for the least λ, zero there, and τ"));
  EXPECT_THAT(least.out, HasSubstr("\n  E_u^T J^T λ - E_u^T h\n"));
  EXPECT_THAT(least.out, HasSubstr("\n  R12''' M λ = s, the least λ·λ"));
  EXPECT_THAT(least.out, HasSubstr(" μ of K_μ μ = x"));
  EXPECT_THAT(treedyn({"info", kModel, "--derivation", "reaction_bias_acceleration"}).out,
              HasSubstr("\n  γ = S_f^T γ_f + S_n^T γ_n\n"));
  expect_usage_error(treedyn({"info", kModel, "--derivation", "dynamics_terms"}),
                     "is no block equation");
  expect_usage_error(treedyn({"info", kModel, "--derivation", "step"}), "is no block equation");
  EXPECT_THAT(treedyn({"generate", kModel, "--dump", "derive"}).out, HasSubstr("mass_matrix: "));
  const auto of_scene = [](const char* scene) {
    return treedyn({"generate", "--scene",
                    std::string(TREEDYN_SOURCE_DIR "/models/scenes/") + scene + ".yaml", "--dump",
                    "derive"})
        .out;
  };
  EXPECT_THAT(
      of_scene("compass_walk"),
      testing::AllOf(
          HasSubstr(
              "reaction_jacobian_transpose: equation (10); errata of the print mended: E6 E17\n"),
          HasSubstr("constrained_dynamics: "), HasSubstr("impact: ")));
  EXPECT_THAT(of_scene("pendulum"), testing::StartsWith("constrained_dynamics: "));
  EXPECT_THAT(of_scene("pendulum"), testing::Not(HasSubstr("impact: ")));
}

/// A finger on a link that follows: its father is the joint that is followed.
TEST_F(Cli, EquationsPickNoJointWhereSomeMimicOthers) {
  const auto link = [](const char* name) {
    return fmt::format(
        "<link name=\"{}\"><inertial><origin xyz=\"0.1 0 0.02\"/><mass value=\"1\"/><inertia "
        "ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>",
        name);
  };
  const auto joint = [](const char* name, const char* father, const char* son, const char* mimic) {
    return fmt::format(
        "<joint name=\"{}\" type=\"revolute\"><parent link=\"{}\"/><child link=\"{}\"/><origin "
        "xyz=\"0.2 0 0\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" "
        "velocity=\"1\"/>{}</joint>",
        name, father, son, mimic);
  };
  write_file(scratch("hand.urdf"),
             "<robot name=\"hand\"><link name=\"world\"/>" + link("a") + link("b") + link("c") +
                 joint("ja", "world", "a", "") +
                 joint("jb", "world", "b", "<mimic joint=\"ja\" multiplier=\"2\"/>") +
                 joint("jc", "b", "c", "") + "</robot>");
  const auto generate = [&](const std::string& value, const std::vector<std::string>& more) {
    write_file(scratch("e.yaml"), "equations: [{name: wanted, value: \"" + value + "\"}]\n");
    std::vector<std::string> words = {
        "generate", scratch("hand.urdf"), "--equations", scratch("e.yaml"), "--effort", "0", "-o",
        out()};
    words.insert(words.end(), more.begin(), more.end());
    return treedyn(words);
  };
  EXPECT_THAT(generate("T(at(ja)) * G", {}).err,
              HasSubstr("equation 'wanted' takes forces on single joints"));
  EXPECT_THAT(generate("T(qd) * tau", {}).err, HasSubstr("'wanted' has rows, columns or inputs"));
  EXPECT_EQ(generate("T(at(ja)) * G", {"--mimic", "independent"}).status, 0);
  EXPECT_EQ(generate("T(qd) * (A * qdd + B)", {}).status, 0);
  EXPECT_THAT(read_file(file("hand.json")), testing::ContainsRegex("\"jc\"[^\n]*\"father\": 0,"));
}

/// Each joint has its column of the momentum about the base origin: one vector on the way there,
/// which takes no turn a joint where values meet in the base.
TEST_F(Cli, EquationsOfChainsGrowWithTheirLinks) {
  write_file(scratch("e.yaml"),
             "equations: [{name: momentum, value: \"T(ones) * (Lam(diagb(r)) * m_d * J_v + J_d * "
             "J_w)\"}]\n");
  const auto operations = [&](int links) {
    std::string model = "name: chain\nlinks:\n";
    for (int k = 0; k < links; ++k) {
      model += fmt::format(
          "  - {{name: l{0}, father: {1}, joint: {{name: j{0}, type: revolute, axis: [0.1, {2}, "
          "1], offset: [0.1, 0.2, 0.3]}}, mass: 1, com: [0.1, 0, 0.2], inertia: [0.2, 0, 0, 0.25, "
          "0, 0.3]}}\n",
          k, k == 0 ? "ground" : fmt::format("l{}", k - 1), 0.3 + 0.01 * k);
    }
    write_file(scratch("chain.yaml"), model);
    const Outcome outcome =
        treedyn({"generate", scratch("chain.yaml"), "--equations", scratch("e.yaml"), "--functions",
                 "momentum", "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string manifest = read_file(file("chain.json"));
    const auto number = [&](const std::string& name) {
      return std::stoi(manifest.substr(manifest.find("\"" + name + "\": ") + name.size() + 4));
    };
    return number("add") + number("mul");
  };
  const int ten = operations(10);
  const int twenty = operations(20);
  const int forty = operations(40);
  EXPECT_NEAR(forty - twenty, 2 * (twenty - ten), 0.1 * (forty - twenty));
  EXPECT_GT(ten, 0);
}

}  // namespace
}  // namespace treedyn
