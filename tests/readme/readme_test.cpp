// README.md and the reference of scenes show what is there: their excerpts are text of committed
// files.
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

/// The code blocks that stand after a marker <!-- excerpt: FILE -->, by file.
std::map<std::string, std::string> excerpts() {
  const std::string marker = "<!-- excerpt: ";
  std::istringstream readme(support::read_file(TREEDYN_SOURCE_DIR "/README.md") +
                            support::read_file(TREEDYN_SOURCE_DIR "/models/scenes/README.md"));
  std::map<std::string, std::string> result;
  std::string file;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with(marker)) {
      file = line.substr(marker.size(), line.find(" -->") - marker.size());
    } else if (line.starts_with("```") && !file.empty()) {
      inside = !inside;
      file = inside ? file : "";
    } else if (inside) {
      result[file] += line + "\n";
    }
  }
  return result;
}

TEST(Readme, ShowsTextOfTheCommittedOutput) {
  const auto shown = excerpts();
  EXPECT_EQ(shown.size(), 3U);
  for (const auto& [file, text] : shown) {
    const std::string committed = support::read_file(TREEDYN_SOURCE_DIR "/" + file);
    EXPECT_NE(committed.find(text), std::string::npos) << file << " has no longer\n" << text;
  }
}

}  // namespace
}  // namespace treedyn
