#include "cli/model_facts.hpp"

#include "block/pattern.hpp"
#include "common/identifier.hpp"
#include "equations/kinematics.hpp"
#include "stages/stages.hpp"

namespace treedyn {

std::vector<std::string> reachability_rows(const model::Tree& tree) {
  std::vector<std::string> rows =
      split(block::to_text(block::reachability(equations::index_of(tree, {}))), '\n');
  rows.resize(tree.links.size());
  return rows;
}

Real total_mass(const model::Tree& tree) {
  Real sum = 0;
  for (const model::Link& link : tree.links) {
    sum += link.inertia.mass;
  }
  return sum;
}

std::vector<Priced> priced(const Model& model, const Request& request,
                           const program::Programs& programs) {
  std::vector<Priced> result;
  if (programs.update) {
    const program::Function& update = *programs.update;
    result.push_back({update.signature, program::cost(update)});
  }
  emit::each_cost(
      programs,
      request.checked ? checked_siblings(model, programs.functions) : std::vector<emit::Checked>(),
      [&](const program::Signature& signature, const program::Cost& cost) {
        result.push_back({signature, cost});
      });
  return result;
}

}  // namespace treedyn
