#include "equations/table.hpp"
#include "model/reach.hpp"
#include "program/random.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

constexpr int kStates = 8;
/// Revolute joints turn by up to 3 rad, prismatic ones move by up to the size of the mechanism.
constexpr double kTurn = 3;

}  // namespace

std::vector<std::vector<double>> ordinary_states(const Model& model) {
  const std::vector<double> reach = model::reach_of(model.tree, model.points);
  program::Random random(5);
  std::vector<std::vector<double>> states(kStates);
  for (std::vector<double>& q : states) {
    for (int k = 0; k < model.tree.dof(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const bool turns = model.tree.moved_by(k).joint.turns();
      q.push_back((turns ? kTurn : reach[i]) * random.symmetric());
    }
  }
  return states;
}

std::vector<emit::Checked> checked_siblings(const Model& model,
                                            const std::vector<program::Function>& functions) {
  const std::vector<std::vector<double>> states = ordinary_states(model);
  std::vector<emit::Checked> result;
  for (const program::Function& function : functions) {
    if (equations::divides_by_pivots(function.signature.name)) {
      result.push_back(emit::checked_sibling(function, program::pivots_of(function, states)));
    }
  }
  return result;
}

}  // namespace treedyn
