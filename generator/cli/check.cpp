#include "cli/check.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "cli/diff.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace fs = std::filesystem;

namespace {

/// What every generated file says near its start.
bool has_mark(const std::string& text) {
  const std::string_view start = std::string_view(text).substr(0, 2000);
  return start.find("GENERATED, DO NOT EDIT") != std::string_view::npos ||
         start.find("\"tool\": \"treedyn ") != std::string_view::npos;
}

/// The text of a manifest from `start` up to `end`, empty if it has none.
std::string between(const std::string& manifest, std::string_view start, std::string_view end) {
  const std::size_t first = manifest.find(start);
  const std::size_t last = manifest.find(end, first);
  return first == std::string::npos || last == std::string::npos
             ? std::string()
             : manifest.substr(first, last - first);
}

/// What a manifest says of the model file, of options and of the names of all that is there: equal
/// texts, the same thing under two names.
std::string source_of(const std::string& manifest) {
  std::string source = between(manifest, "\"model\": {\"file\": ", ", \"sha256\"") +
                       between(manifest, "\"options\": {", "\n");
  constexpr std::string_view kName = "{\"name\": ";
  for (std::size_t at = manifest.find(kName); at != std::string::npos;
       at = manifest.find(kName, at + 1)) {
    source += manifest.substr(at, manifest.find('"', at + kName.size() + 1) - at);
  }
  return source;
}

/// The content of what is a file: others, like pipes, could be waited for without end.
std::optional<std::string> content(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? read_file(path.string()) : std::nullopt;
}

/// True if `stem` is a complete set of files of another model, or of the model with other options.
bool is_another(const fs::path& folder, const std::string& stem, const std::string& our_source) {
  const std::optional<std::string> manifest = content(folder / (stem + ".json"));
  const auto is_there = [&](const char* ending) {
    std::error_code ignored;
    return fs::exists(folder / (stem + ending), ignored);
  };
  return manifest && has_mark(*manifest) && source_of(*manifest) != our_source &&
         ((is_there(".hpp") && is_there(".cpp")) || (is_there(".h") && is_there(".c")));
}

/// Generated files in `folder` that are not among `files`, sorted by name.
std::set<std::string> surplus_files(const std::vector<emit::File>& files, const fs::path& folder) {
  std::set<std::string> result;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string ending = entry.path().extension().string();
    const bool ours =
        std::ranges::any_of(files, [&](const emit::File& file) { return file.name == name; });
    constexpr std::array<std::string_view, 5> kOurs = {".hpp", ".cpp", ".h", ".c", ".json"};
    if (ours || std::ranges::find(kOurs, ending) == kOurs.end()) {
      continue;
    }
    const std::optional<std::string> text = content(entry.path());
    if (text && has_mark(*text) &&
        !is_another(folder, entry.path().stem().string(), source_of(files.back().text))) {
      result.insert(entry.path().string());
    }
  }
  return result;
}

std::string without_returns(std::string text) {
  std::erase(text, '\r');
  return text;
}

/// Without the command in a comment, the version, the names and checksums of files in a manifest:
/// no statement depends on what the model's file is called, and options have their own line in the
/// manifest.
std::string without_origin(std::string text) {
  const std::size_t command = text.find("\n//   treedyn generate");
  if (command != std::string::npos) {
    constexpr std::string_view kGoesOn = "\n//     ";
    std::size_t end = text.find('\n', command + 1);
    while (end != std::string::npos && text.compare(end, kGoesOn.size(), kGoesOn) == 0) {
      end = text.find('\n', end + 1);
    }
    text.erase(command, end - command);
  }
  constexpr std::string_view kFile = "{\"file\": ";
  for (std::size_t at = text.find(kFile); at != std::string::npos; at = text.find(kFile, at + 1)) {
    text.erase(at, text.find('}', at) - at);
  }
  const std::size_t tool = text.find("\"tool\": \"treedyn ");
  if (tool != std::string::npos) {
    text.erase(tool, text.find('\n', tool) - tool);
  }
  return text;
}

/// Without what header and source know each other by.
std::string without_digest(std::string text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const std::string_view before :
       {"kDigest = 0x", "kDigest == 0x", "DIGEST 0x", "DIGEST != 0x"}) {
    const std::size_t at = text.find(before);
    if (at != std::string::npos) {
      const std::size_t digits = at + before.size();
      text.erase(digits, text.find_first_not_of(kDigits, digits) - digits);
    }
  }
  return text;
}

/// What a reader wants to know before the diff. \pre the texts differ
std::string verdict(const std::string& old_text, const std::string& new_text,
                    const std::string& path) {
  const std::string before = without_origin(old_text);
  const std::string after = without_origin(new_text);
  const char* const what = without_digest(before) == without_digest(after)       ? "origin only"
                           : without_literals(before) == without_literals(after) ? "constants only"
                                                                                 : "structure";
  const int lines = changed_lines(old_text, new_text);
  return fmt::format("{}: {}, {} line{}\n", path, what, lines, lines == 1 ? "" : "s");
}

/// Why there is nothing to compare at a path.
std::string absence(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    return fmt::format("missing: {}\n", path);
  }
  if (!error && !fs::is_regular_file(status)) {
    return fmt::format("no file: {}\n", path);
  }
  if (!error && ::access(path.c_str(), R_OK) != 0) {
    error.assign(errno, std::generic_category());
  }
  return fmt::format("{}: cannot be read: {}\n", path,
                     error ? error.message() : std::generic_category().message(EIO));
}

}  // namespace

std::string check_files(const std::vector<emit::File>& files, const std::string& folder) {
  std::string report;
  std::string diffs;
  for (const emit::File& file : files) {
    const std::string path = (fs::path(folder) / file.name).string();
    const std::optional<std::string> present = content(path);
    if (!present) {
      report += absence(path);
    } else if (const std::string text = without_returns(*present); text != file.text) {
      report += verdict(text, file.text, path);
      diffs += unified_diff(text, file.text, path, path + " (generated)");
    } else if (*present != text) {
      report += fmt::format("{}: lines end in \\r\\n and are the same else\n", path);
    }
  }
  for (const std::string& path : surplus_files(files, folder)) {
    report += fmt::format("surplus: {}\n", path);
  }
  return report + diffs;
}

}  // namespace treedyn
