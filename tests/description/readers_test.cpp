// What the two formats allow, what they ignore, and how fast they read.
#include <clocale>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transformed.hpp"
#include "description/text_models.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {
namespace {

/// Processor time of this program in seconds: other programs on the machine do not count.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(ReadYaml, AcceptsJson) {
  const model::Tree tree = yaml(R"({"name": "m", "links": [
    {"name": "a", "father": "ground", "mass": 1.5e0, "com": [0, 0, "1/3"],
     "joint": {"name": "j", "type": "revolute", "axis": [0, 0, 1], "rotation": {"rpy": ["pi/2", 0, 0]}}}]})");
  EXPECT_EQ(tree.links[0].inertia.com[2], Real(1) / 3);
  EXPECT_EQ(tree.links[0].joint.rotation[7], Real(1));
}

TEST(ReadYaml, AcceptsTabsAndEscapesInJson) {
  EXPECT_EQ(yaml("{\n\t\"name\":\"a\\/"
                 "b\",\n\t\"links\":[{\"name\":\"a\",\"father\":\"ground\",\"mass\":1,\n\t\t"
                 "\"joint\":{\"type\":\"revolute\",\"axis\":[0,0,1]}}]}")
                .name,
            "a/b");
}

TEST(ReadYaml, EvaluatesParametersInOrder) {
  const model::Tree tree = yaml(
      "name: m\nparameters: {H: 1.8, c: 0.433*H}\nlinks:\n- {name: a, father: ground, mass: 2*H, "
      "com: [0, 0, -c], "
      "joint: {type: revolute, axis: [0, sqrt(2)/2, -sqrt(2)/2]}}\n");
  EXPECT_EQ(tree.links[0].inertia.mass, Real(36) / 10);
  EXPECT_EQ(tree.links[0].inertia.com[2], -Real(7794) / 10000);
  EXPECT_EQ(tree.links[0].joint.axis[2], -sqrt(Real(2)) / 2);
}

TEST(ReadYaml, TakesNamesOfDigitsAndQuotedWords) {
  EXPECT_EQ(yaml("name: 7\nlinks:\n- {name: \"null\", father: ground, mass: 1, joint: {type: "
                 "revolute, axis: [0, 0, 1]}}\n")
                .links[0]
                .name,
            "null");
}

TEST(ReadUrdf, IgnoresWhatItDoesNotKnow) {
  const model::Tree tree =
      urdf(R"(<?xml version="1.0"?><!-- comment --><robot name="m" xmlns:xacro="http://x">
    <gazebo><joint name="j"/></gazebo><transmission name="t"><joint name="j"/></transmission><material name="grey"/>
    <link name="base"><visual><origin xyz="nonsense"/></visual><sensor/></link>
    <link name="a"><inertial><mass value=" 2 "/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <joint name="j" type="revolute"><parent link="base"/><child link="a"/><axis xyz="  0
      1	0 "/><dynamics damping="x"/><safety_controller/><calibration/></joint></robot>)");
  EXPECT_EQ(tree.links[0].inertia.mass, Real(2));
  EXPECT_EQ(tree.links[0].joint.axis, (Vector3{0, 1, 0}));
}

/// No function has them, so that they are no numbers to be right.
TEST(ReadUrdf, KeepsDampingAndFrictionAsWritten) {
  const auto dissipations = [](const char* type, const char* dynamics) {
    const model::Tree tree = urdf(fmt::format(
        R"(<robot name="m"><link name="base"/>
    <link name="a"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <link name="b"/>
    <joint name="j" type="continuous"><parent link="base"/><child link="a"/></joint>
    <joint name="k" type="{}"><parent link="a"/><child link="b"/>
      {}</joint></robot>)",
        type, dynamics));
    return transformed(tree.dissipations, [](const model::Dissipation& of) {
      return fmt::format("{} {}|{}|{}", of.where.line, of.joint, of.damping, of.friction);
    });
  };
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(dissipations("revolute", "<dynamics damping=' 0.50 ' friction='0.0'/>"),
              ElementsAre("6 k|0.50|"));
  EXPECT_THAT(dissipations("prismatic", "<dynamics friction='x'/><dynamics damping='1'/>"),
              ElementsAre("6 k||x"));
  EXPECT_THAT(dissipations("revolute", "<dynamics damping='0' friction='0e5'/>"), IsEmpty());
  EXPECT_THAT(dissipations("revolute", "<dynamics/>"), IsEmpty());
  EXPECT_THAT(dissipations("fixed", "<dynamics damping='1'/>"), IsEmpty());
}

TEST(ReadUrdf, ToleratesCommentsThatAreNoXml) {
  EXPECT_EQ(urdf("<?xml version=\"1.0\"?>\n<!-- ---- Andr\xe9 -- 2014 ---->" +
                 one_joint("<!------ axis ------>"))
                .size(),
            1);
  EXPECT_EQ(urdf_error("<!-- -- -->\n\n" + one_joint("<axis xyz=\"0 0 0\"/>")),
            "m.urdf:6:71: joint 'j': axis [0, 0, 0] has zero length; expected a non-zero vector");
}

TEST(ReadUrdf, AcceptsFixedJointsWithAnAxisOfZeros) {
  EXPECT_EQ(urdf(R"(<robot name="m"><link name="a"/><link name="b"/><link name="c"/>
    <joint name="f" type="fixed"><parent link="a"/><child link="b"/><axis xyz="0 0 0"/></joint>
    <joint name="r" type="revolute"><parent link="b"/><child link="c"/><limit lower="-inf" upper="1.7976931348623157e308"/></joint></robot>)")
                .size(),
            1);
}

TEST(ReadUrdf, WarnsOfReversedLimits) {
  const model::Tree tree = urdf(one_joint("<limit lower=\"1\" upper=\"-1\"/>"));
  ASSERT_EQ(tree.warnings.size(), 1U);
  EXPECT_EQ(tree.warnings[0].message, "joint 'j': lower limit 1 is above the upper limit -1");
}

TEST(ReadUrdf, ReadsOtherEncodings) {
  const std::string text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + one_joint("");
  EXPECT_EQ(urdf(text).size(), 1);
}

TEST(Readers, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);
    EXPECT_EQ(yaml(one_link("type: revolute, axis: [0.5, 0, 0]", "mass: 1.5 + sqrt(0.25)"))
                  .links[0]
                  .inertia.mass,
              Real(2));
    EXPECT_EQ(urdf(one_joint("<origin xyz=\"0.5 1e-1 0\"/>")).links[0].joint.offset[0], Real(0.5));
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ReadModel, ChoosesTheFormatByTheEndOfTheName) {
  const std::filesystem::path folder = testing::TempDir();
  const auto write = [&](const std::string& name, const std::string& text) {
    std::FILE* const file = std::fopen((folder / name).string().c_str(), "wb");
    std::fwrite(text.data(), 1, text.size(), file);
    std::fclose(file);
    return (folder / name).string();
  };
  const std::string tree = one_link("type: revolute, axis: [0, 0, 1]");
  EXPECT_EQ(read_model(write("a.yaml", tree), options()).size(), 1);
  EXPECT_EQ(read_model(write("a.yml", tree), options()).size(), 1);
  EXPECT_EQ(read_model(write("a.json", tree), options()).size(), 1);
  EXPECT_EQ(read_model(write("a.urdf", one_joint("")), options()).size(), 1);
  EXPECT_THROW(read_model(write("a.xml", one_joint("")), options()), InputError);
  EXPECT_THROW(read_model((folder / "missing.yaml").string(), options()), InputError);
  EXPECT_THROW(read_model(folder.string() + "/.yaml", options()), InputError);
}

/// A URDF of more than 10 MB: a tree of links with inertias, meshes and transmissions.
std::string large_urdf() {
  std::string text = "<robot name=\"large\"><link name=\"l0\"/>\n";
  for (int k = 1; text.size() < (std::size_t{10} << 20); ++k) {
    text += fmt::format(
        "<link name=\"l{0}\"><visual><geometry><mesh "
        "filename=\"package://robot/meshes/l{0}.stl\"/></geometry></visual>\n"
        "<inertial><origin xyz=\"0.1 -0.02 {0}e-4\" rpy=\"0.1 0.2 0.3\"/><mass value=\"1.{0}\"/>"
        "<inertia ixx=\"0.11\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.12\" iyz=\"0.003\" "
        "izz=\"0.13\"/></inertial></link>\n"
        "<joint name=\"j{0}\" type=\"revolute\"><parent link=\"l{1}\"/><child link=\"l{0}\"/>"
        "<origin xyz=\"0.1 0.25 -0.3\" rpy=\"0 1.57079632679 0.5\"/><axis xyz=\"0 0 1\"/>"
        "<limit lower=\"-1.5\" upper=\"1.5\" effort=\"10\" velocity=\"3\"/></joint>\n"
        "<transmission name=\"t{0}\"><joint name=\"j{0}\"/><actuator "
        "name=\"m{0}\"/></transmission>\n",
        k, k / 2);
  }
  return text + "</robot>\n";
}

TEST(ReadUrdf, AcceptsTenMegabytes) {
  const std::string text = large_urdf();
  const double start = seconds();
  const model::Tree tree = urdf(text);
  EXPECT_GT(tree.size(), 10000);
  EXPECT_LT(seconds() - start, 60);
}

/// Reads garbage, which must end with an error within seconds.
template <typename Read>
void expect_fast_refusal(const Read& read, const std::string& text, const std::string& what) {
  const double start = seconds();
  EXPECT_THROW(read(text), InputError) << what;
  EXPECT_LT(seconds() - start, 20) << what;
}

std::string repeated(const std::string& part) {
  std::string text;
  while (text.size() < (std::size_t{10} << 20)) {
    text += part;
  }
  return text;
}

TEST(Readers, RefuseTenMegabytesOfGarbageFast) {
  const auto from_yaml = [](const std::string& text) {
    yaml(text);
  };
  const auto from_urdf = [](const std::string& text) {
    urdf(text);
  };
  for (const char* part :
       {"[",     "{",   "- ",  "a: ", "? ",     "\"",         "'",        "x",    "\n",
        "- a\n", "&a ", "*a ", "!t ", "a: b\n", "[],",        "[a, ",     "{a: ", "|\n",
        ">\n ",  "#",   "%",   "\t",  "---\n",  "0123456789", "\xff\xfe", "\x01"}) {
    expect_fast_refusal(from_yaml, repeated(part), part);
    expect_fast_refusal(from_yaml, "name: m\nlinks: " + repeated(part), part);
  }
  for (const char* part : {"<a>", "<a", "<a/>", "<!--", "<![CDATA[", "&amp;", "x", " ", "<?p ?>",
                           "</a>", "\xff", "<link name=\"a\"/>"}) {
    expect_fast_refusal(from_urdf, repeated(part), part);
    expect_fast_refusal(from_urdf, "<robot name=\"m\">" + repeated(part), part);
    expect_fast_refusal(from_urdf, "<robot name=\"m\" a=\"" + repeated(part), part);
  }
}

TEST(ReadUrdf, RefusesEntitiesBeforeTheyGrow) {
  std::string text = "<?xml version=\"1.0\"?><!DOCTYPE lolz [<!ENTITY l0 \"lol\">";
  for (int k = 1; k < 12; ++k) {
    text += fmt::format(
        "<!ENTITY l{0} \"&l{1};&l{1};&l{1};&l{1};&l{1};&l{1};&l{1};&l{1};&l{1};&l{1};\">", k,
        k - 1);
  }
  text += "]><robot name=\"&l11;\"/>";
  EXPECT_EQ(urdf_error(text),
            "m.urdf:1:37: document type declarations are not supported; expected <robot>");
}

TEST(ReadYaml, RefusesAliasesBeforeTheyGrow) {
  EXPECT_EQ(yaml_error("a: &a [x, x]\nb: &b [*a, *a]\n"),
            "m.yaml:1:4: anchors and tags are not supported; expected a plain value");
}

TEST(Readers, StandAnyTruncation) {
  const std::string tree =
      "name: m\nparameters: {H: 2}\nlinks:\n- {name: a, father: ground, mass: sqrt(H), joint: "
      "{name: j, type: revolute, "
      "axis: [0, 0, 1], rotation: {rpy: [pi/2, 0, 0]}}}\npoints:\n- {name: p, link: a, at: [1, 2, "
      "3]}\n";
  const std::string robot = one_joint("<origin xyz=\"1 2 3\"/><axis xyz=\"0 0 1\"/>");
  EXPECT_EQ(yaml_error(tree), "");
  EXPECT_EQ(urdf_error(robot), "");
  for (std::size_t k = 0; k < robot.size(); ++k) {
    EXPECT_NE(urdf_error(robot.substr(0, k)), "") << k;
  }
  for (std::size_t k = 0; k < tree.find("points") - 2; ++k) {
    EXPECT_NE(yaml_error(tree.substr(0, k)), "") << k;
  }
}

std::vector<std::string> findings(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << text;
  std::vector<std::string> result;
  for (const Warning& finding : vet_model(read_model_text(path), path, {}).findings) {
    result.push_back(fmt::format("{}: {}", finding.where.line, finding.message));
  }
  return result;
}

TEST(ReadUrdf, WarnsOfAttributesThatItDoesNotRead) {
  const model::Tree tree =
      urdf(one_joint("<origin quat_xyzw=\"0.7 0 0 0.7\"/><axis xyz=\"0 0 1\"/>"));
  ASSERT_EQ(tree.warnings.size(), 1U);
  EXPECT_THAT(tree.warnings.front().message,
              testing::EndsWith("attribute 'quat_xyzw' of <origin> is unknown and not read"));
}

TEST(Vet, FindsLimitsThatLeaveAJointOnePosition) {
  using testing::ElementsAre;
  const std::string body =
      "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
      "izz=\"1\"/></inertial>";
  const auto joint = [&](const char* type, const char* limits) {
    return findings("still.urdf",
                    one_joint(fmt::format("<axis xyz=\"0 0 1\"/><limit {}/>", limits), body, type));
  };
  const char* const still = "lower=\"0\" upper=\"0.0\" effort=\"0\" velocity=\"0\"";
  const std::string finding =
      "4: joint 'j': lower and upper limit are both 0, which leaves it one position";
  EXPECT_THAT(joint("revolute", still), ElementsAre(finding));
  EXPECT_THAT(joint("prismatic", still), ElementsAre(finding));
  EXPECT_THAT(joint("continuous", still), ElementsAre()) << "has no limits of position";
  EXPECT_THAT(joint("revolute", "lower=\"0\" upper=\"1\" effort=\"0\" velocity=\"0\""),
              ElementsAre());
  EXPECT_THAT(joint("revolute", "effort=\"0\" velocity=\"0\""), ElementsAre());
  EXPECT_THAT(findings("still.yaml", one_link("type: revolute, axis: [0, 0, 1], limits: {lower: "
                                              "pi/2, upper: pi/2}",
                                              "mass: 1\n  inertia: [1, 0, 0, 1, 0, 1]")),
              ElementsAre("5: joint 'j': lower and upper limit are both pi/2, which leaves it one "
                          "position"));
  std::string with_tip = one_joint("<axis xyz=\"0 0 1\"/>", body);
  with_tip.insert(with_tip.find("</robot>"),
                  fmt::format("<link name=\"tip\"/><joint name=\"f\" type=\"fixed\"><parent "
                              "link=\"a\"/><child link=\"tip\"/><limit {}/></joint>",
                              still));
  EXPECT_THAT(findings("still.urdf", with_tip), ElementsAre());
}

std::string inertial(const char* mass, const char* moment, const char* com = "0 0 0") {
  return fmt::format(
      "<inertial><origin xyz=\"{2}\"/><mass value=\"{0}\"/><inertia ixx=\"{1}\" ixy=\"0\" "
      "ixz=\"0\" iyy=\"{1}\" iyz=\"0\" izz=\"{1}\"/></inertial>",
      mass, moment, com);
}

TEST(Vet, FindsLimitsInDegreesAndBelowZero) {
  using testing::ElementsAre;
  const auto joint = [&](const char* type, const char* limits) {
    return findings("limits.urdf",
                    one_joint(fmt::format("<axis xyz=\"0 0 1\"/><limit {}/>", limits),
                              inertial("1", "1"), type));
  };
  EXPECT_THAT(
      joint("revolute", "lower=\"-90\" upper=\"90\" effort=\"1\" velocity=\"1\""),
      ElementsAre("4: joint 'j': lower limit -90 looks like degrees; angles are in radians",
                  "4: joint 'j': upper limit 90 looks like degrees; angles are in radians"));
  EXPECT_THAT(
      joint("revolute", "lower=\"-25\" upper=\"155\""),
      ElementsAre("4: joint 'j': upper limit 155 looks like degrees; angles are in radians"));
  EXPECT_THAT(joint("revolute", "lower=\"-12.5\" upper=\"1e4\""), ElementsAre());
  EXPECT_THAT(joint("revolute", "lower=\"-62.8\" upper=\"62.8\""), ElementsAre()) << "ten turns";
  EXPECT_THAT(joint("revolute", "lower=\"0\" upper=\"50\""), ElementsAre()) << "a winch";
  EXPECT_THAT(joint("prismatic", "lower=\"-90\" upper=\"90\""), ElementsAre());
  EXPECT_THAT(joint("continuous", "lower=\"90\" upper=\"-90\""), ElementsAre());
  EXPECT_THAT(joint("revolute", "lower=\"0\" upper=\"1\" effort=\"-3\" velocity=\"-2\""),
              ElementsAre("4: joint 'j': velocity limit -2 is negative; it bounds a size",
                          "4: joint 'j': effort limit -3 is negative; it bounds a size"));
}

TEST(Vet, FindsInertiasInOtherUnits) {
  using testing::ElementsAre;
  using testing::HasSubstr;
  const auto bodies = [&](const std::string& base, const std::string& inertia,
                          const char* offset = "0.3 0 0.4") {
    std::string robot =
        one_joint(fmt::format("<origin xyz=\"{}\"/><axis xyz=\"0 0 1\"/>", offset), inertia);
    const std::string_view root = "<link name=\"base\"/>";
    const std::size_t place = robot.find(root);
    return findings("units.urdf",
                    robot.replace(place, root.size(), "<link name=\"base\">" + base + "</link>"));
  };
  const std::string own = inertial("5", "0.05");
  EXPECT_THAT(bodies(own, inertial("2", "0.01", "0.1 0 0")), ElementsAre());
  EXPECT_THAT(
      bodies(own, inertial("2", "0.01", "100 0 0")),
      ElementsAre(HasSubstr("link 'a' has a radius of gyration of 0.0866 m and its center "
                            "of mass at 100 m, beside lengths of up to 0.5 m elsewhere; ")));
  EXPECT_THAT(bodies(own, inertial("2", "1e4")), ElementsAre(HasSubstr("86.6 m")));
  EXPECT_THAT(bodies(own, inertial("2", "1e-10", "1 0 0")), ElementsAre()) << "a point, nearly";
  EXPECT_THAT(bodies(inertial("500", "400"), inertial("2", "0.01"), "0.005 0 0"), ElementsAre())
      << "a satellite";
  EXPECT_THAT(bodies("", inertial("1e6", "1e10")), ElementsAre()) << "nothing to compare with";
  EXPECT_THAT(bodies("", inertial("2", "1e4")),
              ElementsAre(HasSubstr("link 'a' has a mass of 2 kg and a radius of gyration of 86.6 "
                                    "m, which is thinner than air; masses are in kg, inertias in "
                                    "kg m^2")));
}

/// Of two equal rods, the second at the end of the first.
std::vector<std::string> of_rods(const char* length, const char* com, const char* moment) {
  const std::string body =
      fmt::format("mass: 2, com: [{0}, 0, 0], inertia: [1e-4*{1}, 0, 0, {1}, 0, {1}]", com, moment);
  return findings("rods.yaml",
                  fmt::format("name: rods\nlinks:\n- {{name: a, father: ground, joint: {{name: i, "
                              "type: revolute, axis: [0, 1, 0], offset: [0, 0, 1000]}}, {0}}}\n"
                              "- {{name: b, father: a, joint: {{name: j, type: revolute, axis: [0, "
                              "1, 0], offset: [{1}, 0, 0]}}, {0}}}\n",
                              body, length));
}

TEST(Vet, FindsOtherUnitsOfAllLinks) {
  using testing::AllOf;
  using testing::ElementsAre;
  using testing::HasSubstr;
  const auto thin = [](const char* link) {
    return AllOf(HasSubstr(link), HasSubstr("289 m, which is thinner than air"));
  };
  const auto far = [](const char* where, const char* what) {
    return AllOf(HasSubstr(where),
                 HasSubstr(fmt::format("{}, beside radii of gyration of up to 0.289 m", what)));
  };
  EXPECT_THAT(of_rods("1", "0.5", "1/6"), ElementsAre()) << "in a world of 1 km";
  EXPECT_THAT(of_rods("1", "0.5", "1e6/6"), ElementsAre(thin("'a'"), thin("'b'"))) << "kg mm^2";
  EXPECT_THAT(of_rods("1000", "500", "1e6/6"), ElementsAre(thin("'a'"), thin("'b'")));
  EXPECT_THAT(of_rods("1000", "0.5", "1/6"), ElementsAre(far("joint 'j'", "offset of 1e+03 m")));
  EXPECT_THAT(of_rods("1000", "0.5", "1e6/6"), ElementsAre(thin("'a'"), thin("'b'"))) << "both";
  EXPECT_THAT(of_rods("1000", "500", "1/6"),
              ElementsAre(far("link 'a'", "mass at 500 m"), far("link 'b'", "mass at 500 m"),
                          far("joint 'j'", "offset of 1e+03 m")));
}

TEST(Vet, FindsBodiesDenserThanMetal) {
  using testing::ElementsAre;
  using testing::HasSubstr;
  const auto body = [](const char* mass, const char* moments) {
    return findings(
        "dense.yaml",
        one_link("type: revolute, axis: [1, 0, 0]",
                 fmt::format("mass: {}\n  com: [0, 0, 0.1]\n  inertia: [{}]", mass, moments)));
  };
  const char* ball = "0.001, 0, 0, 0.001, 0, 0.001";  // of steel, radius 37.7 mm
  EXPECT_THAT(body("1.76", ball), ElementsAre());
  EXPECT_THAT(
      body("1760", ball),
      ElementsAre(HasSubstr("link 'a' has a mass of 1.76e+03 kg and a radius of gyration of "
                            "0.000923 m, which is denser than any metal (2.5e+11 kg/m^3 at "
                            "least); masses are in kg, inertias in kg m^2")));
  EXPECT_THAT(body("1760", "1, 0, 0, 1, 0, 1"), ElementsAre(HasSubstr("7.8e+06 kg/m^3 at least")))
      << "both in grams";
  EXPECT_THAT(body("1760", "1.5, 0, 0, 1, -0.4, 0.9"), ElementsAre(HasSubstr("kg/m^3 at least")))
      << "in other axes";
  EXPECT_THAT(body("3", "1e-9, 0, 0, 1e-9, 0, 1e-9"), ElementsAre()) << "a point";
  EXPECT_THAT(body("3", "0, 0, 0, 0.01, 0, 0.01"), ElementsAre()) << "a rod";
  EXPECT_THAT(body("3", "0.005, 0, 0, 0.005, 0, 0.01"), ElementsAre()) << "a disc";
}

TEST(Vet, LeavesLargeAndLightModelsAlone) {
  using testing::ElementsAre;
  EXPECT_THAT(of_rods("40", "20", "2*40^2/12"), ElementsAre()) << "a tether";
  EXPECT_THAT(of_rods("100", "50", "2*100^2/12"), ElementsAre()) << "a longer one";
  EXPECT_THAT(of_rods("25", "0.5", "1/6"), ElementsAre()) << "a hook on a rope";
  EXPECT_THAT(of_rods("1e-3", "5e-4", "2e-6/12"), ElementsAre()) << "a micro-robot";
  EXPECT_THAT(of_rods("1", "0.5", "1"), ElementsAre()) << "a guess";
  EXPECT_THAT(of_rods("30", "0", "1e-9"), ElementsAre()) << "points";
  EXPECT_THAT(findings("foucault.yaml", one_link("type: revolute, axis: [1, 0, 0]",
                                                 "mass: 28\n  com: [0, 0, -67]\n  inertia: [0.05, "
                                                 "0, 0, 0.05, 0, 0.05]")),
              ElementsAre());
}

TEST(Vet, FindsAnglesOfFewDigits) {
  using testing::ElementsAre;
  const auto joint = [&](const std::string& angle) {
    return findings("angle.urdf",
                    one_joint(fmt::format("<origin rpy=\"0 {} 0\"/><axis xyz=\"0 0 1\"/>", angle),
                              inertial("1", "1")));
  };
  EXPECT_THAT(joint("1.57"),
              ElementsAre("4: joint 'j': rpy[1] 1.57 is 0.000796 away from pi/2; not changed"));
  EXPECT_THAT(joint("-3.140000"),
              ElementsAre("4: joint 'j': rpy[1] -3.140000 is 0.00159 away from -pi; not changed"));
  for (const char* angle : {"1.571", "1.570", "3.14", "-3.142", "3.141", "4.71", "6.28", "0.785",
                            "2.356", "0.524", "0.523", "-1.047"}) {
    EXPECT_THAT(joint(angle), testing::SizeIs(1)) << angle;
  }
  for (const char* angle :
       {"0",   "0.001", "0.002", "1.5",  "1.56", "1.58", "1.572", "1.569", "1.5720", "3",
        "3.1", "3.13",  "3.15",  "0.79", "0.78", "0.26", "0.5",   "1.05",  "1.5e0",  "1.56900"}) {
    EXPECT_THAT(joint(angle), ElementsAre()) << angle;
  }
}

/// A joint within a link is what the two roots come from.
TEST(Vet, FindsSlipsOfModelsThatCannotBeRead) {
  const std::string path = testing::TempDir() + "slip.urdf";
  std::ofstream(path) << "<robot name=\"r\"><link name=\"b\"/>\n<link name=\"x\"><joint "
                         "name=\"j\" type=\"revolute\"/></link></robot>\n";
  const Vetted vetted = vet_model(read_model_text(path), path, {});
  ASSERT_EQ(vetted.findings.size(), 1U);
  EXPECT_EQ(vetted.findings[0].message,
            "link 'x': <joint> is not read here; its place is in <robot>");
  ASSERT_TRUE(vetted.error.has_value());
  EXPECT_THAT(vetted.error->message(), testing::HasSubstr("both no child of a joint"));
}

TEST(Vet, FindsWhatIsNotReadAndLooksLikeASlip) {
  const std::string robot =
      "<robot name=\"r\" xmlns:x=\"u\"><link name=\"b\"/>\n<link name=\"a\"><inertial><mass "
      "value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
      "izz=\"1\"/></inertial><visual/><extra/></link><gazebo/>\n"
      "<joint name=\"j\" type=\"revolute\"><parent link=\"b\"/><child link=\"a\"/><axis xyz=\"0 0 "
      "1\"/>{}</joint></robot>\n";
  const auto joint = [&](const char* more) {
    std::string text = robot;
    return findings("typo.urdf", text.replace(text.find("{}"), 2, more));
  };
  using testing::ElementsAre;
  EXPECT_THAT(joint("<origin rpy=\"0 0 6.2831853\"/><dynamics damping=\"1\"/>"),
              testing::Not(testing::Contains(testing::HasSubstr("unknown"))));
  EXPECT_THAT(
      joint("<orgin xyz=\"1 0 0\"/>"),
      ElementsAre("3: joint 'j': <orgin> (did you mean 'origin'?) is unknown and not read"));
  EXPECT_THAT(joint("<origin ryp=\"0 0 1\"/>"),
              ElementsAre("3: joint 'j': attribute 'ryp' of <origin> (did you mean 'rpy'?) is "
                          "unknown and not read"));
  EXPECT_THAT(
      joint("<origin quat_xyzw=\"0 0 0 1\"/>"),
      ElementsAre("3: joint 'j': attribute 'quat_xyzw' of <origin> is unknown and not read"));
  EXPECT_THAT(joint("<AXIS xyz=\"0 1 0\"/>"),
              ElementsAre("3: joint 'j': <AXIS> (did you mean 'axis'?) is unknown and not read"));
  EXPECT_THAT(joint("<pose>0 0 1 0 0 0</pose>"),
              ElementsAre("3: joint 'j': <pose> (did you mean 'origin'?) is unknown and not read"));
  EXPECT_THAT(joint("<origin> 0 0 1</origin>"),
              ElementsAre("3: joint 'j': text in <origin> is not read; expected attributes"));
  EXPECT_THAT(joint("<origin><xyz>0 0 1</xyz></origin>"),
              ElementsAre("3: joint 'j': <xyz> is not read; expected attributes of <origin>"));
  EXPECT_THAT(joint("<origin><axis xyz=\"0 1 0\"/></origin>"),
              ElementsAre("3: joint 'j': <axis> is not read here; its place is in <joint>"));
  EXPECT_THAT(joint("<origin><gz:frame xmlns:gz=\"u\"/></origin>"), testing::IsEmpty());
  EXPECT_THAT(joint("<dynamics dampin=\"1\" K=\"2\"/>"),
              ElementsAre("3: joint 'j': attribute 'dampin' of <dynamics> (did you mean "
                          "'damping'?) is unknown and not read"));
  EXPECT_THAT(joint("<link name=\"c\"/>"),
              ElementsAre("3: joint 'j': <link> is not read here; its place is in <robot>"));
  EXPECT_THAT(joint("<inertia/>"),
              ElementsAre("3: joint 'j': <inertia> is not read here; its place is in <inertial>"));
  EXPECT_THAT(joint("<origin rpy=\"91 0 0\"/>"),
              ElementsAre("3: joint 'j': rpy 91 is beyond 2 pi; angles are in radians"));
}

TEST(ReadModel, TakesEndingsInUpperCase) {
  const std::string path = testing::TempDir() + "ROBOT.URDF";
  std::ofstream(path) << "<sdf/>";
  try {
    read_model(path, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.message(), testing::HasSubstr("root element is <sdf>"));
  }
}

}  // namespace
}  // namespace treedyn::description
