#include "common/identifier.hpp"

#include <string>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace treedyn
