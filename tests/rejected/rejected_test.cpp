// Every file beside this one is refused with the line that messages.txt states; further inputs are
// made here.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/read.hpp"

namespace treedyn::description {
namespace {

std::filesystem::path folder() {
  return std::filesystem::path(TREEDYN_SOURCE_DIR) / "tests/rejected";
}

/// file name -> the line that the program prints, with the file's base name.
std::map<std::string, std::string> expected_messages() {
  std::map<std::string, std::string> result;
  std::ifstream stream(folder() / "messages.txt");
  for (std::string line; std::getline(stream, line);) {
    result[line.substr(0, line.find(':'))] = line;
  }
  return result;
}

std::vector<std::filesystem::path> rejected_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() == ".yaml" || entry.path().extension() == ".urdf") {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// The line that is printed for a file; files called base_* are read with `--base axes`.
std::string message_of(const std::filesystem::path& path) {
  ReadOptions options;
  options.base = path.filename().string().rfind("base_", 0) == 0 ? Base::kAxes : Base::kFixed;
  try {
    read_model(path.string(), options);
  } catch (const InputError& error) {
    const std::string text = error.what();
    const std::string parent = path.parent_path().string() + "/";
    return text.rfind(parent, 0) == 0 ? text.substr(parent.size()) : text;
  }
  return "accepted";
}

TEST(RejectedFiles, AreRefusedWithTheStatedMessage) {
  const std::map<std::string, std::string> expected = expected_messages();
  const std::vector<std::filesystem::path> files = rejected_files();
  EXPECT_GE(files.size(), 60U);
  EXPECT_EQ(files.size(), expected.size()) << "a file without a line or a line without a file";
  for (const std::filesystem::path& path : files) {
    const auto line = expected.find(path.filename().string());
    ASSERT_NE(line, expected.end()) << path.filename();
    EXPECT_EQ(message_of(path), line->second);
  }
}

TEST(RejectedFiles, SayWhatWasExpected) {
  for (const auto& [file, line] : expected_messages()) {
    EXPECT_NE(line.find("; expected "), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_NE(line.back(), '.') << line;
  }
}

/// Writes `text` to a file of the test's own and returns the message for it.
std::string message_for(const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(path, std::ios::binary) << text;
  return message_of(path);
}

std::string link_with(const std::string& mass, const std::string& joint = "j") {
  return fmt::format(
      "name: m\nlinks:\n- name: a\n  father: ground\n  joint: {{name: \"{}\", type: revolute, "
      "axis: [0, 0, 1]}}\n  mass: {}\n",
      joint, mass);
}

TEST(RejectedInputs, OfHugeNumbersNameTheirLength) {
  EXPECT_EQ(message_for("digits.yaml", link_with(std::string(100000, '9'))),
            "digits.yaml:6:9: link 'a': mass: number of 100000 characters is too long; expected at "
            "most 1000");
  EXPECT_EQ(message_for("fraction.yaml", link_with(fmt::format("0.{}", std::string(100000, '3')))),
            "fraction.yaml:6:9: link 'a': mass: number of 100002 characters is too long; expected "
            "at most 1000");
  EXPECT_EQ(
      message_for("sum.yaml", link_with(fmt::format("1{}1", std::string(1000, '+')))),
      "sum.yaml:6:9: link 'a': mass: number of 1002 characters is too long; expected at most 1000");
  EXPECT_EQ(
      message_for("nested.yaml",
                  link_with(fmt::format("{}1{}", std::string(60, '('), std::string(60, ')')))),
      "nested.yaml:6:59: link 'a': mass: expression is nested too deeply; expected at most 50 "
      "levels");
}

TEST(RejectedInputs, OfLongNamesNameTheirLength) {
  EXPECT_EQ(message_for("long_name.yaml", link_with("1", std::string(10000, 'x'))),
            "long_name.yaml:5:18: joint name of 10000 bytes is too long; expected at most 255");
}

TEST(RejectedInputs, OfBrokenUtf8AreRefusedByBothReaders) {
  EXPECT_EQ(message_for("utf8.yaml", "name: m\nlinks: \xff\n"),
            "utf8.yaml:2:8: invalid leading UTF-8 octet; expected YAML or JSON");
  EXPECT_EQ(message_for("utf8.urdf", "<robot name=\"\xff\"/>"),
            "utf8.urdf:1:14: not well-formed (invalid token); expected XML");
}

TEST(RejectedInputs, OfBinaryFilesAreRefusedByBothReaders) {
  const std::string binary(
      "\x7f"
      "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0\x3e\0",
      20);
  EXPECT_EQ(message_for("binary.yaml", binary),
            "binary.yaml:1:1: control characters are not allowed; expected YAML or JSON");
  EXPECT_EQ(message_for("binary.urdf", binary),
            "binary.urdf:1:1: not well-formed (invalid token); expected XML");
}

TEST(RejectedInputs, ThatAreNoFilesSayWhy) {
  const std::filesystem::path temporary = testing::TempDir();
  EXPECT_EQ(message_of(temporary / "missing.urdf"),
            "missing.urdf: cannot be read (No such file or directory); expected a file");
  std::filesystem::create_directories(temporary / "folder.yaml");
  EXPECT_EQ(message_of(temporary / "folder.yaml"),
            "folder.yaml: cannot be read (Is a directory); expected a file");
  EXPECT_EQ(message_for("robot.sdf", "<sdf/>"),
            "robot.sdf: unknown kind of file; expected *.urdf, *.yaml, *.yml or *.json");
}

TEST(RejectedInputs, OfMoreThan64MebibytesAreNotRead) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "huge.urdf";
  std::ofstream(path) << "<robot/>";
  std::filesystem::resize_file(path, std::uintmax_t{65} << 20);
  EXPECT_EQ(message_of(path), "huge.urdf: file is too large; expected at most 64 MiB");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace treedyn::description
