// What the program writes: files, text, what differs.
#include "cli/cli.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <map>

namespace treedyn {
namespace {

TEST_F(Cli, WritesThreeFilesAndSaysNothing) {
  const Outcome outcome = treedyn({"generate", kModel, "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(files(), 3U);
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("//   treedyn generate two_link.yaml\n"));
}

TEST_F(Cli, SaysHowLongEveryFunctionAndAllTook) {
  const Outcome outcome = treedyn({"generate", kModel, "-v", "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              testing::ContainsRegex("mass_matrix: 2 mul, 2 add, 1 cos \\([0-9.]+ s\\)\n"));
  EXPECT_THAT(outcome.err,
              testing::ContainsRegex("\n3 of 3 files written\nin all: [0-9]+\\.[0-9] s\n$"));
}

TEST_F(Cli, ReadsYamlFromStandardInput) {
  const Outcome outcome = treedyn({"generate", "-", "-o", out()}, read_file(kModel));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read_file(file("two_link.json")), HasSubstr("\"model\": {\"file\": \"-\""));
}

TEST_F(Cli, DoesNotTouchFilesThatWouldNotChange) {
  treedyn({"generate", kModel, "-o", out()});
  struct stat before {};
  ::stat(file("two_link.hpp").c_str(), &before);
  treedyn({"generate", kModel, "-o", out()});
  struct stat after {};
  ::stat(file("two_link.hpp").c_str(), &after);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(before.st_mtim.tv_nsec, after.st_mtim.tv_nsec);
}

TEST_F(Cli, KeepsThePermissionsOfFiles) {
  treedyn({"generate", kModel, "-o", out()});
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read;
  fs::permissions(file("two_link.cpp"), own);
  EXPECT_EQ(treedyn({"generate", kModel, "--scalar", "float", "-o", out()}).status, 0);
  EXPECT_THAT(read_file(file("two_link.cpp")), HasSubstr("float"));
  EXPECT_EQ(fs::status(file("two_link.cpp")).permissions(), own);
}

/// Another file could be put in its place. Root may write everything, unless that is taken away.
TEST_F(Cli, ReplacesNoFileThatMayNotBeWritten) {
  treedyn({"generate", kModel, "-o", out()});
  fs::permissions(file("two_link.json"), fs::perms::owner_read);
  const std::string before = read_file(file("two_link.cpp"));
  std::vector<std::string> words = {
      TREEDYN_EXECUTABLE, "generate", kModel, "--scalar", "float", "-o", out()};
  if (::geteuid() == 0) {
    words.insert(words.begin(), {"setpriv", "--bounding-set=-dac_override"});
  }
  const Outcome outcome = support::run(words);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, file("two_link.json").string() + ": cannot write: Permission denied\n");
  EXPECT_EQ(read_file(file("two_link.cpp")), before);
  EXPECT_EQ(files(), 3U);
}

/// mass_matrix of the arm: 2 mul, 2 add and a pair of 78 cycles.
TEST_F(Cli, SaysHowToCompileForAProcessorAndWhatACallCosts) {
  const auto generated = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"generate", kModel, "--scalar", "float", "--self-test", "--effort",
                               "100", "-o", out()});
    const Outcome outcome = treedyn(more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_file(file(fs::exists(file("two_link.h")) ? "two_link.h" : "two_link.hpp"));
  };
  const auto of_processor = [](const std::string& header) {
    EXPECT_THAT(header, HasSubstr("--core m4f"));
    EXPECT_THAT(header, HasSubstr("// For a Cortex-M4F: -mcpu=cortex-m4 -mfloat-abi=hard "
                                  "-mfpu=fpv4-sp-d16 -ffp-contract=off\n"));
    EXPECT_THAT(header, HasSubstr("Cost: 2 mul, 2 add, 1 cos.\n/// About 88 cycles on a "
                                  "Cortex-M4F.\n"));
  };
  EXPECT_THAT(generated({}), Not(HasSubstr("Cortex")));
  EXPECT_THAT(read_file(file("two_link.json")), Not(HasSubstr("processor")));
  of_processor(generated({"--core", "m4f"}));
  EXPECT_THAT(read_file(file("two_link.json")), HasSubstr("\"cycles\": {\"mass_matrix\": 88, "));
  EXPECT_THAT(read_file(file("two_link.cpp")),
              HasSubstr("optimize(\"no-tree-slp-vectorize\", \"no-schedule-insns\")\n"));
  EXPECT_EQ(treedyn({"check", kModel, "--scalar", "float", "--self-test", "--core", "m4f",
                     "--effort", "100", "-o", out()})
                .status,
            0);
  EXPECT_EQ(generated({"--core", "m4"}), generated({"--core", "m4f"}));
  EXPECT_THAT(generated({"--core", "host"}), HasSubstr("About"));
  EXPECT_THAT(generated({"--core", "host", "--limb-lanes"}), Not(HasSubstr("About")));
  EXPECT_EQ(generated({"--core", "generic"}), generated({}));
  EXPECT_THAT(generated({"--core", "m4f", "--trig", "early"}),
              HasSubstr("--core m4f --trig early"));
  EXPECT_THAT(generated({"--trig", "late", "--core", "m4f"}), Not(HasSubstr("--trig")));
  expect_usage_error(treedyn({"generate", kModel, "--core", "z80", "-o", out()}), "m0plus");
  of_processor(generated({"--core", "m4f", "--language", "c99"}));
}

TEST_F(Cli, NamesTheOutputsWithoutWritingThem) {
  const Outcome outcome = treedyn({"outputs", kModel, "--name", "arm", "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, file("arm.hpp").string() + "\n" + file("arm.cpp").string() + "\n" +
                             file("arm.json").string() + "\n");
  EXPECT_FALSE(fs::exists(out()));
}

/// Its gravity_force has sums that vanish without a word in their terms: nothing is a multiple of
/// them.
constexpr const char* kVanishing = R"(name: mixed
links:
  - {name: cart, father: ground, joint: {name: rail, type: prismatic, axis: [0, 1, 1]}, mass: 1,
     com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: arm, father: cart, joint: {name: turn, type: revolute, axis: [0, 1, 1], rotation: {rpy: [0.3, -0.2, pi/3]}},
     mass: 1, com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: slide, father: arm, joint: {name: ext, type: prismatic, axis: [0, 1, 1]}, mass: 1,
     com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: wrist, father: slide, joint: {name: w1, type: revolute, axis: [0, 1, 1]}, mass: 1,
     com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: hand, father: wrist, joint: {name: w2, type: revolute, axis: [0, 1, 1]}, mass: 1,
     com: [0.05, 0.02, -0.1], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: tower, father: ground, joint: {name: t1, type: revolute, axis: [0, 0, 1]}, mass: 1,
     com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: boom, father: tower, joint: {name: t2, type: revolute, axis: [1, 0, 0]}, mass: 1,
     com: [0, 0, 0], inertia: [1, 0, 0, 1, 0, 1]}
  - {name: jib, father: boom, joint: {name: t3, type: revolute, axis: [1, 1, 0]}, mass: 1,
     com: [0.15, 0.05, 0], inertia: [1, 0, 0, 1, 0, 1]}
)";

TEST_F(Cli, ProvesFunctionsInWhichSumsVanish) {
  support::write_file(scratch("mixed.yaml"), kVanishing);
  const Outcome outcome = treedyn({"generate", scratch("mixed.yaml"), "--functions",
                                   "gravity_force", "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Cli, WritesADependencyFile) {
  treedyn({"generate", kModel, "-o", out(), "--depfile", scratch("d.d")});
  EXPECT_EQ(read_file(scratch("d.d")),
            file("two_link.hpp").string() + " " + file("two_link.cpp").string() + " " +
                file("two_link.json").string() + ": " + kModel + "\n" + kModel + ":\n");
  fs::copy_file(kModel, scratch("a=b.yaml"));  // to make an assignment
  treedyn({"generate", scratch("a=b.yaml"), "-o", out(), "--depfile", scratch("d.d")});
  EXPECT_THAT(read_file(scratch("d.d")), testing::EndsWith(".json: " + scratch("a=b.yaml") + "\n"));
}

TEST_F(Cli, DependsOnNoStandardInput) {
  const std::string equations = "equations: [{name: own, value: T(ones) * m_d * ones}]\n";
  const auto rule = [&](const std::vector<std::string>& more, const std::string& input) {
    std::vector<std::string> generate = {"generate",   "--depfile", scratch("d.d"), "--stamp",
                                         scratch("s"), "-o",        out()};
    generate.insert(generate.end(), more.begin(), more.end());
    const Outcome outcome = treedyn(generate, input);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_file(scratch("d.d"));
  };
  const std::string of_model = scratch("s") + ": " + kModel + "\n" + kModel + ":\n";
  EXPECT_EQ(rule({kModel, "--effort", "0", "--equations", "-"}, equations), of_model);
  EXPECT_EQ(rule({kModel, "--settings=-"}, "effort = 0\n"), of_model);
  const std::string scene = "scene: s\nmodel: " + kModel + "\nduration: 1\n";
  EXPECT_EQ(rule({"--effort", "0", "--scene", "-"}, scene), of_model);
  EXPECT_EQ(rule({"--effort", "0", "-"}, read_file(kModel)), scratch("s") + ":\n");
}

TEST_F(Cli, ReadsStandardInputOnce) {
  const std::string model = read_file(kModel);
  write_file(scratch("s.txt"), "equations = -\n");
  for (const std::vector<std::string>& two : {std::vector<std::string>{"-", "--equations", "-"},
                                              {"-", "--equations=-"},
                                              {"--scene", "-", "--settings", "-"},
                                              {kModel, "--equations", "-", "--equations", "-"},
                                              {"-", "--settings", scratch("s.txt")}}) {
    std::vector<std::string> generate = {"generate", "-o", out()};
    generate.insert(generate.end(), two.begin(), two.end());
    expect_usage_error(treedyn(generate, model),
                       "standard input (-) is read 2 times; expected it once");
  }
  EXPECT_FALSE(fs::exists(out()));
}

/// The digest follows the command; no number and no statement is another.
TEST_F(Cli, SaysWhereTheOriginAloneIsAnother) {
  for (const std::string language : {"c++", "c99"}) {
    const std::string ending = language == "c99" ? "h" : "hpp";
    const auto run = [&](const std::string& command, const std::string& functions) {
      return treedyn({command, kModel, "-o", out(), "--effort", "0", "--language", language,
                      "--functions", functions});
    };
    EXPECT_EQ(run("generate", "mass_matrix,bias_force").status, 0);
    const Outcome outcome = run("check", "bias_force,mass_matrix");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out,
                HasSubstr(file("two_link." + ending).string() + ": origin only, 2 lines\n"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("constants only")));
  }
  write_file(scratch("m.yaml"), read_file(kModel));
  treedyn({"generate", scratch("m.yaml"), "-o", out()});
  write_file(scratch("m.yaml"), read_file(kModel) + "# a comment\n");
  EXPECT_THAT(treedyn({"check", scratch("m.yaml"), "-o", out()}).out,
              StartsWith(file("two_link.json").string() + ": origin only, 1 line\n"));
}

TEST_F(Cli, SaysHowToUpdateInWordsOfAnyShell) {
  const std::string folder = scratch("it's $HOME M\xc3\xbcller");
  fs::create_directories(folder);
  fs::copy_file(kModel, folder + "/m.yaml");
  const std::vector<std::string> check = {"check", folder + "/m.yaml", "--effort",
                                          "0",     "--functions",      "gravity_force",
                                          "-o",    folder + "/out"};
  const std::string report = treedyn(check).out;
  const std::string before = "to update: treedyn ";
  ASSERT_THAT(report, HasSubstr(before));
  const std::string command = report.substr(report.find(before) + before.size());
  const Outcome updated = support::run({"sh", "-c", TREEDYN_EXECUTABLE " " + command});
  EXPECT_EQ(updated.status, 0) << command << updated.err;
  EXPECT_EQ(treedyn(check).status, 0);
}

TEST_F(Cli, ChecksThatFilesAreUpToDate) {
  treedyn({"generate", kModel, "-o", out()});
  const Outcome outcome = treedyn({"check", kModel, "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
}

TEST_F(Cli, ShowsWhatDiffersWhatIsMissingAndWhatIsSurplus) {
  treedyn({"generate", kModel, "-o", out()});
  const std::string source = read_file(file("two_link.cpp"));
  write_file(file("old_name.cpp"), source);
  write_file(file("mine.cpp"), "int mine();\n");
  write_file(file("two_link.cpp"), source + "// edited\n");
  fs::remove(file("two_link.hpp"));
  const Outcome outcome = treedyn({"check", kModel, "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("missing: " + file("two_link.hpp").string() + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr("surplus: " + file("old_name.cpp").string() + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr(file("two_link.cpp").string() + ": structure, 1 line\n"));
  EXPECT_THAT(outcome.out, HasSubstr("--- " + file("two_link.cpp").string() + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\n }  // namespace two_link\n-// edited\n"));
  EXPECT_THAT(outcome.out,
              HasSubstr("to update: treedyn generate " + kModel + " -o " + out() + "\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("mine.cpp")));
  EXPECT_EQ(read_file(file("two_link.cpp")), source + "// edited\n");
  treedyn({"generate", kModel, "-o", out()});
  EXPECT_EQ(treedyn({"check", kModel, "-o", out()}).out,
            "surplus: " + file("old_name.cpp").string() + "\nto update: remove what is surplus\n");
}

TEST_F(Cli, SaysThatOnlyEndsOfLinesDiffer) {
  treedyn({"generate", kModel, "-o", out()});
  std::string text = read_file(file("two_link.hpp"));
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\r');
  }
  write_file(file("two_link.hpp"), text);
  const Outcome outcome = treedyn({"check", kModel, "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr(file("two_link.hpp").string() +
                                     ": lines end in \\r\\n and are the same else\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("---")));
}

/// One changed number is one changed constant, whatever lines end in; another version is no change.
TEST_F(Cli, ClassifiesWhatDiffersWithoutEndsOfLinesAndVersions) {
  const auto line_of = [&](const char* name, const char* old_word, const char* new_word,
                           bool returns) {
    treedyn({"generate", kModel, "-o", out()});
    std::string text = read_file(file(name));
    const std::size_t place = text.find(old_word);
    EXPECT_NE(place, std::string::npos) << old_word;
    text.replace(place, std::string_view(old_word).size(), new_word);
    for (std::size_t at = 0; returns && (at = text.find('\n', at)) != std::string::npos; at += 2) {
      text.insert(at, 1, '\r');
    }
    write_file(file(name), text);
    return treedyn({"check", kModel, "-o", out()}).out;
  };
  for (const bool returns : {false, true}) {
    EXPECT_THAT(line_of("two_link.cpp", "= 95.0", "= 96.0", returns),
                HasSubstr("two_link.cpp: constants only, 1 line\n"));
    EXPECT_THAT(line_of("two_link.cpp", "upper_arm_p1 + f", "upper_arm_p1 - f", returns),
                HasSubstr("two_link.cpp: structure, 1 line\n"));
    EXPECT_THAT(line_of("two_link.json", "\"treedyn 0.1.0\"", "\"treedyn 0.0.1\"", returns),
                HasSubstr("two_link.json: origin only, 1 line\n"));
  }
}

/// CLI11 alone reads 010 as 8.
TEST_F(Cli, ReadsNumbersInDecimalDigits) {
  for (const char* text : {"010", "+10"}) {
    treedyn({"generate", kModel, "--effort", text, "-o", out()});
    EXPECT_THAT(read_file(file("two_link.json")), HasSubstr("\"effort\": 10,"));
  }
  for (const char* text : {"0x10", "1e3", "1.0", "", "-1", "99999999999"}) {
    expect_usage_error(treedyn({"generate", kModel, "--effort", text, "-o", out()}),
                       " is no whole number from 0 to 1000000000");
  }
}

TEST_F(Cli, LetsModelsShareAFolder) {
  treedyn({"generate", kModel, "-o", out(), "--effort", "0"});
  treedyn({"generate", TREEDYN_SOURCE_DIR "/models/polar.yaml", "-o", out(), "--effort", "0"});
  EXPECT_EQ(treedyn({"check", kModel, "-o", out(), "--effort", "0"}).status, 0);
}

TEST_F(Cli, LetsVariantsOfAModelShareAFolder) {
  treedyn({"generate", kModel, "-o", out(), "--effort", "0"});
  treedyn(
      {"generate", kModel, "-o", out(), "--name", "quick", "--scalar", "float", "--effort", "0"});
  treedyn({"generate", kModel, "-o", out(), "--name", "points", "--functions", "point_positions",
           "--effort", "0"});
  treedyn({"generate", kModel, "-o", out(), "--name", "massless", "--runtime", "forearm.mass",
           "--effort", "0"});
  EXPECT_EQ(treedyn({"check", kModel, "-o", out(), "--effort", "0"}).status, 0);
  treedyn({"generate", kModel, "-o", out(), "--name", "old_name", "--effort", "0"});
  const Outcome outcome = treedyn({"check", kModel, "-o", out(), "--effort", "0"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("surplus: " + file("old_name.hpp").string() + "\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("quick")));
}

TEST_F(Cli, ComparesTheValuesOfOldAndNewFunctions) {
  treedyn({"generate", kModel, "-o", out()});
  std::string source = read_file(file("two_link.cpp"));
  const std::size_t at = source.find("forearm_p1 = 22.5;");
  ASSERT_NE(at, std::string::npos);
  write_file(file("two_link.cpp"), source.replace(at, 18, "forearm_p1 = 23.0;"));
  const Outcome outcome = treedyn({"check", kModel, "-o", out(), "--numeric"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr(file("two_link.cpp").string() + ": constants only, 1 line\n"));
  EXPECT_THAT(outcome.out, HasSubstr("numeric: mass_matrix: largest distance 0.5,"));
  EXPECT_THAT(outcome.out, HasSubstr("numeric: bias_force: largest distance 0,"));
}

TEST_F(Cli, AnotherNominalValueIsNoOtherStructure) {
  const auto run = [&](const char* command, const char* mass) {
    return treedyn({command, one_joint(std::string(mass) + "\n    runtime: [mass]"), "-o", out(),
                    "--effort", "0"});
  };
  ASSERT_EQ(run("generate", "2.5").status, 0);
  for (const char* const mass : {"3.5", "3", "1e3", "3.4567891"}) {
    const Outcome outcome = run("check", mass);
    for (const char* const part : {"one.hpp", "one.json"}) {
      EXPECT_THAT(outcome.out, HasSubstr(file(part).string() + ": constants only, ")) << mass;
    }
  }
}

/// A figure of rounding that happens to be whole is a constant, too.
TEST_F(Cli, FiguresOfTheManifestAreConstants) {
  const auto run = [&](const char* command) {
    return treedyn({command, kModel, "-o", out(), "--effort", "0"});
  };
  ASSERT_EQ(run("generate").status, 0);
  std::string manifest = read_file(file("two_link.json"));
  const std::size_t figure = manifest.find("\"rounding\": 1.0");
  ASSERT_NE(figure, std::string::npos);
  manifest.replace(figure, 15, "\"rounding\": 0.97");
  write_file(file("two_link.json"), manifest);
  EXPECT_THAT(run("check").out,
              HasSubstr(file("two_link.json").string() + ": constants only, 1 line\n"));
}

TEST_F(Cli, AnotherNameOfTheModelsFileIsNoOtherStructure) {
  std::string model = read_file(kModel);
  const std::size_t at = model.find("mass: ");
  ASSERT_NE(at, std::string::npos);
  model.insert(at + 6, "1.25 * ");
  const std::vector<std::string> options = {"--name", "m", "-o", out(), "--effort", "0"};
  const auto run = [&](const std::string& command, const std::vector<std::string>& rest) {
    std::vector<std::string> words = {command};
    words.insert(words.end(), rest.begin(), rest.end());
    words.insert(words.end(), options.begin(), options.end());
    return treedyn(words);
  };
  ASSERT_EQ(run("generate", {kModel}).status, 0);
  for (const std::string name : {"calibrated.yaml", "with blanks.yaml",
                                 "a_name_so_long_that_the_line_"
                                 "of_the_command_in_the_comment_has_to_be_broken_before_it.yaml"}) {
    SCOPED_TRACE(name);
    write_file(scratch(name), model);
    const Outcome outcome = run("check", {scratch(name)});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr(file("m.hpp").string() + ": origin only, "));
    for (const char* const part : {"m.cpp", "m.json"}) {
      EXPECT_THAT(outcome.out, HasSubstr(file(part).string() + ": constants only, "));
    }
    EXPECT_THAT(run("check", {scratch(name), "--functions", "mass_matrix"}).out,
                HasSubstr(file("m.cpp").string() + ": structure, "));
  }
}

/// Declarations of 100 columns stand on one line, where they are looked for.
TEST_F(Cli, ComparesFunctionsWhoseDeclarationsFillTheirLine) {
  std::string name = "tq";
  std::string line;
  for (; line.size() < 100; name += 'x') {
    write_file(scratch("e.yaml"), "equations: [{name: " + name + ", value: A * qd}]\n");
    const std::vector<std::string> options = {kModel,        "--equations", scratch("e.yaml"),
                                              "--functions", name,          "--effort",
                                              "0",           "-o",          out()};
    std::vector<std::string> command = {"generate"};
    command.insert(command.end(), options.begin(), options.end());
    ASSERT_EQ(treedyn(command).status, 0);
    const std::string header = read_file(file("two_link.hpp"));
    const std::size_t begin = header.find("void " + name);
    line = header.substr(begin, header.find('\n', begin) - begin);
    if (line.size() > 97) {
      write_file(file("two_link.cpp"), read_file(file("two_link.cpp")) + "// changed\n");
      command.front() = "check";
      command.emplace_back("--numeric");
      EXPECT_THAT(treedyn(command).out, HasSubstr(name + ": largest distance 0,")) << line;
    }
  }
  EXPECT_EQ(line.size(), 100U) << line;
}

TEST_F(Cli, NamesTheFunctionsWhoseValuesItDoesNotCompare) {
  const std::vector<std::string> options = {
      "--scene",     TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml",
      "--functions", "constrained_dynamics,mass_matrix",
      "--effort",    "0",
      "-o",          out()};
  std::vector<std::string> command = {"generate"};
  command.insert(command.end(), options.begin(), options.end());
  ASSERT_EQ(treedyn(command).status, 0);
  write_file(file("pendulum.cpp"), read_file(file("pendulum.cpp")) + "// changed\n");
  command.front() = "check";
  command.emplace_back("--numeric");
  const Outcome outcome = treedyn(command);
  EXPECT_THAT(outcome.out, HasSubstr("numeric: mass_matrix: largest distance 0,"));
  EXPECT_THAT(outcome.out,
              HasSubstr("constrained_dynamics: a function of a scene, not compared\n"));
}

TEST_F(Cli, ComparesValuesInNamespacesAndSectionsOfTheUser) {
  const std::vector<std::string> options = {"--namespace", "arm", "--section", "RAM",
                                            "--effort",    "0",   "-o",        out()};
  std::vector<std::string> command = {"generate", kModel, "--functions", "mass_matrix"};
  command.insert(command.end(), options.begin(), options.end());
  treedyn(command);
  std::string source = read_file(file("two_link.cpp"));
  const std::size_t at = source.find("forearm_p1 = 22.5;");
  ASSERT_NE(at, std::string::npos);
  write_file(file("two_link.cpp"), source.replace(at, 18, "forearm_p1 = 23.0;"));
  command.front() = "check";
  command.emplace_back("--numeric");
  EXPECT_THAT(treedyn(command).out, HasSubstr("numeric: mass_matrix: largest distance 0.5,"));
  *std::ranges::find(command, "arm") = "leg";
  EXPECT_THAT(treedyn(command).out,
              HasSubstr("numeric: the old files have another namespace than leg\n"));
  expect_usage_error(treedyn({"check", kModel, "-o", out(), "--numeric", "--layout", "packed"}),
                     "--numeric: compares functions of one state, in C++, with dense matrices");
}

TEST_F(Cli, OverwritesNothingThatItReads) {
  const std::string text =
      R"({"name": "arm", "links": [{"name": "l", "father": "ground", "joint": {"name": "j", "type": )"
      R"("revolute", "axis": [0, 1, 0]}, "mass": 1}]})";
  write_file(scratch("arm.json"), text);
  const std::string here = fs::path(scratch("arm.json")).parent_path().string();
  expect_usage_error(treedyn({"generate", scratch("arm.json"), "-o", here}),
                     "arm.json: would be overwritten by another file; expected another path");
  expect_usage_error(
      treedyn({"generate", scratch("arm.json"), "-o", out(), "--stamp", scratch("arm.json")}),
      "would be overwritten");
  expect_usage_error(
      treedyn({"generate", scratch("arm.json"), "-o", out(), "--depfile", out() + "/arm.cpp"}),
      "would be overwritten");
  EXPECT_EQ(read_file(scratch("arm.json")), text);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Cli, DependsOnItsSettingsAndNamesTheirLines) {
  write_file(scratch("s.txt"), "\xEF\xBB\xBFscalar = float\neffort = 0\n");
  ASSERT_EQ(treedyn({"generate", kModel, "-o", out(), "--settings=" + scratch("s.txt"), "--depfile",
                     scratch("d.d")})
                .status,
            0);
  EXPECT_THAT(read_file(scratch("d.d")), HasSubstr(scratch("s.txt")));
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("using Scalar = float;"));
  write_file(scratch("s.txt"), "effort = 0\nscalar = half\n");
  const Outcome refused =
      treedyn({"generate", kModel, "-o", out(), "--settings", scratch("s.txt")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, StartsWith(scratch("s.txt") + ":2: settings: --scalar: half"));
}

/// A # in quotes begins no comment.
TEST_F(Cli, TakesQuotedSettingsAsTheyStand) {
  std::string model = read_file(kModel);
  model.replace(model.find("name: forearm"), 13, "name: \"arm #2\"");
  model.replace(model.find("link: forearm"), 13, "link: \"arm #2\"");
  write_file(scratch("m.yaml"), model);
  for (const std::string line :
       {"points = \"p=arm #2\"  # of the 2nd", "points = 'p=arm #2'# of the 2nd",
        "points = [ \"p=upper_arm\", 'r=arm #2:1,0,0', ]  # ]", "points=p=upper_arm, tip # r"}) {
    write_file(scratch("s.toml"), "effort = 0  # fast\n# all\n\n" + line + "\r\n");
    const Outcome outcome = treedyn(
        {"generate", "-q", scratch("m.yaml"), "-o", out(), "--settings", scratch("s.toml")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("constexpr int tip = 1;"));
  for (const auto& [line, what] : std::map<std::string, std::string>{
           {"points = \"p=arm #2", "has a value without its second \"; expected one"},
           {"points = ['p', 'arm #2]", "has a value without its second '; expected one"},
           {"points = ['p', 'arm'", "has a list without end; expected a ] in the same line"},
           {"points = ['p'] q", "has more behind its list; expected nothing or a comment"},
           {"points = p=\"arm #2\"", "has a quote within a value; expected the whole value in"},
           {"points = \"p\"q", "has a quote within a value; expected the whole value in quotes"},
           {"points = , p", "has a comma without a value before it; expected one"},
           {"points = p,", "has no value behind its last comma; expected one"}}) {
    write_file(scratch("s.toml"), "effort = 0\n" + line + "\n");
    const Outcome refused =
        treedyn({"generate", kModel, "-o", out(), "--settings", scratch("s.toml")});
    EXPECT_EQ(refused.status, 1) << line;
    EXPECT_THAT(refused.err, StartsWith(scratch("s.toml") + ":2: settings: --points " + what));
  }
}

TEST_F(Cli, FindsFilesThatSettingsNameBesideThem) {
  fs::create_directories(scratch("sub"));
  write_file(scratch("sub/own.yaml"), "equations: [{name: own, value: T(ones) * m_d * ones}]\n");
  write_file(scratch("sub/s.txt"), "effort = 0\nequations = own.yaml\n");
  const Outcome outcome = treedyn(
      {"generate", kModel, "-o", out(), "--settings", scratch("sub/s.txt"), "--functions", "own"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("void own("));
}

TEST_F(Cli, ReadsEveryFileOfEquationsThatSettingsName) {
  fs::create_directories(scratch("sub"));
  const auto equation = [](const std::string& name) {
    return "equations: [{name: " + name + ", value: T(ones) * m_d * ones}]\n";
  };
  write_file(scratch("sub/a.yaml"), equation("one"));
  write_file(scratch("sub/b,c.yaml"), equation("two"));
  for (const std::string value :
       {"[\"a.yaml\", 'b,c.yaml']", "a.yaml, 'b,c.yaml'", "a.yaml \"b,c.yaml\" # both"}) {
    write_file(scratch("sub/s.txt"), "effort = 0\nequations = " + value + "\n");
    const Outcome outcome =
        treedyn({"generate", kModel, "-o", out(), "--settings", scratch("sub/s.txt"), "--depfile",
                 scratch("d.d"), "--functions", "one,two"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("one("));
    EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("two("));
    EXPECT_THAT(read_file(scratch("d.d")),
                HasSubstr(scratch("sub/a.yaml") + " " + scratch("sub/b,c.yaml")));
  }
  write_file(scratch("sub/s.txt"), "equations = ['a.yaml', '']\n");
  const Outcome refused =
      treedyn({"generate", kModel, "-o", out(), "--settings", scratch("sub/s.txt")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, StartsWith(scratch("sub/s.txt") + ":1: settings: --equations has no"));
}

TEST_F(Cli, TakesNoOtherWordForAnEmptyValue) {
  expect_usage_error(treedyn({"generate", kModel, "-o", out(), "--stamp=", "--checked"}),
                     "--stamp= has no value; expected one behind it");
  expect_usage_error(treedyn({"vet", kModel, "--error-format=", "-q"}),
                     "--error-format= has no value");
  EXPECT_FALSE(fs::exists("--checked"));
  EXPECT_EQ(treedyn({"generate", kModel, "--effort", "0", "-o", scratch("some"),
                     "--stamp=" + scratch("a=")})
                .status,
            0);
  EXPECT_FALSE(fs::exists(out()));
  for (const auto& [line, what] : std::map<std::string, std::string>{
           {"scalar = ", "--scalar has no value; expected one"},
           {"step = 0.02", "--step: is of the step of a scene; expected --scene FILE"},
           {"points = ''", "--points has no value; expected one"},
           {"checked = maybe", "Could not convert: --checked = maybe"}}) {
    write_file(scratch("s.txt"), "effort = 0\n" + line + "\n");
    const Outcome refused =
        treedyn({"generate", kModel, "-o", out(), "--settings", scratch("s.txt")});
    EXPECT_EQ(refused.status, 1) << line;
    EXPECT_THAT(refused.err, StartsWith(scratch("s.txt") + ":2: settings: " + what)) << line;
  }
}

TEST_F(Cli, RefusesWhatBlockEquationsHaveNoFormFor) {
  for (const char* option : {"--json", "--passes", "--accuracy", "--base-parameters"}) {
    expect_usage_error(treedyn({"info", kModel, "--equations", option}),
                       "--equations: without a FILE shows the block equations");
  }
}

TEST_F(Cli, VetsEquationsOfTheModel) {
  const std::string model = scratch("own.yaml");
  write_file(model, read_file(kModel) + "equations: [{name: own, value: A + qd}]\n");
  const Outcome outcome = treedyn({"vet", model});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("equation 'own': sum of A"));
  const std::string bare = scratch("bare.yaml");  // points are named elsewhere
  write_file(bare,
             "name: bare\nlinks: [{name: a, father: ground, joint: {name: j, type: revolute, "
             "axis: [0, 0, 1]}, mass: 1, com: [1, 0, 0]}]\n"
             "equations: [{name: own, value: T(C) * qd}]\n");
  EXPECT_EQ(treedyn({"vet", bare}).out, "");
}

/// Points of links have their names; which there are is nothing that vet was asked.
TEST_F(Cli, VetsModelsWhoseLinksHaveOneIdentifier) {
  const std::string body =
      "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" "
      "iyz=\"0\" izz=\"1\"/></inertial></link>";
  write_file(scratch("m.urdf"),
             "<robot name=\"m\"><link name=\"b\"/><link name=\"x.1\">" + body +
                 "<link name=\"x_1\">" + body +
                 "<joint name=\"j\" type=\"continuous\"><parent link=\"b\"/><child "
                 "link=\"x.1\"/></joint><joint name=\"k\" type=\"continuous\"><origin xyz=\"1 0 "
                 "0\"/><parent link=\"x.1\"/><child link=\"x_1\"/></joint></robot>");
  const Outcome outcome = treedyn({"vet", scratch("m.urdf")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  write_file(
      scratch("m.yaml"),
      "name: m\nlinks:\n"
      "  - {name: x.1, father: ground, joint: {name: j, type: revolute, axis: [0, 0, 1]}, "
      "mass: 1, com: [1, 0, 0]}\n"
      "  - {name: x_1, father: x.1, joint: {name: k, type: revolute, axis: [0, 1, 0]}, mass: "
      "1, com: [1, 0, 0]}\nequations: [{name: speed, value: D_P * qd}]\n");
  EXPECT_EQ(treedyn({"vet", scratch("m.yaml")}).out, "");
}

TEST_F(Cli, VetsInThreeFormats) {
  EXPECT_EQ(treedyn({"vet", kModel}).status, 0);
  const std::string model = scratch("bad.yaml");
  write_file(model, "name: bad\nlinks: [{name: a, father: nobody}]\n");
  const Outcome text = treedyn({"vet", model});
  EXPECT_EQ(text.status, 1);
  EXPECT_THAT(text.out, StartsWith(model + ":2:"));
  EXPECT_THAT(treedyn({"vet", model, "--error-format", "gcc"}).out, HasSubstr(": error: "));
  EXPECT_THAT(treedyn({"vet", model, "--error-format", "json"}).out,
              HasSubstr("\"severity\": \"error\""));
}

TEST_F(Cli, PagesComeFromTheHelp) {
  const std::string man = treedyn({"pages", "man"}).out;
  EXPECT_THAT(man, HasSubstr(".SS \\&treedyn accuracy\n"));
  EXPECT_THAT(man, HasSubstr(".B \\&\\-\\-language c++|c99\n"));
  EXPECT_THAT(man, HasSubstr(".B \\&WHAT functions|effects|integrators\n"));
  EXPECT_THAT(man, HasSubstr("lanes 1|2|4|8|16=1\n"));
  const std::string script = treedyn({"pages", "bash"}).out;
  const Outcome complete = support::run(
      {"bash", "-c",
       script + "COMP_WORDS=(treedyn generate --language c); COMP_CWORD=3; _treedyn\n"
                "echo ${COMPREPLY[*]}; COMP_WORDS=(treedyn gen); COMP_CWORD=1; _treedyn\n"
                "echo ${COMPREPLY[*]}"});
  EXPECT_EQ(complete.out, "c++ c99\ngenerate\n") << complete.err;
}

TEST_F(Cli, TellsVersionHelpAndNames) {
  EXPECT_THAT(treedyn({"--version"}).out, StartsWith("treedyn "));
  const Outcome help = treedyn({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("generate"));
  EXPECT_THAT(treedyn({"list", "functions"}).out, HasSubstr("mass_matrix "));
  EXPECT_THAT(treedyn({"list", "functions"}).out, HasSubstr("constrained_dynamics "));
  EXPECT_EQ(treedyn({"list", "integrators"}).status, 0);
}

TEST_F(Cli, TellsAboutAModel) {
  const Outcome text = treedyn({"info", kModel});
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, HasSubstr("two_link: 2 joints"));
  EXPECT_THAT(text.out, HasSubstr("  x.  upper_arm\n  xx  forearm\n"));
  EXPECT_THAT(treedyn({"info", kModel, "--json"}).out, HasSubstr("\"dof\": 2"));
  EXPECT_THAT(text.out, testing::Not(HasSubstr("_checked")));
  EXPECT_THAT(text.out, testing::Not(HasSubstr("dynamics>")));
  EXPECT_THAT(treedyn({"info", kModel, "--checked"}).out,
              HasSubstr("\n  forward_dynamics_checked "));
  EXPECT_THAT(treedyn({"info", kModel, "--equations"}).out, HasSubstr("c_fD = l_D + c^d D"));
  expect_usage_error(treedyn({"info", kModel, "--passes", "--json"}), "--json excludes --passes");
  expect_usage_error(treedyn({"generate", kModel, "--dump", "derive", "--stamp", scratch("s")}),
                     "--stamp excludes --dump");
  expect_usage_error(treedyn({"info", kModel, "--accuracy", "--base-parameters"}),
                     "excludes --base-parameters");
}

TEST_F(Cli, TellsWhatPassesGainForEquationsOfUsers) {
  write_file(scratch("own.yaml"), "equations: [{name: own, value: T(ones) * m_d * J_v * qd}]\n");
  const std::string table = treedyn({"info", kModel, "--equations", scratch("own.yaml"),
                                     "--functions", "own", "--passes", "--effort", "0"})
                                .out;
  EXPECT_THAT(table, testing::ContainsRegex("  pass +own *\n"));
  EXPECT_THAT(table, testing::ContainsRegex("  search +[1-9][0-9]* \\+ [12] *\n"));
}

TEST_F(Cli, TellsOfDampingThatNoFunctionHas) {
  write_file(scratch("damped.urdf"),
             R"(<robot name="damped"><link name="base"/><link name="arm"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="hip" type="continuous"><parent link="base"/><child link="arm"/>
<dynamics damping="0.25"/></joint></robot>)");
  const std::string path = scratch("damped.urdf");
  EXPECT_THAT(treedyn({"info", path, "--effort", "0"}).out,
              testing::ContainsRegex("in no function.*\n.*place.*\n.*:4:1.*hip.*0[.]25"));
  EXPECT_THAT(treedyn({"info", path, "--effort", "0", "--json"}).out,
              HasSubstr(R"("joint": "hip", "damping": "0.25", "friction": "")"));
}

TEST_F(Cli, StatesPointsInTheFrameOfTheirLink) {
  write_file(
      scratch("m.yaml"),
      "name: m\nlinks:\n  - {name: arm, father: ground, mass: 1, joint: {name: j, type: "
      "revolute, axis: [0, 0, 1]}}\n"
      "  - {name: tool, father: arm, joint: {name: f, type: fixed, offset: [1, 0, 0], rotation: "
      "{rpy: [0, 0, pi/2]}}}\n"
      "points:\n  - {name: tcp, link: tool, at: [0.5, 0, 0.25]}\n");
  const Outcome outcome = treedyn({"generate", scratch("m.yaml"), "--name", "m", "--functions",
                                   "point_positions", "--points", "tcp,tool", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read_file(file("m.hpp")),
              testing::ContainsRegex("//   tcp +tool +0 +0\\.5, 0, 0\\.25\n"));
  EXPECT_THAT(read_file(file("m.hpp")), testing::ContainsRegex("//   tool +tool +1 +0, 0, 0\n"));
  EXPECT_THAT(treedyn({"info", scratch("m.yaml"), "--functions", "point_positions", "--json"}).out,
              HasSubstr("\"at\": [0.5, 0, 0.25]"));
}

TEST_F(Cli, TakesNoTemplatesIntoSections) {
  ASSERT_EQ(
      treedyn({"generate", kModel, "--section", "RAM_CODE", "--effort", "0", "-o", out()}).status,
      0);
  EXPECT_THAT(read_file(file("two_link.cpp")), Not(HasSubstr("RAM_CODE template")));
  EXPECT_THAT(read_file(file("two_link.json")), HasSubstr("\"sincos\": \"pair\""));
  expect_usage_error(
      treedyn({"generate", kModel, "--section", "RAM_CODE", "--sincos", "vector", "-o", out()}),
      "no --section");
  for (const char* const name : {"q", "kDof", "joint", "Scalar"}) {
    expect_usage_error(
        treedyn({"generate", kModel, "--section", name, "--effort", "0", "-o", scratch("none")}),
        std::string("--section: ") + name + " is a name in the generated code; expected another");
  }
  EXPECT_FALSE(fs::exists(scratch("none")));
}

/// Khalil and Dombre, Modeling, Identification and Control of Robots (2002): in the plane a link
/// has zz, m c_x and m c_y left, of the first one without gravity zz alone. The biped's number is
/// that of prototype and rank in EQUATIONS.md 8.
TEST_F(Cli, CountsBaseParameters) {
  const std::string models = TREEDYN_SOURCE_DIR "/models/";
  EXPECT_THAT(treedyn({"info", kModel, "--base-parameters", "--gravity", "0,0,0"}).out,
              StartsWith("base parameters: 4 of 20;"));
  EXPECT_THAT(treedyn({"info", kModel, "--base-parameters"}).out,
              StartsWith("base parameters: 6 of 20;"));
  EXPECT_THAT(treedyn({"info", models + "puma560.yaml", "-q", "--base-parameters"}).out,
              StartsWith("base parameters: 36 of 60;"));
  EXPECT_THAT(treedyn({"info", models + "puma560.yaml", "-q", "--base-parameters", "--json"}).out,
              testing::AllOf(StartsWith("{\n  \"columns\": 60,\n  \"to_five_digits\": 36,\n"),
                             HasSubstr("[{\"column\": 42, \"parameter\": \"link5.m_c_y\", "
                                       "\"factor\": 1}, {\"column\": 53, \"parameter\": "
                                       "\"link6.m_c_z\", \"factor\": -1}]")));
  EXPECT_THAT(
      treedyn({"info", models + "biped.yaml", "-q", "--base", "axes", "--base-parameters"}).out,
      StartsWith("base parameters: 104 of 180;"));
}

// An axis that is vertical but for 2.7e-6 rad: gravity moves the first link by that much.
TEST_F(Cli, NamesBaseParametersThatHardlyCount) {
  const std::string text =
      "name: arm\nlinks:\n"
      "  - {name: a, father: ground, mass: 1, com: [0.1, 0, 0], inertia: [1, 0, 0, 1, 0, 1],\n"
      "     joint: {name: j, type: revolute, axis: [0, 0, 1], rotation: {rpy: [ROLL, 0, 0]}}}\n"
      "  - {name: b, father: a, mass: 1, com: [0.1, 0, 0], inertia: [1, 0, 0, 1, 0, 1],\n"
      "     joint: {name: k, type: revolute, axis: [0, 1, 0], offset: [0.3, 0, 0]}}\n";
  const auto base_parameters = [&](const std::string& roll) {
    std::string model = text;
    write_file(scratch("arm.yaml"), model.replace(model.find("ROLL"), 4, roll));
    return treedyn({"info", scratch("arm.yaml"), "-q", "--base-parameters"}).out;
  };
  EXPECT_THAT(base_parameters("pi"), Not(HasSubstr("to five digits")));
  EXPECT_THAT(base_parameters("3.14159"), HasSubstr("\nto five digits: 8;"));
}

TEST_F(Cli, PrintsWhatLeavesAStage) {
  EXPECT_THAT(treedyn({"generate", kModel, "--dump", "model"}).out,
              HasSubstr("link 1 forearm father 0"));
  EXPECT_THAT(treedyn({"generate", kModel, "--dump", "program"}).out,
              HasSubstr("function mass_matrix\n"));
  EXPECT_THAT(treedyn({"generate", kModel, "--dump", "emit"}).out,
              HasSubstr("namespace two_link {"));
}

TEST_F(Cli, RepeatsTheOptionsThatMatterInTheHeader) {
  treedyn({"generate", kModel, "-o", out(), "--scalar", "float", "--base", "fixed", "--effort", "0",
           "--gravity", "0,-9.81,0", "--points", "tip=forearm:1,0,0", "--functions",
           "mass_matrix"});
  EXPECT_THAT(
      read_file(file("two_link.hpp")),
      HasSubstr("//   treedyn generate two_link.yaml --scalar float --functions mass_matrix "
                "--points\n//       tip=forearm:1,0,0 --gravity 0,-9.81,0 --effort 0\n"));
}

/// Axes in no direction of their own have 50 digits: what is left where they cancel is not shown.
TEST_F(Cli, ShowsEquationsWithoutRounding) {
  write_file(scratch("tilted.yaml"),
             "name: tilted\nlinks:\n"
             "  - {name: a, father: ground, joint: {name: j, type: revolute, axis: [0.801, -0.011, "
             "0.515]}, mass: 1, com: [0.1, 0.2, 0.3], inertia: [0.1, 0, 0, 0.2, 0, 0.25]}\n"
             "  - {name: b, father: a, joint: {name: k, type: revolute, axis: [0, 0, 1], offset: "
             "[0.1, 0, 0.2], rotation: {rpy: [pi/2, 0, 0]}}, mass: 2, com: [0, 0.1, 0]}\n");
  const std::string text = treedyn({"info", scratch("tilted.yaml"), "--equations"}).out;
  EXPECT_THAT(text, HasSubstr("  [0,1] = "));
  EXPECT_THAT(text, Not(testing::ContainsRegex("e-[3-9][0-9]")));
}

/// dA/dt of a turning and a sliding root is zero; C has no array without an element.
TEST_F(Cli, SaysWhereNothingOfAPackedMatrixIsLeft) {
  write_file(
      scratch("two.yaml"),
      "name: two\nlinks:\n  - name: a\n    father: ground\n    joint: {name: j, type: "
      "revolute, axis: [0, 0, 1]}\n    mass: 1\n    com: [1, 0, 0]\n  - name: b\n    father: "
      "ground\n    joint: {name: k, type: prismatic, axis: [0, 0, 1]}\n    mass: 1\n");
  EXPECT_EQ(treedyn({"generate", scratch("two.yaml"), "--layout", "packed", "--equations",
                     TREEDYN_SOURCE_DIR "/models/equations/coriolis.yaml", "--functions",
                     "mass_matrix,mass_matrix_rate", "--effort", "0", "-o", out()})
                .status,
            0);
  const std::string header = read_file(file("two.hpp"));
  EXPECT_THAT(header, HasSubstr("constexpr int kMassMatrixNonzeros = 2;\n"));
  EXPECT_THAT(
      header,
      HasSubstr("all entries are zero in every state, one is kept, as arrays have at least one.\n"
                "constexpr int kMassMatrixRateNonzeros = 1;\n"));
  EXPECT_THAT(read_file(file("two.cpp")), HasSubstr("value[0] = 0.0;"));
}

/// What m cx and Ixx of the link behind do to the yaw joint is zero: offset (0, -b, 0), axes z and
/// x. Products of another order hide it, and elsewhere equal values would cost an output's
/// accuracy.
TEST_F(Cli, FindsColumnsOfTheRegressorThatAreZero) {
  write_file(
      scratch("arm.yaml"),
      "name: arm\nlinks:\n"
      "  - {name: a, father: ground, joint: {name: j, type: revolute, axis: [0, 0, 1]}, mass: "
      "5.78, inertia: [0.2768, 0, 0, 0.0847, 0, 0.2505]}\n"
      "  - {name: b, father: a, joint: {name: k, type: revolute, axis: [-1, 0, 0], offset: "
      "[0, -0.046, 0]}, mass: 5.16, com: [0, 0, -0.308], inertia: [0.6333, 0, 0, 0.67, 0, "
      "0.9055]}\n"
      "  - {name: c, father: b, joint: {name: l, type: revolute, axis: [0, 0, 1], offset: "
      "[0, -0.944, 0.645]}, mass: 4.2, com: [0, -0.073, 0], inertia: [0.4972, 0, 0, 0.4972, "
      "0, 0.6867]}\n");
  EXPECT_EQ(treedyn({"generate", scratch("arm.yaml"), "--functions", "inverse_dynamics_regressor",
                     "--effort", "0", "-o", out()})
                .status,
            0);
  const std::string code = read_file(file("arm.cpp"));
  EXPECT_THAT(code, HasSubstr("Y[11] = 0.0;"));
  EXPECT_THAT(code, HasSubstr("Y[14] = 0.0;"));
}

TEST_F(Cli, WritesSinesWhereTheyAreNeeded) {
  ASSERT_EQ(treedyn({"generate", kModel, "-q", "--trig", "late", "-o", out()}).status, 0);
  EXPECT_THAT(read_file(file("two_link.hpp")), HasSubstr("--trig late"));
  EXPECT_THAT(read_file(file("two_link.json")), HasSubstr("\"trig\": \"late\""));
  expect_usage_error(treedyn({"generate", kModel, "--trig", "never", "-o", out()}), "--trig");
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

TEST_F(Cli, WritesTheCodeOfEqualLimbsOnce) {
  const std::vector<std::string> options = {TREEDYN_SOURCE_DIR "/models/quadruped.yaml",
                                            "--share-limbs",
                                            "--effort",
                                            "0",
                                            "--functions",
                                            "inverse_dynamics",
                                            "-q",
                                            "-o",
                                            out()};
  std::vector<std::string> generate = options;
  generate.insert(generate.begin(), "generate");
  ASSERT_EQ(treedyn(generate).status, 0);
  const std::string source = read_file(file("quadruped.cpp"));
  EXPECT_EQ(occurrences(source, "void inverse_dynamics_limb_1("), 1U);
  EXPECT_EQ(occurrences(source, "  inverse_dynamics_limb_1(trunk"), 0U);  // its base is fixed
  EXPECT_EQ(occurrences(source, "  inverse_dynamics_limb_1("), 4U);
  EXPECT_THAT(read_file(file("quadruped.hpp")), HasSubstr("Equal limbs share code."));
  EXPECT_THAT(read_file(file("quadruped.json")), HasSubstr("\"share_limbs\": true"));
  std::vector<std::string> check = options;
  check.insert(check.begin(), "check");
  EXPECT_EQ(treedyn(check).status, 0);
}

TEST_F(Cli, SaysThatARobotHasNoLimbsToShare) {
  const Outcome outcome = treedyn({"generate", kModel, "--share-limbs", "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("no two limbs have the same structure"));
  EXPECT_EQ(read_file(file("two_link.cpp")).find("limb_"), std::string::npos);
}

TEST_F(Cli, SaysThatARunTimePlaceOfAPointWithoutFunctionsChangesNothing) {
  const auto said = [&](const char* points) {
    const Outcome outcome = treedyn({"info", kModel, "--runtime", "tip.at", "--points", points});
    EXPECT_EQ(outcome.status, 0);
    return outcome.err;
  };
  EXPECT_THAT(said("other=forearm:0.1,0,0"), HasSubstr("--points leaves point 'tip' out"));
  EXPECT_THAT(said("tip=forearm:0.1,0,0"), testing::Not(HasSubstr("leaves")));
}

}  // namespace
}  // namespace treedyn
