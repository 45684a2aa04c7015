#include "description/mimic.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/index.hpp"

namespace treedyn::description {

namespace {

/// q = multiplier * q_leader + offset; no leader: independent.
struct Rule {
  std::optional<int> leader;
  Real multiplier = 1;
  Real offset = 0;
};

using JointIndex = std::map<std::string_view, int>;

Rule rule_of(const RawTree& raw, const RawJoint& joint, const NumberReader& numbers,
             const JointIndex& moving) {
  if (!joint.mimic) {
    return {};
  }
  const std::string name = fmt::format("joint '{}': mimic", shown(joint.name.text));
  const Text& leader = joint.mimic->joint;
  const auto found = moving.find(leader.text);
  if (found == moving.end()) {
    std::vector<std::string_view> names;
    for (const auto& [known, index] : moving) {
      names.push_back(known);
    }
    throw InputError(
        location(raw, leader.where),
        fmt::format("{} of '{}', which is unknown or fixed{}; expected a joint that moves", name,
                    shown(leader.text), did_you_mean(leader.text, names)));
  }
  Rule rule{found->second};
  if (joint.mimic->multiplier) {
    rule.multiplier = numbers.number(*joint.mimic->multiplier, name + " multiplier");
  }
  if (joint.mimic->offset) {
    rule.offset = numbers.number(*joint.mimic->offset, name + " offset");
  }
  return rule;
}

/// Follows the leaders of joint `start`: q_start = multiplier * q_last + offset.
Rule followed(const model::Tree& tree, const std::vector<Rule>& rules, int start) {
  Rule total{start};
  for (std::size_t steps = 0; rules[to_index(*total.leader)].leader; ++steps) {
    if (steps > rules.size()) {
      const model::Joint& joint = tree.links[to_index(start)].joint;
      throw InputError(joint.where, fmt::format("joint '{}': mimic joints form a cycle; expected "
                                                "one that is independent",
                                                shown(joint.name)));
    }
    const Rule& next = rules[to_index(*total.leader)];
    total.offset += total.multiplier * next.offset;
    total.multiplier *= next.multiplier;
    total.leader = next.leader;
  }
  return total;
}

}  // namespace

void resolve_mimics(const RawTree& raw, const Skeleton& skeleton, const NumberReader& numbers,
                    bool reduce, model::Tree& tree) {
  JointIndex moving;
  for (int i = 0; i < tree.size(); ++i) {
    moving.emplace(tree.links[to_index(i)].joint.name, i);
  }
  std::vector<Rule> rules(tree.links.size());
  for (int i = 0; i < tree.size(); ++i) {
    const auto joint = skeleton.joint_by_name.find(tree.links[to_index(i)].joint.name);
    if (joint != skeleton.joint_by_name.end()) {  // else a base joint
      rules[to_index(i)] = rule_of(raw, raw.joints[to_index(joint->second)], numbers, moving);
    }
  }
  std::vector<Rule> totals;
  for (int i = 0; i < tree.size(); ++i) {
    totals.push_back(followed(tree, rules, i));
  }
  std::vector<int> coordinate(tree.links.size(), 0);
  for (int i = 0; i < tree.size(); ++i) {
    if (!reduce || !rules[to_index(i)].leader) {
      coordinate[to_index(i)] = tree.dof();
      tree.coordinates.push_back(i);
    }
  }
  for (int i = 0; i < tree.size(); ++i) {
    const Rule& total = reduce ? totals[to_index(i)] : Rule{i};
    tree.drives.push_back({coordinate[to_index(*total.leader)], total.multiplier, total.offset});
  }
}

}  // namespace treedyn::description
