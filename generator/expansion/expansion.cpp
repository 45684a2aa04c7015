#include "expansion/expansion.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "block/evaluate.hpp"
#include "common/index.hpp"

namespace treedyn::expansion {
namespace {

void copy(const std::vector<Expanded>& values, std::span<Expanded> leaf) {
  if (!leaf.empty()) {
    std::ranges::copy(values, leaf.begin());
  }
}

}  // namespace

Expansion::Expansion(const model::Tree& tree, std::span<const model::Point> points,
                     const model::Vector3& gravity)
    : index_(equations::index_of(tree, points)), poses_(tree.links.size()) {
  for (const model::Link& link : tree.links) {
    add_joint(link);
  }
  for (const model::Link& link : tree.links) {
    rate_.emplace_back(ring_, ring_.add("qd_" + link.joint.identifier));
  }
  for (const model::Link& link : tree.links) {
    acceleration_.emplace_back(ring_, ring_.add("qdd_" + link.joint.identifier));
  }
  for (const model::Point& point : points) {
    for (const char* axis : {"x", "y", "z"}) {
      force_.emplace_back(ring_, ring_.add(fmt::format("f_{}_{}", point.identifier, axis)));
      moment_.emplace_back(ring_, ring_.add(fmt::format("n_{}_{}", point.identifier, axis)));
    }
  }
  const auto convert = [this](const Real& value) {
    return Expanded(ring_, ring_.constant(value));
  };
  constants_ = equations::constants_of<Expanded>(tree, points, convert);
  gravity_ = equations::vector3<Expanded>(gravity, convert);
  equations::compute_poses<Expanded>(constants_, {sine_, cosine_, position_}, poses_);
}

void Expansion::add_joint(const model::Link& link) {
  const std::string& name = link.joint.identifier;
  if (link.joint.type == model::JointType::kPrismatic) {
    sine_.emplace_back(0);
    cosine_.emplace_back(0);
    position_.emplace_back(ring_, ring_.add("q_" + name));
    return;
  }
  const GiNaC::ex c = ring_.add("c_" + name);
  cosine_.emplace_back(ring_, c);
  sine_.emplace_back(ring_, ring_.add("s_" + name, 1 - c * c));
  position_.emplace_back(0);
}

void Expansion::write_leaves(block::Evaluation<Expanded>& evaluation) const {
  equations::LeafWriter<Expanded>(evaluation).write(constants_, poses_);
  copy(rate_, evaluation.leaf("q̇"));
  copy(rate_, evaluation.leaf("q̇^d"));
  copy(acceleration_, evaluation.leaf("q̈"));
  copy(force_, evaluation.leaf("f_b"));
  copy(moment_, evaluation.leaf("n_b"));
  std::vector<Expanded> masses;
  std::vector<Expanded> gravities;
  for (const auto& link : constants_.links) {
    masses.push_back(link.mass);
    gravities.insert(gravities.end(), gravity_.data(), gravity_.data() + 3);
  }
  copy(masses, evaluation.leaf("m^d"));
  copy(gravities, evaluation.leaf("g"));
}

Entries Expansion::expand(const block::Expression& expression) const {
  block::Plan plan(index_);
  const int result = plan.add(expression);
  block::Evaluation<Expanded> evaluation(plan);
  write_leaves(evaluation);
  evaluation.run(plan.needed({result}));
  const block::Pattern& blocks = plan.step(result).pattern;
  Entries entries;
  entries.rows = blocks.rows() * expression.shape().rows.size;
  entries.cols = blocks.cols() * expression.shape().cols.size;
  entries.values.resize(to_index(entries.rows) * to_index(entries.cols));
  evaluation.write(result, expression.shape(), entries.values);
  return entries;
}

}  // namespace treedyn::expansion
