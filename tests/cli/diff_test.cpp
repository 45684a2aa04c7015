#include "cli/diff.hpp"

#include <random>

#include <gtest/gtest.h>

namespace treedyn {
namespace {

std::string numbered(int from, int to) {
  std::string text;
  for (int k = from; k <= to; ++k) {
    text += std::to_string(k) + "\n";
  }
  return text;
}

TEST(UnifiedDiff, IsEmptyForEqualTexts) {
  EXPECT_EQ(unified_diff("a\nb\n", "a\nb\n", "old", "new"), "");
}

TEST(UnifiedDiff, ShowsThreeLinesAroundAChange) {
  EXPECT_EQ(unified_diff(numbered(1, 9), numbered(1, 4) + "five\n" + numbered(6, 9), "old", "new"),
            "--- old\n+++ new\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST(UnifiedDiff, MakesHunksOfDistantChanges) {
  const std::string changed = "zero\n" + numbered(1, 20) + "21\n";
  EXPECT_EQ(unified_diff(numbered(1, 20), changed, "old", "new"),
            "--- old\n+++ new\n@@ -1,3 +1,4 @@\n+zero\n 1\n 2\n 3\n"
            "@@ -18,3 +19,4 @@\n 18\n 19\n 20\n+21\n");
}

TEST(UnifiedDiff, HandlesEmptyTextsAndMissingLineFeeds) {
  EXPECT_EQ(unified_diff("", "a\n", "old", "new"), "--- old\n+++ new\n@@ -0,0 +1 @@\n+a\n");
  EXPECT_EQ(unified_diff("a", "", "old", "new"),
            "--- old\n+++ new\n@@ -1 +0,0 @@\n-a\n\\ No newline at end of file\n");
}

TEST(WithoutLiterals, KeepsNamesIndicesAndCounts) {
  EXPECT_EQ(without_literals("A[12] = 0.5 * t_2 - 1e-05f * q1.x;  // 3 mul\n"),
            "A[12] = # * t_2 - # * q1.x;  // 3 mul\n");
  EXPECT_EQ(without_literals("kDigest == 0x12abULL, \"" + std::string(64, 'a') + "\""),
            "kDigest == #, \"#\"");
  EXPECT_NE(without_literals("a + 2.0"), without_literals("a - 2.0"));
  EXPECT_EQ(without_literals("x = -0.5;"), without_literals("x = 2.5e-3;"));
}

TEST(ChangedLines, CountsThoseOfTheTextThatHasMore) {
  EXPECT_EQ(changed_lines("a\nb\n", "a\nc\nd\n"), 2);
  EXPECT_EQ(changed_lines("a\nb\nc\n", "a\n"), 2);
  EXPECT_EQ(changed_lines("a\n", "a\n"), 0);
}

/// The lines that a diff adds or removes, and the texts that it tells of, for texts so short that
/// one hunk holds everything.
struct Reading {
  std::string before;
  std::string after;
  int changes = 0;
};

Reading reading(const std::string& diff) {
  Reading result;
  std::size_t at = diff.find("@@\n") + 3;
  while (at < diff.size()) {
    const std::size_t end = diff.find('\n', at) + 1;
    const std::string line = diff.substr(at + 1, end - at - 1);
    result.before += diff[at] != '+' ? line : "";
    result.after += diff[at] != '-' ? line : "";
    result.changes += diff[at] != ' ' ? 1 : 0;
    at = end;
  }
  return result;
}

/// Length of the longest common subsequence, the textbook way.
int common(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> length(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      length[i][j] = a[i - 1] == b[j - 1] ? length[i - 1][j - 1] + 1
                                          : std::max(length[i - 1][j], length[i][j - 1]);
    }
  }
  return length.back().back();
}

TEST(UnifiedDiff, IsTheShortestAndTellsBothTexts) {
  std::mt19937 random(1);
  for (int repetition = 0; repetition < 500; ++repetition) {
    std::string a;
    std::string b;
    for (int k = 0; k < 6; ++k) {  // so short that three lines around any change are everything
      a += random() % 3 == 0 ? "" : std::string(1, static_cast<char>('a' + random() % 3));
      b += random() % 3 == 0 ? "" : std::string(1, static_cast<char>('a' + random() % 3));
    }
    std::string before;
    std::string after;
    for (const char c : a) {
      before += {c, '\n'};
    }
    for (const char c : b) {
      after += {c, '\n'};
    }
    const std::string diff = unified_diff(before, after, "old", "new");
    if (diff.empty() || diff.find("@@\n") != diff.rfind("@@\n") ||
        !diff.starts_with("--- old\n+++ new\n@@ -1")) {
      continue;
    }
    const Reading read = reading(diff);
    EXPECT_EQ(read.changes, static_cast<int>(a.size() + b.size()) - 2 * common(a, b)) << diff;
    EXPECT_TRUE(before.starts_with(read.before) && after.starts_with(read.after)) << diff;
  }
}

TEST(UnifiedDiff, ReplacesEverythingWhereTextsHaveLittleInCommon) {
  const std::string diff = unified_diff(numbered(1, 3000), numbered(10001, 13000), "old", "new");
  EXPECT_TRUE(diff.starts_with("--- old\n+++ new\n@@ -1,3000 +1,3000 @@\n-1\n"));
}

}  // namespace
}  // namespace treedyn
