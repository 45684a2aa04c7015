#include "emit/unit.hpp"

#include "emit/body.hpp"
#include "emit/header.hpp"
#include "emit/limb_text.hpp"
#include "emit/manifest.hpp"
#include "emit/source.hpp"
#include "emit/staged.hpp"

namespace treedyn::emit {

program::Cost total_cost(const Unit& unit) {
  program::Cost total;
  for (const program::Function& function : unit.functions) {
    total = total + program::cost(function);
  }
  for (const program::Staged& staged : unit.staged) {
    total = total + program::worst_cost(staged);
  }
  for (const program::Stepper& stepper : unit.steppers) {
    total = total + program::worst_step_cost(stepper);
  }
  return total;
}

std::vector<std::string> file_names(const std::string& name) {
  return {name + ".hpp", name + ".cpp", name + ".json"};
}

std::vector<File> emit_files(const Unit& unit) {
  const Vocabulary words = vocabulary(*unit.tree);
  std::vector<Body> bodies;
  bodies.reserve(unit.functions.size() + unit.staged.size());
  for (const program::Function& function : unit.functions) {
    bodies.push_back(function.limb_code ? limb_body(function, words, unit.target)
                                        : body(function, words, unit.target));
  }
  for (const program::Staged& staged : unit.staged) {
    bodies.push_back(staged_body(staged, words, unit.target));
  }
  const std::vector<std::string> names = file_names(unit.name);
  return {{names[0], header_text(unit)},
          {names[1], source_text(unit, bodies)},
          {names[2], manifest_text(unit, bodies)}};
}

}  // namespace treedyn::emit
