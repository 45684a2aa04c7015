#include "formulate/placed_frames.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/regrouping.hpp"

namespace treedyn::formulate {

namespace {

/// Squared sine of the angle between axes that count as parallel for the choice of origins: the
/// feet of their common normal are far away (1e12 m for the 1e-12 rad of a rounded right angle),
/// and inertias about them would cancel. Any slide is exact, so only the cost depends on this.
const Real kNearlyParallel("1e-6");
/// Of links with more sons only so many are asked where the frame should be turned to.
constexpr std::size_t kMostSonsAsked = 8;

/// The tree while frames are being chosen. Every operation changes the description, not the robot.
class Workbench {
 public:
  Workbench(NormalTree tree, const Variant& variant) : variant_(variant), tree_(std::move(tree)) {}
  NormalTree run(const std::vector<LimbLinks>& limbs);

 private:
  [[nodiscard]] std::size_t size() const { return tree_.links.size(); }
  NormalLink& link(int i) { return tree_.links[to_index(i)]; }
  [[nodiscard]] const LinkVariant& choice(int i) const { return variant_.links[to_index(i)]; }

  void rotate(int i, const Matrix3& q);
  void turn_half(int i);
  void slide(int i, const Real& distance);
  void turn(int i, const Turn& turn);
  void align(const LimbLinks& limbs);
  void align(int i, const NormalLink& first);

  [[nodiscard]] Real foot_of_most_sons(int i);
  [[nodiscard]] std::optional<Real> slide_distance(int i);
  [[nodiscard]] Turn frame_turn(int i);
  [[nodiscard]] int plain_constants(int i, const Turn& turn, const std::vector<EulerZxz>& angles);
  [[nodiscard]] Turn turn_to_son(int i);

  const Variant& variant_;
  NormalTree tree_;
};

void Workbench::rotate(int i, const Matrix3& q) {
  NormalLink& l = link(i);
  l.rotation = clean(multiply(l.rotation, q));
  l.moment = multiply_transposed(q, l.moment);
  l.pseudo = congruence(transpose(q), l.pseudo);
  l.to_normal = clean(multiply(transpose(q), l.to_normal));
  for (const int son : l.sons) {
    link(son).rotation = clean(multiply(transpose(q), link(son).rotation));
    link(son).offset = multiply_transposed(q, link(son).offset);
  }
}

/// Rotates the frame of link i by `t` about its own axis.
void Workbench::turn(int i, const Turn& t) {
  if (!t.is_identity()) {
    rotate(i, about_z(t));
  }
}

/// Turns the frame of link i by pi about x: its axis then points the other way.
void Workbench::turn_half(int i) {
  rotate(i, {1, 0, 0, 0, -1, 0, 0, 0, -1});
  link(i).sign = -link(i).sign;
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

/// The first one among equals.
Real Workbench::foot_of_most_sons(int i) {
  const std::vector<int>& sons = link(i).sons;
  const std::vector<Real> feet =
      transformed<Real>(sons, [this](int son) { return foot_on_father(link(son)); });
  const auto count = [&](const Real& foot) {
    return std::ranges::count_if(feet, [&](const Real& x) { return identical(x, foot); });
  };
  return *std::ranges::max_element(feet, {}, count);
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
    return foot_of_most_sons(i);
  }
  return std::nullopt;
}

/// x along the common normal with a son's axis (parallel axes: towards its origin).
Turn turn_towards(const NormalLink& son, const EulerZxz& euler) {
  if (euler.alpha.s != 0) {
    return euler.gamma;
  }
  const std::array<Real, 2> across = {son.offset[0], son.offset[1]};
  return is_fixed(across) ? turn_to(across[0], across[1]) : Turn{};
}

int zeros_across(const Vector3& v) {
  return static_cast<int>(identical(v[0], 0)) + static_cast<int>(identical(v[1], 0));
}

/// What a turn of the frame of link i makes zero or a right angle.
/// \param angles  of its sons
int Workbench::plain_constants(int i, const Turn& t, const std::vector<EulerZxz>& angles) {
  constexpr int kTurnWeight = 4;
  const Matrix3 q = about_z(t);
  int count = zeros_across(multiply_transposed(q, link(i).moment));
  for (std::size_t k = 0; k < angles.size(); ++k) {
    count += zeros_across(multiply_transposed(q, link(link(i).sons[k]).offset));
    count += (t.inverse() * angles[k].gamma).is_quarter() ? kTurnWeight : 0;
  }
  return count;
}

/// Towards the son whose turn leaves the plainest constants, the first one among equals. O(sons)
Turn Workbench::turn_to_son(int i) {
  const std::vector<int>& sons = link(i).sons;
  const std::vector<EulerZxz> angles =
      transformed<EulerZxz>(sons, [this](int son) { return euler_zxz(link(son).rotation); });
  const std::size_t asked = std::min(sons.size(), kMostSonsAsked);
  std::vector<Turn> turns;
  std::vector<int> counts;
  for (std::size_t k = 0; k < asked; ++k) {
    turns.push_back(turn_towards(link(sons[k]), angles[k]));
    counts.push_back(asked > 1 ? plain_constants(i, turns.back(), angles) : 0);
  }
  return turns[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
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

NormalTree with_placed_frames(NormalTree tree, const Variant& variant,
                              const std::vector<LimbLinks>& limbs) {
  return Workbench(std::move(tree), variant).run(limbs);
}

}  // namespace treedyn::formulate
