// Reading and writing whole files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace treedyn {

struct OutputFile {
  std::string path;
  std::string text;
};

/// The bytes of a file; nothing if it cannot be read.
std::optional<std::string> read_file(const std::string& path);

/// Everything on standard input. \throws InputError beyond 64 MiB.
std::string read_standard_input();

/// Writes all files or none: temporary files beside the targets first, each flushed to the disk and
/// checked, then renamed. A file whose content would not change is not touched; missing folders are
/// made. \returns the number of files that changed.
/// \throws InputError naming the path; nothing is left behind then.
int write_files(const std::vector<OutputFile>& files);

}  // namespace treedyn
