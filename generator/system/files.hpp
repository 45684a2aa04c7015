// Reading and writing whole files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace treedyn {

struct OutputFile {
  std::string path;
  std::string text;
  bool always = false;  ///< written anew even if its content would not change
};

/// The bytes of a file; nothing if it cannot be read.
std::optional<std::string> read_file(const std::string& path);

/// That a folder, or where it is missing the one in which it would be made, may be written.
/// \throws InputError naming a path
void check_folder(const std::string& folder);

/// Writes all files or none: temporary files beside the targets first, each flushed to the disk and
/// checked, then renamed; where one cannot be, those before it get back what they were. A file
/// whose content would not change is not touched unless it asks for that; missing folders are made.
/// Signals wait meanwhile, and so do others that write with this function into the folder of the
/// first file, two seconds at most and if the file system has locks. What stands in the place of a
/// file has to be one, no folder, no device, and writable; its permissions stay where its owner and
/// group can be kept, and a symbolic link to a file stays one. \returns the number of files that
/// changed. \throws InputError naming the path; nothing is left behind then.
int write_files(const std::vector<OutputFile>& files);

}  // namespace treedyn
