#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "description/vectors.hpp"
#include "engine/engine.hpp"
#include "engine/inertia_factor.hpp"
#include "program/interpret.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

/// Roundings of the largest inertia before a joint that its link's own has to exceed.
constexpr double kSafe = 1e3;
/// Part by which equal inertias differ by rounding.
constexpr double kSame = 1e-9;

/// What a link opposes to its own joint, kg m^2 or kg.
Real own_inertia(const model::Link& link) {
  using description::operator+;
  using description::operator*;
  const model::Inertia& inertia = link.inertia;
  if (link.joint.type == model::JointType::kPrismatic) {
    return inertia.mass;
  }
  const model::Matrix3 about_origin =
      inertia.about_com + description::point_inertia(inertia.mass, inertia.com);
  return description::dot(link.joint.axis, about_origin * link.joint.axis);
}

/// Inertias by coordinate at a state.
struct Inertias {
  std::vector<double> whole;   ///< the diagonal of A
  std::vector<double> pivots;  ///< Δ of A = L^T Δ L
};

using Matrix = engine::Engine<double>::Matrix;

std::vector<double> diagonal(const Matrix& A) {
  const auto all = A.diagonal();
  return {all.begin(), all.end()};
}

Inertias inertias(Matrix A) {
  Inertias result{diagonal(A), {}};
  engine::factorize(A);
  result.pivots = diagonal(A);
  return result;
}

/// The pivots of a model whose joints are looked at.
class Joints {
 public:
  Joints(const Model& model, emit::Scalar scalar);

  [[nodiscard]] bool all_safe() const { return std::ranges::all_of(safe_, std::identity()); }
  /// True if a pivot is a multiple of that of a safe joint. \param values  its, by state
  [[nodiscard]] bool is_safe(const std::vector<double>& values) const;
  [[nodiscard]] const std::vector<std::vector<double>>& states() const { return states_; }
  /// Revolute joints whose pivot may get lost, or their father's.
  [[nodiscard]] std::vector<int> turning() const;

 private:
  [[nodiscard]] bool is_multiple(const std::vector<double>& values, std::size_t joint) const;

  const model::Tree& tree_;
  std::vector<std::vector<double>> states_;
  std::vector<Inertias> inertias_;  ///< by state
  std::vector<bool> safe_;          ///< by coordinate
};

Joints::Joints(const Model& model, emit::Scalar scalar)
    : tree_(model.tree), states_(ordinary_states(model)) {
  const model::Tree& tree = model.tree;
  const auto n = to_index(tree.dof());
  std::vector<double> rotors(n, 0);
  for (const model::Armature& armature : model.scene->armatures) {
    rotors[to_index(armature.joint)] += static_cast<double>(armature.inertia);
  }
  engine::Engine<double> engine(tree);
  for (const std::vector<double>& q : states_) {
    Matrix A(tree.dof(), tree.dof());
    std::ranges::copy(engine.evaluate("mass_matrix", {q}), A.data());
    for (int k = 0; k < tree.dof(); ++k) {
      A(k, k) += rotors[to_index(k)];
    }
    inertias_.push_back(inertias(A));
  }
  const double rounding = kSafe * emit::pivot_rounding(tree.dof(), scalar);
  for (std::size_t k = 0; k < n; ++k) {
    const model::Link& link = tree.moved_by(static_cast<int>(k));
    const double own = static_cast<double>(own_inertia(link)) + rotors[k];
    safe_.push_back(tree.mimics() == 0 && std::ranges::all_of(inertias_, [&](const Inertias& at) {
                      return own > rounding * at.whole[k];
                    }));
  }
}

bool Joints::is_multiple(const std::vector<double>& values, std::size_t joint) const {
  const double factor = values.front() / inertias_.front().pivots[joint];
  for (std::size_t state = 0; state < values.size(); ++state) {
    const double expected = factor * inertias_[state].pivots[joint];
    if (!(std::fabs(values[state] - expected) <= kSame * std::fabs(expected))) {
      return false;
    }
  }
  return true;
}

bool Joints::is_safe(const std::vector<double>& values) const {
  for (std::size_t k = 0; k < safe_.size(); ++k) {
    if (safe_[k] && is_multiple(values, k)) {
      return true;
    }
  }
  return false;
}

std::vector<int> Joints::turning() const {
  std::vector<int> result;
  const auto is_free = [&](int link) {
    const auto k = to_index(tree_.drives[to_index(link)].coordinate);
    std::vector<double> pivots;
    for (const Inertias& at : inertias_) {
      pivots.push_back(at.pivots[k]);
    }
    return !safe_[k] && !is_safe(pivots);
  };
  for (int k = 0; k < tree_.dof(); ++k) {
    const int link = tree_.coordinates[to_index(k)];
    const model::Link& moved = tree_.links[to_index(link)];
    if (moved.joint.turns() &&
        (is_free(link) || (moved.father != model::kGround && is_free(moved.father)))) {
      result.push_back(k);
    }
  }
  return result;
}

/// By pivot and state. \param derived  nominal values
std::vector<std::vector<double>> values_of(const std::vector<program::Pivot>& pivots,
                                           const program::Function& function,
                                           const std::vector<std::vector<double>>& states,
                                           const std::vector<double>& derived) {
  program::Function divisors = function;
  divisors.limb_code = nullptr;
  divisors.outputs.clear();
  std::ranges::transform(pivots, std::back_inserter(divisors.outputs), &program::Pivot::value);
  std::vector<std::vector<double>> result(pivots.size());
  for (const std::vector<double>& q : states) {
    std::vector<std::vector<double>> inputs = {q};
    for (std::size_t k = 1; k < function.signature.inputs.size(); ++k) {
      const program::Array& array = function.signature.inputs[k];
      inputs.push_back(array.type.empty() ? std::vector<double>(to_index(array.size)) : derived);
    }
    const std::vector<std::span<const double>> spans(inputs.begin(), inputs.end());
    const std::vector<double> values = program::interpret<double>(divisors, spans);
    for (std::size_t k = 0; k < pivots.size(); ++k) {
      result[k].push_back(values[k]);
    }
  }
  return result;
}

void test_pivots(program::Staged& staged, const Joints& joints,
                 const std::vector<double>& derived) {
  if (joints.all_safe()) {
    return;
  }
  const std::vector<program::Pivot> pivots = program::pivots_of(staged.function, joints.states());
  const auto values = values_of(pivots, staged.function, joints.states(), derived);
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    if (!joints.is_safe(values[k])) {
      staged.pivots.push_back(pivots[k]);
    }
  }
  program::show_pivots(staged.function, staged.pivots);
}

}  // namespace

program::Programs with_tested_pivots(program::Programs programs, const Model& model,
                                     emit::Scalar scalar) {
  if (programs.staged.empty()) {
    return programs;
  }
  const Joints joints(model, scalar);
  const std::vector<double> derived = transformed(
      programs.derived, [&](const Real& number) { return number.convert_to<double>(); });
  for (program::Staged& staged : programs.staged) {
    test_pivots(staged, joints, derived);
  }
  for (program::Stepper& stepper : programs.steppers) {
    stepper.tests_pivots = std::ranges::any_of(
        programs.staged, [](const program::Staged& staged) { return !staged.pivots.empty(); });
    if (stepper.tests_pivots) {
      stepper.turning = joints.turning();
    }
  }
  return programs;
}

}  // namespace treedyn
