// Exit codes and messages for wrong calls, wrong input and full disks.
#include "cli/cli.hpp"

namespace treedyn {
namespace {

TEST_F(Cli, SaysThatGroundIsInFrontOfTheBasesJoints) {
  const Outcome outcome =
      treedyn({"generate", kModel, "--base", "axes", "--points", "p=ground:1,2,3", "-o", out()});
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("point 'p': 'ground' is in front of the base's joints; "
                                     "expected a link, as base_rx"));
}

TEST_F(Cli, ReturnsTwoForWrongUsage) {
  expect_usage_error(treedyn({}), "subcommand");
  expect_usage_error(treedyn({"generate"}), "MODEL");
  expect_usage_error(treedyn({"generate", kModel}), "-o DIR");
  expect_usage_error(treedyn({"simulate"}), "SCENE");
  expect_usage_error(treedyn({"info", kModel, "--functions", "impact"}), "impact");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--no-such-option"}, "--no-such-option"},
      {{"--scalar", "half"}, "half"},
      {{"--base", "free"}, "--base"},
      {{"--base", "wheels"}, "wheels"},
      {{"--mimic", "never"}, "never"},
      {{"--functions", "mass_matrix,no_such"}, "no_such"},
      {{"--functions", ""}, "--functions"},
      {{"--gravity", "0,0"}, "--gravity"},
      {{"--gravity", "0,0,x"}, "--gravity"},
      {{"--snap", "much"}, "--snap"},
      {{"--snap=-1"}, "--snap"},
      {{"--effort", "-1"}, "--effort"},
      {{"--effort", "all"}, "--effort"},
      {{"--name", "3d"}, "--name"},
      {{"--name", "class"}, "--name"},
      {{"--name", "std"}, "--name"},
      {{"--forward-dynamics", "magic"}, "magic"},
  };
  for (const auto& [options, what] : wrong) {
    std::vector<std::string> arguments = {"generate", kModel, "-o", out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_usage_error(treedyn(arguments), what);
  }
  expect_usage_error(treedyn({"list", "robots"}), "robots");
  expect_usage_error(treedyn({"vet", kModel, "--error-format", "xml"}), "xml");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Cli, ReturnsOneAndWritesNothingForWrongInput) {
  const std::string model = scratch("bad.yaml");
  write_file(model, "name: bad\nlinks: [{name: a, father: nobody}]\n");
  const Outcome outcome = treedyn({"generate", model, "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, StartsWith(model + ":2:"));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_EQ(treedyn({"generate", scratch("nothing.yaml"), "-o", out()}).status, 1);
  EXPECT_EQ(treedyn({"generate", kModel, "--points", "tip=nowhere", "-o", out()}).status, 1);
}

TEST_F(Cli, LeavesOutForwardDynamicsOfAJointWithoutInertia) {
  const std::string model = one_joint("0");
  const Outcome outcome = treedyn({"generate", model, "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: joint 'j': what it moves has no inertia about its "
                                     "axis; forward dynamics has no solution and is left out"));
  const std::string header = read_file(file("one.hpp"));
  for (const char* const name :
       {"mass_matrix", "bias_force", "gravity_force", "inverse_dynamics"}) {
    EXPECT_THAT(header, HasSubstr(std::string("void ") + name));
  }
  EXPECT_THAT(header, testing::Not(HasSubstr("void forward_dynamics")));
  const Outcome asked =
      treedyn({"generate", model, "--functions", "forward_dynamics", "-o", scratch("asked")});
  EXPECT_EQ(asked.status, 1);
  EXPECT_THAT(asked.err, HasSubstr("joint 'j'"));
  const Outcome without = treedyn({"generate", model, "--functions", "mass_matrix", "-o", out()});
  EXPECT_EQ(without.status, 0);
  EXPECT_THAT(without.err, HasSubstr("warning: joint 'j'"));
  EXPECT_EQ(treedyn({"generate", model, "--functions", "mass_matrix", "-q", "-o", out()}).err, "");
}

TEST_F(Cli, DerivesNothingThatHasNoSolution) {
  write_file(scratch("light.yaml"),
             "name: light\nlinks:\n  - {name: a, father: ground, joint: {name: j, type: revolute, "
             "axis: [0, 0, 1]}, mass: 0}\n");
  for (const std::string function : {"forward_dynamics", "mass_matrix_solve"}) {
    const Outcome outcome = treedyn({"info", scratch("light.yaml"), "--derivation", function});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("function '" + function + "' has no solution"));
  }
  EXPECT_EQ(treedyn({"info", scratch("light.yaml"), "--derivation", "mass_matrix"}).status, 0);
}

TEST_F(Cli, RefusesPointFunctionsWithoutPoints) {
  const Outcome outcome =
      treedyn({"generate", one_joint("1"), "--functions", "point_positions", "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("point_positions"));
}

TEST_F(Cli, ReportsFoldersThatCannotBeWritten) {
  write_file(scratch("file"), "");
  for (const std::string& folder : {scratch("file"), scratch("file") + "/below"}) {
    const Outcome outcome = treedyn({"generate", kModel, "-o", folder});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("cannot"));
  }
  fs::create_directories(file("two_link.json"));  // a folder stands where a file should
  const Outcome outcome = treedyn({"generate", kModel, "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(files(), 1U);
}

/// Paths that cannot be followed are different ones, and it is the writing that fails.
TEST_F(Cli, ReportsFoldersThatLeadNowhere) {
  fs::create_symlink("loop", scratch("loop"));
  for (const std::string& folder : {scratch("loop"), scratch("loop") + "/below"}) {
    const Outcome outcome = treedyn({"generate", kModel, "--effort", "0", "-o", folder});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, StartsWith(scratch("loop") + ": cannot make the output folder: "));
  }
}

/// Runs the program with files limited to some kilobytes: what a full disk looks like to it.
Outcome with_small_disk(const std::string& arguments) {
  return support::run({"sh", "-c", "ulimit -f 2; exec " TREEDYN_EXECUTABLE " " + arguments});
}

/// A search forgets what it has tried: 40 MB are enough, of which the program alone takes half.
TEST_F(Cli, SearchesInLittleMemory) {
  const Outcome outcome = support::run(
      {"sh", "-c",
       "ulimit -v 40000; exec " TREEDYN_EXECUTABLE
       " generate -q -j 1 --functions mass_matrix " TREEDYN_SOURCE_DIR "/models/puma560.yaml -o " +
           out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Cli, LeavesNothingHalfWrittenOnAFullDisk) {
  const Outcome fresh = with_small_disk("generate " + kModel + " -o " + out() + "/deep");
  EXPECT_EQ(fresh.status, 1);
  EXPECT_THAT(fresh.err, HasSubstr("cannot write"));
  EXPECT_FALSE(fs::exists(out()));

  treedyn({"generate", kModel, "-o", out()});
  const std::string before = read_file(file("two_link.hpp"));
  const Outcome again = with_small_disk("generate " + kModel + " --gravity 0,0,1 -o " + out());
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(read_file(file("two_link.hpp")), before);
  EXPECT_EQ(files(), 3U);
}

/// The stamp makes a folder where the dependency file should stand, which is put in place last.
TEST_F(Cli, PutsBackWhatItReplacedWhereAFileCannotBePutInPlace) {
  const std::vector<std::string> generate = {
      "generate", kModel,    "--effort",         "0",         "-o",        out(), "--gravity",
      "0,0,1",    "--stamp", out() + "/d/stamp", "--depfile", out() + "/d"};
  EXPECT_EQ(treedyn(generate).status, 1);
  EXPECT_FALSE(fs::exists(out()));

  treedyn({"generate", kModel, "--effort", "0", "-o", out()});
  const auto texts = [&] {
    return read_file(file("two_link.hpp")) + read_file(file("two_link.cpp")) +
           read_file(file("two_link.json"));
  };
  const std::string before = texts();
  const fs::file_time_type time = fs::last_write_time(file("two_link.cpp"));
  const Outcome outcome = treedyn(generate);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, StartsWith(out() + "/d: cannot write: "));
  EXPECT_EQ(texts(), before);
  EXPECT_EQ(fs::last_write_time(file("two_link.cpp")), time);
  EXPECT_EQ(files(), 3U);
}

TEST_F(Cli, ReportsAFullStandardOutput) {
  const std::string small = " info " + kModel;
  const std::string large = " simulate " TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
  for (const std::string& command : {small, large}) {
    const Outcome outcome =
        support::run({"sh", "-c", TREEDYN_EXECUTABLE + command + " > /dev/full"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("standard output"));
  }
}

/// Two joints with parallel axes; the first body's centre of mass is `distance` away.
std::string far_body(const std::string& distance) {
  return "<robot name='far'><link name='base'/>"
         "<link name='a'><inertial><origin xyz='" +
         distance +
         " 0.02 0.01'/><mass value='1'/><inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' "
         "izz='0.1'/></inertial></link>"
         "<link name='b'><inertial><origin xyz='0.3 0.02 0.01'/><mass value='1'/><inertia "
         "ixx='0.1' "
         "ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link>"
         "<joint name='j' type='continuous'><parent link='base'/><child link='a'/>"
         "<axis xyz='0 0.6 0.8'/></joint>"
         "<joint name='k' type='continuous'><origin xyz='0.5 0.1 0.2' rpy='0.3 0.2 0.1'/>"
         "<parent link='a'/><child link='b'/><axis xyz='0 0.6 0.8'/></joint></robot>";
}

TEST_F(Cli, RefusesNumbersThatLeaveNoDigitOfAResult) {
  for (const std::string distance : {"1e+18", "1e+20"}) {  // B, then the pivots of A
    write_file(scratch("far.urdf"), far_body(distance));
    const Outcome refused =
        treedyn({"generate", scratch("far.urdf"), "--effort", "0", "-o", out()});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err,
                HasSubstr("far.urdf:1:38: link 'a': centre of mass at " + distance + " m: "));
    EXPECT_THAT(refused.err, HasSubstr("of fewer decades"));
  }
  std::string far_joint = far_body("0.1");
  far_joint.replace(far_joint.find("0.5 0.1"), 3, "1e200");
  write_file(scratch("far.urdf"), far_joint);
  EXPECT_THAT(treedyn({"generate", scratch("far.urdf"), "--effort", "0", "-o", out()}).err,
              HasSubstr("joint 'k': origin at 1e+200 m: "));
  write_file(scratch("far.urdf"), far_body("1e10"));
  EXPECT_EQ(treedyn({"generate", scratch("far.urdf"), "--effort", "0", "-o", out()}).status, 0);
}

TEST_F(Cli, RefusesVectorsOfAnglesWhereTheyHaveNoPlace) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--lanes", "4"}, {"--trig", "late"}, {"--language", "c99"}}) {
    std::vector<std::string> line = {"generate", kModel, "--sincos", "vector", "-o", out()};
    line.insert(line.end(), options.begin(), options.end());
    expect_usage_error(treedyn(line), "--sincos vector");
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
}

TEST_F(Cli, RefusesToShareLimbsAmongLanesAndInScenes) {
  expect_usage_error(treedyn({"generate", kModel, "--limb-lanes", "--sincos", "libm", "-o", out()}),
                     "--limb-lanes");
  expect_usage_error(treedyn({"generate", kModel, "--share-limbs", "--lanes", "4", "-o", out()}),
                     "--share-limbs");
  expect_usage_error(
      treedyn({"generate", "--scene", TREEDYN_SOURCE_DIR "/models/scenes/compass_walk.yaml",
               "--share-limbs", "-o", out()}),
      "--share-limbs");
}

TEST_F(Cli, RefusesSinesOfALibraryForVectors) {
  for (const std::vector<std::string>& lanes :
       {std::vector<std::string>{"--lanes", "4"}, std::vector<std::string>{"--limb-lanes"}}) {
    std::vector<std::string> command = {"generate", kModel, "-o", out(), "--sincos", "libm"};
    command.insert(command.end(), lanes.begin(), lanes.end());
    expect_usage_error(treedyn(command), "<cmath> has no sines of vectors");
  }
}

TEST_F(Cli, NamesWhatIsNotExpectedInItsOrder) {
  expect_usage_error(treedyn({"outputs", kModel, "-o", out(), "--stamp", "s", "--depfile", "d"}),
                     "not expected: --stamp s --depfile d");
}

}  // namespace
}  // namespace treedyn
