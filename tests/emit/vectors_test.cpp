// Vectors of angles (`--sincos vector`) and of limbs (`--limb-lanes`): clean C++, and the bits of
// numbers one by one.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/driver.hpp"
#include "support/models_folder.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::Outcome;

const std::string kOptions =
    "-std=c++11 -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion "
    "-Wdouble-promotion -Wfloat-conversion -Wold-style-cast -Wcast-qual -Wnull-dereference "
    "-Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Wunused -Wformat=2 -Wimplicit-fallthrough "
    "-Wmissing-declarations -Wredundant-decls -Wextra-semi -Wfloat-equal -Wvla -Walloca "
    "-ffp-contract=off -O1";
const std::string kOnlyGnu =
    " -Wuseless-cast -Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wcast-align=strict";

const support::Program kSingle = {"#include \"single.hpp\"", "single::", "one_"};
const support::Program kVector = {"#include \"vector.hpp\"", "vector::", "all_"};

/// Of one vectors of two doubles on x86-64, of the other of four where the processor has them.
std::vector<std::string> compilers() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx") != 0) {
    return {"g++ -mavx" + kOnlyGnu, "clang++"};
  }
#endif
  return {"g++" + kOnlyGnu, "clang++"};
}

struct VectorCase {
  const char* name;
  std::string options;
  std::string single = "--sincos pair";
  std::string vector = "--sincos vector";
  std::string model = {};  ///< text of `model.yaml`, which stands before the options
};

/// A trunk and three arms around it: of four lanes one is empty.
std::string three_arms() {
  std::string text =
      "name: star\nlinks:\n  - {name: trunk, father: ground, joint: {name: turn, type: revolute, "
      "axis: [0, 0, 1]},\n     mass: 3, com: [0.1, 0, 0.2], inertia: [1, 0, 0, 1, 0, 1]}\n";
  for (int arm = 1; arm <= 3; ++arm) {
    text += fmt::format(
        "  - {{name: upper_{0}, father: trunk, joint: {{name: a_{0}, type: revolute, axis: [1, 0, "
        "0], offset: [{0}, 0.{0}, 0]}},\n     mass: 2.{0}, com: [0, 0.1, -0.3], inertia: [0.1, "
        "0.01, 0, 0.2, 0, 0.1]}}\n  - {{name: lower_{0}, father: upper_{0}, joint: {{name: b_{0}, "
        "type: revolute, axis: [0, 1, 0], offset: [0, 0, -1]}},\n     mass: 1, com: [0.2, 0.1, "
        "-0.3], inertia: [0.1, 0, 0, 0.2, 0.02, 0.1]}}\n",
        arm);
  }
  return text;
}

class Vectors : public testing::TestWithParam<VectorCase> {};

TEST_P(Vectors, HaveTheBitsOfNumbersOneByOne) {
  const support::TemporaryFolder folder;
  const std::string at = folder.path().string() + '/';
  if (!GetParam().model.empty()) {
    support::write_file(at + "model.yaml", GetParam().model);
  }
  const std::string model = GetParam().model.empty() ? "" : at + "model.yaml";
  for (const auto& [kind, options] :
       {std::pair("single", GetParam().single), std::pair("vector", GetParam().vector)}) {
    const Outcome outcome = support::run_words(
        fmt::format("{} generate {} {} -q --effort 0 {} --name {} -o {}", TREEDYN_EXECUTABLE, model,
                    GetParam().options, options, kind, at));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  const support::Manifest manifest = support::read_manifest(at + "vector.json");
  support::write_file(at + "driver.cpp", support::comparing_driver(manifest, kSingle, kVector));
  for (const std::string& compiler : compilers()) {
    for (const char* const kind : {"single", "vector"}) {
      const Outcome outcome = support::run_words(
          fmt::format("{0} {1} -c {2}{3}.cpp -o {2}{3}.o", compiler, kOptions, at, kind));
      ASSERT_EQ(outcome.status, 0) << compiler << outcome.err;
    }
    const Outcome linked = support::run_words(fmt::format(
        "{0} -std=c++17 {1}driver.cpp {1}single.o {1}vector.o -o {1}driver", compiler, at));
    ASSERT_EQ(linked.status, 0) << linked.err;
    EXPECT_EQ(support::run({at + "driver"}).out,
              fmt::format("0 of {}", 100 * manifest.functions.size()))
        << compiler;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Vectors,
    testing::Values(
        VectorCase{"puma560", kModels + "puma560.yaml --checked --self-test"},
        VectorCase{"quadruped", kModels + "quadruped.yaml --scalar float --layout packed"},
        VectorCase{"limbs", kModels + "quadruped.yaml --share-limbs --functions inverse_dynamics"},
        VectorCase{"rows", "--scene " + kModels +
                               "scenes/biped_double_support.yaml --functions "
                               "constrained_dynamics"},
        VectorCase{"contacts", "--scene " + kModels + "scenes/drop.yaml --scalar float"}),
    [](const testing::TestParamInfo<VectorCase>& param) { return std::string(param.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Limbs, Vectors,
    testing::Values(
        VectorCase{"quadruped", kModels + "quadruped.yaml", "--share-limbs", "--limb-lanes"},
        VectorCase{"floating",
                   kModels + "quadruped.yaml --base axes --scalar float --layout packed",
                   "--share-limbs", "--limb-lanes"},
        VectorCase{"humanoid", kModels + "biped.yaml --base axes", "--share-limbs", "--limb-lanes"},
        VectorCase{"three", "", "--share-limbs", "--limb-lanes", three_arms()}),
    [](const testing::TestParamInfo<VectorCase>& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace treedyn
