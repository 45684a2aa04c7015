#include "formulate/trunk.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "common/index.hpp"
#include "formulate/derived.hpp"

namespace treedyn::formulate {
namespace {

/// x of M x = v, row by row: each has one unknown left.
Vec3 substituted(Graph& graph, const Mat3& M, Vec3 v, int body) {
  Vec3 x;
  std::array<bool, kSize> known{};
  const auto is_left = [&](const Vec3& row, std::size_t k) {
    return !known[k] && !row[k].is_zero();
  };
  for (std::size_t n = 0; n < kSize; ++n) {
    std::size_t row = 0;
    std::size_t k = kSize;
    for (std::size_t r = 0; r < kSize; ++r) {
      const auto left = [&](std::size_t c) {
        return is_left(M[r], c);
      };
      if (left(0) + left(1) + left(2) == 1) {
        row = r;
        k = left(0) ? 0 : left(1) ? 1 : 2;
      }
    }
    TREEDYN_EXPECT(k < kSize);
    const Expr inverse = constant(graph, Real(1)) / M[row][k];
    graph.name(inverse.ref(), "inverse_cosine", body);
    x[k] = v[row] * inverse;
    known[k] = true;
    for (std::size_t r = 0; r < kSize; ++r) {
      v[r] -= M[r][k] * x[k];
    }
  }
  return x;
}

Vec3 taken(const std::vector<Expr>& x, int first) {
  return {x[to_index(first)], x[to_index(first + 1)], x[to_index(first + 2)]};
}

void put(const Vec3& v, int first, std::vector<Expr>& x) {
  std::ranges::copy(v, x.begin() + first);
}

}  // namespace

Trunk::Trunk(const Task& task, Way way)
    : task_(task),
      k_(task.kinematics),
      triads_{triad(0, 2, way), triad(3, 4, Way::kToRoot)},
      kinematics_(from_trunk()),
      seen_{task.tree, task.normal, task.options, kinematics_} {}

Trunk::Triad Trunk::triad(int first, int frame, Way way) const {
  k_.graph().set_body(frame);
  Triad result{first, frame, FrameChanges(k_, way), {}};
  for (int k = 0; k < 3; ++k) {
    const int joint = first + k;
    const Vec3 z = {Expr(), Expr(), constant(k_.graph(), Real(k_.link(joint).sign))};
    result.axes[to_index(k)] = result.frames.moved(z, joint, frame);
  }
  return result;
}

/// The ground turns like the trunk.
Kinematics Trunk::from_trunk() const {
  k_.graph().set_body(kTrunkLink);
  std::vector<Expr> speeds;
  for (int i = 0; i <= kTrunkLink; ++i) {
    speeds.push_back(k_.of_joint(i, k_.inputs().qd));
  }
  const Vec3 omega = along_axes(triads_[1], speeds);
  name(k_.graph(), omega, "omega", kTrunkLink);
  return k_.from_trunk(omega);
}

/// The vector in the trunk's frame that the joints of a triad make up.
Vec3 Trunk::along_axes(const Triad& triad, const std::vector<Expr>& x) const {
  const Vec3 sum = transposed(triad.axes) * taken(x, triad.first);
  return triad.frames.moved(sum, triad.frame, kTrunkLink);
}

/// Components of a vector in the trunk's frame become values along the axes there, or the other way
/// round: axis i is z of link i, or -z.
Vec3 Trunk::with_signs(const Triad& triad, Vec3 v) const {
  for (int k = 0; k < 3; ++k) {
    v[to_index(k)] = k_.link(triad.first + k).sign > 0 ? v[to_index(k)] : -v[to_index(k)];
  }
  return v;
}

std::vector<Expr> Trunk::velocities(std::vector<Expr> qd) const {
  for (const Triad& triad : triads_) {
    put(with_signs(triad, along_axes(triad, qd)), triad.first, qd);
  }
  return qd;
}

std::vector<Expr> Trunk::forces(std::vector<Expr> tau) const {
  for (const Triad& triad : triads_) {
    const Vec3 f = substituted(k_.graph(), triad.axes, taken(tau, triad.first), triad.frame);
    put(with_signs(triad, triad.frames.moved(f, triad.frame, kTrunkLink)), triad.first, tau);
  }
  return tau;
}

/// B^-1 x, with what is added to it: a linear part in the frame of the triad, an angular one in the
/// trunk's.
std::vector<Expr> Trunk::to_joints(std::vector<Expr> x, const std::array<Vec3, 2>& more) const {
  k_.graph().set_body(kTrunkLink);
  for (const Triad& t : triads_) {
    const Vec3 own = with_signs(t, taken(x, t.first));
    const Vec3 sum = t.first == 0 ? t.frames.moved(own, kTrunkLink, t.frame) + more[0]
                                  : t.frames.moved(own + more[1], kTrunkLink, t.frame);
    put(substituted(k_.graph(), transposed(t.axes), sum, t.frame), t.first, x);
  }
  return x;
}

std::vector<Expr> Trunk::joint_velocities(std::vector<Expr> x) const {
  return to_joints(std::move(x), {});
}

std::vector<Expr> Trunk::joint_accelerations(std::vector<Expr> x) const {
  model::Point origin;
  origin.link = kTrunkLink;
  const std::vector<Expr> gamma =
      values_at(task_, "angular_bias_acceleration", {origin}, Way::kInLinks, kTrunkLink);
  const Triad& sliding = triads_[0];
  const Vec3 g = sliding.frames.moved(-k_.ground_acceleration(), kBase, sliding.frame);
  return to_joints(std::move(x), {g, -taken(gamma, 0)});
}

std::vector<std::pair<const char*, program::Cost>> trunk_lines(const model::Tree& tree,
                                                               const Options& options,
                                                               bool impact) {
  using Make = std::vector<Expr> (*)(const Trunk&, const std::vector<Expr>&);
  const auto cost = [&](Make make) {
    Recipe recipe = recipe_of("forward_dynamics");
    recipe.build = [make](const Task& task) {
      std::vector<Expr> x;
      for (int i = 0; i <= kTrunkLink; ++i) {
        x.push_back(task.kinematics.argument(task.kinematics.inputs().tau, i));
      }
      return make(Trunk(task), x);
    };
    return program::cost(build(tree, recipe, options, plain_variant(tree)));
  };
  if (impact) {
    return {
        {"v = B q̇ before the impact, of the trunk along its axes",
         cost([](const Trunk& trunk, const std::vector<Expr>& x) { return trunk.velocities(x); })},
        {"Δq̇ = B^-1 y, y = B Δq̇", cost([](const Trunk& trunk, const std::vector<Expr>& x) {
           return trunk.joint_velocities(x);
         })}};
  }
  const Make turning = [](const Trunk& trunk, const std::vector<Expr>&) {
    const Vec3& omega = trunk.seen().kinematics.ground_turning();
    return std::vector<Expr>(omega.begin(), omega.end());
  };
  return {{"ω = B q̇ of the trunk, in its frame", cost(turning)},
          {"f = B^-T τ, force and moment on it",
           cost([](const Trunk& trunk, const std::vector<Expr>& x) { return trunk.forces(x); })},
          {"q̈ = B^-1 (y - γ)", cost([](const Trunk& trunk, const std::vector<Expr>& x) {
             return trunk.joint_accelerations(x);
           })}};
}

}  // namespace treedyn::formulate
