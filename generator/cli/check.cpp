#include "cli/check.hpp"

#include <algorithm>
#include <array>
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

/// The line that names the model file in a manifest: equal lines, equal model file.
std::string model_file_of(const std::string& manifest) {
  const std::size_t start = manifest.find("\"model\": {\"file\": ");
  const std::size_t end = manifest.find(", \"sha256\"", start);
  return start == std::string::npos || end == std::string::npos
             ? std::string()
             : manifest.substr(start, end - start);
}

/// The content of what is a file: others, like pipes, could be waited for without end.
std::optional<std::string> content(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? read_file(path.string()) : std::nullopt;
}

/// True if `stem` is a complete set of files of another model.
bool belongs_to_other_model(const fs::path& folder, const std::string& stem,
                            const std::string& our_model) {
  const std::optional<std::string> manifest = content(folder / (stem + ".json"));
  return manifest && has_mark(*manifest) && model_file_of(*manifest) != our_model &&
         ((fs::exists(folder / (stem + ".hpp")) && fs::exists(folder / (stem + ".cpp"))) ||
          (fs::exists(folder / (stem + ".h")) && fs::exists(folder / (stem + ".c"))));
}

/// Generated files in `folder` that are not among `files`, sorted by name.
std::set<std::string> surplus_files(const std::vector<emit::File>& files, const fs::path& folder) {
  std::set<std::string> result;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string ending = entry.path().extension().string();
    const bool ours = std::any_of(files.begin(), files.end(),
                                  [&](const emit::File& file) { return file.name == name; });
    constexpr std::array<std::string_view, 5> kOurs = {".hpp", ".cpp", ".h", ".c", ".json"};
    if (ours || std::find(kOurs.begin(), kOurs.end(), ending) == kOurs.end()) {
      continue;
    }
    const std::optional<std::string> text = content(entry.path());
    if (text && has_mark(*text) &&
        !belongs_to_other_model(folder, entry.path().stem().string(),
                                model_file_of(files.back().text))) {
      result.insert(entry.path().string());
    }
  }
  return result;
}

/// What a reader wants to know before the diff.
std::string verdict(const std::string& old_text, const std::string& new_text,
                    const std::string& path) {
  const bool constants = without_literals(old_text) == without_literals(new_text);
  const int lines = changed_lines(old_text, new_text);
  return fmt::format("{}: {}, {} line{}\n", path, constants ? "constants only" : "structure", lines,
                     lines == 1 ? "" : "s");
}

}  // namespace

std::string check_files(const std::vector<emit::File>& files, const std::string& folder) {
  std::string report;
  std::string diffs;
  for (const emit::File& file : files) {
    const std::string path = (fs::path(folder) / file.name).string();
    const std::optional<std::string> present = content(path);
    if (!present) {
      report += fmt::format("missing: {}\n", path);
    } else if (*present != file.text) {
      report += verdict(*present, file.text, path);
      diffs += unified_diff(*present, file.text, path, path + " (generated)");
    }
  }
  for (const std::string& path : surplus_files(files, folder)) {
    report += fmt::format("surplus: {}\n", path);
  }
  return report + diffs;
}

}  // namespace treedyn
