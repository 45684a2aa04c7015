// Names, places and signals that somebody else chose.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "system/signals.hpp"

namespace treedyn {
namespace {

constexpr const char* kCompile = TREEDYN_CXX " -std=gnu++17 -fsyntax-only ";

Outcome shell(const std::string& command) { return support::run({"sh", "-c", command}); }

class Hostile : public Cli {
 protected:
  /// A model of one link and joint, both called `name`.
  [[nodiscard]] std::string named(const std::string& name) const {
    write_file(
        scratch("named.yaml"),
        fmt::format("name: \"{0}\"\nlinks:\n  - name: \"{0}\"\n    father: ground\n    joint: "
                    "{{name: \"{0}\", type: revolute, axis: [0, 0, 1]}}\n    mass: 1\n"
                    "    com: [1, 0, 0]\npoints: [{{name: \"{0}\", link: \"{0}\"}}]\n",
                    name));
    return scratch("named.yaml");
  }
  /// A scene of the two-link arm with the given lines.
  [[nodiscard]] std::string scene(const std::string& lines, const std::string& name = "s") const {
    write_file(scratch("s.yaml"),
               fmt::format("scene: {}\nmodel: {}\nduration: 0.01\n{}", name, kModel, lines));
    return scratch("s.yaml");
  }
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& what) const {
    const Outcome outcome = treedyn(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(what));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(out()));
  }
};

TEST_F(Hostile, NamesOfTheLanguageAndOfTheLibraryCompile) {
  for (const char* const name : {"typeof", "signbit", "isnan", "restrict", "complex", "FLT_RADIX",
                                 "y0", "index", "acosf64x", "noreturn", "kDof", "w"}) {
    fs::remove_all(out());
    ASSERT_EQ(treedyn({"generate", named(name), "--effort", "0", "-o", out()}).status, 0) << name;
    const Outcome outcome = shell("cd " + out() + " && for f in *.cpp; do " + kCompile +
                                  " -include math.h -include stdlib.h -include string.h $f; done");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

TEST_F(Hostile, NamesOf255BytesAreRefusedBeforeAnythingIsWritten) {
  const std::string name(255, 'x');
  expect_refusal({"generate", named(name), "--effort", "0", "-o", out()},
                 "file name of 259 bytes is too long; expected at most 255");
  expect_refusal({"simulate", scene("", std::string(252, 'x')), "-o", out()}, "too long");
  EXPECT_EQ(
      treedyn({"generate", named(std::string(250, 'x')), "--effort", "0", "-o", out()}).status, 0);
  EXPECT_EQ(files(), 3U);
}

TEST_F(Hostile, ControlCharactersInNamesOfScenesAndPhasesAreRefused) {
  expect_refusal({"simulate", scene("", "\"a\\x1b[31m\"")},
                 "s.yaml:1:9: scene name 'a\\x1b[31m' has a control character");
  expect_refusal({"simulate", scene("phases: [{name: \"a\\nb\", active: []}]\n")},
                 "s.yaml:4:18: phase name 'a\\x0ab' has a control character");
  expect_refusal({"simulate", scene("effects: {locked_joint: [{name: \"\\t\", joint: elbow}]}\n")},
                 "constraint name '\\x09' has a control character");
}

TEST_F(Hostile, ControlCharactersInPathsAreEscapedInMessages) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: \"\\x1b[31m.yaml\"\nduration: 1\n");
  expect_refusal({"simulate", scratch("s.yaml")}, "/\\x1b[31m.yaml: cannot be read");
}

TEST_F(Hostile, PhasesOfOneIdentifierAreRefused) {
  const char* const kPhases =
      "phases:\n  - {{name: {0}, active: [], until: [{{time: 0.1, then: {1}}}]}}\n"
      "  - {{name: {1}, active: [], until: [{{time: 0.1, then: {0}}}]}}\n";
  const std::string path = scene(fmt::format(fmt::runtime(kPhases), "a-b", "a_b"));
  expect_refusal({"generate", "--scene", path, "-o", out()},
                 "s.yaml:6:12: phases 'a-b' and 'a_b' both become the identifier 'a_b'");
  expect_refusal({"simulate", path}, "both become the identifier");
}

TEST_F(Hostile, FormulasInTablesAreText) {
  const Outcome outcome = treedyn({"simulate", scene("phases: [{name: \"=1+1\", active: []}]\n")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\n0,'=1+1,"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr(",=1+1,")));
}

/// make reads the dependency file of paths with what it treats specially, and finds every file.
TEST_F(Hostile, DependencyFilesAreReadByMake) {
  const std::string folder = scratch("a b#c$d:e\\f\\ g");
  fs::create_directories(folder);
  fs::copy_file(kModel, folder + "/m.yaml");
  ASSERT_EQ(treedyn({"generate", folder + "/m.yaml", "--effort", "0", "-o", folder + "/out",
                     "--depfile", scratch("d.d")})
                .status,
            0);
  write_file(scratch("Makefile"), "include d.d\n");
  const Outcome read = shell("cd " + scratch("") + " && make -r");
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_THAT(read.out, HasSubstr("'" + folder + "/out/two_link.hpp'"));
  fs::remove(folder + "/m.yaml");
  EXPECT_EQ(shell("cd " + scratch("") + " && make -r").status, 0) << "needs a file that is gone";
}

TEST_F(Hostile, LineBreaksAreRefusedInDependencyFiles) {
  fs::create_directories(scratch("a\nb"));
  fs::copy_file(kModel, scratch("a\nb/m.yaml"));
  expect_refusal({"generate", scratch("a\nb/m.yaml"), "--effort", "0", "-o", out(), "--depfile",
                  scratch("d.d")},
                 "has a control character, which no dependency file can hold");
}

TEST_F(Hostile, PipesAndDevicesAreNoOutput) {
  fs::create_directories(out());
  ASSERT_EQ(::mkfifo(file("two_link.cpp").c_str(), 0600), 0);
  const Outcome outcome = treedyn({"generate", kModel, "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("is no regular file; expected one, or nothing there"));
  EXPECT_EQ(files(), 1U);
  const Outcome checked = support::run(
      {"timeout", "60", TREEDYN_EXECUTABLE, "check", kModel, "--effort", "0", "-o", out()});
  EXPECT_EQ(checked.status, 1) << "waits for what the pipe says";
  EXPECT_THAT(checked.out, HasSubstr("no file: " + file("two_link.cpp").string()));
  EXPECT_THAT(
      treedyn({"generate", kModel, "--effort", "0", "-o", scratch("o"), "--depfile", "/dev/full"})
          .err,
      HasSubstr("/dev/full: is no regular file"));
  EXPECT_FALSE(fs::exists(scratch("o")));
}

TEST_F(Hostile, FilesThatCannotBeReadAreToldFromThoseThatAreNone) {
  ASSERT_EQ(treedyn({"generate", kModel, "--effort", "0", "-o", out()}).status, 0);
  const auto check = [&] {
    const Outcome outcome = treedyn({"check", kModel, "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 1);
    return outcome.out;
  };
  fs::remove(file("two_link.hpp"));
  EXPECT_THAT(check(), StartsWith("missing: " + file("two_link.hpp").string() + "\n"));
  fs::create_symlink("two_link.hpp", file("two_link.hpp"));
  EXPECT_THAT(check(), StartsWith(file("two_link.hpp").string() +
                                  ": cannot be read: Too many levels of symbolic links\n"));
  fs::remove(file("two_link.hpp"));
  fs::create_directory(file("two_link.hpp"));
  EXPECT_THAT(check(), StartsWith("no file: " + file("two_link.hpp").string() + "\n"));
}

TEST_F(Hostile, SymbolicLinksToFilesStay) {
  fs::create_directories(out());
  fs::create_directories(scratch("real"));
  write_file(scratch("real/x.cpp"), "");
  fs::create_symlink("../real/x.cpp", file("two_link.cpp"));
  fs::create_symlink("nowhere", file("two_link.json"));
  ASSERT_EQ(treedyn({"generate", kModel, "--effort", "0", "-o", out()}).status, 0);
  EXPECT_TRUE(fs::is_symlink(file("two_link.cpp")));
  EXPECT_THAT(read_file(scratch("real/x.cpp")), HasSubstr("void mass_matrix("));
  EXPECT_FALSE(fs::is_symlink(file("two_link.json")));
  EXPECT_EQ(files(), 3U);
  EXPECT_FALSE(fs::exists(file("nowhere")));
  EXPECT_EQ(shell("ls -A " + scratch("real")).out, "x.cpp\n");
}

TEST_F(Hostile, ScenesOfFarPointsAreRightAsFarAsNumbersAre) {
  for (const char* const far : {"1e7", "1e9", "1e12", "1e20"}) {
    const std::string text =
        scene(fmt::format("points: [{{name: far, link: forearm, at: [{}, 0, 0]}}]\n"
                          "effects: {{point_constraint: [{{point: far, along: [x, z]}}]}}\n",
                          far));
    const Outcome outcome = treedyn({"generate", "--scene", text, "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

/// A header of another run beside a source: the compiler refuses them.
TEST_F(Hostile, HeaderAndSourceOfDifferentRunsDoNotCompile) {
  const auto generate = [&](const std::string& gravity, const std::string& folder) {
    return treedyn({"generate", kModel, "--effort", "0", "--gravity", gravity, "-o", folder})
        .status;
  };
  ASSERT_EQ(generate("0,0,-9.81", out()), 0);
  const std::string compile = kCompile + file("two_link.cpp").string();
  EXPECT_EQ(shell(compile).status, 0);
  ASSERT_EQ(generate("0,0,-1.62", scratch("new")), 0);
  fs::copy_file(scratch("new/two_link.hpp"), file("two_link.hpp"),
                fs::copy_options::overwrite_existing);
  const Outcome mixed = shell(compile);
  EXPECT_NE(mixed.status, 0);
  EXPECT_THAT(mixed.err, HasSubstr("header and source are of different runs"));
  EXPECT_EQ(treedyn({"check", kModel, "--effort", "0", "-o", out()}).status, 1);
}

/// Ended at any moment, generate leaves a complete set of files or none, and no temporary ones.
TEST_F(Hostile, SignalsLeaveNothingHalfWritten) {
  for (int k = 0; k < 25; ++k) {
    fs::remove_all(out());
    const pid_t process = ::fork();
    if (process == 0) {
      ::execl(TREEDYN_EXECUTABLE, "treedyn", "generate", kModel.c_str(), "--effort", "0", "-o",
              out().c_str(), nullptr);
      ::_exit(127);
    }
    ::usleep(static_cast<useconds_t>(2000 * k));
    ::kill(process, k % 2 == 0 ? SIGTERM : SIGINT);
    int status = 0;
    ::waitpid(process, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
    EXPECT_TRUE(!fs::exists(out()) || files() == 3) << k;
  }
}

/// Two that write into one folder would mix their sets: the second one waits, but not for ever,
/// since the other one may have started it.
TEST_F(Hostile, WaitsForOthersThatWriteIntoTheFolder) {
  fs::create_directories(out());
  const int folder = ::open(out().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(::flock(folder, LOCK_EX), 0);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(treedyn({"generate", kModel, "--effort", "0", "-o", out()}).status, 0);
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_EQ(files(), 3U);
  ::close(folder);
}

/// A signal that arrives while others wait acts behind what is done meanwhile.
TEST_F(Hostile, SignalsWaitWhileTheyAreHeld) {
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP}) {
    fs::remove(scratch("done"));
    const pid_t process = ::fork();
    if (process == 0) {
      const rlimit none{0, 0};
      ::setrlimit(RLIMIT_CORE, &none);
      std::signal(signal, SIG_DFL);
      {
        const HeldSignals held;
        ::raise(signal);
        write_file(scratch("done"), "");
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_TRUE(fs::exists(scratch("done"))) << signal;
  }
}

/// A compiler that takes long ends with the program, and the temporary folder with both.
TEST_F(Hostile, SignalsEndTheCompilerAndItsFolder) {
  fs::create_directories(scratch("tmp"));
  write_file(scratch("slow"), "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\ntouch " +
                                  scratch("compiling") + "\nexec sleep 60\n");
  fs::permissions(scratch("slow"), fs::perms::owner_all);
  const Outcome outcome = shell("TMPDIR=" + scratch("tmp") + " CXX=" + scratch("slow") +
                                " " TREEDYN_EXECUTABLE " simulate --compiled " + scene("") +
                                " >/dev/null & until [ -e " + scratch("compiling") +
                                " ]; do sleep 0.05; done; kill -TERM $!; wait $!; echo $?");
  EXPECT_THAT(outcome.out, HasSubstr("143"));
  EXPECT_TRUE(fs::is_empty(scratch("tmp")));
}

TEST_F(Hostile, TheCompilerMayHaveOptionsAndTheFolderAnyName) {
  const std::string run = " " TREEDYN_EXECUTABLE " simulate --compiled " + scene("");
  const std::string here = "cd " + scratch("") + " && mkdir -p ./-x && ";
  const Outcome good = shell(here + "TMPDIR=-x CXX='" TREEDYN_CXX " -O1'" + run);
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_TRUE(fs::is_empty(scratch("-x")));
  const Outcome missing = shell("TMPDIR=" + scratch("nowhere") + run);
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, StartsWith("treedyn: TMPDIR: '"));
  EXPECT_THAT(missing.err, HasSubstr("is no folder; expected one"));
}

TEST_F(Hostile, AMasslessLastLinkOfASceneIsRefused) {
  write_file(scratch("m.yaml"),
             "name: m\nlinks:\n"
             "  - {name: a, father: ground, joint: {name: a, type: prismatic, axis: [1, 0, 0]}, "
             "mass: 1}\n"
             "  - {name: b, father: a, joint: {name: b, type: prismatic, axis: [0, 0, 1]}}\n");
  const std::string scene = "scene: s\nmodel: m.yaml\nduration: 0.01\n";
  write_file(scratch("s.yaml"), scene);
  const std::string message = "m.yaml:4:33: joint 'b': what it moves has no inertia along its axis";
  expect_refusal({"simulate", scratch("s.yaml")}, message);
  expect_refusal({"simulate", "--engine", scratch("s.yaml")}, message);
  expect_refusal({"generate", "--scene", scratch("s.yaml"), "-o", out()}, message);
  expect_refusal({"info", "--scene", scratch("s.yaml")}, message);
  write_file(scratch("s.yaml"), scene + "effects: {armature: [{joint: b, inertia: 0.1}]}\n");
  EXPECT_EQ(treedyn({"simulate", scratch("s.yaml")}).status, 0);
}

TEST_F(Hostile, ModelsThatAreTooLargeNameTheLimit) {
  std::string chain = "name: m\nlinks:\n";
  for (int k = 0; k < 1000; ++k) {
    chain += fmt::format(
        "- {{name: l{}, father: {}, joint: {{type: revolute, axis: [0, 0, 1]}}, mass: 1, com: [1, "
        "0, 0]}}\n",
        k, k == 0 ? "ground" : fmt::format("l{}", k - 1));
  }
  write_file(scratch("chain.yaml"), chain);
  const std::string message = "joints in all, which are too many; expected at most 20000";
  expect_refusal({"generate", scratch("chain.yaml"), "-o", out()}, message);
  write_file(scratch("s.yaml"), "scene: s\nmodel: chain.yaml\nduration: 1\n");
  expect_refusal({"simulate", scratch("s.yaml")}, message);
  std::string model = read_file(kModel);
  for (int k = 0; k < 5000; ++k) {
    model += fmt::format("  - {{name: p{0}, link: forearm, at: [0, 0, {0}]}}\n", k);
  }
  write_file(scratch("points.yaml"), model);
  expect_refusal({"generate", scratch("points.yaml"), "-o", out()},
                 "5001 points, which are too many; expected at most 5000");
}

TEST_F(Hostile, MotionsWhoseDerivativesAreTooLargeNameTheLimit) {
  const auto at = [&](const std::string& motion) {
    return scene("effects: {locked_joint: [{joint: elbow, at: \"" + motion + "\"}]}\n");
  };
  EXPECT_EQ(treedyn({"simulate", at("tan(tan(t))/10")}).status, 0);
  expect_refusal({"simulate", at("tan(tan(tan(tan(tan(tan(tan(t)))))))")}, "expected at most");
  std::string sines = "t";
  for (int k = 0; k < 45; ++k) {
    sines = "sin(" + sines + ")";
  }
  expect_refusal({"simulate", at(sines)}, "second derivative of this motion may have 3.");
}

TEST_F(Hostile, TheDigestOfAScenesManifestCoversItsModel) {
  const auto manifest = [&](const std::string& mass) {
    write_file(scratch("m.yaml"),
               "name: m\nlinks: [{name: a, father: ground, joint: {type: prismatic, axis: [0, 0, "
               "1]}, mass: " +
                   mass + "}]\n");
    write_file(scratch("s.yaml"), "scene: s\nmodel: m.yaml\nduration: 1\n");
    EXPECT_EQ(treedyn({"generate", "--scene", scratch("s.yaml"), "-o", out()}).status, 0);
    const std::string text = read_file(file("s.json"));
    const std::size_t start = text.find("\"sha256\": \"") + 11;
    return text.substr(start, 64);
  };
  const std::string one = manifest("1");
  EXPECT_EQ(shell("cat " + scratch("s.yaml") + " " + scratch("m.yaml") + " | sha256sum")
                .out.substr(0, 64),
            one);
  EXPECT_NE(manifest("1.0"), one);
}

}  // namespace
}  // namespace treedyn
