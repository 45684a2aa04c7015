// E2 of tests/scenes/README.md: an effect never makes a scene cheaper, and the arithmetic that a
// compiler emits for it is what its price names, one by one.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {
namespace {

using Effects = std::set<std::string>;

/// Effects of a two-link arm whose code has no branch: every instruction is executed.
const std::map<std::string, std::string> kEffects = {
    {"viscous_friction", "{joint: elbow, coefficient: 0.3}"},
    {"joint_spring", "{joint: elbow, stiffness: 30, damping: 2}"},
    {"coulomb_friction", "{joint: shoulder, force: 1, slip_speed: 0.01}"},
    {"armature", "{joint: shoulder, inertia: 0.2}"},
    {"drive", "{joint: elbow, kp: 10, kd: 3, target: 0.5}"},
    {"force", "{point: hand, value: [1, 0, 3*x]}"},
    {"point_spring", "{point: hand, anchor: [1, 0, 1], stiffness: 20}"}};

struct Count {
  long operations = 0;
  long instructions = 0;  ///< compiled, of this machine
  long arithmetic = 0;    ///< of these, and calls of sin and cos
};

std::string scene_text(const Effects& effects) {
  std::string lines;
  for (const std::string& effect : effects) {
    lines += fmt::format("  {}:\n    - {}\n", effect, kEffects.at(effect));
  }
  return arm_scene(lines);
}

void succeed(const std::vector<std::string>& command) {
  const Outcome outcome = run(command);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
}

/// Instructions of one value that are arithmetic, and those that call sin or cos.
long arithmetic_of(const std::string& instruction) {
  static const std::map<std::string, long> kArithmetic = {
      {"addsd", 1}, {"subsd", 1}, {"mulsd", 1}, {"divsd", 1}, {"sqrtsd", 1},                 // x86
      {"fadd", 1},  {"fsub", 1},  {"fmul", 1},  {"fnmul", 1}, {"fdiv", 1},   {"fsqrt", 1}};  // Arm
  const auto found = kArithmetic.find(instruction.substr(0, instruction.find_first_of(" \t\n")));
  return found == kArithmetic.end() ? 0 : found->second;
}

/// Lines "  4f:\taddsd ..." of a disassembly, and relocations "... \tsin-0x4" of calls.
Count instructions_of(const std::string& disassembly) {
  Count result;
  for (std::size_t at = disassembly.find(":\t"); at != std::string::npos;
       at = disassembly.find(":\t", at + 1)) {
    ++result.instructions;
    result.arithmetic += arithmetic_of(disassembly.substr(at + 2, 10));
  }
  for (const auto& [call, values] : {std::pair("sin", 1), {"cos", 1}, {"sincos", 2}}) {
    for (const char* const end : {"-", "\n"}) {
      const std::string name = fmt::format("\t{}{}", call, end);
      for (std::size_t at = disassembly.find(name); at != std::string::npos;
           at = disassembly.find(name, at + 1)) {
        result.arithmetic += values;
      }
    }
  }
  return result;
}

Count count(const Effects& effects) {
  const TemporaryFolder folder;
  const std::string stem = (folder.path() / "arm").string();
  write_file(stem + ".yaml", scene_text(effects));
  succeed({TREEDYN_EXECUTABLE, "generate", "-q", "--scene", stem + ".yaml", "--functions",
           "constrained_dynamics", "--sincos", "libm",  // the calls of which move few registers
           "-o", folder.path().string()});
  succeed({TREEDYN_CXX, "-std=c++11", "-O2", "-ffp-contract=off", "-fno-math-errno",
           "-fno-tree-vectorize", "-c", stem + ".cpp", "-o", stem + ".o"});
  const Outcome listing = run({"objdump", "-dr", "--no-show-raw-insn", stem + ".o"});
  EXPECT_EQ(listing.status, 0) << listing.err;
  const auto manifest = Json::parse(read_file(stem + ".json"));
  Count result = instructions_of(listing.out);
  for (const Json& each : manifest.at("functions").front().at("operations")) {
    result.operations += each.get<long>();
  }
  return result;
}

class Pairs : public ::testing::Test {
 protected:
  const Count& of(const Effects& effects) {
    const auto known = counts_.find(effects);
    return known != counts_.end() ? known->second
                                  : counts_.emplace(effects, count(effects)).first->second;
  }

  /// What `added` costs in a scene that has `effects`.
  void expect_fair_price(const Effects& effects, const std::string& added) {
    Effects more = effects;
    more.insert(added);
    const long price = of(more).operations - of(effects).operations;
    const long instructions = of(more).instructions - of(effects).instructions;
    const std::string what = fmt::format("{} beside {}", added, fmt::join(effects, ", "));
    EXPECT_GE(price, 0) << what;
    // what is executed is what the price names; moves of registers are the compiler's own
    EXPECT_EQ(of(more).arithmetic - of(effects).arithmetic, price) << what;
    EXPECT_LE(instructions, price + 20) << what;  // the bound of E2: loads, stores and moves
  }

  std::map<Effects, Count> counts_;
};

TEST_F(Pairs, ACostOfAnEffectIsItsPriceWhateverElseIsThere) {
  EXPECT_GT(of({}).operations, 0);
  EXPECT_EQ(of({}).arithmetic, of({}).operations);
  for (const auto& [added, entry] : kEffects) {
    expect_fair_price({}, added);
    for (const auto& [other, values] : kEffects) {
      if (other != added) {
        expect_fair_price({other}, added);
      }
    }
  }
}

}  // namespace
}  // namespace treedyn::support
