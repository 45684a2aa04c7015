// Machine code of the pair of sine and cosine and of functions that use it: no branch.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace {

using treedyn::support::Outcome;
using treedyn::support::run;
using Words = std::vector<std::string>;

bool is_there(const std::string& program) {
  return run({"sh", "-c", "command -v " + program}).status == 0;
}

/// The instructions of an object file by function.
std::map<std::string, Words> instructions(const std::string& objdump, const std::string& object) {
  std::istringstream lines(run({objdump, "-d", "-C", "--no-show-raw-insn", object}).out);
  std::map<std::string, Words> result;
  std::string function;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name = line.find('<');
    const std::size_t tab = line.find(":\t");
    if (line.ends_with(">:")) {
      function = line.substr(name + 1, line.size() - name - 3);
    } else if (tab != std::string::npos) {
      result[function].push_back(line.substr(tab + 2));
    }
  }
  return result;
}

/// Jumps under a condition of x86, and those of Thumb with and without a width.
bool is_branch(const std::string& mnemonic, bool thumb) {
  if (!thumb) {
    return mnemonic[0] == 'j' && mnemonic != "jmp";
  }
  static const std::set<std::string> kBranches{"beq", "bne", "bcs", "bcc", "bmi", "bpl",
                                               "bvs", "bvc", "bhi", "bls", "bge", "blt",
                                               "bgt", "ble", "cbz", "tbb", "tbh", "cbnz"};
  return kBranches.contains(mnemonic.substr(0, mnemonic.find('.')));
}

std::map<std::string, Words> compiled(const std::string& tools, const std::string& compiler,
                                      const Words& options, const std::string& source) {
  const treedyn::support::TemporaryFolder folder;
  const std::string object = folder.path() / "object.o";
  Words command{compiler, "-std=c++17", "-Wno-psabi", "-c", source, "-o", object};
  command.insert(command.end(), options.begin(), options.end());
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return instructions(tools + "objdump", object);
}

/// Functions with a branch.
std::set<std::string> branching(const std::string& tools, const std::string& compiler,
                                const Words& options, const std::string& source,
                                std::size_t* functions) {
  std::set<std::string> result;
  const auto found = compiled(tools, compiler, options, source);
  *functions = found.size();
  for (const auto& [function, lines] : found) {
    for (const std::string& line : lines) {
      const std::string word = line.substr(0, line.find_first_of(" \t"));
      if (is_branch(word, !tools.empty())) {
        result.insert(function + ": " + word);
      }
    }
  }
  return result;
}

void expect_no_branch(const std::string& tools, const std::string& compiler, const Words& options) {
  for (const std::string& program : {compiler, tools + "objdump"}) {
    if (!is_there(program)) {
      GTEST_SKIP() << program << " is not installed";
    }
  }
  for (const char* source :
       {"/pair_double.cpp", "/pair_float.cpp", "/vector_double.cpp", "/vector_float.cpp"}) {
    std::size_t functions = 0;
    EXPECT_THAT(
        branching(tools, compiler, options, std::string(TREEDYN_PAIRS) + source, &functions),
        testing::IsEmpty())
        << compiler << ' ' << options.front() << source;
    EXPECT_GE(functions, 6U);  // the pair and those of the model
  }
}

TEST(Branches, AreThereWhereTheSourceHasOne) {
  const treedyn::support::TemporaryFolder folder;
  const std::string source = folder.path() / "branch.cpp";
  treedyn::support::write_file(source, "void g();\nvoid f(double x) { if (x > 1) g(); }\n");
  std::size_t functions = 0;
  EXPECT_EQ(branching("", "g++", {"-O2"}, source, &functions).size(), 1U);
  EXPECT_EQ(branching("", "clang++", {"-O2"}, source, &functions).size(), 1U);
}

TEST(Branches, AreNotThereWithGcc) { expect_no_branch("", "g++", {"-O2"}); }

TEST(Branches, AreNotThereWithGccForVectors) {
  expect_no_branch("", "g++", {"-O3", "-march=x86-64-v3"});
}

TEST(Branches, AreNotThereWithClang) { expect_no_branch("", "clang++", {"-O2"}); }

TEST(Branches, AreNotThereWithClangForVectors) {
  expect_no_branch("", "clang++", {"-O3", "-march=x86-64-v3"});
}

/// Code for SSE that runs behind them is slow as long as upper halves of registers are in use.
TEST(Vectors, LeaveNoUpperHalvesOfRegistersInUse) {
  for (const char* compiler : {"g++", "clang++"}) {
    for (const char* source : {"/vector_double.cpp", "/vector_float.cpp"}) {
      int with_vectors = 0;
      for (const auto& [function, lines] : compiled("", compiler, {"-O3", "-march=x86-64-v3"},
                                                    TREEDYN_PAIRS + std::string(source))) {
        const auto has = [&lines = lines](const char* word) {
          return std::any_of(lines.begin(), lines.end(), [word](const std::string& line) {
            return line.find(word) != std::string::npos;
          });
        };
        with_vectors += has("%ymm") ? 1 : 0;
        EXPECT_EQ(has("%ymm"), has("vzeroupper")) << compiler << source << ' ' << function;
      }
      EXPECT_GT(with_vectors, 0);
    }
  }
}

TEST(Branches, AreNotThereOnACortexM4F) {
  for (const char* level : {"-O2", "-Os", "-O3"}) {
    expect_no_branch(
        "arm-none-eabi-", "arm-none-eabi-g++",
        {level, "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"});
  }
}

/// The sources include nothing, so clang++ needs no library of the target.
TEST(Branches, AreNotThereOnACortexM4FWithClang) {
  for (const char* level : {"-O2", "-Os", "-O3"}) {
    expect_no_branch("arm-none-eabi-", "clang++",
                     {level, "--target=thumbv7em-none-eabihf", "-mcpu=cortex-m4",
                      "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"});
  }
}

}  // namespace
