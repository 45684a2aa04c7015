// The C++ compiler of the user's machine, and a place for what it makes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace treedyn {

/// A folder that vanishes with the object. \throws InputError
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] std::filesystem::path path() const { return path_; }

 private:
  std::string path_;
};

/// Runs a program found on PATH without a shell; its output goes to a file.
/// \returns true if it exits with 0.
bool succeeds(std::vector<std::string> words, const std::string& output);

/// $CXX, c++, g++ or clang++, the first that runs; empty if there is none.
/// \param scratch  a file that may be written
std::string find_compiler(const std::string& scratch);

}  // namespace treedyn
