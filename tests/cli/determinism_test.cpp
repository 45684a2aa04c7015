// The same bytes on every run: 20 fresh processes with randomised addresses, one to seven threads,
// two locales, two working directories.
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;

const std::string kModels = TREEDYN_SOURCE_DIR "/models";

/// Everything in a folder, one file after the other by name.
std::string content(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    files[file.path().filename().string()] = support::read_file(file.path());
  }
  std::string result;
  for (const auto& [name, text] : files) {
    result += name + text;
  }
  return result;
}

/// What generate writes when a shell starts it like this.
std::string generated(const std::string& before, const std::string& model) {
  const support::TemporaryFolder folder;
  const support::Outcome outcome = support::run(
      {"sh", "-c",
       before + " " TREEDYN_EXECUTABLE " generate " + model + " -q -o " + folder.path().string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return content(folder.path());
}

TEST(Determinism, AddressesAreRandomised) {
  std::ifstream setting("/proc/sys/kernel/randomize_va_space");
  int value = 0;
  setting >> value;
  EXPECT_GT(value, 0) << "the next test proves less than it says";
}

TEST(Determinism, TwentyRunsWriteTheSameBytes) {
  const std::string some_search = "/puma560.yaml --effort 50";
  const std::string first = generated("", kModels + some_search);
  EXPECT_GT(first.size(), 10000U);
  for (int run = 1; run < 20; ++run) {
    ASSERT_EQ(generated("", kModels + some_search), first);
  }
}

TEST(Determinism, TwentyRunsWriteTheSameBytesForAScene) {  // with drives that GiNaC reads
  const std::string scene =
      "--scene " + kModels + "/scenes/four_bar.yaml --functions constrained_dynamics --effort 0";
  const std::string first = generated("", scene);
  EXPECT_GT(first.size(), 10000U);
  for (int run = 1; run < 20; ++run) {
    ASSERT_EQ(generated("", scene), first);
  }
}

TEST(Determinism, ThreadsDecideNoByte) {
  const std::string models = kModels;
  for (const std::string& what :
       {models + "/puma560.yaml --effort 50",
        models + "/quadruped.yaml --effort 20 --base axes --runtime base_rx.mass,gravity",
        "--scene " + models + "/scenes/biped_stepping.yaml --effort 0"}) {
    const std::string one = generated("", what + " --jobs 1");
    EXPECT_GT(one.size(), 10000U);
    EXPECT_EQ(generated("", what + " --jobs 2"), one) << what;
    EXPECT_EQ(generated("", what + " -j 7"), one) << what;
  }
}

TEST(Determinism, LocaleAndWorkingDirectoryDoNotMatter) {
  const std::string model = "puma560.yaml --effort 100";
  const std::string first = generated("LC_ALL=C", kModels + "/" + model);
  EXPECT_EQ(generated("LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8", kModels + "/" + model), first);
  EXPECT_EQ(generated("cd " + kModels + " &&", model), first);
  EXPECT_EQ(generated("cd / &&", "." + kModels + "/" + model), first);
}

}  // namespace
}  // namespace treedyn
