// `--self-test`: right on this machine with and without contraction, and it names what is wrong.
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::Outcome;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kMain = R"(#include "m.hpp"
#include <cstdio>
int main() {
  int place[2];
  m::Scalar error[1];
  const int wrong = m::self_test(place, error);
  std::printf("%d wrong, worst %d[%d]: %g", wrong, place[0], place[1], static_cast<double>(error[0]));
}
)";

class SelfTest : public testing::TestWithParam<const char*> {
 protected:
  void generate(const std::vector<std::string>& more) {
    std::vector<std::string> command = {TREEDYN_EXECUTABLE, "generate"};
    command.insert(command.end(), more.begin(), more.end());
    command.insert(command.end(),
                   {"--name", "m", "-q", "--effort", "0", "--self-test", "-o", at()});
    outcome_ = support::run(command);
  }
  [[nodiscard]] std::string at() const { return folder_.path().string(); }
  /// What the program prints.
  [[nodiscard]] std::string run(const std::string& contraction) const {
    support::write_file(at() + "/main.cpp", kMain);
    const Outcome compiler = support::run({TREEDYN_CXX, "-std=c++11", "-O1", "-Wall", "-Wextra",
                                           "-Wconversion", "-Wshadow", "-Werror", contraction,
                                           at() + "/main.cpp", at() + "/m.cpp", "-o", at() + "/m"});
    EXPECT_EQ(compiler.status, 0) << compiler.err;
    return support::run({at() + "/m"}).out;
  }
  void replace(const std::string& from, const std::string& to) const {
    std::string text = support::read_file(at() + "/m.cpp");
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos);
    support::write_file(at() + "/m.cpp", text.replace(place, from.size(), to));
  }

  support::TemporaryFolder folder_;
  Outcome outcome_;
};

const std::string kPuma = TREEDYN_SOURCE_DIR "/models/puma560.yaml";

TEST_P(SelfTest, FindsNothingWrongAndNamesAWrongDigit) {
  const bool single = std::string(GetParam()) == "float";
  generate({kPuma, "--scalar", GetParam()});
  ASSERT_EQ(outcome_.status, 0) << outcome_.err;
  EXPECT_THAT(run("-ffp-contract=off"), StartsWith("0 wrong"));
  EXPECT_THAT(run("-ffp-contract=fast"), StartsWith("0 wrong"));
  replace("A[35] = link6_I1;", single ? "A[35] = 4.1e-04f;" : "A[35] = 4.1e-04;");
  EXPECT_THAT(run("-ffp-contract=off"), StartsWith("2 wrong, worst 1[35]: "));
  replace("A[35] = 4.1e-04", "A[35] = 0 * q[0] / (0 * q[0]) + 1.0");
  EXPECT_THAT(run("-ffp-contract=off"), HasSubstr("worst 1[35]: "));
}

TEST_F(SelfTest, NeedsFunctionsOfTheModel) {
  generate({"--scene", TREEDYN_SOURCE_DIR "/models/scenes/drop.yaml"});
  EXPECT_EQ(outcome_.status, 2);
  EXPECT_THAT(outcome_.err, HasSubstr("--self-test: tests functions of the model"));
  support::write_file(at() + "/e.yaml",
                      "equations:\n  - {name: known_q, value: T(ones) * m_d * J_v * qd, doc: x}\n");
  generate({kPuma, "--equations", at() + "/e.yaml", "--functions", "known_q"});
  EXPECT_EQ(outcome_.status, 1);
  EXPECT_THAT(outcome_.err, HasSubstr("equation 'known_q' has a name that is taken"));
  generate({kPuma, "--lanes", "4"});
  EXPECT_EQ(outcome_.status, 2);
}

INSTANTIATE_TEST_SUITE_P(Scalars, SelfTest, testing::Values("double", "float"),
                         [](const testing::TestParamInfo<const char*>& scalar) {
                           return std::string(scalar.param);
                         });

}  // namespace
}  // namespace treedyn
