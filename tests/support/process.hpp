// Runs a program and keeps what it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace treedyn::support {

/// What a finished program left behind; `status` is 128 + signal for one that was killed.
struct Outcome {
  int status = 0;
  std::string out;
  std::string err;
};

/// Runs `command[0]` (a path, or a name to look up on PATH) without a shell and waits for it.
///
/// Standard input is `input`. Safe to call from several threads.
/// \throws std::system_error if the program cannot be started.
Outcome run(const std::vector<std::string>& command, const std::string& input = {});

/// The same of a program that must succeed. \throws std::runtime_error
Outcome run_checked(const std::vector<std::string>& command);

/// The same of words between spaces.
Outcome run_words(const std::string& line);

/// A new folder for the files of one test; removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The bytes of a file. \throws std::runtime_error if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// \throws std::runtime_error if the file cannot be written.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace treedyn::support
