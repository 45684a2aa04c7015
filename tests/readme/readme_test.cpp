// README.md and the reference of scenes show what is there: their excerpts are text of committed
// files.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

/// The code blocks that stand after a marker <!-- KIND: FILE -->, by file.
std::map<std::string, std::string> excerpts(const std::string& kind) {
  const std::string marker = "<!-- " + kind + ": ";
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
  const auto shown = excerpts("excerpt");
  EXPECT_EQ(shown.size(), 2U);
  for (const auto& [file, text] : shown) {
    const std::string committed = support::read_file(TREEDYN_SOURCE_DIR "/" + file);
    EXPECT_NE(committed.find(text), std::string::npos) << file << " has no longer\n" << text;
  }
}

TEST(Readme, ShowsLinesThatCommandsPrint) {
  const auto shown = excerpts("printed by");
  std::filesystem::current_path(TREEDYN_SOURCE_DIR);
  EXPECT_EQ(shown.size(), 1U);
  for (const auto& [command, text] : shown) {
    const auto printed = support::run_words(TREEDYN_EXECUTABLE " " + command);
    EXPECT_EQ(printed.status, 0) << command;
    std::istringstream lines(text);
    std::size_t at = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line != "  ..") {
        at = printed.out.find(line + "\n", at);
        ASSERT_NE(at, std::string::npos) << command << " has no longer, in this order: " << line;
      }
    }
  }
}

/// Locals of a generated source whose name says what they are, as a part of all.
double named_locals(const std::string& name) {
  const std::string text =
      support::read_file(fmt::format(TREEDYN_SOURCE_DIR "/generated/{0}/{0}.cpp", name));
  const std::regex local(R"(\n  const Scalar&? (\w+) = )");
  const std::sregex_iterator end;
  int all = 0;
  int named = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), local); at != end; ++at) {
    ++all;
    named += at->str(1).starts_with("t_") ? 0 : 1;
  }
  return static_cast<double>(named) / all;
}

TEST(Generated, CallsMostLocalsByNamesOfTheField) {
  for (const char* model : {"puma560", "panda", "quadruped", "biped"}) {
    EXPECT_GT(named_locals(model), 0.5) << model;
  }
}

namespace fs = std::filesystem;

/// Files of the folders of the project that end with one of `ends`.
std::vector<fs::path> project_files(const std::vector<std::string>& ends) {
  const fs::path root = TREEDYN_SOURCE_DIR;
  std::vector<fs::path> result = {root / "README.md"};
  for (const char* folder : {"generator", "templates", "models", "generated", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      for (const std::string& end : ends) {
        if (entry.is_regular_file() && entry.path().string().ends_with(end)) {
          result.push_back(entry.path());
        }
      }
    }
  }
  return result;
}

/// What stands between `](` and `)` in a text and is no address of the network.
std::vector<std::string> links(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
    const std::size_t end = text.find_first_of(")\n #", at + 2);
    const std::string link = text.substr(at + 2, end - at - 2);
    if (!link.empty() && text[end] != '\n' && link.find("://") == std::string::npos) {
      result.push_back(link);
    }
  }
  return result;
}

TEST(Documents, LinkToFilesThatAreThere) {
  int count = 0;
  for (const fs::path& document : project_files({".md"})) {
    for (const std::string& link : links(support::read_file(document))) {
      EXPECT_TRUE(fs::exists(document.parent_path() / link)) << document << ": " << link;
      ++count;
    }
  }
  EXPECT_GT(count, 30);
}

/// Words like EQUATIONS.md.
std::set<std::string> cited(const std::string& text) {
  std::set<std::string> result;
  for (std::size_t at = text.find(".md"); at != std::string::npos; at = text.find(".md", at + 1)) {
    std::size_t begin = at;
    while (begin > 0 &&
           ((text[begin - 1] >= 'A' && text[begin - 1] <= 'Z') || text[begin - 1] == '_')) {
      --begin;
    }
    if (at - begin > 2) {
      result.insert(text.substr(begin, at + 3 - begin));
    }
  }
  return result;
}

TEST(Documents, CitedByNameAreInTheRepository) {
  std::set<std::string> there;
  for (const fs::path& document : project_files({".md"})) {
    there.insert(document.filename());
  }
  for (const fs::path& file :
       project_files({".md", ".cpp", ".hpp", ".in", ".txt", ".cmake", ".yaml"})) {
    for (const std::string& name : cited(support::read_file(file))) {
      EXPECT_TRUE(there.contains(name)) << file << " cites " << name;
    }
  }
}

}  // namespace
}  // namespace treedyn
