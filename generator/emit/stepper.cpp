#include "emit/stepper.hpp"

#include <map>
#include <utility>
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

/// A row of the tableau of Dormand and Prince: what a stage takes of the stages before it.
struct TableauRow {
  int stage;
  const char* time;
  std::vector<std::pair<int, const char*>> weights;
};

/// Dormand, Prince, A family of embedded Runge-Kutta formulae (1980), RK5(4)7M; row 7 is the
/// result.
const std::vector<TableauRow>& dopri5_tableau() {
  static const std::vector<TableauRow> rows = {
      {2, "1/5", {{1, "1/5"}}},
      {3, "3/10", {{1, "3/40"}, {2, "9/40"}}},
      {4, "4/5", {{1, "44/45"}, {2, "-56/15"}, {3, "32/9"}}},
      {5, "8/9", {{1, "19372/6561"}, {2, "-25360/2187"}, {3, "64448/6561"}, {4, "-212/729"}}},
      {6,
       "1",
       {{1, "9017/3168"}, {2, "-355/33"}, {3, "46732/5247"}, {4, "49/176"}, {5, "-5103/18656"}}},
      {7, "1", {{1, "35/384"}, {3, "500/1113"}, {4, "125/192"}, {5, "-2187/6784"}, {6, "11/84"}}}};
  return rows;
}

Real fraction(const std::string& text) {
  const std::size_t bar = text.find('/');
  return bar == std::string::npos ? Real(text)
                                  : Real(Real(text.substr(0, bar)) / Real(text.substr(bar + 1)));
}

void add_dopri5_slots(const Stepper& stepper, Scalar scalar, Slots& slots) {
  const bool reacts = stepper.rows > 0;
  const auto of_step = [&](const char* part) {
    return literal(stepper.step * fraction(part), scalar);
  };
  std::vector<std::string> constants;
  std::vector<std::string> times;
  for (const TableauRow& row : dopri5_tableau()) {
    for (const auto& [stage, weight] : row.weights) {
      constants.push_back(fmt::format("  constexpr {} c{}{} = {};", type_name(scalar), row.stage,
                                      stage, of_step(weight)));
    }
    if (row.stage < 7) {
      slots[fmt::format("t{}", row.stage)] =
          stepper.takes_time ? fmt::format(", t{}", row.stage) : "";
      times.push_back(
          fmt::format("  const Scalar t{}[1] = {{t[0] + {}}};", row.stage, of_step(row.time)));
    }
  }
  slots["constants"] = fmt::format("{}", fmt::join(constants, "\n"));
  slots["times"] = stepper.takes_time ? fmt::format("{}", fmt::join(times, "\n")) : "";
  slots["later_lambda"] = reacts ? fmt::format("  Scalar later[{}];", stepper.rows) : "";
  slots["later"] = reacts ? ", later" : "";
  slots.erase("step");
  slots.erase("type");
}

/// What the dynamics need beside the state, as arguments or as parameters.
std::vector<std::string> context(const Stepper& stepper, const std::string& which,
                                 const std::string& t, bool parameters) {
  const char* const type = parameters ? "const Scalar* " : "";
  std::vector<std::string> result;
  if (stepper.switches()) {
    result.push_back((parameters ? "int " : "") + which);
  }
  result.push_back(fmt::format("{}tau", type));
  if (stepper.takes_time) {
    result.push_back(type + t);
  }
  if (stepper.takes_anchor) {
    result.push_back(fmt::format("{}anchor", type));
  }
  return result;
}

std::string stage_declaration(const Stepper& stepper, const std::string& name,
                              const std::vector<std::string>& own) {
  std::vector<std::string> parameters = context(stepper, "which", "t", true);
  parameters.insert(parameters.end(), own.begin(), own.end());
  return declaration("void " + name, parameters, " noexcept {");
}

void add_sdirk2_slots(const Stepper& stepper, Scalar scalar, Slots& slots) {
  const bool reacts = stepper.rows > 0;
  const bool single = scalar == Scalar::kFloat;
  const Real rest = sqrt(Real("0.5"));
  const auto arguments = [&](const std::string& which, const std::string& t) {
    return fmt::format("{}", fmt::join(context(stepper, which, t, false), ", "));
  };
  slots["change"] = single ? "1e-12f" : "1e-26";
  slots["enough"] = single ? "1e-10f" : "1e-22";
  slots["difference"] = single ? "3e-4f" : "1.5e-8";
  slots["nan"] = single ? "NAN" : "static_cast<Scalar>(NAN)";
  slots["nearer"] = literal(Real("0.9"), scalar);
  slots["one_half"] = literal(Real("0.5"), scalar);
  slots["stage"] = literal(stepper.step * (1 - rest), scalar);
  slots["rest"] = literal(stepper.step * rest, scalar);
  slots["times"] = stepper.takes_time ? fmt::format(
                                            "  const Scalar t_stage[1] = {{t[0] + kStage}};\n"
                                            "  const Scalar t_full[1] = {{t[0] + {}}};",
                                            literal(stepper.step, scalar))
                                      : "";
  slots["later_lambda"] = reacts ? fmt::format("  Scalar later[{}];", stepper.rows) : "";
  slots["later"] = reacts ? ", later" : "";
  slots["first_phase"] = slots.at("phase");
  slots["phase"] = stepper.switches() ? "which, " : "";
  slots["factor_declaration"] = stage_declaration(
      stepper, "factor_stage",
      {"const Scalar* x0", "const Scalar* v0", "const Scalar* a", "Scalar (*M)[kDof]", "int* row"});
  slots["find_declaration"] =
      stage_declaration(stepper, "find_stage",
                        {"Scalar size", "const Scalar* x0", "const Scalar* v0", "Scalar* a",
                         "Scalar (*M)[kDof]", "int* row"});
  slots["context"] = arguments("which", "t");
  slots["first_context"] = arguments("phase[0]", "t_stage");
  slots["second_context"] = arguments("phase[0]", "t_full");
  slots.erase("step");
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
  std::vector<std::string> lines = {
      declaration("const int failed = " + phase.dynamics, arguments, ";")};
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
    lines.push_back(last ? "  default: {" : fmt::format("  case phase::{}: {{", phase.identifier));
    for (const std::string& line : dynamics_lines(stepper, phase)) {
      lines.push_back("    " + line);
    }
    lines.emplace_back("    return failed;");
    lines.emplace_back("  }");
  }
  lines.emplace_back("}");
  return "\n/// Accelerations and reactions in a phase.\n" +
         declaration("int dynamics_in", parameters, " noexcept {") + block(lines);
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
  Slots slots = {
      {"declaration", declaration(returned(signature), parameters(signature, all), " noexcept {")},
      {"type", type_name(target.scalar)},
      {"step", literal(stepper.step, target.scalar)},
      {"dynamics", switches ? "dynamics_in" : stepper.phases.front().dynamics},
      {"phase", switches ? "phase[0], " : ""},
      {"t", stepper.takes_time ? ", t" : ""},
      {"anchor", stepper.takes_anchor ? ", anchor" : ""},
      {"lambda", stepper.rows > 0 ? ", lambda" : ""},
      {"events", events_text(stepper, target.scalar)}};
  const std::string local = local_text(stepper, words, target);
  switch (stepper.method) {
    case StepMethod::kRk4:
      add_rk4_slots(stepper, target.scalar, slots);
      return local + fill(template_text("step_rk4.cpp"), slots);
    case StepMethod::kDopri5:
      add_dopri5_slots(stepper, target.scalar, slots);
      return local + fill(template_text("step_dopri5.cpp"), slots);
    case StepMethod::kSdirk2:
      add_sdirk2_slots(stepper, target.scalar, slots);
      return local + fill(template_text("step_sdirk2.cpp"), slots);
    case StepMethod::kSemiImplicitEuler:
      break;
  }
  return local + fill(template_text("step_semi_implicit_euler.cpp"), slots);
}

}  // namespace treedyn::emit
