#include "emit/stepper.hpp"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/parts.hpp"
#include "emit/staged.hpp"
#include "emit/step_events.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::StepMethod;
using program::Stepper;
using program::StepPhase;

namespace {

using Slots = std::map<std::string, std::string>;

/// Times of the later stages; nothing if nothing depends on time.
std::string times(const Stepper& stepper) {
  return stepper.takes_time ? "  const Scalar t_half[1] = {t[0] + half};\n"
                              "  const Scalar t_full[1] = {t[0] + h};"
                            : "";
}

void add_rk4_slots(const Stepper& stepper, Scalar scalar, Slots& slots) {
  const bool reacts = stepper.rows > 0;
  slots["half"] = literal(stepper.step / 2, scalar);
  slots["sixth"] = literal(stepper.step / 6, scalar);
  slots["times"] = times(stepper);
  slots["t_half"] = stepper.takes_time ? ", t_half" : "";
  slots["t_full"] = stepper.takes_time ? ", t_full" : "";
  slots["later_lambda"] = reacts ? fmt::format("  Scalar later[{}];", stepper.rows) : "";
  slots["later"] = reacts ? ", later" : "";
}

/// The dynamics of one phase: the call, and zeros for the reactions that it does not have.
std::vector<std::string> dynamics_lines(const Stepper& stepper, const StepPhase& phase) {
  std::vector<std::string> arguments = {"q", "qd", "tau"};
  if (phase.takes_time) {
    arguments.emplace_back("t");
  }
  if (phase.takes_anchor) {
    arguments.emplace_back("anchor");
  }
  arguments.emplace_back("qdd");
  if (phase.rows > 0) {
    arguments.emplace_back("lambda");
  }
  std::vector<std::string> lines = {declaration(phase.dynamics, arguments, ";")};
  for (int k = phase.rows; k < stepper.rows; ++k) {
    lines.push_back(fmt::format("lambda[{}] = Scalar(0);", k));
  }
  return lines;
}

/// Calls the dynamics of the phase that acts, of no other.
std::string dispatch(const Stepper& stepper) {
  const int n = stepper.signature.inputs.front().size;
  std::vector<std::string> parameters = {"int which", fmt::format("const Scalar q[{}]", n),
                                         fmt::format("const Scalar qd[{}]", n),
                                         fmt::format("const Scalar tau[{}]", n)};
  for (const program::Array& array : stepper.signature.inputs) {
    if (array.name == "t" || array.name == "anchor") {
      parameters.push_back(fmt::format("const Scalar {}[{}]", array.name, array.size));
    }
  }
  parameters.push_back(fmt::format("Scalar qdd[{}]", n));
  if (stepper.rows > 0) {
    parameters.push_back(fmt::format("Scalar lambda[{}]", stepper.rows));
  }
  std::vector<std::string> lines = {"switch (which) {"};
  for (std::size_t k = 0; k < stepper.phases.size(); ++k) {
    const StepPhase& phase = stepper.phases[k];
    const bool last = k + 1 == stepper.phases.size();
    lines.push_back(last ? "  default:" : fmt::format("  case phase::{}:", phase.identifier));
    for (const std::string& line : dynamics_lines(stepper, phase)) {
      lines.push_back("    " + line);
    }
    lines.emplace_back("    break;");
  }
  lines.emplace_back("}");
  return "\n/// Accelerations and reactions in a phase.\n" +
         declaration("void dynamics_in", parameters, " noexcept {") + block(lines);
}

/// What only `step` calls.
std::string local_text(const Stepper& stepper, const Vocabulary& words, const Target& target) {
  std::string result;
  for (const StepPhase& phase : stepper.phases) {
    result += local_functions(phase.guards, words, target);
    result += local_functions(phase.approaches, words, target);
  }
  result += local_functions(stepper.anchors, words, target);
  result += stepper.switches() ? dispatch(stepper) : "";
  return result.empty() ? result : "namespace {\n" + result + "\n}  // namespace\n\n";
}

}  // namespace

std::string stepper_text(const Stepper& stepper, const Vocabulary& words, const Target& target) {
  const program::Signature& signature = stepper.signature;
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  const bool switches = stepper.switches();
  Slots slots = {{"declaration",
                  declaration("void " + signature.name, parameters(signature, all), " noexcept {")},
                 {"type", type_name(target.scalar)},
                 {"step", literal(stepper.step, target.scalar)},
                 {"dynamics", switches ? "dynamics_in" : stepper.phases.front().dynamics},
                 {"phase", switches ? "phase[0], " : ""},
                 {"t", stepper.takes_time ? ", t" : ""},
                 {"anchor", stepper.takes_anchor ? ", anchor" : ""},
                 {"lambda", stepper.rows > 0 ? ", lambda" : ""},
                 {"events", events_text(stepper, target.scalar)}};
  const std::string local = local_text(stepper, words, target);
  if (stepper.method == StepMethod::kSemiImplicitEuler) {
    return local + fill(template_text("step_semi_implicit_euler.cpp"), slots);
  }
  add_rk4_slots(stepper, target.scalar, slots);
  return local + fill(template_text("step_rk4.cpp"), slots);
}

}  // namespace treedyn::emit
