// Formulates the functions of a scene one by one, with the gates between their parts.
#pragma once

#include <vector>

#include "formulate/functions.hpp"
#include "formulate/scene_names.hpp"
#include "formulate/scene_phases.hpp"
#include "formulate/scene_rank.hpp"
#include "formulate/stand_ins.hpp"
#include "model/scene.hpp"
#include "program/staged.hpp"

namespace treedyn::formulate {

/// One scene and how hard to look for cheap formulations.
class SceneFormulator {
 public:
  SceneFormulator(const model::Scene& scene, const Options& options);

  /// Its numbers are seen as stand-ins.
  [[nodiscard]] const model::Scene& scene() const { return scene_; }
  [[nodiscard]] int rows() const;

  /// J^T and gamma of all rows.
  [[nodiscard]] program::Function jacobian() const;
  [[nodiscard]] program::Function bias() const;

  [[nodiscard]] program::Staged constrained_dynamics(const PhaseState& state) const;
  [[nodiscard]] program::Staged inverse_dynamics(const PhaseState& state) const;
  [[nodiscard]] program::Staged impact(const ImpactName& impact) const;
  /// What a closed contact does to the joint forces.
  [[nodiscard]] program::Staged contact_press(std::size_t contact) const;
  [[nodiscard]] program::Staged contact_force(std::size_t contact) const;

 private:
  static void add_forces(const PhaseState& state, program::Staged& staged);
  static void add_input(const program::Array& input, program::Staged& staged);
  static void add_rows(int rows, program::Signature& inner);
  void add_places(const std::vector<int>& active, program::Staged& staged) const;
  /// \param joints  whose columns of J the rows of K stand for; empty: K stands for rows of J
  [[nodiscard]] program::RowSolve solve_of(const program::Function& function, int rows,
                                           const std::vector<int>& constraints,
                                           const std::vector<int>& joints = {}) const;
  void add_contacts(program::Staged& staged) const;
  void add_depths(program::Signature& inner) const;
  void add_least_reactions(const std::vector<int>& active, program::Staged& staged) const;
  void add_power(std::size_t contact, std::size_t gate, program::Staged& staged) const;
  [[nodiscard]] program::Array q() const;
  [[nodiscard]] program::Array qd() const;
  [[nodiscard]] program::Array anchor() const;
  [[nodiscard]] Inputs places() const;
  [[nodiscard]] program::Function plain(const program::Signature& signature,
                                        std::vector<Expr> (*build)(const Task& task)) const;

  const Seen seen_;
  const model::Scene& scene_;
  const model::Tree tree_;  ///< in its unit of mass
  Options options_;
  int dof_;
  ScenePositions positions_;
  std::vector<int> all_;
};

}  // namespace treedyn::formulate
