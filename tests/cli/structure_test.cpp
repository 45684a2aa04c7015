// Robots of one structure have one text: a changed number changes literals and nothing else, a sign
// too.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "cli/diff.hpp"

namespace treedyn {
namespace {

/// One number of a model, wherever the model has it.
struct Change {
  std::string from;
  std::string to;
};

struct Robot {
  const char* name;
  std::vector<Change> changes;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string with(std::string text, const Change& change) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(change.from, at)) != std::string::npos; ++found) {
    text.replace(at, change.from.size(), change.to);
    at += change.to.size();
  }
  EXPECT_GE(found, 1U) << change.from;
  return text;
}

class Structure : public Cli, public testing::WithParamInterface<Robot> {
 protected:
  using Texts = std::vector<std::string>;  ///< header, source, manifest

  Texts generated(const std::string& model, const std::string& effort) {
    const std::string name = GetParam().name;
    write_file(scratch("model.yaml"), model);
    const Outcome outcome =
        treedyn({"generate", "-q", "--effort", effort, scratch("model.yaml"), "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return {read_file(file(name + ".hpp")), read_file(file(name + ".cpp")),
            read_file(file(name + ".json"))};
  }

  /// Definitions of constants, the digest of both files, a unit of length.
  static bool may_change(const std::string& line) {
    return line.starts_with("constexpr ") || line.find("kDigest") != std::string::npos ||
           line.starts_with("//   L = ");
  }

  /// The lines that change are lines with literals, the rest is the same, character by character;
  /// in the source they are those of the table, of the digest and of units of length.
  static void expect_literals_only(const Texts& before, const Texts& after) {
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(without_literals(before[k]), without_literals(after[k]));
      const std::vector<std::string> a = lines_of(before[k]);
      const std::vector<std::string> b = lines_of(after[k]);
      ASSERT_EQ(a.size(), b.size());
      int changed = 0;
      int dependent = 0;
      for (std::size_t n = 0; n < a.size(); ++n) {
        changed += a[n] != b[n] ? 1 : 0;
        EXPECT_TRUE(a[n] == b[n] || k != 1 || may_change(a[n])) << a[n] << '\n' << b[n];
        dependent += without_literals(a[n]) != a[n] && a[n] != b[n] ? 1 : 0;
      }
      EXPECT_LE(changed, dependent);
    }
    EXPECT_NE(before[1], after[1]);
  }

  /// With an equation that divides by a sum of masses.
  static std::string model() {
    return read_file(fmt::format("{}/models/{}.yaml", TREEDYN_SOURCE_DIR, GetParam().name)) +
           "equations:\n  - {name: centre, value: T(ones) * m_d * r / (T(ones) * m_d * ones)}\n";
  }
};

TEST_P(Structure, DecidesTheTextWithoutASearch) {
  const Texts before = generated(model(), "0");
  for (const Change& change : GetParam().changes) {
    SCOPED_TRACE(change.from + " -> " + change.to);
    expect_literals_only(before, generated(with(model(), change), "0"));
  }
}

TEST_P(Structure, DecidesTheTextOfTheSearch) {
  const Change& change = GetParam().changes.front();
  expect_literals_only(generated(model(), "40"), generated(with(model(), change), "40"));
}

/// Number or numbers of a link, as comments of the table call them.
struct ModelNumber {
  Change change;
  std::string link;
  std::string part;  ///< "com y"
};

/// A constant of the table with the comment above it, on one line.
struct Constant {
  std::string definition;
  std::string comment;
};

std::vector<Constant> table_of(const std::string& source) {
  std::vector<Constant> result;
  std::string comment;
  for (const std::string& line : lines_of(source)) {
    if (line.starts_with("//")) {
      const std::size_t begin = std::min(line.find_first_not_of("/ "), line.size());
      comment += (comment.empty() ? "" : " ") + line.substr(begin);
    } else {
      if (line.starts_with("constexpr ")) {
        result.push_back({line, comment});
      }
      comment.clear();
    }
  }
  return result;
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
    end = text.find(separator, begin);
    result.push_back(text.substr(begin, end - begin));
  }
  return result;
}

/// True if a comment like " kg m^2: mass, com y z of link3, link4; gravity" tells of the number.
bool mentions(const std::string& comment, const ModelNumber& number) {
  const std::vector<std::string> wanted = split(number.part, " ");
  const std::size_t unit = comment.find(": ");
  for (const std::string& group :
       split(comment.substr(unit == std::string::npos ? 0 : unit + 2), "; ")) {
    const std::vector<std::string> sides = split(group, " of ");
    if (sides.size() < 2 || !std::ranges::count(split(sides[1], ", "), number.link)) {
      continue;
    }
    for (const std::string& part : split(sides[0], ", ")) {
      const std::vector<std::string> words = split(part, " ");
      if (words[0] == wanted[0] &&
          (words.size() == 1 || wanted.size() == 1 || std::ranges::count(words, wanted[1]) > 0)) {
        return true;
      }
    }
  }
  return false;
}

class Table : public Cli {};

TEST_F(Table, TellsWhichConstantsANumberOfTheModelChanges) {
  const std::vector<ModelNumber> numbers = {
      {{"mass: 17.4", "mass: 17.15"}, "link2", "mass"},
      {{"mass: 4.8", "mass: 4.9"}, "link3", "mass"},
      {{"mass: 0.82", "mass: 0.9"}, "link4", "mass"},
      {{"mass: 0.09", "mass: 0.5"}, "link6", "mass"},
      {{"com: [0.068", "com: [0.07"}, "link2", "com x"},
      {{"0.006, -0.016", "0.0055, -0.016"}, "link2", "com y"},
      {{"0.006, -0.016", "0.006, -0.0163"}, "link2", "com z"},
      {{"[0, -0.070", "[0, -0.071"}, "link3", "com y"},
      {{"-0.070, 0.014", "-0.070, 0.0123456789"}, "link3", "com z"},
      {{"0.2435", "0.244"}, "link2", "offset y"},
      {{"0.4318", "0.44"}, "link3", "offset x"},
      {{"-0.0203", "-0.0197"}, "link4", "offset x"},
      {{"0.35]", "0.36]"}, "link1", "inertia zz"},
      {{"0.524", "0.53"}, "link2", "inertia yy"},
      {{"0.539", "0.5"}, "link2", "inertia zz"},
      {{"0.04e-3", "0.05e-3"}, "link6", "inertia zz"}};
  const std::string model = read_file(TREEDYN_SOURCE_DIR "/models/puma560.yaml");
  const auto table = [&](const std::string& text) {
    write_file(scratch("model.yaml"), text);
    EXPECT_EQ(
        treedyn({"generate", "-q", "--effort", "0", scratch("model.yaml"), "-o", out()}).status, 0);
    return table_of(read_file(file("puma560.cpp")));
  };
  const std::vector<Constant> before = table(model);
  ASSERT_GT(before.size(), 20U);
  for (const ModelNumber& number : numbers) {
    const std::vector<Constant> after = table(with(model, number.change));
    ASSERT_EQ(after.size(), before.size());
    int changed = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(after[k].comment, before[k].comment);
      const bool is_told = mentions(before[k].comment, number);
      const bool is_changed = after[k].definition != before[k].definition;
      EXPECT_EQ(is_changed, is_told)
          << number.part << " of " << number.link << ": " << before[k].comment << '\n'
          << before[k].definition;
      changed += is_changed ? 1 : 0;
    }
    EXPECT_GT(changed, 0) << number.part << " of " << number.link;
  }
}

const Robot kRobots[] = {
    {"puma560",
     {{"mass: 4.8", "mass: 4.9"},
      {"mass: 17.4", "mass: 17.15"},
      {"mass: 0.82", "mass: 0.9"},
      {"mass: 0.34", "mass: 0.3333"},
      {"mass: 0.09", "mass: 0.5"},
      {"com: [0.068", "com: [0.07"},
      {"0.006, -0.016", "0.0055, -0.016"},
      {"0.006, -0.016", "0.006, -0.0163"},
      {"[0, -0.070", "[0, -0.071"},
      {"[0, -0.070", "[0, 0.070"},
      {"com: [0.068", "com: [-0.068"},
      {"-0.070, 0.014", "-0.070, 0.0123456789"},
      {"0.2435", "0.244"},
      {"0.4318", "0.44"},
      {"-0.0934", "-0.1"},
      {"-0.0203", "0.0203"},
      {"-0.0203", "-0.0197"},
      {"-0.4331", "-0.4339"},
      {"0.35]", "0.36]"},
      {"0.524", "0.53"},
      {"0.539", "0.5"},
      {"1.8e-3", "1.85e-3"},
      {"0.04e-3", "0.05e-3"}}},
    {"quadruped",
     {{"length: 0.38", "length: 0.381"},
      {"width: 0.098", "width: 0.1"},
      {"hip: 0.062", "hip: 0.0617"},
      {"thigh: 0.209", "thigh: 0.2"},
      {"shank: 0.175", "shank: 0.18"},
      {"13*u", "14*u"},
      {"mass: 0.54", "mass: 0.55"},
      {"mass: 0.634", "mass: 0.6"},
      {"mass: 0.064", "mass: 0.07"},
      {"0.036", "0.0357"},
      {"0.016", "0.017"},
      {"-0.061", "-0.0625"},
      {"-0.02]", "0.02]"},
      {"1.5*u", "1.6*u"},
      {"408*u", "410*u"},
      {"381*u", "390*u"},
      {"248*u", "250*u"},
      {"-0.02]", "-0.021]"},
      {"1983*u", "1990*u"},
      {"2103*u", "2100*u"},
      {" 6*u", " 6.1*u"}}},
    {"biped",
     {{"M: 80.5", "M: 82.3"},
      {"H: 1.77", "H: 1.8"},
      {"pelvis: 0.094", "pelvis: 0.1"},
      {"pelvis_width: 0.224", "pelvis_width: 0.23"},
      {"thigh: 0.432", "thigh: 0.44"},
      {"shank: 0.433", "shank: 0.43"},
      {"foot: 0.139", "foot: 0.14"},
      {"heel_x: -0.06", "heel_x: -0.061"},
      {"0.08*0.123*M", "0.081*0.123*M"},
      {"m_thigh: 0.123*M", "m_thigh: 0.124*M"},
      {"m_shank: 0.048*M", "m_shank: 0.05*M"},
      {"0.2*0.012*M", "0.21*0.012*M"},
      {"m_foot: 0.012*M", "m_foot: 0.0121*M"},
      {"0.152*H", "0.153*H"},
      {"0.039*H", "0.0392*H"},
      {"29^2*J_thigh", "29.5^2*J_thigh"},
      {"15^2*J_thigh", "15.2^2*J_thigh"},
      {"-0.429*thigh", "-0.43*thigh"},
      {"-0.429*thigh", "0.429*thigh"},
      {"10^2*J_shank", "11^2*J_shank"},
      {"48^2*J_foot", "47^2*J_foot"}}},
};

INSTANTIATE_TEST_SUITE_P(Models, Structure, testing::ValuesIn(kRobots),
                         [](const auto& test) { return std::string(test.param.name); });

/// A number of a scene, or of the model under it.
struct SceneChange {
  std::string from;
  std::string to;
  bool in_model = false;
};

struct SceneCase {
  const char* name;   ///< as the scene says
  std::string model;  ///< below models/, or a text
  std::vector<SceneChange> changes;
};

/// Every kind of effect that numbers enter.
const char* const kEffectsModel = R"yaml(name: slider
links:
  - name: cart
    father: ground
    joint: {name: rail, type: prismatic, axis: [1, 0, 0]}
    mass: 3.1
  - name: arm
    father: cart
    joint: {name: swing, type: revolute, axis: [0, 1, 0], offset: [0.02, 0, 0.03]}
    mass: 1.7
    com: [0.21, 0.01, -0.13]
    inertia: [0.011, 0, 0, 0.012, 0, 0.013]
  - name: hand
    father: arm
    joint: {name: wrist, type: revolute, axis: [0, 1, 0], offset: [0.43, 0, -0.11]}
    mass: 0.6
    com: [0.17, 0, 0.02]
    inertia: [0.001, 0, 0, 0.0022, 0, 0.0023]
points:
  - {name: tip, link: hand, at: [0.31, 0.04, -0.05]}
)yaml";
const char* const kEffects = R"yaml(scene: effects
model: model.yaml
effects:
  gravity: [0, 0, -9.81]
  joint_spring: [{joint: swing, stiffness: 35, damping: 0.7, rest: 0.3}]
  point_spring: [{point: tip, anchor: [0.9, 0.1, 1.2], stiffness: 120,
       damping: 2.5, rest_length: 0.4}]
  viscous_friction: [{joint: rail, coefficient: 4.5}]
  coulomb_friction: [{joint: wrist, force: 0.9, slip_speed: 0.02}]
  stribeck_friction: [{joint: rail, force: 3.3, static_force: 4.1,
       stribeck_speed: 0.15, slip_speed: 0.012}]
  armature: [{joint: swing, inertia: 0.08}]
  drive:
    - {joint: swing, kp: 210, kd: 11, target: 0.25*sin(3.7*t)}
    - {joint: rail, torque: "-17*q[rail] + 6.1*cos(3.7*t)"}
  force: [{point: tip, value: [1.95*x, 0, 2.3 - 0.45*vz]}]
  moment: [{point: tip, value: [0, 0.33*sin(3.7*t), 0]}]
  ground_contact:
    - {point: tip, stiffness: 5200, exponent: 1.5, dissipation: 0.35,
       friction: 0.62, slip_speed: 0.011, height: -0.27, normal: [0.1, 0.2, 1]}
  point_constraint: [{name: stop, point: hand, along: [z]}]
  locked_joint: [{joint: wrist, name: led, at: 0.23*sin(1.9*t)}]
  stabilisation: {method: baumgarte, rate: 23}
phases:
  - name: free
    until:
      - {expression: "q[rail] - 1.23", crossing: rising, then: held}
      - {touch_down: {point: hand, height: -0.61},
         impact: {constraints: [stop], restitution: 0.31, rest_below: 0.02}, then: free}
    active: []
  - name: held
    active: [stop, led]
    until:
      - {lift_off: {constraint: stop}, then: free}
initial: {q: {swing: 0.4}}
duration: 1
stepping: {integrator: rk4, step: 0.001}
)yaml";

class SceneStructure : public Cli, public testing::WithParamInterface<SceneCase> {
 protected:
  static std::string read(const std::string& name) {
    return read_file(TREEDYN_SOURCE_DIR "/models/" + name);
  }
  static std::string scene() {
    const std::string name = GetParam().name;
    return name == "effects" ? kEffects : read("scenes/" + name + ".yaml");
  }
  static std::string model() {
    return GetParam().model.empty() ? kEffectsModel : read(GetParam().model);
  }

  /// Line by line but for literals and what rounding was measured to do.
  static void expect_same_form(const std::string& before, const std::string& after) {
    const std::vector<std::string> a = lines_of(before);
    const std::vector<std::string> b = lines_of(after);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
      if (a[n].find("\"rounding\"") == std::string::npos) {
        ASSERT_EQ(without_literals(a[n]), without_literals(b[n]));
      }
    }
  }

  std::vector<std::string> generated(std::string scene, const std::string& model) {
    const std::size_t path = scene.find("model: ");
    scene.replace(path, scene.find('\n', path) - path, "model: model.yaml");
    write_file(scratch("model.yaml"), model);
    write_file(scratch("scene.yaml"), scene);
    const Outcome outcome =
        treedyn({"generate", "-q", "--effort", "0", "--scene", scratch("scene.yaml"), "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string stem = GetParam().name;
    return {read_file(file(stem + ".hpp")), read_file(file(stem + ".cpp")),
            read_file(file(stem + ".json"))};
  }
};

/// The manifest has the counts, the source the names and their order.
TEST_P(SceneStructure, DecidesTheTextOfItsFunctions) {
  const std::vector<std::string> before = generated(scene(), model());
  for (const SceneChange& change : GetParam().changes) {
    SCOPED_TRACE(change.from + " -> " + change.to);
    const Change plain = {change.from, change.to};
    const std::vector<std::string> after =
        generated(change.in_model ? scene() : with(scene(), plain),
                  change.in_model ? with(model(), plain) : model());
    EXPECT_NE(before[1], after[1]);
    for (std::size_t k = 0; k < before.size(); ++k) {
      expect_same_form(before[k], after[k]);
    }
  }
}

const SceneCase kScenes[] = {
    {"drop",
     "scenes/drop.model.yaml",
     {{"1e8", "1.1e8"}, {"dissipation: 0.3", "dissipation: 0.35"}, {"-9.81", "-9.8"}}},
    {"four_bar",
     "scenes/four_bar.model.yaml",
     {{"kd: 2", "kd: 2.5"},
      {"6*t", "6.5*t"},
      {"-9.81", "-9.8"},
      {"crank: 0.2", "crank: 0.21", true},
      {"rocker: 0.4", "rocker: 0.41", true},
      {"mass: 0.4", "mass: 0.45", true}}},
    {"arm_circle",
     "two_link.yaml",
     {{"1.2 +", "1.21 +"}, {"-0.4 +", "-0.41 +"}, {"-9.81", "-9.8"}}},
    {"compass_walk", "compass_walker.yaml", {{"slope: pi/60", "slope: pi/61"}, {"9.81", "9.8"}}},
    {"biped_double_support",
     "biped.yaml",
     {{"bend: 0.3", "bend: 0.31"},
      {"kp: 2000", "kp: 2100"},
      {"kd: 100", "kd: 110"},
      {"rotor: 0.2", "rotor: 0.25"},
      {"m_thigh: 0.123*M", "m_thigh: 0.124*M", true},
      {"heel_x: -0.06", "heel_x: -0.061", true}}},
    {"biped_stepping", "biped.yaml", {{"w: 2*pi/1.2", "w: 2*pi/1.3"}, {"kp: 20000", "kp: 21000"}}},
    {"effects",
     "",
     {{"stiffness: 35", "stiffness: 36"},
      {"damping: 0.7", "damping: 0.71"},
      {"rest: 0.3}", "rest: 0.33}"},
      {"anchor: [0.9", "anchor: [0.91"},
      {"stiffness: 120", "stiffness: 121"},
      {"damping: 2.5", "damping: 2.6"},
      {"rest_length: 0.4", "rest_length: 0.43"},
      {"coefficient: 4.5", "coefficient: 4.6"},
      {"force: 0.9", "force: 0.91"},
      {"slip_speed: 0.02}", "slip_speed: 0.021}"},
      {"force: 3.3", "force: 3.4"},
      {"static_force: 4.1", "static_force: 4.4"},
      {"stribeck_speed: 0.15", "stribeck_speed: 0.16"},
      {"slip_speed: 0.012", "slip_speed: 0.013"},
      {"inertia: 0.08", "inertia: 0.09"},
      {"kp: 210", "kp: 220"},
      {"0.23*sin", "0.24*sin"},
      {"1.9*t", "1.8*t"},
      {"0.25*sin", "0.26*sin"},
      {"3.7*t", "3.8*t"},
      {"-17*q", "-18*q"},
      {"1.95*x", "1.85*x"},
      {"0.45*vz", "0.46*vz"},
      {"0.33*sin", "0.34*sin"},
      {"stiffness: 5200", "stiffness: 5300"},
      {"dissipation: 0.35", "dissipation: 0.36"},
      {"friction: 0.62", "friction: 0.63"},
      {"slip_speed: 0.011", "slip_speed: 0.0115"},
      {"height: -0.27", "height: -0.28"},
      {"normal: [0.1", "normal: [0.12"},
      {"rate: 23", "rate: 24"},
      {"1.23", "1.24"},
      {"height: -0.61", "height: -0.62"},
      {"restitution: 0.31", "restitution: 0.32"},
      {"rest_below: 0.02", "rest_below: 0.03"},
      {"mass: 1.7", "mass: 1.8", true},
      {"at: [0.31", "at: [0.32", true}}},
};

INSTANTIATE_TEST_SUITE_P(Models, SceneStructure, testing::ValuesIn(kScenes),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn
