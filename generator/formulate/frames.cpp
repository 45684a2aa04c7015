#include "formulate/frames.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "formulate/placed_frames.hpp"
#include "formulate/regrouping.hpp"

namespace treedyn::formulate {

namespace {

/// Of trees with frames that are kept.
constexpr std::size_t kMostLinksKept = 512;

/// A rotation whose third column is `axis`; a relabelling of axes if `axis` is one of them.
Matrix3 frame_with_z(const Vector3& axis) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (identical(abs(axis[k]), 1)) {
      const bool negative = axis[k] < 0;
      Matrix3 relabel{};
      relabel[3 * ((k + 1) % 3) + (negative ? 1 : 0)] = 1;
      relabel[3 * ((k + 2) % 3) + (negative ? 0 : 1)] = 1;
      relabel[3 * k + 2] = negative ? -1 : 1;
      return relabel;
    }
  }
  const auto largest = static_cast<std::size_t>(
      std::ranges::max_element(axis, [](const Real& a, const Real& b) { return abs(a) < abs(b); }) -
      axis.begin());
  Vector3 helper{};
  helper[(largest + 1) % 3] = 1;
  Vector3 x = cross(helper, axis);
  x = Real(1 / sqrt(dot(x, x))) * x;
  const Vector3 y = cross(axis, x);
  return {x[0], y[0], axis[0], x[1], y[1], axis[1], x[2], y[2], axis[2]};
}

/// Frames at the joints.
NormalTree at_joints(const model::Tree& tree, const Vector3& gravity) {
  NormalTree result;
  result.gravity = gravity;
  std::vector<Matrix3> frame;  // normal frame -> original link frame
  for (int i = 0; i < tree.size(); ++i) {
    const model::Link& source = tree.links[to_index(i)];
    NormalLink made;
    made.father = source.father;
    made.revolute = source.joint.turns();
    const Matrix3 p = frame_with_z(source.joint.axis);
    const bool root = source.father == model::kGround;
    const Matrix3 father = root ? identity() : frame[to_index(source.father)];
    made.rotation = clean(multiply(multiply(transpose(father), source.joint.rotation), p));
    made.offset = multiply_transposed(father, source.joint.offset);
    made.mass = source.inertia.mass;
    made.moment = multiply_transposed(p, source.inertia.mass * source.inertia.com);
    const Vector3& com = source.inertia.com;
    made.pseudo = congruence(transpose(p), second_moments(source.inertia.about_com) +
                                               source.inertia.mass * outer(com, com));
    made.to_normal = transpose(p);
    frame.push_back(p);
    if (!root) {
      result.links[to_index(source.father)].sons.push_back(i);
    }
    result.links.push_back(made);
  }
  return result;
}

void scale_lengths(NormalTree& tree, const Real& unit) {
  tree.unit = unit;
  tree.gravity = Real(1 / unit) * tree.gravity;
  for (NormalLink& l : tree.links) {
    l.offset = Real(1 / unit) * l.offset;
    l.moment = unit * l.moment;
    l.mass *= unit * unit;
  }
}

}  // namespace

NormalForms::NormalForms(const model::Tree& tree, const Vector3& gravity,
                         const std::vector<LimbLinks>& limbs)
    : model_(tree), limbs_(limbs), start_(at_joints(tree, gravity)) {}

const NormalTree& NormalForms::placed(const Variant& variant) {
  Places places;
  for (const LinkVariant& link : variant.links) {
    places.emplace_back(link.slide, link.angle);
  }
  const auto known = placed_.find(places);
  if (known != placed_.end()) {
    return known->second;
  }
  if (placed_.size() * start_.links.size() > kMostLinksKept) {
    placed_.clear();
  }
  return placed_.emplace(std::move(places), with_placed_frames(start_, variant, limbs_))
      .first->second;
}

NormalTree NormalForms::of(const Variant& variant) {
  NormalTree tree = placed(variant);
  if (variant.unit_length > 0) {
    lengths_ = lengths_ ? std::move(lengths_) : unit_lengths(model_);
    scale_lengths(tree, (*lengths_)[to_index(variant.unit_length - 1)].metres);
  }
  for (int i = static_cast<int>(tree.links.size()) - 1; i >= 0; --i) {
    regroup(tree, i, variant.links[to_index(i)]);
  }
  clean_constants(tree);
  return tree;
}

UnitLengths unit_lengths(const model::Tree& tree) {
  UnitLengths lengths;
  for (const model::Link& link : tree.links) {
    if (link.joint.type == model::JointType::kPrismatic) {
      return {};
    }
  }
  const NormalTree normal = normal_form(tree, {}, plain_variant(tree));
  for (std::size_t i = 0; i < normal.links.size(); ++i) {
    for (const Real& component : normal.links[i].offset) {
      const Real length = abs(component);
      const bool known = std::ranges::any_of(lengths, [&](const auto& other) {
        return abs(other.metres - length) < Real("1e-9") * length;
      });
      if (length > Real("1e-9") && length.recipe() == 0 && !known) {
        lengths.push_back({length, static_cast<int>(i)});
      }
    }
  }
  std::ranges::sort(lengths, {}, &program::LengthUnit::metres);
  return lengths;
}

program::LengthUnit unit_of(const model::Tree& tree, const Variant& variant) {
  return variant.unit_length == 0 ? program::LengthUnit{}
                                  : unit_lengths(tree)[to_index(variant.unit_length - 1)];
}

namespace {

/// True if the axes of joints 0..5 are along those of the base's links, the sliding ones at right
/// angles, the turning ones each at a right angle to the next.
bool has_right_angles(const model::Tree& tree) {
  const auto is_quarter = [](const Real& x) {
    return identical(abs(x), 0) || identical(abs(x), 1);
  };
  Matrix3 R = identity();
  std::array<Vector3, 6> axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const model::Joint& joint = tree.links[i].joint;
    R = i == 0 ? R : multiply(R, joint.rotation);
    axes[i] = multiply(R, joint.axis);
    if (!std::ranges::all_of(axes[i], is_quarter) || !std::ranges::all_of(R, is_quarter)) {
      return false;
    }
  }
  const auto right = [&](std::size_t i, std::size_t k) {
    return identical(dot(axes[i], axes[k]), 0);
  };
  return right(0, 1) && right(0, 2) && right(1, 2) && right(3, 4) && right(4, 5);
}

}  // namespace

bool has_trunk(const model::Tree& tree) { return has_free_base(tree) && has_right_angles(tree); }

}  // namespace treedyn::formulate
