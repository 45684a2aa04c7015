#include "cli/model_facts.hpp"

#include "block/pattern.hpp"
#include "common/identifier.hpp"
#include "stages/checked_siblings.hpp"

namespace treedyn {

bool is_revolute(const model::Link& link) { return link.joint.type == model::JointType::kRevolute; }

std::vector<std::string> reachability_rows(const model::Tree& tree) {
  block::Index index;
  for (const model::Link& link : tree.links) {
    index.father.push_back(link.father);
    index.revolute.push_back(is_revolute(link));
  }
  std::vector<std::string> rows = split(block::to_text(block::reachability(index)), '\n');
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
  for (const program::Function& function : programs.functions) {
    result.push_back({function.signature, program::cost(function)});
  }
  if (request.checked) {
    for (const emit::Checked& checked : checked_siblings(model, programs.functions)) {
      result.push_back({checked.signature, emit::cost(checked)});
    }
  }
  for (const program::Staged& staged : programs.staged) {
    result.push_back({staged.signature, program::cost(staged)});
  }
  for (const program::Stepper& stepper : programs.steppers) {
    result.push_back({stepper.signature, program::step_cost(stepper)});
  }
  return result;
}

}  // namespace treedyn
