// Gappa, which knows nothing of our bounds, proves those of small functions from their operations.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "accuracy/bound_search.hpp"
#include "description/read.hpp"
#include "formulate/formulate.hpp"
#include "support/process.hpp"

namespace treedyn::accuracy {
namespace {

using program::Kind;
using program::Ref;

constexpr const char* kGappa = "/usr/bin/gappa";

/// A script that says of one output: |rounded - exact| <= bound. Value k is e_k in real numbers and
/// r_k in the code; sines and cosines are in [-1, 1] and off by what the header states and by the
/// rounding of an angle that is a sum.
class Script {
 public:
  Script(const program::Function& function, const Box& box, emit::Scalar scalar)
      : graph_(function.graph), box_(box), single_(scalar == emit::Scalar::kFloat) {}

  std::string text(Ref output, double bound) {
    const std::vector<Ref> one = {output};
    for (const Ref k : program::reachable(graph_, one)) {
      append(k);
    }
    const Ref k = std::abs(output);
    return fmt::format("@rnd = float<ieee_{}, ne>;\n{}{{ {} ->\n  |r{} - e{}| <= {:.17g}{} }}\n",
                       single_ ? 32 : 64, definitions_,
                       assumptions_.empty() ? "0 in [0,0]" : assumptions_, k, k, bound, goals_);
  }

 private:
  static std::string use(char what, Ref a) {
    return fmt::format("{}{}{}", a < 0 ? "-" : "", what, std::abs(a));
  }

  void assume(const std::string& what) {
    assumptions_ += (assumptions_.empty() ? "" : " /\\\n  ") + what;
  }

  void define(Ref k, const std::string& exact, const std::string& rounded) {
    definitions_ += fmt::format("e{} = {};\nr{} = rnd({});\n", k, exact, k, rounded);
  }

  void append(Ref k) {
    const program::Node& node = graph_.node(k);
    switch (node.kind) {
      case Kind::kConstant: {
        const std::string digits = graph_.value(k).str(50);
        define(k, digits, digits);
        break;
      }
      case Kind::kInput:
        definitions_ += fmt::format("e{0} = rnd(q{0});\nr{0} = e{0};\n", k);
        assume(fmt::format("e{} in [{:.17g},{:.17g}]", k,
                           box_[static_cast<std::size_t>(node.b)].low,
                           box_[static_cast<std::size_t>(node.b)].high));
        break;
      case Kind::kAdd:
      case Kind::kMultiply: {
        const char sign = node.kind == Kind::kAdd ? '+' : '*';
        define(k, fmt::format("({}) {} ({})", use('e', node.a), sign, use('e', node.b)),
               fmt::format("({}) {} ({})", use('r', node.a), sign, use('r', node.b)));
        break;
      }
      case Kind::kSin:
      case Kind::kCos:
        append_wave(k, std::abs(node.a));
        break;
      default:
        FAIL() << "no such operation in a script";
    }
  }

  void append_wave(Ref k, Ref angle) {
    const bool sum = graph_.node(angle).kind == Kind::kAdd;
    const double rounding = sum ? std::ldexp(4, single_ ? -24 : -53) : 0;  // of angles below 8
    if (sum) {
      goals_ += fmt::format(" /\\\n  |r{0} - e{0}| <= {1:.17g}", angle, rounding);
    }
    assume(fmt::format("e{} in [-1,1]", k));
    assume(fmt::format("|r{0} - e{0}| <= {1:.17g}", k, (single_ ? 1e-7 : 1.7e-16) + rounding));
  }

  const program::Graph& graph_;
  const Box& box_;  ///< of one array
  bool single_;
  std::string definitions_, assumptions_, goals_;
};

struct Proof {
  std::string model;
  std::string function;
  double room;  ///< of the bound, where ours knows more: c^2 + s^2 = 1, errors that cancel
};

std::ostream& operator<<(std::ostream& out, const Proof& proof) {
  return out << proof.function << " of " << proof.model;
}

class Gappa : public testing::TestWithParam<Proof> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kGappa)) {
      GTEST_SKIP() << "gappa is not installed";
    }
  }

  static bool proves(const std::string& script) {
    return support::run({kGappa, "-Eprecision=200"}, script).status == 0;
  }

  static void expect_proof(emit::Scalar scalar) {
    const model::Tree tree =
        description::read_model(TREEDYN_SOURCE_DIR "/models/" + GetParam().model, {});
    formulate::Options options;
    options.gravity = {0, 0, Real("-9.81")};
    options.effort = 0;
    const program::Function function = formulate::formulated(tree, GetParam().function, options);
    const Box box = States(tree).ranges(function.signature);
    const std::vector<double> scales(function.outputs.size(), 1);
    const BoundsOver bounds =
        bounds_over(function, {scalar, emit::Sincos::kPair}, {box, scales, 0});
    int proofs = 0;
    for (std::size_t k = 0; k < function.outputs.size(); ++k) {
      if (bounds.outputs[k] > 0) {
        const std::string script =
            Script(function, box, scalar)
                .text(function.outputs[k], GetParam().room * bounds.outputs[k]);
        EXPECT_TRUE(proves(script))
            << script << support::run({kGappa, "-Eprecision=200"}, script).err;
        EXPECT_FALSE(proves(
            Script(function, box, scalar).text(function.outputs[k], bounds.outputs[k] / 16)));
        ++proofs;
      }
    }
    EXPECT_GT(proofs, 0);
  }
};

TEST_P(Gappa, ProvesBoundsInFloat) { expect_proof(emit::Scalar::kFloat); }

TEST_P(Gappa, ProvesBoundsInDouble) { expect_proof(emit::Scalar::kDouble); }

INSTANTIATE_TEST_SUITE_P(SmallFunctions, Gappa,
                         testing::Values(Proof{"two_link.yaml", "mass_matrix", 1},
                                         Proof{"two_link.yaml", "gravity_force", 1},
                                         Proof{"polar.yaml", "mass_matrix", 1},
                                         Proof{"polar.yaml", "gravity_force", 1},
                                         Proof{"puma560.yaml", "gravity_force", 1.02}));

}  // namespace
}  // namespace treedyn::accuracy
