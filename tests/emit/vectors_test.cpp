// `--sincos vector`: clean C++, and the bits of the pair of sine and cosine.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/driver.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::Outcome;

const std::string kOptions =
    "-std=c++17 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow "
    "-Wdouble-promotion -Wfloat-conversion -Wcast-qual -Wundef -Wunused -ffp-contract=off -O1";

const support::Program kPair = {"#include \"pair.hpp\"", "pair::", "one_"};
const support::Program kVector = {"#include \"vector.hpp\"", "vector::", "all_"};

/// Of one vectors of two doubles on x86-64, of the other of four where the processor has them.
std::vector<std::string> compilers() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx") != 0) {
    return {"g++ -mavx", "clang++"};
  }
#endif
  return {"g++", "clang++"};
}

const std::string kModels = TREEDYN_SOURCE_DIR "/models/";

struct Case {
  const char* name;
  std::string options;
};

class Vectors : public testing::TestWithParam<Case> {};

TEST_P(Vectors, HaveTheBitsOfThePair) {
  const support::TemporaryFolder folder;
  const std::string at = folder.path().string() + '/';
  for (const std::string kind : {"pair", "vector"}) {
    const Outcome outcome = support::run_words(
        fmt::format("{0} generate {1} -q --effort 0 --sincos {2} --name {2} -o {3}",
                    TREEDYN_EXECUTABLE, GetParam().options, kind, at));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  const support::Manifest manifest = support::read_manifest(at + "vector.json");
  support::write_file(at + "driver.cpp", support::comparing_driver(manifest, kPair, kVector));
  for (const std::string& compiler : compilers()) {
    for (const char* const kind : {"pair", "vector"}) {
      const Outcome outcome = support::run_words(
          fmt::format("{0} {1} -c {2}{3}.cpp -o {2}{3}.o", compiler, kOptions, at, kind));
      ASSERT_EQ(outcome.status, 0) << compiler << outcome.err;
    }
    const Outcome linked = support::run_words(fmt::format(
        "{0} -std=c++17 {1}driver.cpp {1}pair.o {1}vector.o -o {1}driver", compiler, at));
    ASSERT_EQ(linked.status, 0) << linked.err;
    EXPECT_EQ(support::run({at + "driver"}).out,
              fmt::format("0 of {}", 100 * manifest.functions.size()))
        << compiler;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Vectors,
    testing::Values(Case{"puma560", kModels + "puma560.yaml --checked --self-test"},
                    Case{"quadruped", kModels + "quadruped.yaml --scalar float --layout packed"},
                    Case{"limbs",
                         kModels + "quadruped.yaml --share-limbs --functions inverse_dynamics"},
                    Case{"rows", "--scene " + kModels +
                                     "scenes/biped_double_support.yaml --functions "
                                     "constrained_dynamics"},
                    Case{"contacts", "--scene " + kModels + "scenes/drop.yaml --scalar float"}),
    [](const testing::TestParamInfo<Case>& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace treedyn
