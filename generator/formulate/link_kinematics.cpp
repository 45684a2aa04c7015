#include "formulate/link_kinematics.hpp"

#include <algorithm>

namespace treedyn::formulate {

namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr int kNoInput = -1;

/// A value after all rotations, the last one first.
template <class Value>
Value turned(const std::vector<PlaneRotation>& steps, Value value,
             Value (PlaneRotation::*turn)(const Value&) const) {
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    value = ((*step).*turn)(value);
  }
  return value;
}

}  // namespace

Kinematics::Kinematics(Graph& graph, const model::Tree& tree, const NormalTree& normal,
                       const Variant& variant, const Inputs& inputs, SharedLimbs* limbs)
    : graph_(graph),
      tree_(tree),
      normal_(normal),
      variant_(variant),
      inputs_(inputs),
      limbs_(limbs) {
  find_runs();
  place_frames();
  for (int i = 0; i < size(); ++i) {
    place_link(i);
  }
}

Expr Kinematics::of_joint(int i, int array) const {
  return array == kNoInput ? Expr()
                           : constant(graph_, multiplier(i)) *
                                 coordinate(array, tree_.drives[to_index(i)].coordinate);
}

Expr Kinematics::displacement(int i) const {
  if (is_from_trunk_ && i <= kTrunkLink) {
    return {};
  }
  const model::Drive& drive = tree_.drives[to_index(i)];
  const Expr q = constant(graph_, multiplier(i)) * coordinate(inputs_.q, drive.coordinate) +
                 constant(graph_, drive.offset);
  return link(i).sign > 0 ? q : -q;
}

Angle Kinematics::joint_angle(int i) const {
  if (!link(i).revolute) {
    return {};
  }
  const model::Drive& drive = tree_.drives[to_index(i)];
  const Turn offset = drive.offset == 0 ? Turn{} : turn_by(link(i).sign * drive.offset);
  const Real factor = multiplier(i);
  if (factor == 0) {
    return constant_angle(offset);
  }
  return {{{drive.coordinate, link(i).sign * factor}}, offset};
}

const Angle& Kinematics::own(int i, const std::vector<Angle>& angles) const {
  return is_of_limb(i) ? angles[to_index(limbs_->places[to_index(i)].limb)] : angles.front();
}

template <class Number>
Expr Kinematics::number_of(int i, const std::vector<Angle>& angles, Number number) const {
  std::vector<Real> values;
  std::ranges::transform(angles, std::back_inserter(values), number);
  return own(i, values);
}

CosineAndSine Kinematics::of_turn(int i, const std::vector<Angle>& angles) const {
  const Expr c = number_of(i, angles, [](const Angle& a) { return a.turn.c; });
  return {c, number_of(i, angles, [](const Angle& a) { return a.turn.s; })};
}

CosineAndSine Kinematics::of_sum(int i, const std::vector<Angle>& angles) const {
  const Angle& angle = own(i, angles);
  const int flip = angle.terms.front().second > 0 ? 1 : -1;  // first coefficient positive
  Expr sum;
  for (const auto& [k, coefficient] : angle.terms) {
    sum += constant(graph_, flip * coefficient) * coordinate(inputs_.q, k);
  }
  const bool is_quarter = same_quarter(angles);
  if (!is_quarter) {
    sum += number_of(i, angles, [flip](const Angle& a) { return Real(flip * angle_of(a.turn)); });
  }
  const Expr c(graph_, graph_.cos(sum.ref()));
  const Expr s(graph_, graph_.sin(sum.ref()));
  return quarter_turned({c, flip > 0 ? s : -s}, is_quarter ? angle.turn : Turn{});
}

CosineAndSine Kinematics::of_products(int i, const std::vector<Angle>& angles) const {
  const Angle& angle = own(i, angles);
  CosineAndSine result;
  for (auto term = angle.terms.begin(); term != angle.terms.end(); ++term) {
    const auto& [k, coefficient] = *term;
    const Expr x = constant(graph_, abs(coefficient)) * coordinate(inputs_.q, k);
    const Expr c(graph_, graph_.cos(x.ref()));
    const Expr s(graph_, graph_.sin(x.ref()));
    const CosineAndSine turn(c, coefficient > 0 ? s : -s);
    result = term == angle.terms.begin() ? turn : added(result, turn);
  }
  return same_quarter(angles) ? quarter_turned(result, angle.turn)
                              : added(result, of_turn(i, angles));
}

CosineAndSine Kinematics::cosine_and_sine(int i, const std::vector<Angle>& angles) const {
  if (own(i, angles).terms.empty()) {
    return of_turn(i, angles);
  }
  return variant_.add_angles ? of_sum(i, angles) : of_products(i, angles);
}

template <class AngleOf>
void Kinematics::append(std::vector<PlaneRotation>& steps, std::size_t axis, int i,
                        AngleOf angle) const {
  const std::vector<Angle> angles = of_peers(i, angle);
  const bool identity = std::ranges::all_of(
      angles, [](const Angle& a) { return a.terms.empty() && a.turn.is_identity(); });
  if (!identity) {
    const auto [c, s] = cosine_and_sine(i, angles);
    steps.push_back({axis, c, s});
  }
}

/// The axis is the father's, in the other limbs too.
bool Kinematics::is_parallel(int i) const {
  const std::vector<int> all = peers(i);
  return std::ranges::all_of(all, [&](int peer) { return link(peer).euler.alpha.is_identity(); });
}

void Kinematics::find_runs() {
  head_.assign(to_index(size()), -1);
  run_.resize(to_index(size()));
  std::vector<bool> continued(to_index(size()), false);
  for (int i = 0; i < size(); ++i) {
    const int f = link(i).father;
    if (!link(i).revolute) {
      continue;
    }
    const bool parallel = f != model::kGround && link(f).revolute && is_parallel(i);
    if (parallel && choice(i).merge_parallel && !continued[to_index(f)]) {
      continued[to_index(f)] = true;
      head_[to_index(i)] = head_[to_index(f)];
    } else {
      head_[to_index(i)] = i;
    }
    run_[to_index(head_[to_index(i)])].push_back(i);
  }
}

/// The frame of a run follows the first `cut` turns; the other links are turned against it by
/// frame_angle_.
void Kinematics::place_frames() {
  frame_angle_.resize(to_index(size()));
  run_angle_.resize(to_index(size()));
  for (int head = 0; head < size(); ++head) {
    const std::vector<int>& members = run_[to_index(head)];
    std::vector<Angle> cumulated = {Angle{}};
    for (const int i : members) {
      Angle angle = joint_angle(i) + constant_angle(link(i).euler.epsilon);
      if (i != head) {
        angle = angle + constant_angle(link(i).euler.gamma);
      }
      cumulated.push_back(cumulated.back() + angle);
    }
    const std::size_t cut = std::min<std::size_t>(choice(head).cut, members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
      frame_angle_[to_index(members[k])] = cumulated[k + 1] - cumulated[cut];
    }
    run_angle_[to_index(head)] = cumulated[cut];
  }
}

/// Turn of the father's expression frame against its normal frame.
Angle Kinematics::father_angle(int i) const {
  return link(i).father == model::kGround ? Angle{} : frame_angle_[to_index(link(i).father)];
}

/// Turns about z before and behind the one about x.
Angle Kinematics::first_angle(int i) const {
  return father_angle(i) + constant_angle(link(i).euler.gamma);
}
Angle Kinematics::last_angle(int i) const {
  return link(i).revolute ? run_angle_[to_index(i)] : constant_angle(link(i).euler.epsilon);
}

void Kinematics::place_link(int i) {
  const NormalLink& l = link(i);
  graph_.set_body(i);
  Vec3 s = own_vector(i, &NormalLink::offset);
  std::vector<PlaneRotation> to_frame;
  append(to_frame, kZ, i, [this](int k) { return father_angle(k); });
  for (const PlaneRotation& step : to_frame) {
    s = step.forward(s);
  }
  std::vector<PlaneRotation> steps;
  if (!shares_frame(i)) {
    if (is_parallel(i)) {
      append(steps, kZ, i, [this](int k) { return first_angle(k) + last_angle(k); });
    } else {
      append(steps, kZ, i, [this](int k) { return first_angle(k); });
      append(steps, kX, i, [this](int k) { return constant_angle(link(k).euler.alpha); });
      append(steps, kZ, i, [this](int k) { return last_angle(k); });
    }
  }
  rotations_.push_back(std::move(steps));
  joint_offset_.push_back(s);
  if (!l.revolute) {
    s = s + displacement(i) * axis_in_father(i);
  }
  name(graph_, s, "s", i);
  offset_.push_back(s);
}

Vec3 Kinematics::axis_in_father(int i) const {
  return to_father(i, {Expr(), Expr(), constant(graph_, Real(1))});
}

Vec3 Kinematics::to_father(int i, const Vec3& v) const {
  return turned(rotations_[to_index(i)], v, &PlaneRotation::forward);
}

Vec3 Kinematics::from_father(int i, Vec3 v) const {
  for (const PlaneRotation& step : rotations_[to_index(i)]) {
    v = step.backward(v);
  }
  return v;
}

Mat3 Kinematics::to_father_symmetric(int i, const Mat3& s) const {
  return turned(rotations_[to_index(i)], s, &PlaneRotation::forward_symmetric);
}

Mat3 Kinematics::to_father_general(int i, const Mat3& h) const {
  return turned(rotations_[to_index(i)], h, &PlaneRotation::forward_general);
}

Vec3 Kinematics::ground_acceleration() const {
  return is_from_trunk_ ? Vec3{} : -constant(graph_, normal_.gravity);
}

Kinematics Kinematics::with_forces(const std::vector<Expr>& forces) const {
  constexpr int kGiven = -2;
  Kinematics k = *this;
  k.inputs_.tau = inputs_.tau < 0 ? kGiven : inputs_.tau;
  k.forces_ = forces;
  return k;
}

Kinematics Kinematics::with_loads(const PointLoads& loads) const {
  Kinematics k = *this;
  k.loads_ = &loads;
  return k;
}

Kinematics Kinematics::from_trunk(const Vec3& omega) const {
  Kinematics k = *this;
  const Expr one = constant(graph_, Real(1));
  // x, y, z: z of link i is the next axis
  for (std::size_t i = 0; i <= to_index(kTrunkLink); ++i) {
    k.rotations_[i] = {{kZ, Expr(), one}, {kX, Expr(), one}};
    k.offset_[i] = k.joint_offset_[i] = {};
  }
  k.is_from_trunk_ = true;
  k.ground_turning_ = omega;
  return k;
}

std::vector<PlaneRotation> Kinematics::turn_of_frame(int i) const {
  std::vector<PlaneRotation> steps;
  append(steps, kZ, i, [this](int k) { return frame_angle_[to_index(k)]; });
  return steps;
}

Vec3 Kinematics::in_frame(int i, const Vec3& v) const {
  return turned(turn_of_frame(i), v, &PlaneRotation::forward);
}

Mat3 Kinematics::in_frame_symmetric(int i, const Mat3& m) const {
  return turned(turn_of_frame(i), m, &PlaneRotation::forward_symmetric);
}

const Kinematics::Body& Kinematics::body(int i) const {
  return written(i, bodies_, [](const NormalLink& l) { return l.pseudo; });
}

const Kinematics::Body& Kinematics::body_with_inertia_tensor(int i) const {
  return written(i, bodies_with_inertia_tensor_, [](const NormalLink& l) {
    const Matrix3& e = l.pseudo;
    return Real(e[0] + e[4] + e[8]) * identity() - e;
  });
}

const Kinematics::Body& Kinematics::written(int i, Bodies& bodies,
                                            Matrix3 (*tensor)(const NormalLink&)) const {
  const auto [place, is_new] = bodies.try_emplace(i);
  Body& body = place->second;
  if (is_new) {
    body.mass = own(i, of_peers(i, [this](int peer) { return link(peer).mass; }));
    body.moment = own_vector(i, &NormalLink::moment);
    body.tensor = own_matrix(i, tensor);
    for (const PlaneRotation& step : turn_of_frame(i)) {
      body.moment = step.forward(body.moment);
      body.tensor = step.forward_symmetric(body.tensor);
    }
  }
  return body;
}

Vec3 Kinematics::point(int i, const Vector3& at) const {
  const NormalLink& l = link(i);
  return in_frame(i,
                  constant(graph_, Real(1 / normal_.unit) * multiply(l.to_normal, at - l.origin)));
}

Mat3 Kinematics::tensor_of(int i, const Matrix3& of_model) const {
  return in_frame_symmetric(i, constant(graph_, congruence(link(i).to_normal, of_model)));
}

Mat3 Kinematics::orientation(int i) const {
  Mat3 m = own_matrix(i, [](const NormalLink& l) { return l.to_normal; });
  for (const PlaneRotation& step : turn_of_frame(i)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 v = step.forward(column(m, k));
      m[0][k] = v[0];
      m[1][k] = v[1];
      m[2][k] = v[2];
    }
  }
  return m;
}

}  // namespace treedyn::formulate
