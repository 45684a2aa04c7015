// The table of constants costs nothing: with literals in the places of names compilers make the
// same object file. No number of a model is left out of it.
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/models_folder.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::Outcome;

struct TextCase {
  const char* name;
  const char* extension;
  const char* language;  ///< of the compiler
  std::vector<std::string> options;
};

/// The source without its table, literals in the places of its names.
std::string with_literals(const std::string& source, int& names) {
  static const std::regex definition(
      "(?:constexpr|static const) (?:double|float) (\\w+) = ([^;]+);");
  std::map<std::string, std::string> literals;
  std::istringstream stream(source);
  std::string result;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_match(line, match, definition)) {
      literals[match[1]] = "(" + match[2].str() + ")";
      ++names;
      line.clear();
    }
    static const std::regex word("[A-Za-z_]\\w*");
    std::size_t end = 0;
    std::string replaced;
    for (auto it = std::sregex_iterator(line.begin(), line.end(), word);
         it != std::sregex_iterator(); ++it) {
      const auto at = static_cast<std::size_t>(it->position());
      const auto literal = literals.find(it->str());
      replaced += line.substr(end, at - end);
      replaced += literal != literals.end() ? literal->second : it->str();
      end = at + it->str().size();
    }
    result += replaced + line.substr(end) + '\n';
  }
  return result;
}

class Constants : public testing::TestWithParam<TextCase> {};

TEST_P(Constants, CostNothing) {
  const support::TemporaryFolder folder;
  const fs::path other = folder.path() / "literals";
  std::vector<std::string> generate = {TREEDYN_EXECUTABLE, "generate", "-q", "--effort",   "0",
                                       "--name",           "m",        "-o", folder.path()};
  generate.insert(generate.end(), GetParam().options.begin(), GetParam().options.end());
  const Outcome generated = support::run(generate);
  ASSERT_EQ(generated.status, 0) << generated.err;
  fs::create_directory(other);
  const std::string file = std::string("m.") + GetParam().extension;
  const std::string source = support::read_file(folder.path() / file);
  int names = 0;
  const std::string literals = with_literals(source, names);
  EXPECT_GT(names, 10);
  fs::copy(folder.path() / (file == "m.c" ? "m.h" : "m.hpp"), other);
  support::write_file(other / file, literals);
  std::map<std::string, std::string> objects;
  for (const fs::path& place : {folder.path(), other}) {
    const Outcome compiled = support::run_words(
        fmt::format("{0} {1} -c -O2 -Wall -Wextra -Wshadow -Werror {2}/{3} -o {2}/m.o", TREEDYN_CXX,
                    GetParam().language, place.string(), file));
    ASSERT_EQ(compiled.status, 0) << compiled.err;
    objects[place] = support::read_file(place / "m.o");
  }
  EXPECT_TRUE(objects[folder.path()] == objects[other]);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Constants,
    testing::Values(
        TextCase{"double", "cpp", "-std=c++17", {kModels + "puma560.yaml"}},
        TextCase{"float",
                 "cpp",
                 "-std=c++17",
                 {kModels + "biped.yaml", "--scalar", "float", "--layout", "packed"}},
        TextCase{
            "c99", "c", "-x c -std=c99 -pedantic", {kModels + "puma560.yaml", "--language", "c99"}},
        TextCase{"lanes", "cpp", "-std=c++17", {kModels + "puma560.yaml", "--lanes", "2"}},
        TextCase{"limbs", "cpp", "-std=c++17", {kModels + "quadruped.yaml", "--share-limbs"}},
        TextCase{"parameters",
                 "cpp",
                 "-std=c++17",
                 {kModels + "puma560.yaml", "--runtime", "link3.mass"}}),
    [](const auto& test) { return std::string(test.param.name); });

/// Numbers that passes make of others, ratios and roots among them, keep their sources: what stands
/// as a literal in a function is a number of the equations, short ones all of them.
TEST(ConstantsOfModels, AreNoLiteralsInFunctions) {
  static const std::regex long_literal("[0-9]\\.[0-9]{6,}");
  for (const char* const model :
       {"puma560.yaml", "panda.yaml", "quadruped.yaml", "compass_walker.yaml"}) {
    const support::TemporaryFolder folder;
    const Outcome generated = support::run({TREEDYN_EXECUTABLE, "generate", "-q", "--effort", "100",
                                            "--name", "m", "-o", folder.path(), kModels + model});
    ASSERT_EQ(generated.status, 0) << generated.err;
    const std::string source = support::read_file(folder.path() / "m.cpp");
    const std::size_t functions = source.find("\nvoid ");
    ASSERT_NE(functions, std::string::npos);
    std::smatch literal;
    const std::string text = source.substr(functions);
    EXPECT_FALSE(std::regex_search(text, literal, long_literal)) << model << ' ' << literal.str();
  }
}

}  // namespace
}  // namespace treedyn
