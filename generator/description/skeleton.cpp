#include "description/skeleton.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <queue>
#include <utility>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

constexpr std::size_t kMaxNameLength = 255;
constexpr std::string_view kGroundName = "ground";

std::size_t index(int i) { return static_cast<std::size_t>(i); }

[[noreturn]] void fail(const RawTree& raw, const Place& where, const std::string& message) {
  throw InputError(location(raw, where), message);
}

/// The length of the UTF-8 character at the front, 0 if there is none (overlong forms and
/// surrogates too).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const auto follows = [&](std::size_t k) {
    return (byte(k) & 0xc0U) == 0x80U;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80U) {
    return 1;
  }
  if (lead >= 0xc2U && lead <= 0xdfU) {
    return follows(1) ? 2 : 0;
  }
  if (lead >= 0xe0U && lead <= 0xefU) {
    const bool canonical =
        (lead != 0xe0U || byte(1) >= 0xa0U) && (lead != 0xedU || byte(1) < 0xa0U);
    return canonical && follows(1) && follows(2) ? 3 : 0;
  }
  if (lead >= 0xf0U && lead <= 0xf4U) {
    const bool canonical =
        (lead != 0xf0U || byte(1) >= 0x90U) && (lead != 0xf4U || byte(1) < 0x90U);
    return canonical && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

/// Why a name cannot stand in a file or a comment, or nullptr.
const char* fault_of_name(std::string_view name) {
  if (name.empty()) {
    return "is empty; expected a word";
  }
  while (!name.empty()) {
    const auto byte = static_cast<unsigned char>(name.front());
    const std::size_t length = utf8_length(name);
    if (byte < 0x20 || byte == 0x7f) {
      return "has a control character; expected printable text";
    }
    if (length == 0) {
      return "is not UTF-8; expected printable text";
    }
    name.remove_prefix(length);
  }
  return nullptr;
}

void check_name(const RawTree& raw, const Text& name, std::string_view kind) {
  if (name.text.size() > kMaxNameLength) {
    fail(raw, name.where,
         fmt::format("{} name of {} bytes is too long; expected at most {}", kind, name.text.size(),
                     kMaxNameLength));
  }
  if (const char* const fault = fault_of_name(name.text)) {
    fail(raw, name.where, fmt::format("{} name '{}' {}", kind, shown(name.text), fault));
  }
}

void add_name(const RawTree& raw, std::map<std::string_view, int>& names, const Text& name, int k,
              std::string_view kind) {
  if (!names.emplace(name.text, k).second) {
    fail(raw, name.where,
         fmt::format("{} '{}' is defined twice; expected different names", kind, shown(name.text)));
  }
}

void check_names(const RawTree& raw, Skeleton& skeleton) {
  check_name(raw, raw.name, "model");
  for (std::size_t k = 0; k < raw.links.size(); ++k) {
    const Text& name = raw.links[k].name;
    check_name(raw, name, "link");
    if (raw.format == Format::kYaml && name.text == kGroundName) {
      fail(raw, name.where, "link name 'ground' means the ground; expected another name");
    }
    add_name(raw, skeleton.link_by_name, name, static_cast<int>(k), "link");
  }
  for (std::size_t k = 0; k < raw.joints.size(); ++k) {
    check_name(raw, raw.joints[k].name, "joint");
    if (raw.format == Format::kYaml && raw.joints[k].type.text == "fixed") {
      continue;  // nothing refers to it, its name may be missing
    }
    add_name(raw, skeleton.joint_by_name, raw.joints[k].name, static_cast<int>(k), "joint");
  }
  for (const RawPoint& point : raw.points) {
    check_name(raw, point.name, "point");
  }
}

struct KindRow {
  std::string_view type;
  JointKind kind;
  bool in_yaml;
};
constexpr std::array<KindRow, 4> kKinds = {{
    {"revolute", JointKind::kRevolute, true},
    {"prismatic", JointKind::kPrismatic, true},
    {"fixed", JointKind::kFixed, true},
    {"continuous", JointKind::kRevolute, false},
}};

JointKind kind_of(const RawTree& raw, const RawJoint& joint) {
  const bool yaml = raw.format == Format::kYaml;
  for (const KindRow& row : kKinds) {
    if (row.type == joint.type.text && (row.in_yaml || !yaml)) {
      return row.kind;
    }
  }
  fail(raw, joint.type.where,
       fmt::format(
           "joint '{}': type '{}' is not supported; expected {}", shown(joint.name.text),
           shown(joint.type.text),
           yaml ? "revolute, prismatic or fixed" : "revolute, continuous, prismatic or fixed"));
}

int find_link(const RawTree& raw, const Skeleton& skeleton, const RawJoint& joint, const Text& name,
              std::string_view role) {
  const auto found = skeleton.link_by_name.find(name.text);
  if (found == skeleton.link_by_name.end()) {
    fail(raw, name.where,
         fmt::format("joint '{}': {} '{}' is unknown; expected a link of the file{}",
                     shown(joint.name.text), role, shown(name.text),
                     raw.format == Format::kYaml ? " or ground" : ""));
  }
  return found->second;
}

void connect(const RawTree& raw, Skeleton& skeleton) {
  skeleton.joint.assign(raw.links.size(), kNoJoint);
  skeleton.father.assign(raw.links.size(), model::kGround);
  for (std::size_t k = 0; k < raw.joints.size(); ++k) {
    const RawJoint& joint = raw.joints[k];
    skeleton.kinds.push_back(kind_of(raw, joint));
    const int son = find_link(raw, skeleton, joint, joint.son, "child");
    int& carrier = skeleton.joint[index(son)];
    if (carrier != kNoJoint) {
      fail(raw, joint.son.where,
           fmt::format("link '{}' is the child of joints '{}' and '{}'; expected one father",
                       shown(joint.son.text), shown(raw.joints[index(carrier)].name.text),
                       shown(joint.name.text)));
    }
    carrier = static_cast<int>(k);
    const bool on_ground = raw.format == Format::kYaml && joint.father.text == kGroundName;
    skeleton.father[index(son)] =
        on_ground ? model::kGround
                  : find_link(raw, skeleton, joint, joint.father,
                              raw.format == Format::kYaml ? "father" : "parent");
  }
}

void check_roots(const RawTree& raw, const Skeleton& skeleton) {
  std::optional<std::size_t> root;
  for (std::size_t k = 0; raw.format == Format::kUrdf && k < raw.links.size(); ++k) {
    if (skeleton.joint[k] != kNoJoint) {
      continue;
    }
    if (root) {
      fail(raw, raw.links[k].where,
           fmt::format("links '{}' and '{}' are both no child of a joint; expected one root link",
                       shown(raw.links[*root].name.text), shown(raw.links[k].name.text)));
    }
    root = k;
  }
}

/// Reports the cycle above `link`, which the ground does not reach.
[[noreturn]] void fail_with_cycle(const RawTree& raw, const Skeleton& skeleton, int link) {
  std::vector<bool> seen(raw.links.size(), false);
  while (!seen[index(link)]) {
    seen[index(link)] = true;
    link = skeleton.father[index(link)];
  }
  std::string path;
  int count = 0;
  const int start = link;
  do {
    path += count < 10 ? fmt::format("'{}' -> ", shown(raw.links[index(link)].name.text)) : "";
    link = skeleton.father[index(link)];
    ++count;
  } while (link != start);
  path += count > 10 ? ".. -> " : "";
  fail(raw, raw.links[index(start)].where,
       fmt::format("fathers form the cycle {}'{}'; expected a tree on the ground", path,
                   shown(raw.links[index(start)].name.text)));
}

/// Breadth first from the ground, sons in file order.
void sort_links(const RawTree& raw, Skeleton& skeleton) {
  std::vector<std::vector<int>> sons(raw.links.size());
  for (std::size_t k = 0; k < raw.links.size(); ++k) {
    const int father = skeleton.father[k];
    (father == model::kGround ? skeleton.order : sons[index(father)])
        .push_back(static_cast<int>(k));
  }
  for (std::size_t k = 0; k < skeleton.order.size(); ++k) {
    const std::vector<int>& next = sons[index(skeleton.order[k])];
    skeleton.order.insert(skeleton.order.end(), next.begin(), next.end());
  }
  if (skeleton.order.size() < raw.links.size()) {
    std::vector<bool> reached(raw.links.size(), false);
    for (const int link : skeleton.order) {
      reached[index(link)] = true;
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    fail_with_cycle(raw, skeleton, static_cast<int>(lost - reached.begin()));
  }
}

}  // namespace

Skeleton resolve_skeleton(const RawTree& raw) {
  Skeleton skeleton;
  if (raw.links.empty()) {
    fail(raw, raw.name.where,
         fmt::format("model '{}' has no link; expected at least one", shown(raw.name.text)));
  }
  check_names(raw, skeleton);
  connect(raw, skeleton);
  check_roots(raw, skeleton);
  sort_links(raw, skeleton);
  return skeleton;
}

std::vector<int> moving_order(const Skeleton& skeleton, const std::vector<int>& moving_father) {
  const auto moves = [&](int link) {
    const int joint = skeleton.joint[index(link)];
    return joint != kNoJoint && skeleton.kinds[index(joint)] != JointKind::kFixed;
  };
  using Entry = std::pair<int, int>;  // joint, link
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
  std::vector<std::vector<int>> sons(moving_father.size());
  for (const int link : skeleton.order) {
    const int father = moving_father[index(link)];
    if (moves(link) && father == model::kGround) {
      ready.emplace(skeleton.joint[index(link)], link);
    } else if (moves(link)) {
      sons[index(father)].push_back(link);
    }
  }
  std::vector<int> result;
  while (!ready.empty()) {
    const int link = ready.top().second;
    ready.pop();
    result.push_back(link);
    for (const int son : sons[index(link)]) {
      ready.emplace(skeleton.joint[index(son)], son);
    }
  }
  return result;
}

}  // namespace treedyn::description
