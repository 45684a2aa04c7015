// Equations (2)-(11) for one tree as polynomials in sines, cosines, slides and rates of the joints.
#pragma once

#include <span>
#include <vector>

#include "block/block.hpp"
#include "common/index.hpp"
#include "equations/kinematics.hpp"
#include "expansion/expanded.hpp"
#include "expansion/ring.hpp"
#include "model/tree.hpp"

namespace treedyn::expansion {

/// A matrix of expanded entries, row-major.
struct Entries {
  int rows = 0;
  int cols = 0;
  std::vector<Expanded> values;
  [[nodiscard]] const Expanded& at(int i, int j) const {
    return values[to_index(i) * to_index(cols) + to_index(j)];
  }
};

/// The symbols of a tree, and the block expressions in them.
///
/// Variables: c_<joint>, s_<joint> with s^2 = 1 - c^2 for revolute, q_<joint> for prismatic joints;
/// qd_<joint>, qdd_<joint>; f_<point>_x.., n_<point>_x... Constants are exact (Ring::constant).
/// All joints count, also those that mimic others.
class Expansion {
 public:
  Expansion(const model::Tree& tree, std::span<const model::Point> points,
            const model::Vector3& gravity);
  Expansion(const Expansion&) = delete;  // its elements point to its ring
  Expansion& operator=(const Expansion&) = delete;
  Expansion(Expansion&&) = delete;
  Expansion& operator=(Expansion&&) = delete;
  ~Expansion() = default;

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const equations::Constants<Expanded>& constants() const { return constants_; }

  /// Sine and cosine (revolute; else 0), position (prismatic; else 0), rate of joint i.
  [[nodiscard]] const Expanded& sine(std::size_t i) const { return sine_[i]; }
  [[nodiscard]] const Expanded& cosine(std::size_t i) const { return cosine_[i]; }
  [[nodiscard]] const Expanded& position(std::size_t i) const { return position_[i]; }
  [[nodiscard]] const Expanded& rate(std::size_t i) const { return rate_[i]; }

  /// Acceleration of joint i; element k of the forces at the points, of the moments.
  [[nodiscard]] const Expanded& acceleration(std::size_t i) const { return acceleration_[i]; }
  [[nodiscard]] const Expanded& force(std::size_t k) const { return force_[k]; }
  [[nodiscard]] const Expanded& moment(std::size_t k) const { return moment_[k]; }

  /// Every entry of `expression`, in normal form; zero blocks are never computed.
  [[nodiscard]] Entries expand(const block::Expression& expression) const;

 private:
  void add_joint(const model::Link& link);
  void write_leaves(block::Evaluation<Expanded>& evaluation) const;

  Ring ring_;
  block::Index index_;
  equations::Constants<Expanded> constants_;
  equations::Vector3<Expanded> gravity_;
  std::vector<Expanded> sine_, cosine_, position_, rate_, acceleration_, force_, moment_;
  equations::Poses<Expanded> poses_;
};

}  // namespace treedyn::expansion
