// The C++ compiler of the user's machine, and a place for what it makes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/signals.hpp"

namespace treedyn {

/// A folder that vanishes with the object, which holds signals as long: nothing is left behind.
/// \throws InputError if TMPDIR is no folder that can be written
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] std::filesystem::path path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + '/' + name; }

 private:
  HeldSignals signals_;
  std::string path_;
};

/// Runs a program found on PATH without a shell; its output goes to a file.
/// \returns true if it exits with 0.
bool succeeds(std::vector<std::string> words, const std::string& output);

/// The words of $CXX ("ccache g++ -O1"), c++, g++ or clang++, the first that runs; none otherwise.
/// \param scratch  a file that may be written
std::vector<std::string> find_compiler(const std::string& scratch);

}  // namespace treedyn
