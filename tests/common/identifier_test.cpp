#include "common/identifier.hpp"

#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

TEST(ToIdentifier, ReplacesBytesOutsideOfLettersDigitsAndUnderscores) {
  EXPECT_EQ(to_identifier("joint_0.0"), "joint_0_0");
  EXPECT_EQ(to_identifier("a b\n*/\"'"), "a_b_____");
  EXPECT_EQ(to_identifier("k\xc3\xbche"), "k__he");
}

TEST(ToIdentifier, PrefixesALeadingDigitOrUnderscore) {
  EXPECT_EQ(to_identifier("7dof"), "n7dof");
  EXPECT_EQ(to_identifier("_Reserved"), "n_Reserved");
  EXPECT_EQ(to_identifier("__x"), "n__x");
  EXPECT_EQ(to_identifier("-a"), "n_a");
  EXPECT_EQ(to_identifier(""), "n");
}

TEST(ToIdentifier, AppendsAnUnderscoreToReservedWords) {
  for (const char* word : {"class", "int", "xor", "co_await", "constinit", "requires", "char8_t",
                           "and_eq", "std", "NULL", "NAN", "linux", "errno", "INT_MAX"}) {
    EXPECT_EQ(to_identifier(word), std::string(word) + "_");
  }
}

TEST(ToIdentifier, KeepsContextualKeywordsAndLongerWords) {
  for (const char* word : {"final", "override", "module", "classes", "Int", "main", "q", "kDof"}) {
    EXPECT_EQ(to_identifier(word), word);
  }
}

TEST(IsReservedWord, KnowsEveryKeywordOfCpp20) {  // [lex.key] table 5 and [lex.digraph]
  for (
      const char* word :
      {"alignas",       "alignof",     "asm",       "auto",      "bool",         "break",
       "case",          "catch",       "char",      "char8_t",   "char16_t",     "char32_t",
       "class",         "concept",     "const",     "consteval", "constexpr",    "constinit",
       "const_cast",    "continue",    "co_await",  "co_return", "co_yield",     "decltype",
       "default",       "delete",      "do",        "double",    "dynamic_cast", "else",
       "enum",          "explicit",    "export",    "extern",    "false",        "float",
       "for",           "friend",      "goto",      "if",        "inline",       "int",
       "long",          "mutable",     "namespace", "new",       "noexcept",     "nullptr",
       "operator",      "private",     "protected", "public",    "register",     "reinterpret_cast",
       "requires",      "return",      "short",     "signed",    "sizeof",       "static",
       "static_assert", "static_cast", "struct",    "switch",    "template",     "this",
       "thread_local",  "throw",       "true",      "try",       "typedef",      "typeid",
       "typename",      "union",       "unsigned",  "using",     "virtual",      "void",
       "volatile",      "wchar_t",     "while",     "and",       "and_eq",       "bitand",
       "bitor",         "compl",       "not",       "not_eq",    "or",           "or_eq",
       "xor",           "xor_eq"}) {
    EXPECT_TRUE(is_reserved_word(word)) << word;
  }
}

TEST(IsReserved, KnowsWhatANamespaceMustNotBeCalled) {
  for (const char* name :
       {"int", "std", "main", "gamma", "j1", "EOF", "NULL", "errno", "assert", "INT_MAX", "M_PI",
        "I", "linux", "time", "double", "signbit", "acosf64", "typeof"}) {
    EXPECT_TRUE(is_reserved(name)) << name;
  }
  EXPECT_FALSE(is_reserved("biped"));
  EXPECT_FALSE(is_reserved_word("j1")) << "a good name for a joint";
}

/// Every word of the headers, as the preprocessor leaves them.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + ' ') {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    if (letter || (!word.empty() && c >= '0' && c <= '9')) {
      word += c;
    } else {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// What the compiler itself knows is in no list of ours: every word of the headers that is not
/// reserved is good for a namespace and for a joint.
TEST(IsReserved, LeavesNoNameOfAHeaderFree) {
  const support::TemporaryFolder folder;
  const std::string path = (folder.path() / "words.cpp").string();
  std::string headers;
  for (const char* const name : {"cassert", "cerrno", "cfloat", "climits", "cmath", "cstddef",
                                 "cstdint", "cstdio", "cstdlib", "cstring", "ctime", "math.h"}) {
    headers += fmt::format("#include <{}>\n", name);
  }
  for (const char* const standard : {"-std=gnu++17", "-std=gnu++20"}) {
    support::write_file(path, headers);
    std::set<std::string> words;
    for (const char* const what : {"-P", "-dM"}) {
      const auto found = support::run({TREEDYN_CXX, standard, "-E", what, path});
      ASSERT_EQ(found.status, 0) << found.err;
      words.merge(words_of(found.out));
    }
    std::string text = headers;
    for (const std::string& word : words) {
      if (!word.empty() && word.front() != '_' && !is_reserved(word)) {
        text += fmt::format("namespace {0} {{ inline constexpr int {0} = 0; }}\n", word);
      }
    }
    EXPECT_GT(text.size(), 10000U);
    support::write_file(path, text);
    const auto compiled = support::run({TREEDYN_CXX, standard, "-fsyntax-only", path});
    EXPECT_EQ(compiled.status, 0) << compiled.err;
  }
}

}  // namespace
}  // namespace treedyn
