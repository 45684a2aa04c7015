#include "description/urdf_reader.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "description/numbers.hpp"
#include "description/xml_element.hpp"

namespace treedyn::description {

namespace {

/// Which elements are read, by the element around them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kRead = {{
    {"robot", "link"},
    {"robot", "joint"},
    {"link", "inertial"},
    {"inertial", "origin"},
    {"inertial", "mass"},
    {"inertial", "inertia"},
    {"joint", "parent"},
    {"joint", "child"},
    {"joint", "origin"},
    {"joint", "axis"},
    {"joint", "limit"},
    {"joint", "mimic"},
    {"joint", "dynamics"},
}};

bool wanted(std::string_view father, std::string_view child) {
  return std::ranges::find(kRead, std::pair(father, child)) != kRead.end();
}

/// An element and how messages call it.
struct Part {
  const std::string& file;
  const Element& element;
  std::string what;

  [[noreturn]] void fail(const Place& where, const std::string& message) const {
    throw InputError(where.in(file), fmt::format("{}: {}", what, message));
  }

  /// The only child of that name, or nullptr.
  [[nodiscard]] const Element* find(std::string_view name) const {
    const Element* result = nullptr;
    for (const Element& child : element.children) {
      if (child.name != name) {
        continue;
      }
      if (result != nullptr) {
        fail(child.where, fmt::format("second <{}>; expected one", name));
      }
      result = &child;
    }
    return result;
  }

  [[nodiscard]] const Element& get(std::string_view name) const {
    const Element* const child = find(name);
    if (child == nullptr) {
      fail(element.where, fmt::format("has no <{}>; expected one", name));
    }
    return *child;
  }

  [[nodiscard]] Text text(const Element& of, std::string_view key) const {
    const std::string* const value = of.attribute(key);
    if (value == nullptr) {
      fail(of.where, fmt::format("<{}> has no attribute '{}'; expected it here", of.name, key));
    }
    return {*value, of.where};
  }
};

constexpr std::string_view kSpaces = " \t\r\n";

/// `text` without the spaces around it: URDF writers put them into scalar attributes too.
Text trimmed(Text text) {
  const std::size_t first = std::min(text.text.find_first_not_of(kSpaces), text.text.size());
  const std::size_t last = text.text.find_last_not_of(kSpaces);
  text.text = last == std::string::npos ? "" : text.text.substr(first, last - first + 1);
  return text;
}

std::optional<Text> optional_number(const Element& of, std::string_view key) {
  const std::string* const value = of.attribute(key);
  return value == nullptr ? std::nullopt : std::optional(trimmed({*value, of.where}));
}

/// The numbers of an attribute such as xyz="0 0 1".
std::optional<Numbers> numbers(const Element& of, std::string_view key) {
  const std::string* const value = of.attribute(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  Numbers result{{}, of.where};
  std::size_t at = value->find_first_not_of(kSpaces);
  while (at != std::string::npos) {
    const std::size_t end = std::min(value->find_first_of(kSpaces, at), value->size());
    result.values.push_back({value->substr(at, end - at), of.where});
    at = value->find_first_not_of(kSpaces, end);
  }
  return result;
}

RawPose read_origin(const Part& part) {
  const Element* const origin = part.find("origin");
  return origin == nullptr
             ? RawPose{}
             : RawPose{numbers(*origin, "xyz"), numbers(*origin, "rpy"), std::nullopt};
}

std::string called(std::string_view kind, const Element& element) {
  const std::string* const name = element.attribute("name");
  return name == nullptr ? std::string(kind) : fmt::format("{} '{}'", kind, shown(*name));
}

struct KnownRow {
  std::string_view element;
  std::vector<std::string_view> attributes;
  std::vector<std::string_view> children;  ///< that are read, or known and not read
};

/// What the URDF format has, in the elements that are read.
const std::vector<KnownRow>& known_rows() {
  static const std::vector<KnownRow> rows = {
      {"robot",
       {"name", "version"},
       {"link", "joint", "material", "gazebo", "transmission", "sensor", "model_type"}},
      {"link",
       {"name", "type"},
       {"inertial", "visual", "collision", "contact", "self_collision_checking"}},
      {"joint",
       {"name", "type"},
       {"parent", "child", "origin", "axis", "limit", "mimic", "dynamics", "calibration",
        "safety_controller"}},
      {"inertial", {}, {"origin", "mass", "inertia"}},
      {"origin", {"xyz", "rpy"}, {}},
      {"mass", {"value"}, {}},
      {"inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, {}},
      {"parent", {"link"}, {}},
      {"child", {"link"}, {}},
      {"axis", {"xyz"}, {}},
      {"limit", {"lower", "upper", "velocity", "effort", "acceleration", "jerk"}, {}},
      {"mimic", {"joint", "multiplier", "offset"}, {}},
      {"dynamics", {"damping", "friction", "mu_viscous", "mu_coulomb", "K", "D"}, {}},
  };
  return rows;
}

/// "; it stands in <link>" for an element that is read in other places; empty for others.
std::string place_of(std::string_view element) {
  std::string result;
  for (const auto& [father, child] : kRead) {
    if (child == element) {
      result += fmt::format("{} <{}>", result.empty() ? "; its place is in" : " or", father);
    }
  }
  return result;
}

/// What a mistyped element may be: capitals are slips, too, and SDF has a word of its own.
std::string meant_by(std::string name, const std::vector<std::string_view>& known) {
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return did_you_mean(name == "pose" ? "origin" : name, known);
}

/// What an element holds that nobody reads and that looks like a slip: `<orgin>`, `ryp=`, a link
/// within a link. Other unknown elements, and those of namespaces, belong to other programs.
void vet_element(const Part& part, std::vector<Warning>& findings) {
  const Element& element = part.element;
  const auto row = std::ranges::find(known_rows(), element.name, &KnownRow::element);
  if (row == known_rows().end()) {
    return;
  }
  const auto find = [&](const Place& where, const std::string& message) {
    findings.push_back({where.in(part.file), fmt::format("{}: {}", part.what, message)});
  };
  const bool leaf = row->children.empty();  // others carry what belongs to other programs
  for (const Text& stray : element.strays) {
    if (is_known(stray.text, row->children)) {
      continue;
    }
    const std::string misplaced = place_of(stray.text);
    const std::string meant = misplaced.empty() ? meant_by(stray.text, row->children) : "";
    if (!misplaced.empty()) {
      find(stray.where, fmt::format("<{}> is not read here{}", shown(stray.text), misplaced));
    } else if (leaf && stray.text.find(':') == std::string::npos) {
      find(stray.where, fmt::format("<{}> is not read; expected attributes of <{}>",
                                    shown(stray.text), element.name));
    } else if (!meant.empty()) {
      find(stray.where, fmt::format("<{}>{} is unknown and not read", shown(stray.text), meant));
    }
  }
  if (leaf && element.text.line > 0) {
    find(element.text, fmt::format("text in <{}> is not read; expected attributes", element.name));
  }
  for (const auto& [name, value] : element.attributes) {
    const std::string meant = did_you_mean(name, row->attributes);
    if (!is_known(name, row->attributes) && name.find(':') == std::string::npos &&
        (leaf || !meant.empty())) {
      find(element.where, fmt::format("attribute '{}' of <{}>{} is unknown and not read",
                                      shown(name), element.name, meant));
    }
  }
  for (const Element& child : element.children) {
    const bool own = child.name == "link" || child.name == "joint";
    vet_element({part.file, child, own ? called(child.name, child) : part.what}, findings);
  }
}

/// Elements of xacro that were left as they are.
void refuse_xacro(const Part& robot) {
  for (const Text& stray : robot.element.strays) {
    if (stray.text.starts_with("xacro:")) {
      robot.fail(stray.where, of_xacro(fmt::format("<{}>", shown(stray.text))));
    }
  }
}

RawInertia read_inertia(const Part& part) {
  const Element& tensor = part.get("inertia");
  RawInertia inertia{trimmed(part.text(part.get("mass"), "value")), read_origin(part),
                     Numbers{{}, tensor.where}, part.element.where};
  for (const std::string_view key : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    inertia.tensor->values.push_back(trimmed(part.text(tensor, key)));
  }
  return inertia;
}

/// The name of a link or joint.
Text read_name(const Part& part, const Element& element, std::string_view key) {
  Text name = part.text(element, key);
  if (is_xacro(name.text)) {
    part.fail(name.where, of_xacro(fmt::format("'{}'", shown(name.text))));
  }
  return name;
}

RawLink read_link(const std::string& file, const Element& element) {
  const Part part{file, element, called("link", element)};
  RawLink link{read_name(part, element, "name"), std::nullopt, element.where};
  if (const Element* const inertial = part.find("inertial")) {
    link.inertia = read_inertia({file, *inertial, part.what});
  }
  return link;
}

RawLimits read_limits(const Element* element) {
  return element == nullptr
             ? RawLimits{}
             : RawLimits{optional_number(*element, "lower"), optional_number(*element, "upper"),
                         optional_number(*element, "velocity"),
                         optional_number(*element, "effort")};
}

RawJoint read_joint(const std::string& file, const Element& element) {
  const Part part{file, element, called("joint", element)};
  RawJoint joint;
  joint.where = element.where;
  joint.name = read_name(part, element, "name");
  joint.type = part.text(element, "type");
  joint.father = read_name(part, part.get("parent"), "link");
  joint.son = read_name(part, part.get("child"), "link");
  joint.pose = read_origin(part);
  joint.axis = Numbers{{{"1", {}}, {"0", {}}, {"0", {}}}, element.where};  // of the URDF format
  if (const Element* const axis = part.find("axis")) {
    const std::optional<Numbers> written = numbers(*axis, "xyz");
    if (written) {
      joint.axis = written;
    } else if (joint.type.text != "fixed") {
      part.fail(axis->where, "<axis> has no attribute 'xyz'; expected it here");
    }
  }
  joint.limits = read_limits(part.find("limit"));
  if (const Element* const mimic = part.find("mimic")) {
    joint.mimic = RawMimic{part.text(*mimic, "joint"), optional_number(*mimic, "multiplier"),
                           optional_number(*mimic, "offset")};
  }
  const auto dynamics = std::ranges::find(element.children, "dynamics", &Element::name);
  if (dynamics != element.children.end()) {
    joint.dissipation = {optional_number(*dynamics, "damping"),
                         optional_number(*dynamics, "friction")};
  }
  return joint;
}

}  // namespace

RawTree read_urdf(const std::string& text, const std::string& file) {
  const Element root = parse_xml(text, file, wanted);
  const Part robot{file, root, "robot"};
  if (root.name != "robot") {
    robot.fail(root.where, fmt::format("root element is <{}>; expected <robot>", shown(root.name)));
  }
  refuse_xacro(robot);
  RawTree raw;
  vet_element(robot, raw.oddities);
  raw.format = Format::kUrdf;
  raw.file = file;
  raw.name = robot.text(root, "name");
  for (const Element& child : root.children) {
    if (child.name == "link") {
      raw.links.push_back(read_link(file, child));
    } else {
      raw.joints.push_back(read_joint(file, child));
    }
  }
  return raw;
}

}  // namespace treedyn::description
