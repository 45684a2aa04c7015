// Numbers that are known at run time only: the same results as code that was generated from them.

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "support/manifest.hpp"

namespace treedyn {
namespace {

using support::FunctionInfo;
using support::Manifest;

const std::string kWarnings =
    "-Wall -Wextra -Werror -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion "
    "-Wunused -ffp-contract=off -O1";

/// A number of the model and what it is at run time.
struct ParameterChange {
  std::string from;   ///< in the model or scene
  std::string to;     ///< in that which other code is generated from
  std::string field;  ///< of Parameters; "": none
  std::string value;
};

struct RunTimeRobot {
  std::string name;
  const char* model;
  std::string runtime;
  std::vector<ParameterChange> changes;
  std::vector<std::string> options;
  double epsilon;
  std::vector<std::string> others = {};  ///< options of the changed model alone
  std::string scene = {};                ///< of tests/data/run_time
  std::vector<ParameterChange> declared =
      {};  ///< in the model whose numbers are known at run time only
};

/// In the names of tests.
void PrintTo(const RunTimeRobot& robot, std::ostream* out) { *out << robot.name; }

/// The texts of a model and its scene.
struct Texts {
  std::string model;
  std::string scene;

  void apply(const ParameterChange& change) {
    std::string& text = scene.find(change.from) != std::string::npos ? scene : model;
    const std::size_t at = text.find(change.from);
    EXPECT_NE(at, std::string::npos) << change.from;
    EXPECT_EQ(text.find(change.from, at + 1), std::string::npos) << change.from;
    text.replace(at, change.from.size(), change.to);
  }
};

/// Calls of the functions of both with the same random arguments, the results compared: the
/// largest difference, as a part of the largest result.
std::string comparison(const FunctionInfo& function, const std::string& first,
                       const std::string& second) {
  std::string text = "  {\n";
  std::string inputs;
  bool derived = false;
  for (std::size_t k = 0; k < function.inputs.size(); ++k) {
    derived |= function.arguments[k] == "derived";
    if (function.arguments[k] == "derived") {
      continue;
    }
    text += fmt::format("    Scalar {0}[{1}];\n    for (Scalar& x : {0}) x = random_number();\n",
                        function.arguments[k], function.inputs[k]);
    inputs += (inputs.empty() ? "" : ", ") + function.arguments[k];
  }
  std::string ours = inputs + (derived ? ", ours" : "");
  std::string theirs = inputs + (derived && second == "p_" ? ", &theirs" : "");
  std::string compare;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::string& name = function.results[k];
    for (const std::string own : {"a_", "b_"}) {
      text += fmt::format("    Scalar {}{}[{}] = {{}};\n", own, name, function.outputs[k]);
      (own == "a_" ? ours : theirs) += ", " + own + name;
    }
    compare += fmt::format("    compare(\"{0}\", a_{1}, b_{1}, {2});\n", function.name, name,
                           function.outputs[k]);
  }
  return text + fmt::format("    {}{}({});\n    {}{}({});\n{}  }}\n", first, function.name, ours,
                            second, function.name, theirs, compare);
}

std::string driver(const Manifest& manifest, const std::string& header, const std::string& second,
                   const std::string& set) {
  std::string calls;
  for (const FunctionInfo& function : manifest.functions) {
    calls += function.name == "update_parameters" ? "" : comparison(function, "r::", second);
  }
  return fmt::format(R"(#include <cmath>
#include <cstdio>
#include "r.hpp"
#include "{0}"
using r::Scalar;
static unsigned state = 1;
static Scalar random_number() {{
  state = state * 1664525u + 1013904223u;
  return static_cast<Scalar>(state >> 8) / 8388608 - 1;
}}
static double worst = 0;
static void compare(const char*, const Scalar* a, const Scalar* b, int count) {{
  double largest = 0;
  double difference = 0;
  for (int k = 0; k < count; ++k) {{
    largest = std::fmax(largest, std::fabs(static_cast<double>(b[k])));
    const double d = std::fabs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
    difference = d <= difference ? difference : d;
  }}
  const double part = difference == 0 ? 0 : difference / largest;
  worst = part <= worst ? worst : part;
}}
int main() {{
  r::Parameters p = r::kNominalParameters;
  r::DerivedParameters ours;
{1}
  for (int n = 0; n < 20; ++n) {{
{2}  }}
  std::printf("%.3e", worst);
}}
)",
                     header, set, calls);
}

/// `count` steps from rest at 1, what a step gives is the argument of the next; at the end `q` is
/// printed, and how often the phase has changed.
std::string motion(const FunctionInfo& step, const std::string& space, const std::string& derived,
                   int count) {
  std::string text = fmt::format("  {{\n    using {}::Scalar;\n", space);
  std::string arguments;
  std::string next;
  for (std::size_t k = 0; k < step.inputs.size(); ++k) {
    const std::string& name = step.arguments[k];
    if (name == "derived") {
      arguments += ", " + derived;
      continue;
    }
    text += fmt::format("    {} {}[{}] = {{{}}};\n", step.integer_inputs[k] ? "int" : "Scalar",
                        name, step.inputs[k], name == "q" ? "1" : "");
    arguments += (k == 0 ? "" : ", ") + name;
  }
  for (std::size_t k = 0; k < step.outputs.size(); ++k) {
    const std::string& name = step.results[k];
    text += fmt::format("    {} {}[{}] = {{}};\n", step.integer_outputs[k] ? "int" : "Scalar", name,
                        step.outputs[k]);
    arguments += ", " + name;
    if (name.ends_with("_next")) {
      next += fmt::format("      for (int i = 0; i < {}; ++i) {}[i] = {}[i];\n", step.outputs[k],
                          name.substr(0, name.size() - 5), name);
    }
  }
  return text + fmt::format(
                    "    int changes = 0;\n    for (int n = 0; n < {}; ++n) {{\n"
                    "      {}::step({});\n      changes += phase[0] != phase_next[0];\n{}"
                    "    }}\n    std::printf(\"%.17g %d \", q[0], changes);\n  }}\n",
                    count, space, arguments, next);
}

class RunTime : public Cli, public testing::WithParamInterface<RunTimeRobot> {
 protected:
  void SetUp() override {
    const RunTimeRobot& robot = GetParam();
    Texts texts{read_file(fmt::format("{}/models/{}", TREEDYN_SOURCE_DIR, robot.model)), ""};
    if (!robot.scene.empty()) {
      texts.scene =
          read_file(fmt::format("{}/tests/data/run_time/{}", TREEDYN_SOURCE_DIR, robot.scene));
    }
    Texts nominal = texts;
    for (const ParameterChange& change : robot.declared) {
      nominal.apply(change);
    }
    for (const ParameterChange& change : robot.changes) {
      texts.apply(change);
    }
    write("nominal", nominal);
    write("changed", texts);
    std::vector<std::string> options = {"--name", "r"};
    if (!robot.runtime.empty()) {
      options.insert(options.end(), {"--runtime", robot.runtime});
    }
    generate("nominal", options);
  }

  void write(const std::string& name, Texts texts) const {
    write_file(scratch(name + ".yaml"), texts.model);
    if (!texts.scene.empty()) {
      texts.apply({fmt::format("model: {}", GetParam().model), fmt::format("model: {}.yaml", name),
                   "", ""});
      write_file(scratch(name + ".scene.yaml"), texts.scene);
    }
  }

  void generate(const std::string& name, std::vector<std::string> more) {
    if (GetParam().scene.empty()) {
      more.insert(more.begin(), scratch(name + ".yaml"));
    } else {
      more.insert(more.begin(), {"--scene", scratch(name + ".scene.yaml")});
    }
    more.insert(more.begin(), {"generate", "-q", "-o", out()});
    more.insert(more.end(), GetParam().options.begin(), GetParam().options.end());
    const Outcome outcome = treedyn(more);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  static void run_compiler(const std::string& options) {
    const Outcome outcome = support::run_words(TREEDYN_CXX " " + options);
    ASSERT_EQ(outcome.status, 0) << options << '\n' << outcome.err;
  }

  /// What the driver finds.
  [[nodiscard]] double difference(const std::string& other_source, const std::string& text) const {
    write_file(file("driver.cpp"), text);
    const std::string at = out() + "/";
    run_compiler(fmt::format("-std=c++17 {0} -c {1}r.cpp -o {1}r.o", kWarnings, at));
    run_compiler(fmt::format("{2} {0} -c {1}{3} -o {1}other.o", kWarnings, at,
                             other_source.ends_with(".c") ? "-x c -std=c99" : "-std=c++17",
                             other_source));
    run_compiler(fmt::format("-std=c++17 -O1 {0}driver.cpp {0}r.o {0}other.o -o {0}driver", at));
    const Outcome outcome = support::run({at + "driver"});
    EXPECT_EQ(outcome.status, 0);
    return std::stod(outcome.out);
  }

  static std::string changed_fields(const std::string& object) {
    std::string set;
    for (const ParameterChange& change : GetParam().changes) {
      set += change.field.empty() ? ""
                                  : fmt::format("  {}.{} = static_cast<Scalar>({});\n", object,
                                                change.field, change.value);
    }
    return set;
  }

  /// Rounding: as many unit roundoffs of the largest result as both functions have operations.
  static double tolerance(const Manifest& manifest) {
    long most = 0;
    for (const FunctionInfo& function : manifest.functions) {
      most = std::max(most, function.operations[0] + function.operations[1]);
    }
    return 2 * static_cast<double>(most) * GetParam().epsilon;
  }
};

TEST_P(RunTime, GivesWhatCodeOfTheChangedModelGives) {
  std::vector<std::string> others = GetParam().others;
  others.insert(others.end(), {"--name", "m"});
  generate("changed", others);
  const Manifest manifest = support::read_manifest(file("r.json"));
  const std::string update = "  r::update_parameters(p, ours);\n";
  const double off =
      difference("m.cpp", driver(manifest, "m.hpp", "m::", changed_fields("p") + update));
  EXPECT_LE(off, tolerance(manifest));
  const double control = difference("m.cpp", driver(manifest, "m.hpp", "m::", update));
  EXPECT_GE(control, 1e-3) << "the changes change nothing";
}

using RunTimeSteps = RunTime;

/// Events come where the parameters put them.
TEST_P(RunTimeSteps, MoveAsCodeOfTheChangedSceneDoes) {
  generate("changed", {"--name", "m"});
  const FunctionInfo step = support::read_manifest(file("r.json")).function("step");
  const FunctionInfo other = support::read_manifest(file("m.json")).function("step");
  constexpr int kSteps = 3000;
  const auto moved = [&](const std::string& set) {
    write_file(file("driver.cpp"),
               "#include <cstdio>\n#include \"r.hpp\"\n#include \"m.hpp\"\nint main() {\n"
               "  using r::Scalar;\n  r::Parameters p = r::kNominalParameters;\n"
               "  r::DerivedParameters d;\n" +
                   set + "  r::update_parameters(p, d);\n" + motion(step, "r", "d", kSteps) +
                   motion(other, "m", "", kSteps) + "}\n");
    const std::string at = out() + "/";
    run_compiler(fmt::format("-std=c++17 {0} -O2 {1}driver.cpp {1}r.cpp {1}m.cpp -o {1}driver",
                             kWarnings, at));
    double height = 0;
    double expected = 0;
    int changes = 0;
    int expected_changes = 0;
    std::istringstream(support::run({at + "driver"}).out) >> height >> changes >> expected >>
        expected_changes;
    EXPECT_GT(expected_changes, 2);
    return std::tuple(height - expected, changes - expected_changes);
  };
  const auto [off, changes] = moved(changed_fields("p"));
  EXPECT_LE(std::fabs(off), 8 * kSteps * 2.3e-16);  // roundings of a step, of numbers of size 1
  EXPECT_EQ(changes, 0);
  EXPECT_GE(std::fabs(std::get<0>(moved(""))), 1e-3) << "the changes change nothing";
}

using RunTimeInC = RunTime;

TEST_P(RunTimeInC, HasTheSameBits) {
  std::vector<std::string> options = {"--name", "r", "--language", "c99", "--prefix", "p"};
  if (!GetParam().runtime.empty()) {
    options.insert(options.end(), {"--runtime", GetParam().runtime});
  }
  generate("nominal", options);
  const Manifest manifest = support::read_manifest(file("r.json"));
  const std::string set = changed_fields("p") +
                          "  r::update_parameters(p, ours);\n"
                          "  p_Parameters in_c = P_NOMINAL_PARAMETERS;\n" +
                          changed_fields("in_c") +
                          "  p_DerivedParameters theirs;\n  p_update_parameters(&in_c, &theirs);\n";
  EXPECT_EQ(difference("r.c", driver(manifest, "r.h", "p_", set)), 0);
}

const std::string kFunctions =
    "mass_matrix,bias_force,gravity_force,inverse_dynamics,forward_dynamics,kinetic_energy,"
    "potential_energy,mass_matrix_factor,mass_matrix_solve,mass_matrix_inverse,dynamics_terms,"
    "joint_to_com_vectors";
const std::vector<ParameterChange> kOfPuma = {
    {"mass: 4.8", "mass: 6.3125", "link3_mass", "6.3125"},
    {"com: [0, -0.070, 0.014]", "com: [0.03, 0.05, -0.02]", "link3_com_x", "0.03"},
    {"[0.03, 0.05", "[0.03, 0.05", "link3_com_y", "0.05"},
    {"0.05, -0.02]", "0.05, -0.02]", "link3_com_z", "-0.02"},
    {"mass: 0.09\n", "mass: 0.5\n", "link6_mass", "0.5"},
    {"inertia: [0.15e-3, 0, 0, 0.15e-3, 0, 0.04e-3]",
     "inertia: [0.3e-3, 1e-5, -2e-5, 0.4e-3, 3e-5, 0.5e-3]", "link6_inertia_xx", "0.3e-3"},
    {"[0.3e-3, 1e-5", "[0.3e-3, 1e-5", "link6_inertia_xy", "1e-5"},
    {"1e-5, -2e-5", "1e-5, -2e-5", "link6_inertia_xz", "-2e-5"},
    {"-2e-5, 0.4e-3", "-2e-5, 0.4e-3", "link6_inertia_yy", "0.4e-3"},
    {"0.4e-3, 3e-5", "0.4e-3, 3e-5", "link6_inertia_yz", "3e-5"},
    {"3e-5, 0.5e-3", "3e-5, 0.5e-3", "link6_inertia_zz", "0.5e-3"}};
const std::vector<ParameterChange> kOfBiped = {
    {"com: [0.502*foot, 0.034*foot, 0.01 - 0.199*foot]", "com: [0.04, -0.01, -0.03]",
     "left_foot_com_x", "0.04"},
    {"[0.04, -0.01", "[0.04, -0.01", "left_foot_com_y", "-0.01"},
    {"-0.01, -0.03]", "-0.01, -0.03]", "left_foot_com_z", "-0.03"},
    {"[22^2*J_foot, -11^2*J_foot, 17^2*J_foot, 48^2*J_foot, 0, 49^2*J_foot]",
     "[0.02, 0.001, -0.002, 0.03, 0.003, 0.04]", "left_foot_inertia_xx", "0.02"},
    {"[0.02, 0.001", "[0.02, 0.001", "left_foot_inertia_xy", "0.001"},
    {"0.001, -0.002", "0.001, -0.002", "left_foot_inertia_xz", "-0.002"},
    {"-0.002, 0.03", "-0.002, 0.03", "left_foot_inertia_yy", "0.03"},
    {"0.03, 0.003", "0.03, 0.003", "left_foot_inertia_yz", "0.003"},
    {"0.003, 0.04", "0.003, 0.04", "left_foot_inertia_zz", "0.04"}};
const std::string kRuntimeOfPuma = "link3.mass,link3.com,link6.mass,link6.inertia";

const RunTimeRobot kPuma = {
    "Puma", "puma560.yaml", kRuntimeOfPuma, kOfPuma, {"--effort", "20", "--functions", kFunctions},
    2.3e-16};
/// The same robot and changes with other options.
RunTimeRobot with_options(RunTimeRobot robot, std::string name, std::vector<std::string> options,
                          double epsilon) {
  robot.name = std::move(name);
  robot.options = std::move(options);
  robot.epsilon = epsilon;
  return robot;
}

const RunTimeRobot kPlainPuma =
    with_options(kPuma, "PumaPlain",
                 {"--effort", "0", "--functions", kFunctions, "--layout", "packed"}, 2.3e-16);
const RunTimeRobot kPumaByMasses = with_options(
    kPuma, "PumaDividesByMasses",
    {"--effort", "0", "--equations", TREEDYN_SOURCE_DIR "/models/equations/centre_of_mass.yaml",
     "--functions", "centre_of_mass,centre_of_mass_jacobian,centre_of_mass_bias"},
    2.3e-16);
const RunTimeRobot kPumaInFloat = with_options(kPuma, "PumaInFloat",
                                               {"--effort", "0", "--scalar", "float", "--functions",
                                                "mass_matrix,inverse_dynamics,gravity_force"},
                                               1.2e-7);
const RunTimeRobot kFreeBiped = {"FreeBiped",
                                 "biped.yaml",
                                 "left_foot.com,left_foot.inertia",
                                 kOfBiped,
                                 {"--effort", "0", "--base", "axes", "--functions",
                                  "mass_matrix,inverse_dynamics,forward_dynamics"},
                                 2.3e-16};
const RunTimeRobot kPolar = {"Polar",
                             "polar.yaml",
                             "boom.mass,boom.com",
                             {{"mass: m3", "mass: 5.5", "boom_mass", "5.5"},
                              {"com: [0, 0, -c3]", "com: [0.01, 0.02, -0.4]", "boom_com_x", "0.01"},
                              {"[0.01, 0.02", "[0.01, 0.02", "boom_com_y", "0.02"},
                              {"0.02, -0.4]", "0.02, -0.4]", "boom_com_z", "-0.4"}},
                             {"--effort", "20"},
                             2.3e-16};
/// A robot on a slope, with a load.
const RunTimeRobot kTilted = {"Tilted",
                              "puma560.yaml",
                              "gravity,link6.mass",
                              {{"name: puma560", "name: puma560", "gravity_x", "1.5"},
                               {"name: puma560", "name: puma560", "gravity_y", "-2.25"},
                               {"name: puma560", "name: puma560", "gravity_z", "-9.0"},
                               {"mass: 0.09\n", "mass: 0.5\n", "link6_mass", "0.5"}},
                              {"--effort", "20", "--functions",
                               "gravity_force,inverse_dynamics,forward_dynamics,potential_energy"},
                              2.3e-16,
                              {"--gravity", "1.5,-2.25,-9"}};
const RunTimeRobot kTiltedPolar = {"TiltedPolar",
                                   "polar.yaml",
                                   "gravity",
                                   {{"name: polar", "name: polar", "gravity_x", "1.5"},
                                    {"name: polar", "name: polar", "gravity_y", "-2.25"},
                                    {"name: polar", "name: polar", "gravity_z", "0"}},
                                   {"--effort", "0", "--layout", "packed"},
                                   2.3e-16,
                                   {"--gravity", "1.5,-2.25,0"}};
const RunTimeRobot kTiltedBiped = {"TiltedBiped",
                                   "biped.yaml",
                                   "gravity",
                                   {{"name: biped", "name: biped", "gravity_x", "1.5"},
                                    {"name: biped", "name: biped", "gravity_y", "-2.25"}},
                                   {"--effort", "0", "--base", "axes", "--functions",
                                    "inverse_dynamics,forward_dynamics,gravity_force"},
                                   2.3e-16,
                                   {"--gravity", "1.5,-2.25,-9.81"}};

/// Lengths: joint 3 of the PUMA turns about an axis parallel to that of joint 2.
const std::vector<ParameterChange> kLengthsOfPuma = {
    {"offset: [0.4318, 0, -0.0934]", "offset: [0.5, 0.02, -0.1]", "link3_offset_x", "0.5"},
    {"[0.5, 0.02", "[0.5, 0.02", "link3_offset_y", "0.02"},
    {"0.02, -0.1]", "0.02, -0.1]", "link3_offset_z", "-0.1"},
    {"offset: [-0.0203, -0.4331, 0]", "offset: [-0.0203, -0.4, 0]", "link4_offset_y", "-0.4"},
    {"com: [0, -0.070, 0.014]", "com: [0, 0.05, 0.014]", "link3_com_y", "0.05"}};
const std::string kRuntimeLengthsOfPuma = "link3.offset,link4.offset.y,link3.com.y";
const RunTimeRobot kLongerPuma = {"LongerPuma",
                                  "puma560.yaml",
                                  kRuntimeLengthsOfPuma,
                                  kLengthsOfPuma,
                                  {"--effort", "20", "--functions", kFunctions},
                                  2.3e-16};
const RunTimeRobot kLongerPlainPuma = with_options(
    kLongerPuma, "LongerPumaPlain", {"--effort", "0", "--functions", kFunctions}, 2.3e-16);
/// A tool, and a forearm that another one has taken the place of.
const RunTimeRobot kOtherTool = {
    "OtherTool",
    "two_link.yaml",
    "tip.at,forearm.offset.x,forearm.mass",
    {{"at: [a2, 0, 0]", "at: [0.7, 0.1, -0.2]", "tip_at_x", "0.7"},
     {"[0.7, 0.1", "[0.7, 0.1", "tip_at_y", "0.1"},
     {"0.1, -0.2]", "0.1, -0.2]", "tip_at_z", "-0.2"},
     {"offset: [a1, 0, 0]", "offset: [0.9, 0, 0]", "forearm_offset_x", "0.9"}},
    {"--effort", "20"},
    2.3e-16};
const RunTimeRobot kLongerPolar = {
    "LongerPolar",
    "polar.yaml",
    "boom.offset",
    {{"offset: [0, d2, 0]", "offset: [0.05, 0.3, -0.1]", "boom_offset_x", "0.05"},
     {"[0.05, 0.3", "[0.05, 0.3", "boom_offset_y", "0.3"},
     {"0.3, -0.1]", "0.3, -0.1]", "boom_offset_z", "-0.1"}},
    {"--effort", "0", "--layout", "packed"},
    2.3e-16};
const RunTimeRobot kWiderBiped = {
    "WiderBiped",
    "biped.yaml",
    "left_hip_block.offset.y,left_toe.at.x",
    {{"name: left_hip_yaw, type: revolute, axis: [0, 0, 1], offset: [0, hip_y, -pelvis]",
      "name: left_hip_yaw, type: revolute, axis: [0, 0, 1], offset: [0, 0.2, -pelvis]",
      "left_hip_block_offset_y", "0.2"},
     {"left_toe, link: left_foot, at: [toe_x", "left_toe, link: left_foot, at: [0.3",
      "left_toe_at_x", "0.3"}},
    {"--effort", "0", "--base", "axes", "--functions",
     "mass_matrix,inverse_dynamics,forward_dynamics,point_positions,force_jacobian_transpose"},
    2.3e-16};

ParameterChange of_parameter(const std::string& name, const std::string& from,
                             const std::string& to) {
  return {name + ": " + from, name + ": " + to, name, to};
}

const ParameterChange kNothingAtRunTime = {
    "runtime: [g, slope, kp, kd, target, amplitude, omega, viscous, dry, creep, rotor, k, damping, "
    "rest, anchor_x, push, height,\n  ground, loss, mu, slip]\n",
    "", "", ""};
const RunTimeRobot kEveryNumber = {"EveryNumber",
                                   "two_link.yaml",
                                   "",
                                   {kNothingAtRunTime,
                                    of_parameter("g", "9.81", "3.7"),
                                    of_parameter("slope", "0.05", "-0.4"),
                                    of_parameter("kp", "120", "200"),
                                    of_parameter("kd", "8", "2.5"),
                                    of_parameter("target", "0.4", "-0.7"),
                                    of_parameter("amplitude", "0.3", "0.9"),
                                    of_parameter("omega", "2", "5"),
                                    of_parameter("viscous", "1.5", "0.5"),
                                    of_parameter("dry", "2.5", "4"),
                                    of_parameter("creep", "0.1", "0.3"),
                                    of_parameter("rotor", "0.75", "0.25"),
                                    of_parameter("k", "90", "35"),
                                    of_parameter("damping", "4", "7.5"),
                                    of_parameter("rest", "0.2", "-0.1"),
                                    of_parameter("anchor_x", "0.5", "-0.8"),
                                    of_parameter("push", "6", "13"),
                                    of_parameter("height", "-0.25", "0.3"),
                                    of_parameter("ground", "5000", "900"),
                                    of_parameter("loss", "0.5", "0.2"),
                                    of_parameter("mu", "0.6", "0.9"),
                                    of_parameter("slip", "0.05", "0.2")},
                                   {"--effort", "20"},
                                   2.3e-16,
                                   {},
                                   "every_number.yaml"};
const RunTimeRobot kEveryPlainNumber =
    with_options(kEveryNumber, "EveryPlainNumber", {"--effort", "0"}, 2.3e-16);
const RunTimeRobot kEveryNumberInFloat =
    with_options(kEveryNumber, "EveryNumberInFloat", {"--scalar", "float"}, 1.2e-7);
const RunTimeRobot kLed = {
    "Led",
    "polar.yaml",
    "",
    {{"runtime: [radius, omega, offset, rate, grip]\n", "", "", ""},
     of_parameter("radius", "0.25", "0.6"),
     of_parameter("omega", "2", "3"),
     of_parameter("offset", "1.2", "0.5"),
     of_parameter("rate", "0.5", "4"),
     {"mass: m3", "mass: 5.5", "boom_mass", "5.5"},
     {"com: [0, 0, -c3]", "com: [0.01, 0.02, -0.4]", "boom_com_x", "0.01"},
     {"[0.01, 0.02", "[0.01, 0.02", "boom_com_y", "0.02"},
     {"0.02, -0.4]", "0.02, -0.4]", "boom_com_z", "-0.4"},
     {"offset: [0, d2, 0]", "offset: [0.05, 0.3, -0.1]", "boom_offset_x", "0.05"},
     {"[0.05, 0.3", "[0.05, 0.3", "boom_offset_y", "0.3"},
     {"0.3, -0.1]", "0.3, -0.1]", "boom_offset_z", "-0.1"},
     {"link: boom}", "link: boom, at: [0.3, -0.2, 0.15]}", "hand_at_x", "0.3"},
     {"at: [0.3, -0.2", "at: [0.3, -0.2", "hand_at_y", "-0.2"},
     {"-0.2, 0.15]", "-0.2, 0.15]", "hand_at_z", "0.15"},
     of_parameter("grip", "0.2", "-0.35")},
    {"--effort", "20"},
    2.3e-16,
    {},
    "led.yaml",
    {{"    com: [0, 0, -c3]\n", "    com: [0, 0, -c3]\n    runtime: [mass, com, offset]\n", "", ""},
     {"link: boom}", "link: boom, runtime: [at]}", "", ""}}};

const RunTimeRobot kBounce = {"Bounce",
                              "scenes/drop.model.yaml",
                              "",
                              {{"runtime: [floor, g, pull, low]\n", "", "", ""},
                               of_parameter("floor", "0.1", "0.25"),
                               of_parameter("g", "9.81", "3.7"),
                               of_parameter("pull", "1", "0.5"),
                               of_parameter("low", "-1.2", "-1.1")},
                              {},
                              2.3e-16,
                              {},
                              "bounce.yaml"};

std::string name_of(const testing::TestParamInfo<RunTimeRobot>& of) { return of.param.name; }

INSTANTIATE_TEST_SUITE_P(Robots, RunTime,
                         testing::Values(kPuma, kPlainPuma, kPumaByMasses, kPumaInFloat, kFreeBiped,
                                         kPolar, kTilted, kTiltedPolar, kTiltedBiped, kLongerPuma,
                                         kLongerPlainPuma, kOtherTool, kLongerPolar, kWiderBiped,
                                         kEveryNumber, kEveryPlainNumber, kEveryNumberInFloat,
                                         kLed),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Robots, RunTimeSteps, testing::Values(kBounce), name_of);
INSTANTIATE_TEST_SUITE_P(Robots, RunTimeInC,
                         testing::Values(kPlainPuma, kPumaInFloat, kPolar, kTiltedPolar, kOtherTool,
                                         kEveryNumber, kLed),
                         name_of);

const std::string kScene = TREEDYN_SOURCE_DIR "/models/scenes/drop.yaml";

class RunTimeCli : public Cli {
 protected:
  /// One link.
  static std::string declared(const std::string& mass) {
    return "name: one\nlinks:\n  - name: a\n    father: ground\n    joint: {name: j, type: "
           "revolute, axis: [0, 1, 0]}\n    " +
           mass + "\n";
  }
  /// One sentence, and nothing is written.
  void expect_refused(std::vector<std::string> arguments, const std::string& what) const {
    arguments.insert(arguments.begin(), {"generate", "-o", out()});
    const Outcome outcome = treedyn(arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(what));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(out()));
  }
};

TEST_F(RunTimeCli, RefusesWhatItDoesNotTake) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& what) {
    arguments.insert(arguments.begin(), kModel);
    expect_refused(arguments, what);
  };
  refused({"--runtime", "hand.mass"}, "--runtime: there is no link 'hand'; expected one");
  refused({"--runtime", "mass"},
          "--runtime: 'mass' cannot be known at run time only; expected gravity");
  refused({"--runtime", "nose.at"},
          "--runtime: there is no point 'nose'; expected one of the model's");
  refused({"--runtime", "forearm.com.w"},
          "--runtime: link 'forearm': 'com.w' cannot be known at run time only; expected mass");
  refused({"--runtime", "forearm.at"}, "there is no point 'forearm'");
  refused({"--runtime", "gravity,gravity"},
          "--runtime: run-time parameter 'gravity' is defined twice");
  refused({"--runtime", "forearm.length"},
          "'length' cannot be known at run time only; expected "
          "mass, com, inertia, offset; of one component com.x or inertia.xx");
  refused({"--runtime", "forearm.mass,forearm.mass"}, "'forearm.mass' is defined twice");
}

TEST_F(RunTimeCli, RefusesOptionsThatReportNumbers) {
  for (const std::string option : {"--accuracy", "--passes"}) {
    expect_usage_error(treedyn({"info", kModel, "--runtime", "forearm.mass", option}), option);
  }
  for (const std::string option : {"--lanes=2", "--share-limbs", "--limb-lanes", "--self-test",
                                   "--checked", "--accuracy-samples=3"}) {
    expect_usage_error(
        treedyn({"generate", kModel, "--runtime", "forearm.mass", option, "-o", out()}),
        option.substr(0, option.find('=')) + ": is for models without run-time parameters");
    EXPECT_FALSE(fs::exists(out()));
  }
  expect_usage_error(
      treedyn({"check", kModel, "--runtime", "forearm.mass", "--numeric", "-o", out()}),
      "--numeric");
  expect_usage_error(treedyn({"generate", "--scene", kScene, "--runtime", "a.mass", "-o", out()}),
                     "--runtime is for models");
}

/// A turn whose sine is seen with another sign than it has takes x for -x where both are zero. The
/// tool holds what it writes against its equations, with other values too.
TEST_F(RunTimeCli, NominalZerosAreNotTakenForTheirNegatives) {
  const auto accepted = [&](const std::string& links, const std::string& runtime) {
    write_file(scratch("tilted.yaml"), "name: tilted\nlinks:\n" + links);
    for (const char* const effort : {"0", "20"}) {
      const Outcome outcome = treedyn({"generate", scratch("tilted.yaml"), "--runtime", runtime,
                                       "--effort", effort, "-j", "1", "-o", out()});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
    }
  };
  const std::string inertia = "mass: 1.5, inertia: [0.1, 0, 0, 0.1, 0, 0.1]";
  for (const char* const turn : {"1.1", "1.3", "-2"}) {
    accepted(
        fmt::format("  - {{name: a, father: ground, joint: {{name: ja, type: revolute, axis: [0, "
                    "1, 0], rotation: {{rpy: [{}, 0, 0]}}}}, com: [0.1, 0.2, 0.3], {}}}\n",
                    turn, inertia),
        "gravity");
  }
  accepted(
      fmt::format("  - {{name: a, father: ground, joint: {{name: ja, type: revolute, axis: [0, 0, "
                  "1]}}, {0}}}\n  - {{name: b, father: a, joint: {{name: jb, type: revolute, "
                  "axis: [0, 1, 0]}}, {0}}}\n  - {{name: s, father: b, joint: {{name: js, type: "
                  "prismatic, axis: [0, 1, 0], rotation: {{rpy: [-0.4, 0, 0]}}}}, {0}}}\n",
                  inertia),
      "s.com");
}

/// Tensors that are none would tell nothing: what the code is held at stays a body.
TEST_F(RunTimeCli, ScenesAreCheckedWithTensorsOfBodies) {
  write_file(
      scratch("arm.yaml"),
      "name: m\nlinks:\n  - {name: body, father: ground, joint: {type: fixed}, mass: 1, "
      "inertia: [0.1, 0, 0, 0.1, 0, 0.1]}\n  - {name: arm, father: body, joint: {name: elbow, "
      "type: revolute, axis: [0, 1, 0]}, mass: 1, inertia: [0.1, 0, 0, 0.1, 0, 0.1], "
      "runtime: [mass, com, inertia]}\n");
  write_file(scratch("scene.yaml"),
             "scene: s\nmodel: arm.yaml\nbase: axes\neffects:\n  point_constraint: [{point: "
             "hand}]\npoints: [{name: hand, link: body, at: [0.1, 0, 0.2]}]\nduration: 1\n");
  const Outcome outcome =
      treedyn({"generate", "--scene", scratch("scene.yaml"), "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

/// What alone is fixed to a base on axes has its numbers, in scenes too.
TEST_F(RunTimeCli, KnowsTheBodyOnABaseOnAxesAtRunTime) {
  const auto write_body = [&](const std::string& joint, const std::string& runtime,
                              const std::string& frame) {
    write_file(
        scratch("body.yaml"),
        fmt::format("name: m\nlinks:\n  - {{name: body, father: ground, joint: {{{}}}, mass: "
                    "1, com: [0.1, 0, 0], inertia: [0.1, 0, 0, 0.1, 0, 0.1], runtime: "
                    "[{}]}}\n  - {{name: imu, father: ground, joint: {{type: fixed}}{}}}\n",
                    joint, runtime, frame));
  };
  write_file(scratch("scene.yaml"),
             "scene: s\nmodel: body.yaml\nbase: axes\neffects:\n  point_constraint: [{point: "
             "hand}]\npoints: [{name: hand, link: body, at: [0.1, 0, 0.2]}]\nduration: 1\n");
  const std::vector<std::string> of_model = {scratch("body.yaml"), "--base", "axes"};
  const std::vector<std::string> of_scene = {"--scene", scratch("scene.yaml")};
  write_body("type: fixed", "mass, com.x, inertia", "");
  for (std::vector<std::string> arguments : {of_model, of_scene}) {
    arguments.insert(arguments.begin(), "generate");
    arguments.insert(arguments.end(), {"-q", "--effort", "0", "--name", "m", "-o", out()});
    const Outcome outcome = treedyn(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(read_file(file("m.hpp")), HasSubstr("Scalar base_rx_mass;"));
    fs::remove_all(out());
  }
  const std::string part = "link 'body' is fixed to base link 'base_rx' and is not all of it";
  write_body("type: fixed", "mass", ", mass: 0.1");
  expect_refused(of_scene, part);
  write_body("type: fixed, offset: [0, 0, 1]", "mass", "");
  expect_refused(of_model, part);
  write_body("type: fixed", "offset", "");
  expect_refused(of_model, part);
}

/// Where the only lengths are known at run time there is no unit to measure them in.
TEST_F(RunTimeCli, EquationsOfUsersTakeLengths) {
  const std::string momentum = TREEDYN_SOURCE_DIR "/models/equations/momentum.yaml";
  for (const char* const parameters : {"forearm.offset", "forearm.offset.x"}) {
    const Outcome outcome = treedyn({"generate", kModel, "--equations", momentum, "--runtime",
                                     parameters, "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

/// The energy divides by nothing and is good for masses of zero, beside a centre of mass too.
TEST_F(RunTimeCli, WhatDividesIsNotSharedWithWhatDoesNot) {
  write_file(scratch("two.yaml"),
             "name: two\nlinks:\n  - {name: a, father: ground, joint: {name: ja, type: prismatic, "
             "axis: [0, 0, 1], offset: [0.06, 0, 0], rotation: {rpy: [pi/2, 0, 0]}}, mass: 2.17, "
             "inertia: [0.4, 0, 0, 0.4, 0, 0.4]}\n  - {name: b, father: ground, joint: {name: jb, "
             "type: prismatic, axis: [0, 1, 0], offset: [-0.29, 0.32, 0.11]}, mass: 0.62, inertia: "
             "[0.4, 0, 0, 0.4, 0, 0.4]}\nequations:\n  - {name: centre, value: "
             "T(ones)*m_d*r/(T(ones)*m_d*ones)}\n");
  const Outcome outcome =
      treedyn({"generate", scratch("two.yaml"), "--functions", "potential_energy,centre",
               "--runtime", "a.mass,b.mass,gravity", "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

/// A nominal zero takes its spring out of the scene that is priced, and what it was multiplied
/// with.
TEST_F(RunTimeCli, PricesParametersThatOthersOfNominalZeroNeed) {
  write_file(scratch("model.yaml"), declared("mass: 2\n    inertia: [1, 0, 0, 1, 0, 1]"));
  write_file(
      scratch("scene.yaml"),
      "scene: s\nmodel: model.yaml\nduration: 1\nparameters: {k: 0, rest: 0.1}\n"
      "runtime: [k, rest]\neffects: {joint_spring: [{joint: j, stiffness: k, rest: rest}]}\n");
  const Outcome outcome = treedyn({"info", "--scene", scratch("scene.yaml"), "--effort", "0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\n  rest "));
}

TEST_F(RunTimeCli, ScenesRefuseWhatTheyDoNotTake) {
  const auto refused = [&](const std::string& scene, const std::string& what) {
    write_file(scratch("scene.yaml"), "scene: s\nmodel: model.yaml\nduration: 1\n" + scene);
    expect_refused({"--scene", scratch("scene.yaml")}, what);
  };
  write_file(scratch("model.yaml"), "runtime: [gravity]\n" + declared("mass: 2"));
  refused("", "scene.yaml:2:8: scene: the model declares 'gravity' as known at run time only");
  write_file(scratch("model.yaml"), declared("mass: 2\n    inertia: [1, 0, 0, 1, 0, 1]"));
  const std::string k = "parameters: {k: 2}\nruntime: [k]\n";
  refused("runtime: [k]\n", "runtime: there is no parameter 'k'");
  refused("parameters: {k: 2}\nruntime: [k, k]\n", "parameter 'k' stands there twice");
  refused(k, "no function that is generated depends on parameter 'k'");
  const std::string fixed = "'k' is known at run time only, which this is not";
  refused(k + "stepping: {step: k/1000}\n", fixed);
  refused(k + "points: [{name: p, link: a, at: [k, 0, 0]}]\nstepping: {integrator: rk4}\n"
              "effects: {point_constraint: [{point: p, along: [y]}]}\n",
          "constraint 'p' closes a loop that steps draw to where it begins");
  refused(k + "effects: {coulomb_friction: [{joint: j, force: k}]}\n", fixed);
  refused(k + "effects: {ground_contact: [{point: a, stiffness: 1, exponent: k}]}\n", fixed);
  refused(k + "effects: {point_constraint: [{point: a, along: [[k, 0, 0]]}]}\n", fixed);
  refused(
      "parameters: {k: 0}\nruntime: [k]\neffects: {coulomb_friction: [{joint: j, force: 1, "
      "slip_speed: k}]}\n",
      "'slip_speed' is 0; expected a number above 0");
  refused(k + "effects: {joint_spring: [{joint: j, stiffness: asin(k/4)}]}\n", "asin");
}

/// Functions of the model have the gravity of its scene.
TEST_F(RunTimeCli, FunctionsOfTheModelKnowTheGravityOfItsScene) {
  write_file(scratch("model.yaml"), declared("mass: 2\n    com: [1, 0, 0]"));
  write_file(scratch("scene.yaml"),
             "scene: s\nmodel: model.yaml\nduration: 1\nparameters: {g: 9}\nruntime: [g]\n"
             "effects: {gravity: [0, 0, -g]}\n");
  const Outcome outcome =
      treedyn({"generate", "-q", "--scene", scratch("scene.yaml"), "--functions",
               "gravity_force,mass_matrix,constrained_dynamics", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string header = read_file(file("s.hpp"));
  EXPECT_THAT(header, HasSubstr("void gravity_force(const Scalar q[1], const DerivedParameters& "
                                "derived, Scalar G[1])"));
  EXPECT_THAT(header, HasSubstr("void mass_matrix(const Scalar q[1], Scalar A[1])"));
}

/// Initial states and durations are nominal; what `simulate` runs is, too.
TEST_F(RunTimeCli, ScenesSimulateWithNominalNumbers) {
  write_file(scratch("model.yaml"), declared("mass: 2\n    inertia: [1, 0, 0, 1, 0, 1]"));
  const auto simulated = [&](const std::string& runtime) {
    write_file(scratch("scene.yaml"),
               "scene: s\nmodel: model.yaml\nduration: k\nparameters: {k: 2}\n" + runtime +
                   "effects: {joint_spring: [{joint: j, stiffness: k}]}\ninitial: {q: {j: k/4}}\n");
    const Outcome outcome = treedyn({"simulate", scratch("scene.yaml")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(simulated("runtime: [k]\n"), simulated(""));
}

TEST_F(RunTimeCli, SaysWhatParametersOfScenesCost) {
  write_file(scratch("model.yaml"), declared("mass: 2\n    inertia: [1, 0, 0, 1, 0, 1]"));
  write_file(scratch("scene.yaml"),
             "scene: s\nmodel: model.yaml\nduration: 1\nparameters: {k: 2, c: 1}\nruntime: [k, "
             "c]\neffects: {joint_spring: [{joint: j, stiffness: k, damping: c + 1}]}\n");
  const Outcome outcome = treedyn({"info", "--scene", scratch("scene.yaml")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("price of every run-time parameter"));
  EXPECT_THAT(outcome.out, HasSubstr("  c         update_parameters "));
}

/// A point of --points with the name of the model's: its place is the nominal one, and functions
/// take it from the fields.
TEST_F(RunTimeCli, PlacesAreThoseOfThePointsThatAreGenerated) {
  const auto places = [&](const std::string& model, const std::string& points) {
    const Outcome outcome =
        treedyn({"generate", "-q", model, "--points", points, "--runtime", "tip.at", "--functions",
                 "point_positions", "--effort", "0", "--name", "m", "-o", out()});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(read_file(file("m.cpp")), HasSubstr("derived."));
  };
  places(kModel, "tip=forearm:0.5,0.2,0");
  EXPECT_THAT(read_file(file("m.hpp")),
              testing::ContainsRegex("kNominalParameters = \\{[^0]*0\\.5[^0]*0\\.2"));
  places(kModel, "tip=upper_arm");
  EXPECT_THAT(read_file(file("m.hpp")), HasSubstr("place x of point tip, frame of link upper_arm"));
  std::string model = read_file(kModel);
  for (std::size_t at = 0; (at = model.find("forearm", at)) != std::string::npos;) {
    model.replace(at, 7, "tip");
  }
  write_file(scratch("tips.yaml"), model);
  places(scratch("tips.yaml"), "tip=tip");
  places(scratch("tips.yaml"), "all");
}

TEST_F(RunTimeCli, SaysWhatEachCosts) {
  const Outcome outcome =
      treedyn({"info", kModel, "--effort", "0", "--runtime", "forearm.mass,forearm.com"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("price of every run-time parameter"));
  EXPECT_THAT(outcome.out, HasSubstr("  forearm.com   "));
  EXPECT_THAT(outcome.out, HasSubstr("  update_parameters "));
}

/// The type of all fields is no name of one; nor is a comment cut before names differ.
TEST_F(RunTimeCli, NamesOfParametersCompile) {
  write_file(scratch("model.yaml"), declared("mass: 2\n    inertia: [1, 0, 0, 1, 0, 1]"));
  write_file(scratch("scene.yaml"),
             "scene: s\nmodel: model.yaml\nduration: 1\nparameters: {Scalar: 2, c: 1}\n"
             "runtime: [Scalar, c]\neffects: {joint_spring: [{joint: j, stiffness: Scalar, "
             "damping: c}]}\n");
  const Outcome outcome =
      treedyn({"generate", "-q", "--scene", scratch("scene.yaml"), "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Outcome compiled =
      support::run({TREEDYN_CXX, "-std=c++11", "-Wall", "-Werror", "-fsyntax-only", file("s.cpp")});
  EXPECT_EQ(compiled.status, 0) << compiled.err;

  const std::string name(80, 'n');
  std::string model = declared("mass: 2\n    com: [1, 0, 0]\n    runtime: [com]");
  model.replace(model.find("name: a\n"), 7, "name: " + name + "e");
  write_file(scratch("model.yaml"), model);
  const Outcome long_name = treedyn({"generate", "-q", scratch("model.yaml"), "-o", out()});
  ASSERT_EQ(long_name.status, 0) << long_name.err;
  EXPECT_THAT(read_file(file("one.hpp")), HasSubstr(name + "e, m\n"));
}

/// Of what functions take every field says what it is made of, and code reads it by its name.
TEST_F(RunTimeCli, NamesWhatFunctionsTake) {
  const Outcome outcome = treedyn({"generate", "-q", kModel, "--effort", "0", "--name", "m",
                                   "--runtime", "forearm.mass,forearm.offset.x", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string header = read_file(file("m.hpp"));
  EXPECT_THAT(header, HasSubstr("  /// offset x of forearm\n  Scalar forearm_p"));
  EXPECT_THAT(header, HasSubstr("  /// mass, com x of forearm\n  Scalar forearm_p"));
  const std::string source = read_file(file("m.cpp"));
  EXPECT_THAT(source, HasSubstr("derived.forearm_p"));
  EXPECT_THAT(source, testing::Not(HasSubstr("derived.value")));
}

/// Names are hostile: long, equal when shortened, with bytes that no identifier has.
TEST_F(RunTimeCli, TakesNamesOfAnyKind) {
  const std::string one = "a*/ link " + std::string(200, 'x');
  std::string text = declared("mass: 2\n    runtime: [inertia, com, mass]");
  text.replace(text.find("name: a"), 7, "name: '" + one + "'");
  write_file(scratch("model.yaml"), text);
  const Outcome outcome = treedyn(
      {"generate", "-q", "--language", "c99", "--name", "m", scratch("model.yaml"), "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Outcome compiled =
      support::run({TREEDYN_CXX, "-x", "c", "-std=c99", "-pedantic-errors", "-Wall", "-Wextra",
                    "-Werror", "-fsyntax-only", file("m.c").string()});
  EXPECT_EQ(compiled.status, 0) << compiled.err;
}

}  // namespace
}  // namespace treedyn
