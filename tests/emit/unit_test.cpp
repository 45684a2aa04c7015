// Whole generated files: what they compute, what they cost, and how compilers and clang-format see
// them.
#include "emit/unit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program/interpret.hpp"
#include "program/random_function.hpp"
#include "support/compiled.hpp"
#include "support/process.hpp"
#include "support/states.hpp"

namespace treedyn::emit {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

model::Tree tree(const std::vector<std::string>& names) {
  model::Tree result;
  result.name = "robot";
  for (const std::string& name : names) {
    model::Link link;
    link.name = name;
    link.father = result.size() - 1;
    link.joint.name = name;
    link.joint.identifier = fmt::format("{}{}", name.size() > 100 ? name : "j", result.size());
    result.coordinates.push_back(result.size());
    result.drives.push_back({result.size(), 1, 0});
    result.links.push_back(link);
  }
  return result;
}

model::Tree plain_tree(int links) {
  std::vector<std::string> names;
  for (int i = 0; i < links; ++i) {
    names.push_back(fmt::format("link_{}", i));
  }
  return tree(names);
}

Unit unit(const model::Tree& tree, const program::Function& function,
          Scalar scalar = Scalar::kDouble) {
  Unit result;
  result.name = "robot";
  result.tree = &tree;
  result.functions = {function};
  result.functions[0].signature.brief = "What the test says.";
  result.functions[0].signature.equation = "(0)";
  result.target.scalar = scalar;
  result.command = {"treedyn", "generate", "robot.yaml"};
  result.tool = "treedyn test";
  result.model_file = "robot.yaml";
  result.options = {{"scalar", fmt::format("\"{}\"", type_name(scalar))}, {"base", "\"fixed\""}};
  return result;
}

void write(const std::filesystem::path& folder, const Unit& unit) {
  for (const File& file : emit_files(unit)) {
    support::write_file(folder / file.name, file.text);
  }
}

/// A function of four joints with what emission treats in a special way: outputs that are equal,
/// negative, zero, constant, an input, used elsewhere.
program::Function special_function() {
  program::Function f;
  program::Graph& g = f.graph;
  f.signature = {"special", "(0)", "Special.", {{"q", 4, "rad"}, {"qd", 4, ""}}, {{"A", 12, ""}}};
  const program::Ref s = g.sin(g.input(0, 0));
  const program::Ref c = g.cos(g.input(0, 0));
  const program::Ref difference = g.add(g.multiply(s, g.input(0, 1)), -c);
  const program::Ref inverse = g.divide(g.constant(1), g.add(g.constant(2), g.multiply(c, c)));
  const program::Ref root = g.sqrt(g.add(g.constant(3), g.multiply(s, s)));
  f.outputs = {difference,
               -difference,
               0,
               g.constant(Real(1) / 3),
               g.input(0, 2),
               -g.input(0, 2),
               inverse,
               -inverse,
               -root,
               -g.constant(2),
               g.add(root, -inverse),
               -g.add(s, -g.multiply(c, root))};
  return f;
}

/// Values and operation counts of compiled code against the interpreter and the graph.
void expect_same_as_program(const program::Function& function, int links, Scalar scalar,
                            Sincos sincos = Sincos::kPair, bool vectors = false) {
  const model::Tree robot = plain_tree(links);
  const support::TemporaryFolder folder;
  Unit robot_unit = unit(robot, function, scalar);
  robot_unit.target.sincos = sincos;
  robot_unit.target.vectors = vectors;
  write(folder.path(), robot_unit);
  const support::CompiledModel code(folder.path(), "robot", support::Variant::kMeasured);
  support::Random random(3);
  support::CompiledModel::Inputs inputs;
  std::vector<std::span<const double>> spans;
  for (const program::Array& array : function.signature.inputs) {
    inputs.push_back(random.list(static_cast<std::size_t>(array.size)));
  }
  spans.assign(inputs.begin(), inputs.end());
  const support::Measurement m = code.measure(function.signature.name, inputs);
  const std::vector<double> expected = program::interpret<double>(function, spans);
  ASSERT_EQ(m.values.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_LE(std::abs(m.values[k] - expected[k]), 2 * m.bounds[k] + 1e-13 * std::abs(expected[k]))
        << k;
  }
  const program::Cost cost = program::cost(function);
  EXPECT_EQ(m.operations,
            (std::array<long, 6>{cost.add, cost.mul, cost.div, cost.sqrt, cost.sin, cost.cos}));
  EXPECT_EQ(m.operations, code.manifest().function(function.signature.name).operations);
}

TEST(EmitFiles, ComputesSpecialOutputsLikeTheProgram) {
  expect_same_as_program(special_function(), 4, Scalar::kDouble);
  expect_same_as_program(special_function(), 4, Scalar::kFloat);
  expect_same_as_program(special_function(), 4, Scalar::kDouble, Sincos::kLibm);
}

TEST(EmitFiles, ComputesRandomFunctionsLikeTheProgramAtTheSameCost) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    expect_same_as_program(program::random_function(seed, 300), 4, Scalar::kDouble);
  }
}

TEST(EmitFiles, ComputesSplitFunctionsLikeTheProgramAtTheSameCost) {
  expect_same_as_program(program::spatial_chain(60), 60, Scalar::kDouble);
}

TEST(EmitFiles, WritesEqualNegativeAndZeroOutputsAsAssignments) {
  const model::Tree robot = plain_tree(4);
  const std::string source = emit_files(unit(robot, special_function()))[1].text;
  EXPECT_THAT(source, HasSubstr("A[0] = s_j0 * q[1] - c_j0;\n  A[1] = -A[0];"));
  EXPECT_THAT(source, HasSubstr("A[2] = 0.0;"));
  EXPECT_THAT(source, HasSubstr("A[3] = 0.3333333333333333;"));
  EXPECT_THAT(source, HasSubstr("A[5] = -q[2];"));
  EXPECT_THAT(source, HasSubstr("const Scalar /*qd*/[4]"));
}

std::string source_of(const program::Function& function, Sincos sincos) {
  const model::Tree robot = plain_tree(4);
  Unit robot_unit = unit(robot, function);
  robot_unit.target.sincos = sincos;
  return emit_files(robot_unit)[1].text;
}

TEST(EmitFiles, StatesSineAndCosineOfAnAngleTogether) {
  const std::string source = source_of(special_function(), Sincos::kPair);
  EXPECT_THAT(source, HasSubstr("  const auto p_s_j0 = sine_cosine(q[0]);\n"
                                "  const Scalar& s_j0 = p_s_j0.sine;\n"
                                "  const Scalar& c_j0 = p_s_j0.cosine;\n"));
  EXPECT_THAT(source, Not(HasSubstr("using std::sin")));
  EXPECT_THAT(source_of(special_function(), Sincos::kLibm),
              HasSubstr("  const Scalar s_j0 = sin(q[0]);\n  const Scalar c_j0 = cos(q[0]);\n"));
}

TEST(EmitFiles, StatesAPairOfWhichOneIsOnlyAnOutput) {
  program::Function f;
  f.signature = {"f", "", "F.", {{"q", 2, ""}}, {{"B", 2, ""}}};
  const program::Ref c = f.graph.cos(f.graph.input(0, 1));
  const program::Ref s = f.graph.sin(f.graph.input(0, 1));
  f.outputs = {s, f.graph.multiply(c, f.graph.input(0, 0))};
  EXPECT_THAT(source_of(f, Sincos::kPair),
              HasSubstr("  const Scalar& c_j1 = p_s_j1.cosine;\n  B[0] = s_j1;\n"));
  expect_same_as_program(f, 2, Scalar::kDouble);
}

/// Sines and cosines of an angle, of a sine, and of a sum with a cosine.
program::Function nested_function() {
  program::Function f;
  program::Graph& g = f.graph;
  f.signature = {"f", "", "F.", {{"q", 2, ""}, {"sines", 1, ""}}, {{"B", 6, ""}}};
  const auto pair = [&](program::Ref angle) {
    return std::pair(g.sin(angle), g.cos(angle));
  };
  const auto [s0, c0] = pair(g.input(0, 0));
  const auto [s1, c1] = pair(s0);
  const auto [s2, c2] = pair(g.add(c0, g.input(0, 1)));
  const auto [s3, c3] = pair(g.input(1, 0));
  f.outputs = {s0, g.multiply(c0, s3), c1, g.add(s1, c3), s2, g.multiply(c2, c2)};
  return f;
}

TEST(EmitFiles, StatesAllAnglesThatDependOnNoneTogether) {
  const model::Tree robot = plain_tree(2);
  Unit vectors = unit(robot, nested_function());
  vectors.target.vectors = true;
  const std::string source = emit_files(vectors)[1].text;
  EXPECT_THAT(source, HasSubstr("  Scalar sines_[4];\n  Scalar cosines[4];\n"
                                "  sines_cosines(sines_, cosines, q[0], sines[0]);\n"
                                "  const Scalar s_j0 = sines_[0];\n"
                                "  const Scalar c_j0 = cosines[0];\n"));
  EXPECT_THAT(source, HasSubstr("  sines_cosines(sines_2, cosines_2, s_j0, t_1);\n"));
  expect_same_as_program(nested_function(), 2, Scalar::kDouble, Sincos::kPair, true);
  expect_same_as_program(nested_function(), 2, Scalar::kFloat, Sincos::kPair, true);
  expect_same_as_program(program::spatial_chain(60), 60, Scalar::kDouble, Sincos::kPair, true);
}

TEST(EmitFiles, IncludesCmathOnlyForWhatItUsesOfIt) {
  program::Function f;
  f.signature = {"f", "", "F.", {{"q", 2, ""}}, {{"B", 1, ""}}};
  f.outputs = {f.graph.cos(f.graph.input(0, 1))};
  EXPECT_THAT(source_of(f, Sincos::kPair), Not(HasSubstr("#include <cmath>")));
  EXPECT_THAT(source_of(f, Sincos::kLibm), HasSubstr("#include <cmath>"));
  f.outputs = {f.graph.sqrt(f.graph.input(0, 1))};
  EXPECT_THAT(source_of(f, Sincos::kPair), HasSubstr("#include <cmath>"));
}

TEST(EmitFiles, WritesFloatLiteralsOnlyInFloatCode) {
  const model::Tree robot = plain_tree(4);
  std::string source = emit_files(unit(robot, special_function(), Scalar::kFloat))[1].text;
  source = std::regex_replace(source, std::regex("//.*\n"), "");
  EXPECT_THAT(source, HasSubstr("0.33333334f"));
  EXPECT_THAT(source, Not(ContainsRegex("[0-9][.][0-9]+(e[+-][0-9]+)?[^0-9ef+-]")));
}

TEST(EmitFiles, SplitsALargeFunctionIntoPartsOfAtMost400Statements) {
  const model::Tree robot = plain_tree(60);
  std::istringstream source(emit_files(unit(robot, program::spatial_chain(60)))[1].text);
  int parts = 0;
  int lines = 0;
  for (std::string line; std::getline(source, line);) {
    if (line.starts_with("[[gnu::noinline]]")) {
      ++parts;
      lines = 0;
    }
    const bool moves =
        line.find("w[") != std::string::npos || line.find(" = p_s_") != std::string::npos;
    lines = line == "}" ? 0 : lines + (line.ends_with(';') && !moves ? 1 : 0);
    EXPECT_LE(lines, 400);
    EXPECT_LE(line.size(), 100U);
  }
  EXPECT_GE(parts, 5);
}

TEST(EmitFiles, KeepsValuesOfOtherPartsAsLongAsTheyAreNeeded) {
  const model::Tree robot = plain_tree(60);
  std::istringstream source(emit_files(unit(robot, program::spatial_chain(60)))[1].text);
  const std::regex store("  w\\[(\\d+)\\] = (\\w+);");
  const std::regex load("  const Scalar (\\w+) = w\\[(\\d+)\\];");
  std::map<std::string, std::string> workspace;
  std::size_t stores = 0;
  std::smatch found;
  for (std::string line; std::getline(source, line);) {
    if (std::regex_match(line, found, store)) {
      workspace[found[1]] = found[2];
      ++stores;
    } else if (std::regex_match(line, found, load)) {
      EXPECT_EQ(workspace[found[2]], found[1]) << line;
    }
  }
  EXPECT_LT(workspace.size(), stores);  // elements serve again
}

TEST(EmitFiles, NumbersTheTemporariesOfEveryBodyFromOne) {
  const model::Tree robot = plain_tree(2);
  program::Function f;
  f.signature = {"f", "", "F.", {{"q", 2, ""}}, {{"B", 4, ""}}};
  for (const int body : {1, 0}) {
    f.graph.set_body(body);
    const program::Ref x = f.graph.multiply(f.graph.input(0, body), f.graph.input(0, body));
    f.outputs.push_back(f.graph.add(x, f.graph.constant(1)));
    f.outputs.push_back(f.graph.multiply(x, f.graph.constant(3)));
  }
  const std::string source = emit_files(unit(robot, f))[1].text;
  EXPECT_THAT(source, HasSubstr("const Scalar t_link_1_1 = q[1] * q[1];"));
  EXPECT_THAT(source, HasSubstr("const Scalar t_link_0_1 = q[0] * q[0];"));
}

constexpr const char* kWarnings =
    "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion "
    "-Wold-style-cast -Wnull-dereference -Wnon-virtual-dtor -Woverloaded-virtual -Wundef "
    "-Wformat=2 "
    "-Wimplicit-fallthrough -Wmissing-declarations -Wredundant-decls -Wextra-semi -Wfloat-equal "
    "-Wvla -Walloca -Werror -fno-exceptions -fno-rtti -fno-math-errno -O2 -c -o /dev/null";
constexpr const char* kOnlyGnu =
    "-Wuseless-cast -Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wcast-align=strict";

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) {
    result.push_back(word);
  }
  return result;
}

void expect_no_warnings(const std::filesystem::path& source) {
  for (const char* compiler : {"g++", "clang++"}) {
    std::vector<std::string> command =
        words(fmt::format("{} -std=c++11 {} {}", compiler, kWarnings,
                          std::string_view(compiler) == "g++" ? kOnlyGnu : ""));
    command.push_back(source.string());
    const support::Outcome outcome = support::run(command);
    EXPECT_EQ(outcome.status, 0) << compiler << "\n" << outcome.err.substr(0, 2000);
  }
}

void expect_formatted(const std::filesystem::path& file) {
  const std::string text = support::read_file(file);
  const support::Outcome outcome = support::run(
      {"clang-format", "--style=file:" TREEDYN_SOURCE_DIR "/.clang-format", file.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto [ours, theirs] =
      std::mismatch(text.begin(), text.end(), outcome.out.begin(), outcome.out.end());
  EXPECT_TRUE(text == outcome.out) << "from here clang-format writes\n"
                                   << std::string(theirs, outcome.out.end()).substr(0, 300);
}

void expect_clean(const Unit& unit) {
  const support::TemporaryFolder folder;
  write(folder.path(), unit);
  expect_no_warnings(folder.path() / "robot.cpp");
  expect_formatted(folder.path() / "robot.cpp");
  expect_formatted(folder.path() / "robot.hpp");
}

TEST(EmitFiles, CompilesWithoutWarningsAndIsFormatted) {
  const model::Tree four = plain_tree(4);
  expect_clean(unit(four, special_function()));
  expect_clean(unit(four, special_function(), Scalar::kFloat));
  const model::Tree sixty = plain_tree(60);
  Unit chain = unit(sixty, program::spatial_chain(60));
  expect_clean(chain);
  chain.target.vectors = true;
  expect_clean(chain);
  Unit nested = unit(four, nested_function(), Scalar::kFloat);
  nested.target.vectors = true;
  expect_clean(nested);
}

TEST(EmitFiles, SurvivesHostileNames) {
  model::Tree robot = tree({"PI", "E", "*/ int x;", "a\nb\\", std::string(10000, 'x'),
                            "\xe2\x80\xae", "int", "\"", "link", "link_link"});
  robot.name = "*/\n#error";
  program::Function f = program::spatial_chain(10);
  for (program::Ref k = 1; k < static_cast<program::Ref>(f.graph.size()); ++k) {
    const program::Kind kind = f.graph.node(k).kind;
    if (kind == program::Kind::kAdd || kind == program::Kind::kMultiply) {
      f.graph.set_hint(k, {k % 3 == 0 ? "M" : nullptr, k % 10, k % 2 == 0 ? "2" : nullptr});
    }
  }
  Unit hostile = unit(robot, f);
  hostile.command = {"treedyn", "generate", "*/\n\\.yaml", "--points", std::string(150, 'p')};
  hostile.points = {{"*/", "n__", "a\nb", 0, {}}};
  expect_clean(hostile);
}

TEST(EmitFiles, IsTheSameTextEveryTime) {
  const model::Tree robot = plain_tree(12);
  const std::vector<File> first = emit_files(unit(robot, program::spatial_chain(12)));
  const std::vector<File> second = emit_files(unit(robot, program::spatial_chain(12)));
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].text, second[k].text);
  }
}

TEST(EmitFiles, RefusesConstantsThatFloatCannotHold) {
  program::Function f;
  f.signature = {"f", "", "F.", {{"q", 1, ""}}, {{"B", 1, ""}}};
  f.outputs = {f.graph.multiply(f.graph.constant(Real("1e40")), f.graph.input(0, 0))};
  const model::Tree robot = plain_tree(1);
  EXPECT_THROW(emit_files(unit(robot, f, Scalar::kFloat)), std::range_error);
}

}  // namespace
}  // namespace treedyn::emit
