// `info --accuracy` and `generate --accuracy-samples` against compiled code and the textbook's A.
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/cli.hpp"
#include "support/compiled.hpp"

namespace treedyn {
namespace {

using Json = nlohmann::json;

class FunctionAccuracy : public Cli {
 protected:
  static Json study(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"info",     "--accuracy", kModel, "--json",
                                          "--effort", "0",          "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = treedyn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

/// A of the two-link arm, Siciliano 7.3.2: m = 50, a = 1, l = 1/2, I = 10.
double textbook(const std::string& element, double elbow) {
  const double c = std::cos(elbow);
  return element == "A[0]"   ? 2 * 10 + 50 * 0.25 + 50 * (1 + 0.25 + c)
         : element == "A[3]" ? 10 + 50 * 0.25
                             : 10 + 50 * (0.25 + 0.5 * c);
}

TEST_F(FunctionAccuracy, IsThatOfCompiledCodeInTheStateThatItNames) {
  const Json result = study({"--functions", "mass_matrix", "--accuracy-samples", "50"});
  const Json& row = result.at("rows").at(0);
  EXPECT_EQ(row.at("option"), "as asked for");
  const Json& worst = row.at("float").at("ulp");
  const std::string element = worst.at("output");
  std::vector<double> q;
  for (const Json& named : result.at("named_states")) {
    if (named.at("state") == worst.at("state")) {
      q = named.at("values").at("q").get<std::vector<double>>();
    }
  }
  ASSERT_EQ(q.size(), 2U);
  for (double& x : q) {
    x = static_cast<double>(static_cast<float>(x));  // printed with the digits of float
  }
  const support::CompiledModel model = support::generate_and_compile(
      kModel, {"--effort", "0", "--functions", "mass_matrix", "--scalar", "float"});
  const std::size_t k = element == "A[0]" ? 0 : element == "A[3]" ? 3 : 1;
  const double exact = textbook(element, q[1]);
  const double error = std::abs(model.call("mass_matrix", {q})[k] - exact);
  const double unit = std::ldexp(1.0, std::ilogb(exact) - 23);
  EXPECT_NEAR(worst.at("error").get<double>(), error / unit, 0.005 * error / unit);
}

TEST_F(FunctionAccuracy, HasCostAndErrorInOneRowForEveryOption) {
  const Json result =
      study({"--functions", "bias_force,forward_dynamics", "--accuracy-samples", "20"});
  EXPECT_EQ(result.at("states"), 20);
  std::map<std::string, std::vector<std::string>> options;
  std::map<std::string, int> operations;
  for (const Json& row : result.at("rows")) {
    const std::string option = row.at("option");
    options[row.at("function")].push_back(option);
    const Json& cost = row.at("double").at("operations");
    if (row.at("function") == "bias_force") {
      operations[option] =
          cost.at("add").get<int>() + cost.at("mul").get<int>() + cost.at("div").get<int>();
    }
    const double in_float = row.at("float").at("scaled").at("error");
    const double in_double = row.at("double").at("scaled").at("error");
    EXPECT_GT(in_float / in_double, 1e7) << row;  // 2^29, by some luck
    EXPECT_LT(in_float / in_double, 1e10) << row;
  }
  EXPECT_EQ(options.at("bias_force").size(), 12U);  // nine passes
  EXPECT_THAT(options.at("bias_force"), testing::Contains("sincos libm"));
  EXPECT_THAT(options.at("forward_dynamics"), testing::IsSupersetOf({"factor", "articulated"}));
  EXPECT_LT(operations.at("as asked for"), operations.at("without all passes"));
}

TEST_F(FunctionAccuracy, SaysWhichLimitsTheModelStates) {
  const Outcome outcome = treedyn({"info", "--accuracy", kModel, "--effort", "0", "--functions",
                                   "gravity_force", "--accuracy-samples", "5", "-q"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the model states no limits of position for any joint"));
  EXPECT_THAT(outcome.out, HasSubstr("in 5 pseudo-random states"));
  EXPECT_THAT(outcome.out, HasSubstr("without regrouping"));
}

TEST_F(FunctionAccuracy, HasProvenBoundsAndSaysWhereThereAreNone) {
  const std::vector<std::string> options = {
      "--functions", "mass_matrix,bias_force,forward_dynamics", "--accuracy-samples", "20"};
  const Json result = study(options);
  std::map<std::string, std::string> kinds;
  for (const Json& row : result.at("rows")) {
    for (const char* scalar : {"float", "double"}) {
      const Json& bound = row.at(scalar).at("bound");
      EXPECT_GE(bound.at("error").get<double>(), bound.at("sampled").get<double>()) << row;
      EXPECT_LE(bound.at("error").get<double>(), 100 * bound.at("sampled").get<double>()) << row;
      EXPECT_EQ(bound.at("kind") == "running", bound.at("obstacle") != "") << row;
      if (row.at("option") == "as asked for") {
        kinds[row.at("function")] = bound.at("kind").get<std::string>() + " " +
                                    bound.at("assumed").get<std::string>() +
                                    bound.at("obstacle").get<std::string>();
      }
    }
  }
  EXPECT_EQ(kinds.at("mass_matrix"), "proven ");
  EXPECT_EQ(kinds.at("bias_force"), "proven qd of any joint");
  EXPECT_EQ(kinds.at("forward_dynamics"), "running a divisor may be zero");
  std::vector<std::string> arguments = {"info", "--accuracy", kModel, "--effort", "0", "-q"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = treedyn(arguments);
  EXPECT_THAT(outcome.out, HasSubstr("bias_force: proven for the ranges taken of qd of any joint, "
                                     "which have no limits"));
  EXPECT_THAT(outcome.out, HasSubstr("forward_dynamics: running, because a divisor may be zero as "
                                     "far as intervals tell"));
}

/// Of a pendulum with these limits of its angle.
std::string pendulum_between(const char* lower, const char* upper) {
  return fmt::format(
      "name: p\nlinks: [{{name: a, father: ground, mass: 1, com: [0.1, 0, 0.2], joint: {{name: j, "
      "type: revolute, axis: [1, 0, 0], limits: {{lower: {}, upper: {}}}}}}}]\n",
      lower, upper);
}

TEST_F(FunctionAccuracy, SaysWhyABoundIsNone) {
  const std::string model = scratch("far.yaml");
  write_file(model, pendulum_between("-1e6", "1e6"));
  const auto text = [&](const std::string& sines) {
    return treedyn({"info", "--accuracy", model, "--effort", "0", "--functions", "gravity_force",
                    "--sincos", sines, "-q"})
        .out;
  };
  const char* const why =
      "in float: none, because an angle may leave the range of the sines as far as intervals tell";
  const std::string pair = text("pair");
  EXPECT_THAT(pair, HasSubstr("(none)"));
  EXPECT_THAT(pair, HasSubstr(std::string("  gravity_force ") + why + "\n"));
  EXPECT_THAT(pair, Not(HasSubstr("in double:")));
  EXPECT_THAT(text("libm"), HasSubstr(std::string("  gravity_force sincos pair ") + why + "\n"));
}

/// Placeholders, and limits that are exchanged.
TEST_F(FunctionAccuracy, TakesLimitsThatLeaveNoRangeForNone) {
  for (const auto& [lower, upper] : {std::pair{"0", "0"}, std::pair{"1", "-1"}}) {
    const std::string model = scratch("no_range.yaml");
    write_file(model, pendulum_between(lower, upper));
    const Outcome outcome = treedyn({"info", "--accuracy", model, "--effort", "0", "--functions",
                                     "gravity_force", "--json", "-q"});
    const Json result = Json::parse(outcome.out);
    EXPECT_THAT(result.at("missing_limits").get<std::string>(),
                HasSubstr("no limits of position for any joint (taken: -pi to pi rad"));
    const Json& in_float = result.at("rows").at(0).at("float");
    EXPECT_GT(in_float.at("scaled").at("error").get<double>(), 1e-8);
    EXPECT_EQ(in_float.at("bound").at("kind"), "proven");
    EXPECT_LT(in_float.at("bound").at("error").get<double>(),
              10 * in_float.at("scaled").at("error").get<double>());
  }
}

TEST_F(FunctionAccuracy, TakesEquationsOfUsers) {
  const Json result = study({"--equations", TREEDYN_SOURCE_DIR "/models/equations/power.yaml",
                             "--functions", "total_power", "--accuracy-samples", "10"});
  const Json& row = result.at("rows").at(0);  // two products and a sum of numbers of float
  const double error = row.at("float").at("scaled").at("error");
  EXPECT_LE(error, 2 * 0x1p-24);
  EXPECT_GT(error, 0x1p-27);
  EXPECT_LE(row.at("double").at("scaled").at("error").get<double>(), 0x1p-53);
}

/// The same errors as those of `info`, and `check` finds them again.
TEST_F(FunctionAccuracy, GoesIntoTheManifest) {
  const std::vector<std::string> options = {
      kModel, "-q", "--effort", "0", "--scalar", "float", "-o", out(), "--accuracy-samples", "20"};
  const auto with = [&](const char* command) {
    std::vector<std::string> arguments = {command};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return treedyn(arguments);
  };
  EXPECT_EQ(with("generate").status, 0);
  EXPECT_EQ(with("check").status, 0);
  const Json manifest = Json::parse(read_file(file("two_link.json")));
  EXPECT_EQ(manifest.at("options").at("accuracy_samples"), 20);
  const Json expected = study({"--accuracy-samples", "20"});
  int compared = 0;
  for (const Json& function : manifest.at("functions")) {
    for (const Json& row : expected.at("rows")) {
      if (row.at("option") == "as asked for" && row.at("function") == function.at("name")) {
        EXPECT_EQ(function.at("errors").at("scaled"), row.at("float").at("scaled"));
        EXPECT_EQ(function.at("errors").at("ulp"), row.at("float").at("ulp"));
        EXPECT_EQ(function.at("errors").at("bound"), row.at("float").at("bound"));
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 7);
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("--accuracy-samples 20"));
}

TEST_F(FunctionAccuracy, RefusesWhatItDoesNotMeasure) {
  expect_usage_error(treedyn({"info", kModel, "--accuracy-samples", "20"}), "expected --accuracy");
  expect_usage_error(treedyn({"generate", kModel, "--accuracy-samples", "0", "-o", out()}),
                     "--accuracy-samples");
  expect_usage_error(
      treedyn({"info", "--accuracy", "--scene", TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml",
               "--functions", "step", "--integrator", "rk4", "--step", "0.01"}),
      "--functions of its model");
}

}  // namespace
}  // namespace treedyn
