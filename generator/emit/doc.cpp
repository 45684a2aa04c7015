#include "emit/doc.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/literal.hpp"
#include "emit/names.hpp"
#include "emit/run_time.hpp"

namespace treedyn::emit {

namespace {

std::string array_doc(const program::Array& array, bool output, std::size_t name_width) {
  const std::string what = array.type == kDerivedParameters ? "made by update_parameters"
                           : !array.type.empty() ? fmt::format("{} numbers, SI units", array.size)
                           : array.unit.empty()  ? std::to_string(array.size)
                                                 : fmt::format("{}, {}", array.size, array.unit);
  return wrapped(what, fmt::format("/// \\param{} {:{}}  ", output ? "[out]" : "     ", array.name,
                                   name_width));
}

/// What it does, its arguments and the rows of constraints.
std::string signature_doc(const program::Signature& signature) {
  std::size_t name_width = 0;
  for (const program::Array& array : signature.arrays()) {
    name_width = std::max(name_width, array.name.size());
  }
  std::string result = wrapped(signature.brief, "/// ") + "///\n";
  for (const program::Array& array : signature.inputs) {
    result += array_doc(array, false, name_width);
  }
  for (const program::Array& array : signature.outputs) {
    result += array_doc(array, true, name_width);
  }
  for (std::size_t k = 0; k < signature.rows.size(); ++k) {
    const std::string text = for_comment(signature.rows[k], kLongestCell * 2);
    result += wrapped(fmt::format("Row {}: {}", k, text), "/// ", 4);
  }
  return result;
}

}  // namespace

std::string doc(const program::Function& function) {
  const program::Signature& signature = function.signature;
  const std::string equation =
      signature.equation.empty() ? "" : fmt::format("Equation {}. ", signature.equation);
  const program::Cost cost = program::cost(function);
  const char* const divides =
      cost.div > 0 && signature.name != kUpdate
          ? "Results mean nothing where a divisor is zero, as where A is singular. "
          : "";
  return signature_doc(signature) +
         wrapped(fmt::format("{}{}Cost: {}.{}", divides, equation, cost_text(cost),
                             function.limb_code ? " Equal limbs share code." : ""),
                 "/// ");
}

std::string doc(const Checked& checked) {
  return signature_doc(checked.signature) +
         wrapped("\\return 0 or bits of status: rank_lost, not_a_number", "/// ") +
         wrapped(fmt::format("Equation {}. Cost: {}, and comparisons.", checked.signature.equation,
                             cost_text(cost(checked))),
                 "/// ");
}

namespace {

/// Why lambda is not unique. Where drives are sought, an equation stands for a joint without one.
std::string rank_text(const program::Staged& staged, const program::RowSolve& solve) {
  const bool drives = staged.signature.outputs.front().name == "tau";
  const std::string off =
      solve.elsewhere > solve.rank
          ? fmt::format(
                " At positions to which no motion from where the scene begins leads they "
                "have {}, and results are not those of such a position; row_given_up tells where "
                "a row is left out by 0.003 of its ordinary length.",
                solve.elsewhere)
          : "";
  return fmt::format("{} {} {} rank {}: lambda is of least norm.{}",
                     drives ? "The equations of the" : "The", solve.rows,
                     drives ? "joints without a drive have" : "rows have", solve.rank, off);
}

/// What it may return.
std::string status_doc(const program::Staged& staged) {
  const bool loses = !staged.solves.empty() || !staged.pivots.empty();
  return wrapped(
      fmt::format("\\return 0 or bits of status: {}{}not_a_number", loses ? "rank_lost, " : "",
                  staged.solves.empty() ? "" : "row_given_up, "),
      "/// ");
}

}  // namespace

/// The cost of the regular path and the bound.
std::string doc(const program::Staged& staged) {
  std::string result = signature_doc(staged.signature);
  for (const std::string& anchor : staged.anchors) {
    result += wrapped(for_comment(anchor, kLongestCell * 3), "/// ", 4);
  }
  for (const program::RowSolve& solve : staged.solves) {
    result += solve.regular() ? "" : wrapped(rank_text(staged, solve), "/// ");
  }
  result += status_doc(staged);
  for (const program::Staged& contact : staged.contacts) {
    const char* const power = program::worst_powers(contact) > 0 ? ", 1 pow" : "";
    result += wrapped(fmt::format("A closed contact ({}) adds {}{}.", contact.signature.name,
                                  cost_text(program::cost(contact)), power),
                      "/// ");
  }
  return result + wrapped(fmt::format("Equation {}. Cost: {}. Never more than {}.",
                                      staged.signature.equation, cost_text(program::cost(staged)),
                                      cost_text(program::worst_cost(staged))),
                          "/// ");
}

namespace {

std::string method_text(StepMethod method) {
  switch (method) {
    case StepMethod::kRk4:
      return "Runge-Kutta of order 4";
    case StepMethod::kDopri5:
      return "Dormand and Prince of order 5";
    case StepMethod::kSdirk2:
      return "two implicit stages, of order 2 and L-stable (Alexander 1977)";
    case StepMethod::kSemiImplicitEuler:
      break;
  }
  return "semi-implicit Euler";
}

/// ", from 40 steps on", ", from 3 steps and 0.002 s on", "": how long the phase has lasted.
std::string lasting_text(const program::StepEvent& event) {
  const program::Lasting& time = event.not_before;
  if (time.none()) {
    return {};
  }
  const bool alone = event.cause == program::StepCause::kTime;
  const std::string rest = time.rest == 0 ? "" : fmt::format(" and {} s", decimal(time.rest));
  return fmt::format("{}{} step{}{}{}", alone ? ", " : ", from ", time.steps,
                     time.steps == 1 ? "" : "s", rest, alone ? "" : " on");
}

/// "phase left: touch_down of right_foot, from 40 steps on: impact_left, then right"
std::string event_text(const program::Stepper& stepper, const program::StepPhase& phase,
                       const program::StepEvent& event) {
  const auto outcome = [&](const program::StepOutcome& result) {
    return fmt::format("{}{}", result.impact.empty() ? "" : result.impact + ", then ",
                       stepper.phases[static_cast<std::size_t>(result.then)].identifier);
  };
  const std::string after = lasting_text(event);
  const std::string rest =
      event.rest ? fmt::format("; slower than {}one step takes back: {}",
                               event.rest_below > 0
                                   ? fmt::format("{} m/s, or than ", decimal(event.rest_below))
                                   : "",
                               outcome(*event.rest))
                 : "";
  return fmt::format("Phase {}: {}{}: {}{}", phase.identifier,
                     for_comment(event.brief, kLongestCell * 2), after, outcome(event.outcome),
                     rest);
}

std::string phases_text(const program::Stepper& stepper) {
  return fmt::format("The scene begins in {}. With the index of no phase results are not numbers.",
                     stepper.first);
}

/// What the events do, and how late.
std::string events_doc(const program::Stepper& stepper) {
  std::string result;
  for (const program::StepPhase& phase : stepper.phases) {
    for (const program::StepEvent& event : phase.events) {
      result += wrapped(event_text(stepper, phase, event), "/// ", 4);
    }
  }
  if (result.empty()) {
    return stepper.switches() ? wrapped(phases_text(stepper), "/// ") : "";
  }
  const std::string where =
      stepper.cuts == 0 ? "Events are taken where the step ends, up to a step late: behind an "
                          "event the error is that of order 1, whatever the method."
                        : fmt::format(
                              "Events are taken where they happen: {} shorter steps find the "
                              "place, or {}, and the rest of the step is one in the next phase.",
                              stepper.cuts, stepper.cuts + 1);
  return result +
         wrapped(where +
                     fmt::format(" {} events of a step, and times that they wait for, at most.",
                                 stepper.events) +
                     (stepper.switches() ? " " + phases_text(stepper) : ""),
                 "/// ");
}

}  // namespace

/// The method, its step and what a step costs.
std::string doc(const program::Stepper& stepper) {
  const bool iterates = stepper.method == StepMethod::kSdirk2;
  const std::string where =
      stepper.switches() ? fmt::format(" in phase {}", stepper.phases.front().identifier) : "";
  const std::string with =
      iterates ? fmt::format(" with {} Newton steps a stage", program::kUsualNewtonSteps) : "";
  const std::string fails =
      iterates
          ? fmt::format(" Where the iteration does not converge, parts of the step, {} at most.",
                        program::kMostTries)
          : "";
  std::string bits = stepper.rows > 0 || stepper.tests_pivots ? "rank_lost, " : "";
  bits += stepper.rows > 0 ? "row_given_up, " : "";
  bits += stepper.turning.empty() ? "" : "turned_far, ";
  bits += iterates ? "no_convergence, " : "";
  bits += stepper.ends() ? "event_missed, " : "";
  bits += stepper.most_guards() > 0 && stepper.cuts == 0 ? "event_late, " : "";
  bits += stepper.most_guards() > 0 ? "guard_undefined, " : "";
  const std::string parts =
      stepper.turning.empty()
          ? ""
          : fmt::format(" Where joints turn far, parts of the step, {} at most.", stepper.parts);
  const char* const drifts =
      stepper.drifts ? " Positions of rows may drift: nothing stabilises them." : "";
  return signature_doc(stepper.signature) + events_doc(stepper) +
         wrapped(fmt::format("\\return 0 or bits of status: {}not_a_number", bits), "/// ") +
         wrapped(fmt::format("By {}, {} s.{}{}{} Cost{}{}: {}. Never more than {}.",
                             method_text(stepper.method), decimal(stepper.step), parts, fails,
                             drifts, where, with, cost_text(program::step_cost(stepper)),
                             cost_text(program::worst_step_cost(stepper))),
                 "/// ");
}

}  // namespace treedyn::emit
