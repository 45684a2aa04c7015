// Robots of one structure have one text: a changed number changes literals and nothing else.
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

  static std::string model() {
    return read_file(fmt::format("{}/models/{}.yaml", TREEDYN_SOURCE_DIR, GetParam().name));
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
  int told = 0;
  int all_changed = 0;
  for (const ModelNumber& number : numbers) {
    const std::vector<Constant> after = table(with(model, number.change));
    ASSERT_EQ(after.size(), before.size());
    int changed = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(after[k].comment, before[k].comment);
      const bool is_told = mentions(before[k].comment, number);
      const bool is_changed = after[k].definition != before[k].definition;
      EXPECT_LE(is_changed, is_told)
          << number.part << " of " << number.link << ": " << before[k].comment << '\n'
          << before[k].definition;
      changed += is_changed ? 1 : 0;
      told += is_told ? 1 : 0;
    }
    EXPECT_GT(changed, 0) << number.part << " of " << number.link;
    all_changed += changed;
  }
  EXPECT_LE(told, all_changed + all_changed / 5);  // some of what a number is made of cancels
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
      {"-0.070, 0.014", "-0.070, 0.0123456789"},
      {"0.2435", "0.244"},
      {"0.4318", "0.44"},
      {"-0.0934", "-0.1"},
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
      {"10^2*J_shank", "11^2*J_shank"},
      {"48^2*J_foot", "47^2*J_foot"}}},
};

INSTANTIATE_TEST_SUITE_P(Models, Structure, testing::ValuesIn(kRobots),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn
