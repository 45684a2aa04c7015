// Literals, names, JSON, hash, templates, layout: everything below the level of a function.
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "emit/header.hpp"
#include "emit/json.hpp"
#include "emit/layout.hpp"
#include "emit/literal.hpp"
#include "emit/names.hpp"
#include "emit/sha256.hpp"
#include "emit/shell.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {
namespace {

using testing::ElementsAre;

TEST(Literal, IsTheShortestThatReadsBackExactly) {
  EXPECT_EQ(literal(Real("0.1"), Scalar::kDouble), "0.1");
  EXPECT_EQ(literal(Real(2), Scalar::kDouble), "2.0");
  EXPECT_EQ(literal(Real(1) / 3, Scalar::kDouble), "0.3333333333333333");
  EXPECT_EQ(literal(Real(1) / 3, Scalar::kFloat), "0.33333334f");
  EXPECT_EQ(literal(Real("1e-5"), Scalar::kFloat), "1e-05f");
  EXPECT_EQ(literal(Real("1e300"), Scalar::kDouble), "1e+300");
}

TEST(Literal, RoundsOnceToTheScalarType) {
  // Just above the middle between two floats, but the double next to it is the middle itself.
  const Real above_middle = 1 + pow(Real(2), -24) + pow(Real(2), -60);
  EXPECT_EQ(literal(above_middle, Scalar::kFloat), "1.0000001f");
  EXPECT_EQ(std::stod(literal(1 + pow(Real(2), -53), Scalar::kDouble)), 1.0);  // ties to even
  EXPECT_EQ(std::stod(literal(1 + pow(Real(2), -53) + pow(Real(2), -120), Scalar::kDouble)),
            std::nextafter(1.0, 2.0));
}

TEST(Literal, RefusesWhatTheTypeCannotHold) {
  EXPECT_EQ(literal(Real("3e38"), Scalar::kFloat), "3e+38f");
  EXPECT_THROW(literal(Real("1e39"), Scalar::kFloat), std::range_error);
  EXPECT_THROW(literal(Real("1e309"), Scalar::kDouble), std::range_error);
}

TEST(Sha256, MatchesThePublishedVectors) {  // FIPS 180-4 examples, NIST CAVP
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(sha256(std::string(1, '\0')),
            "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d");
}

TEST(JsonString, EscapesWhatJsonDoesNotAllow) {
  EXPECT_EQ(json_string("a\"b\\c\n\t\x01"), "\"a\\\"b\\\\c\\n\\t\\u0001\"");
  EXPECT_EQ(json_string(std::string("a\0b", 3)), "\"a\\u0000b\"");
  EXPECT_EQ(json_string("M\xc3\xbcller \xe2\x82\xac \xf0\x9f\xa4\x96"),
            "\"M\xc3\xbcller \xe2\x82\xac \xf0\x9f\xa4\x96\"");
}

TEST(JsonString, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(json_string("\xff"), "\"\\ufffd\"");
  EXPECT_EQ(json_string("a\xc3"), "\"a\\ufffd\"");
  EXPECT_EQ(json_string("\xc0\xaf"), "\"\\ufffd\\ufffd\"");             // overlong
  EXPECT_EQ(json_string("\xed\xa0\x80"), "\"\\ufffd\\ufffd\\ufffd\"");  // surrogate
}

TEST(Fill, ReplacesEverySlot) {
  EXPECT_EQ(fill("a @x@ b @y@@x@\n", {{"x", "1"}, {"y", "2"}}), "a 1 b 21\n");
}

TEST(Fill, TakesTheLineOfAnEmptySlotAway) { EXPECT_EQ(fill("a\n@x@\nb\n", {{"x", ""}}), "a\nb\n"); }

TEST(FillDeathTest, StopsAtUnknownAndUnusedSlots) {
  EXPECT_DEATH(fill("@x@", {}), "broken invariant");
  EXPECT_DEATH(fill("text", {{"x", "1"}}), "broken invariant");
  EXPECT_DEATH(fill("@x", {{"x", "1"}}), "broken invariant");
}

TEST(Wrapped, BreaksAtSpacesOnly) {
  const std::string word(60, 'w');
  EXPECT_EQ(wrapped("a b", "// "), "// a b\n");
  EXPECT_EQ(wrapped(word + " " + word, "// ", 2), "// " + word + "\n//   " + word + "\n");
}

TEST(ShellComment, QuotesWhatAShellOrACommentWouldMisread) {
  EXPECT_EQ(shell_comment({"treedyn", "a-b_c.yaml"}), "treedyn a-b_c.yaml");
  EXPECT_EQ(shell_comment({"my robot.yaml"}), "'my robot.yaml'");
  EXPECT_EQ(shell_comment({"a\nb*/\\"}), "$'a\\012b\\052/\\134'");
  EXPECT_EQ(shell_comment({"it's"}), "$'it\\047s'");
  EXPECT_EQ(shell_comment({""}), "''");
}

TEST(ShellLine, IsForAnyPosixShellWhereItCanBe) {
  EXPECT_EQ(shell_line({"treedyn", "a-b_c.yaml", ""}), "treedyn a-b_c.yaml ''");
  EXPECT_EQ(shell_line({"my $robot*/\\?? .yaml"}), "'my $robot*/\\?? .yaml'");
  EXPECT_EQ(shell_line({"it's"}), "'it'\\''s'");
  EXPECT_EQ(shell_line({"M\xc3\xbcller"}), "'M\xc3\xbcller'");
  EXPECT_EQ(shell_line({"a\nb*"}), "$'a\\012b\\052'");
  EXPECT_EQ(shell_line({"a\x7f"}), "$'a\\177'");
  EXPECT_EQ(shell_line({"a\xc2\x9b"}), "$'a\\302\\233'");  // a control character beyond ASCII
  EXPECT_EQ(shell_line({"a\xff"}), "$'a\\377'");
}

TEST(Shortened, DropsLinkAndShortensWords) {
  EXPECT_THAT(shortened({"elbow_link", "left_shoulder_pitch_link"}, 16),
              ElementsAre("elbow", "left_shoul_pitch"));
}

TEST(Shortened, KeepsNamesApart) {
  EXPECT_THAT(shortened({"base_link", "base"}, 16), ElementsAre("base_link", "base"));
  EXPECT_THAT(shortened({"a", "a"}, 16), ElementsAre("a", "b1"));
  const std::string long_name(10000, 'a');
  EXPECT_THAT(
      shortened({"left_shoulder_pitch", "left_shoulder_pitcher", long_name, long_name + "b"}, 14),
      ElementsAre("left_shou_pitc", "b1", std::string(14, 'a'), "b3"));
}

TEST(ForComment, LetsNothingEndACommentOrALine) {
  EXPECT_EQ(for_comment("left foot (2)", 40), "left foot (2)");
  EXPECT_EQ(for_comment("a*/b\n\\", 40), "a_/b__");
  EXPECT_EQ(for_comment(" a  b ", 40), "_a_ b_");
  EXPECT_EQ(for_comment("\xe2\x80\xae", 40), "___");
  EXPECT_EQ(for_comment(std::string(50, 'x'), 10), "xxxxxxx...");
}

TEST(ForComment, LeavesWhatIsReadableBesideWhatIsNot) {
  EXPECT_EQ(for_comment("pen*/: force along (0.707107, 0, -0.707107)", 60),
            "pen_/: force along (0.707107, 0, -0.707107)");
}

TEST(CostText, NamesOnlyWhatOccurs) {
  EXPECT_EQ(cost_text({.add = 2, .mul = 3, .cos = 1}), "3 mul, 2 add, 1 cos");
  EXPECT_EQ(cost_text({}), "none");
}

}  // namespace
}  // namespace treedyn::emit
