#include "formulate/frames.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "formulate/regrouping.hpp"

namespace treedyn::formulate {

namespace {

/// Squared sine of the angle between axes that count as parallel for the choice of origins: the
/// feet of their common normal are far away (1e12 m for the 1e-12 rad of a rounded right angle),
/// and inertias about them would cancel. Any slide is exact, so only the cost depends on this.
const Real kNearlyParallel("1e-6");

/// Of trees with frames that are kept.
constexpr std::size_t kMostLinksKept = 512;

/// The tree while frames are being chosen. Every operation changes the description, not the robot.
class Workbench {
 public:
  Workbench(NormalTree tree, const Variant& variant) : variant_(variant), tree_(std::move(tree)) {}
  NormalTree run(const std::vector<LimbLinks>& limbs);

 private:
  [[nodiscard]] std::size_t size() const { return tree_.links.size(); }
  NormalLink& link(int i) { return tree_.links[to_index(i)]; }
  [[nodiscard]] const LinkVariant& choice(int i) const { return variant_.links[to_index(i)]; }

  void turn_half(int i);
  void slide(int i, const Real& distance);
  void turn(int i, const Turn& turn);
  void align(const LimbLinks& limbs);
  void align(int i, const NormalLink& first);

  [[nodiscard]] std::optional<Real> slide_distance(int i);
  [[nodiscard]] Turn frame_turn(int i);
  [[nodiscard]] Turn turn_to_son(int i);

  const Variant& variant_;
  NormalTree tree_;
};

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

/// E = tr(J)/2 - J about the origin, from the tensor about the centre of mass.
Matrix3 pseudo_inertia(const model::Inertia& inertia) {
  const Matrix3& j = inertia.about_com;
  const Real half_trace = (j[0] + j[4] + j[8]) / 2;
  return half_trace * identity() - j + inertia.mass * outer(inertia.com, inertia.com);
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
    made.revolute = source.joint.type == model::JointType::kRevolute;
    const Matrix3 p = frame_with_z(source.joint.axis);
    const bool root = source.father == model::kGround;
    const Matrix3 father = root ? identity() : frame[to_index(source.father)];
    made.rotation = clean(multiply(multiply(transpose(father), source.joint.rotation), p));
    made.offset = multiply_transposed(father, source.joint.offset);
    made.mass = source.inertia.mass;
    made.moment = multiply_transposed(p, source.inertia.mass * source.inertia.com);
    made.pseudo = congruence(transpose(p), pseudo_inertia(source.inertia));
    made.to_normal = transpose(p);
    frame.push_back(p);
    if (!root) {
      result.links[to_index(source.father)].sons.push_back(i);
    }
    result.links.push_back(made);
  }
  return result;
}

/// Rotates the frame of link i by `t` about its own axis.
void Workbench::turn(int i, const Turn& t) {
  if (t.is_identity()) {
    return;
  }
  NormalLink& l = link(i);
  const Matrix3 q = about_z(t);
  l.rotation = clean(multiply(l.rotation, q));
  l.moment = multiply_transposed(q, l.moment);
  l.pseudo = congruence(transpose(q), l.pseudo);
  l.to_normal = clean(multiply(transpose(q), l.to_normal));
  for (const int son : l.sons) {
    link(son).rotation = clean(multiply(transpose(q), link(son).rotation));
    link(son).offset = multiply_transposed(q, link(son).offset);
  }
}

/// Turns the frame of link i by pi about x: its axis then points the other way.
void Workbench::turn_half(int i) {
  NormalLink& l = link(i);
  const Matrix3 q = {1, 0, 0, 0, -1, 0, 0, 0, -1};
  l.rotation = clean(multiply(l.rotation, q));
  l.moment = multiply(q, l.moment);
  l.pseudo = congruence(q, l.pseudo);
  l.to_normal = clean(multiply(q, l.to_normal));
  l.sign = -l.sign;
  for (const int son : l.sons) {
    link(son).rotation = clean(multiply(q, link(son).rotation));
    link(son).offset = multiply(q, link(son).offset);
  }
}

/// Moves the origin of revolute link i by `distance` along its axis.
void Workbench::slide(int i, const Real& distance) {
  if (distance == 0) {
    return;
  }
  NormalLink& l = link(i);
  const Vector3 z = {l.rotation[2], l.rotation[5], l.rotation[8]};
  l.offset = l.offset + distance * z;
  const Vector3 r = {0, 0, -distance};  // the old origin seen from the new one
  l.origin = l.origin + multiply_transposed(l.to_normal, Vector3{0, 0, distance});
  l.pseudo = l.pseudo + outer(r, l.moment) + outer(l.moment, r) + l.mass * outer(r, r);
  l.moment = l.moment + l.mass * r;
  for (const int son : l.sons) {
    link(son).offset = link(son).offset + r;
  }
}

bool is_nearly_parallel(const Real& sine2) {
  return sine2 < kNearlyParallel || sine2.plain() < kNearlyParallel;
}

/// Distance along z_i to the foot of the common normal with the father's axis.
Real foot_to_father(const NormalLink& l) {
  const Vector3 z = {l.rotation[2], l.rotation[5], l.rotation[8]};
  const Real sine2 = z[0] * z[0] + z[1] * z[1];
  if (is_nearly_parallel(sine2)) {
    return -l.offset[2] / z[2];
  }
  return -(l.offset[0] * z[0] + l.offset[1] * z[1]) / sine2;
}

/// Distance along the father's z axis to the foot of the common normal with the axis of its son
/// `l`.
Real foot_on_father(const NormalLink& l) {
  const Vector3 z = {l.rotation[2], l.rotation[5], l.rotation[8]};
  const Real sine2 = z[0] * z[0] + z[1] * z[1];
  return is_nearly_parallel(sine2) ? l.offset[2] : l.offset[2] + foot_to_father(l) * z[2];
}

std::optional<Real> Workbench::slide_distance(int i) {
  const NormalLink& l = link(i);
  const bool root = l.father == model::kGround;
  Slide slide = choice(i).slide;
  if (slide == Slide::kAuto) {
    const bool massless_inside = l.mass == 0 && !l.sons.empty();
    slide = root ? Slide::kSon : massless_inside ? Slide::kNone : Slide::kFather;
  }
  if (slide == Slide::kFather && !root) {
    return foot_to_father(l);
  }
  if (slide == Slide::kSon && !l.sons.empty()) {
    return foot_on_father(link(l.sons.front()));
  }
  return std::nullopt;
}

/// x along the common normal with the first son's axis (parallel axes: towards its origin).
Turn Workbench::turn_to_son(int i) {
  const NormalLink& son = link(link(i).sons.front());
  const EulerZxz euler = euler_zxz(son.rotation);
  if (euler.alpha.s != 0) {
    return euler.gamma;
  }
  const std::array<Real, 2> across = {son.offset[0], son.offset[1]};
  return is_fixed(across) ? turn_to(across[0], across[1]) : Turn{};
}

Turn Workbench::frame_turn(int i) {
  const NormalLink& l = link(i);
  FrameAngle angle = choice(i).angle;
  if (angle == FrameAngle::kAuto) {
    if (!l.sons.empty()) {
      return turn_to_son(i);
    }
    angle = FrameAngle::kFirstMoment;
  }
  const Matrix3& e = l.pseudo;
  if (angle == FrameAngle::kFirstMoment ? !is_fixed(l.moment) : !is_fixed(e)) {
    return {};  // what a turn makes zero would not stay so
  }
  switch (angle) {
    case FrameAngle::kKeep:
      return {};
    case FrameAngle::kFirstMoment:
      return turn_to(l.moment[0], l.moment[1]);
    case FrameAngle::kProductXy: {
      const Turn twice = turn_to(e[0] - e[4], 2 * e[1]);
      return turn_by(angle_of(twice) / 2);
    }
    default:
      return turn_to(e[2], e[5]);
  }
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

/// Constants of a link that are equal in the link of another limb; those of rotations count most.
int equal_constants(const NormalLink& a, const NormalLink& b) {
  constexpr int kRotationWeight = 100;
  int count = 0;
  const auto compare = [&](const auto& x, const auto& y, int weight) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      count += identical(x[k], y[k]) ? weight : 0;
    }
  };
  compare(a.rotation, b.rotation, kRotationWeight);
  compare(a.offset, b.offset, 1);
  compare(a.moment, b.moment, 1);
  compare(a.pseudo, b.pseudo, 1);
  return count;
}

/// Of the four frames that half turns make of the frame of link i, the one most like `first`.
void Workbench::align(int i, const NormalLink& first) {
  const Turn half = {-1, 0};
  const auto step = [&](int k) {
    k % 2 == 0 ? turn(i, half) : turn_half(i);
  };
  int best = 0;
  int most = equal_constants(link(i), first);
  for (int k = 0; k < 4; ++k) {
    step(k);
    if (const int count = equal_constants(link(i), first); k < 3 && count > most) {
      most = count;
      best = k + 1;
    }
  }
  for (int k = 0; k < best; ++k) {
    step(k);
  }
}

void Workbench::align(const LimbLinks& limbs) {
  for (std::size_t limb = 1; limb < limbs.size(); ++limb) {
    for (std::size_t p = 0; p < limbs[limb].size(); ++p) {  // fathers first
      const int i = limbs[limb][p];
      const NormalLink& first = link(limbs[0][p]);
      align(i, first);
      link(i).coordinate_sign = link(i).sign * first.sign;
      link(i).sign = first.sign;
    }
  }
}

NormalTree Workbench::run(const std::vector<LimbLinks>& limbs) {
  const int n = static_cast<int>(size());
  for (int i = 0; i < n; ++i) {
    if (link(i).father != model::kGround && link(i).rotation[8] == -1) {
      turn_half(i);
    }
  }
  for (int i = 0; i < n; ++i) {
    if (link(i).revolute) {
      if (const std::optional<Real> distance = slide_distance(i)) {
        slide(i, *distance);
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    if (link(i).revolute) {
      turn(i, with_right_angles(frame_turn(i)));  // any turn is exact
    }
  }
  for (const LimbLinks& of_class : limbs) {
    align(of_class);
  }
  clean_constants(tree_);
  for (NormalLink& l : tree_.links) {
    l.euler = euler_zxz(l.rotation);
  }
  return std::move(tree_);
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
  return placed_.emplace(std::move(places), Workbench(start_, variant).run(limbs_)).first->second;
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
  Variant plain;
  plain.links.resize(tree.links.size());
  const NormalTree normal = normal_form(tree, {}, plain);
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
