// The generic layers below the readers: YAML nodes, XML elements, names, numbers.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/identifiers.hpp"
#include "description/numbers.hpp"
#include "description/xml_element.hpp"
#include "description/yaml_node.hpp"

namespace treedyn::description {
namespace {

using testing::SizeIs;

TEST(ParseYamlNode, KeepsOrderKeysAndPlaces) {
  const Node root = parse_yaml_node("b: 1\na:\n  - x\n  - {c: 'd e'}\n", "f");
  ASSERT_THAT(root.items, SizeIs(2));
  EXPECT_EQ(root.items[0].key.text, "b");
  EXPECT_EQ(root.items[1].kind, NodeKind::kSequence);
  const Node& inner = root.items[1].items[1].items[0];
  EXPECT_EQ(inner.key.text, "c");
  EXPECT_EQ(inner.text, "d e");
  EXPECT_EQ(inner.where.line, 4);
  EXPECT_EQ(inner.where.column, 10) << "of the first character inside of the quotes";
}

TEST(ParseYamlNode, TellsNullFromAQuotedWord) {
  const Node root = parse_yaml_node("[~, null, '', \"null\", x]", "f");
  EXPECT_TRUE(root.items[0].empty);
  EXPECT_TRUE(root.items[1].empty);
  EXPECT_FALSE(root.items[2].empty);
  EXPECT_FALSE(root.items[3].empty);
}

TEST(ParseYamlNode, JoinsThePairsThatJsonEscapesACharacterBy) {
  const Node root = parse_yaml_node(R"(["\ud83d\ude00!", "\\ud83d\\ude00", "\u00e9"])", "f");
  EXPECT_EQ(root.items[0].text, "\xF0\x9F\x98\x80!");
  EXPECT_EQ(root.items[1].text, R"(\ud83d\ude00)");
  EXPECT_EQ(root.items[2].text, "\xC3\xA9");
  EXPECT_EQ(parse_yaml_node(R"(- \ud83d\ude00)", "f").items[0].text, R"(\ud83d\ude00)");
  EXPECT_EQ(parse_yaml_node(R"(['\ud83d\ude00'])", "f").items[0].text, R"(\ud83d\ude00)");
}

TEST(ParseYamlNode, FindsARepeatedKeyAmongMany) {
  std::string text;
  for (int k = 0; k < 1000; ++k) {
    text += fmt::format("k{}: 1\n", k);
  }
  EXPECT_THAT(parse_yaml_node(text, "f").items, SizeIs(1000));
  EXPECT_THROW(parse_yaml_node(text + "k500: 2\n", "f"), InputError);
}

bool everything_but_skipped(std::string_view, std::string_view child) { return child != "skipped"; }

TEST(ParseXml, KeepsWhatIsWanted) {
  const Element root = parse_xml("<r a='1'>\n <x b='&lt;2'/><skipped><x/></skipped>\n <y/></r>",
                                 "f", everything_but_skipped);
  EXPECT_EQ(*root.attribute("a"), "1");
  EXPECT_EQ(root.attribute("b"), nullptr);
  ASSERT_THAT(root.children, SizeIs(2));
  EXPECT_EQ(*root.children[0].attribute("b"), "<2");
  EXPECT_EQ(root.children[0].where.line, 2);
  EXPECT_EQ(root.children[0].where.column, 2);
  EXPECT_EQ(root.children[1].name, "y");
}

TEST(ParseXml, CountsTheDepthOfSkippedElementsToo) {
  std::string text = "<r>";
  for (int k = 0; k < 100; ++k) {
    text += "<skipped>";
  }
  EXPECT_THROW(parse_xml(text, "f", everything_but_skipped), InputError);
}

TEST(CheckIdentifiers, NamesBothOfAPair) {
  EXPECT_NO_THROW(check_identifiers({{"a", "a", {}}, {"b", "b", {}}}, "joint"));
  try {
    check_identifiers({{"a.1", "a_1", {}}, {"b", "b", {}}, {"a-1", "a_1", {"f", 3, 4}}}, "joint");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "f:3:4: joints 'a.1' and 'a-1' both become the identifier 'a_1'; expected names "
                 "that differ "
                 "in letters or digits");
  }
}

TEST(NumberReader, BoundsTheRoundingOfADecimal) {
  EXPECT_EQ(NumberReader::rounding({"0.012", {}}, 100), Real(5) / 10000);
  EXPECT_EQ(NumberReader::rounding({"1", {}}, 2), Real(2) / 1000) << "at most 0.1 % of the scale";
  EXPECT_EQ(NumberReader::rounding({"0", {}}, 1), Real(0));
  EXPECT_EQ(NumberReader::rounding({"1/3", {}}, 1), Real(0));
}

}  // namespace
}  // namespace treedyn::description
