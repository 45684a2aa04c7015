#include "description/skeleton.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <queue>
#include <utility>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/index.hpp"
#include "description/identifiers.hpp"

namespace treedyn::description {

namespace {

constexpr std::string_view kGroundName = "ground";

[[noreturn]] void fail(const RawTree& raw, const Place& where, const std::string& message) {
  throw InputError(location(raw, where), message);
}

void check_name(const RawTree& raw, const Text& name, std::string_view kind) {
  description::check_name(location(raw, name.where), name.text, kind);
}

void add_name(const RawTree& raw, std::map<std::string_view, int>& names, const Text& name, int k,
              std::string_view kind) {
  if (!names.emplace(name.text, k).second) {
    fail(raw, name.where,
         fmt::format("{} '{}' is defined twice; expected different names", kind, shown(name.text)));
  }
}

void check_names(const RawTree& raw, Skeleton& skeleton) {
  if (raw.name.text.empty()) {
    fail(raw, raw.name.where, "the model's own name is empty; expected a word, with --name too");
  }
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
  const std::string& type = joint.type.text;
  const bool floats = type == "floating" || type == "free";
  const bool in_several_ways =
      floats || type == "planar" || type == "spherical" || type == "ball" || type == "universal";
  std::vector<std::string_view> types;
  for (const KindRow& row : kKinds) {
    if (row.in_yaml || !yaml) {
      types.push_back(row.type);
    }
    if (row.type == joint.type.text && (row.in_yaml || !yaml)) {
      return row.kind;
    }
  }
  fail(raw, joint.type.where,
       fmt::format(
           "joint '{}': type '{}' is not supported{}; expected {}{}{}", shown(joint.name.text),
           shown(type), in_several_ways ? "" : did_you_mean(type, types),
           yaml ? "revolute, prismatic or fixed" : "revolute, continuous, prismatic or fixed",
           in_several_ways ? ", several in a row with links without inertia between them" : "",
           floats ? "; of a robot that floats --base axes and no joint at its root" : ""));
}

std::vector<std::string_view> link_names(const RawTree& raw) {
  std::vector<std::string_view> names;
  if (raw.format == Format::kYaml) {
    names.push_back(kGroundName);
  }
  for (const RawLink& link : raw.links) {
    names.push_back(link.name.text);
  }
  return names;
}

int find_link(const RawTree& raw, const Skeleton& skeleton, const RawJoint& joint, const Text& name,
              std::string_view role) {
  const auto found = skeleton.link_by_name.find(name.text);
  if (found == skeleton.link_by_name.end()) {
    fail(raw, name.where,
         fmt::format("joint '{}': {} '{}' is unknown{}; expected a link of the file{}",
                     shown(joint.name.text), role, shown(name.text),
                     did_you_mean(name.text, link_names(raw)),
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
    int& carrier = skeleton.joint[to_index(son)];
    if (carrier != kNoJoint) {
      fail(raw, joint.son.where,
           fmt::format("link '{}' is the child of joints '{}' and '{}'; expected one father",
                       shown(joint.son.text), shown(raw.joints[to_index(carrier)].name.text),
                       shown(joint.name.text)));
    }
    carrier = static_cast<int>(k);
    const bool on_ground = raw.format == Format::kYaml && joint.father.text == kGroundName;
    skeleton.father[to_index(son)] =
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
  while (!seen[to_index(link)]) {
    seen[to_index(link)] = true;
    link = skeleton.father[to_index(link)];
  }
  std::string path;
  int count = 0;
  const int start = link;
  do {
    path += count < 10 ? fmt::format("'{}' -> ", shown(raw.links[to_index(link)].name.text)) : "";
    link = skeleton.father[to_index(link)];
    ++count;
  } while (link != start);
  path += count > 10 ? ".. -> " : "";
  fail(raw, raw.links[to_index(start)].where,
       fmt::format("fathers form the cycle {}'{}'; expected a tree on the ground", path,
                   shown(raw.links[to_index(start)].name.text)));
}

/// Breadth first from the ground, sons in file order.
void sort_links(const RawTree& raw, Skeleton& skeleton) {
  std::vector<std::vector<int>> sons(raw.links.size());
  for (std::size_t k = 0; k < raw.links.size(); ++k) {
    const int father = skeleton.father[k];
    (father == model::kGround ? skeleton.order : sons[to_index(father)])
        .push_back(static_cast<int>(k));
  }
  for (std::size_t k = 0; k < skeleton.order.size(); ++k) {
    const std::vector<int>& next = sons[to_index(skeleton.order[k])];
    skeleton.order.insert(skeleton.order.end(), next.begin(), next.end());
  }
  if (skeleton.order.size() < raw.links.size()) {
    std::vector<bool> reached(raw.links.size(), false);
    for (const int link : skeleton.order) {
      reached[to_index(link)] = true;
    }
    const auto lost = std::ranges::find(reached, false);
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
    const int joint = skeleton.joint[to_index(link)];
    return joint != kNoJoint && skeleton.kinds[to_index(joint)] != JointKind::kFixed;
  };
  using Entry = std::pair<int, int>;  // joint, link
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
  std::vector<std::vector<int>> sons(moving_father.size());
  for (const int link : skeleton.order) {
    const int father = moving_father[to_index(link)];
    if (moves(link) && father == model::kGround) {
      ready.emplace(skeleton.joint[to_index(link)], link);
    } else if (moves(link)) {
      sons[to_index(father)].push_back(link);
    }
  }
  std::vector<int> result;
  while (!ready.empty()) {
    const int link = ready.top().second;
    ready.pop();
    result.push_back(link);
    for (const int son : sons[to_index(link)]) {
      ready.emplace(skeleton.joint[to_index(son)], son);
    }
  }
  return result;
}

}  // namespace treedyn::description
