// Every file of tests/rejected_scenes is refused with the line that messages.txt states.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/scene_reader.hpp"

namespace treedyn::description {
namespace {

const std::string kFolder = std::string(TREEDYN_SOURCE_DIR) + "/tests/rejected_scenes/";

/// The message without the folder.
std::string message_of(const std::string& path) {
  try {
    read_scene(path);
  } catch (const InputError& error) {
    const std::string text = error.what();
    return text.rfind(kFolder, 0) == 0 ? text.substr(kFolder.size()) : text;
  }
  return "accepted";
}

std::map<std::string, std::string> expected_messages() {
  std::map<std::string, std::string> result;
  std::ifstream stream(kFolder + "messages.txt");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t space = line.find(' ');
    result[line.substr(0, space)] = line.substr(space + 1);
  }
  return result;
}

TEST(RejectedScenes, AreRefusedWithTheStatedMessage) {
  const std::map<std::string, std::string> expected = expected_messages();
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    ++count;
    const auto line = expected.find(entry.path().stem().string());
    ASSERT_NE(line, expected.end()) << entry.path();
    EXPECT_EQ(message_of(entry.path().string()), line->second);
  }
  EXPECT_EQ(count, expected.size()) << "a file without a line or a line without a file";
  EXPECT_GE(count, 70U);
}

TEST(RejectedScenes, SayWhereAndWhatWasExpected) {
  for (const auto& [name, line] : expected_messages()) {
    EXPECT_NE(line.find("expected "), std::string::npos) << line;
    EXPECT_NE(line.back(), '.') << line;
  }
}

TEST(Scenes, OfTheRepositoryAreAccepted) {
  std::size_t count = 0;
  const std::string folder = TREEDYN_SOURCE_DIR "/models/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.find(".model.") == std::string::npos && entry.path().extension() == ".yaml") {
      EXPECT_EQ(message_of(entry.path().string()), "accepted");
      ++count;
    }
  }
  EXPECT_GE(count, 9U);
}

}  // namespace
}  // namespace treedyn::description
