// The tree and its state as leaves of a plan.
#pragma once

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "block/evaluate.hpp"
#include "engine/coordinates.hpp"
#include "equations/kinematics.hpp"

namespace treedyn::engine {

/// Writes masses and gravity at once, and what a state decides when it is set. Allocates in the
/// constructor alone.
template <class Scalar>
class TreeLeaves {
 public:
  /// \pre `evaluation` outlives this object
  TreeLeaves(const model::Tree& tree, std::span<const model::Point> points,
             const model::Vector3& gravity, block::Evaluation<Scalar>& evaluation)
      : evaluation_(evaluation),
        coordinates_(tree, convert),
        constants_(equations::constants_of<Scalar>(tree, points, convert)),
        writer_(evaluation),
        poses_(tree.links.size()),
        sine_(tree.links.size()),
        cosine_(tree.links.size()),
        q_(tree.links.size()) {
    const std::span<Scalar> mass = evaluation.leaf("m^d");
    const std::span<Scalar> g = evaluation.leaf("g");
    for (std::size_t i = 0; i < mass.size(); ++i) {
      mass[i] = constants_.links[i].mass;
    }
    for (std::size_t k = 0; k < g.size(); ++k) {
      g[k] = convert(gravity[k % 3]);
    }
  }

  static Scalar convert(const Real& x) { return static_cast<Scalar>(x); }

  [[nodiscard]] const Coordinates<Scalar>& coordinates() const { return coordinates_; }
  [[nodiscard]] const equations::Constants<Scalar>& constants() const { return constants_; }
  [[nodiscard]] const equations::Poses<Scalar>& poses() const { return poses_; }

  /// \param u  independent coordinates: `q`, `qd` or `qdd`
  /// \return false for any other name
  bool set(std::string_view name, std::span<const Scalar> u) {
    if (name == "q") {
      set_positions(u);
    } else if (name == "qd") {
      set_rates("q̇", u);
      set_rates("q̇^d", u);
    } else if (name == "qdd") {
      set_rates("q̈", u);
    } else {
      return false;
    }
    return true;
  }

 private:
  void set_rates(const char* name, std::span<const Scalar> u) {
    const std::span<Scalar> leaf = evaluation_.leaf(name);
    if (!leaf.empty()) {
      coordinates_.expand_rates(u, leaf);
    }
  }

  void set_positions(std::span<const Scalar> u) {
    using std::cos;
    using std::sin;
    coordinates_.expand_positions(u, q_);
    for (std::size_t i = 0; i < q_.size(); ++i) {
      if (constants_.links[i].revolute) {
        sine_[i] = sin(q_[i]);
        cosine_[i] = cos(q_[i]);
      }
    }
    equations::compute_poses<Scalar>(constants_, {sine_, cosine_, q_}, poses_);
    writer_.write(constants_, poses_);
  }

  block::Evaluation<Scalar>& evaluation_;
  Coordinates<Scalar> coordinates_;
  equations::Constants<Scalar> constants_;
  equations::LeafWriter<Scalar> writer_;
  equations::Poses<Scalar> poses_;
  std::vector<Scalar> sine_, cosine_, q_;
};

}  // namespace treedyn::engine
