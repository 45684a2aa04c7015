#include "emit/step_integrate.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::Stepper;

namespace {

using Slots = std::map<std::string, std::string>;

/// A part of the step: a number, or a product with h.
std::string part_of_step(const Stepper& stepper, Form form, const Real& part, Scalar scalar) {
  return form == Form::kStep ? literal(stepper.step * part, scalar)
                             : literal(part, scalar) + " * h";
}

std::string constant(const std::string& name, const std::string& value, Form form, Scalar scalar) {
  return form == Form::kStep
             ? fmt::format("  constexpr {} {} = {};", type_name(scalar), name, value)
             : fmt::format("  const Scalar {} = {};", name, value);
}

/// Constants for the length of the step, and h itself if nobody passes it.
std::string lengths(const Stepper& stepper, Form form, Scalar scalar,
                    const std::vector<std::pair<std::string, Real>>& parts, bool h) {
  Lines lines;
  if (form == Form::kStep && h) {
    lines.push_back(constant("h", literal(stepper.step, scalar), form, scalar));
  }
  for (const auto& [name, part] : parts) {
    lines.push_back(constant(name, part_of_step(stepper, form, part, scalar), form, scalar));
  }
  return joined(lines, "");
}

void add_rk4_slots(const Stepper& stepper, Form form, Scalar scalar, Slots& slots) {
  slots["lengths"] =
      lengths(stepper, form, scalar, {{"half", Real("0.5")}, {"sixth", Real(1) / 6}}, true);
  slots["times"] = stepper.takes_time ? "  const Scalar t_half[1] = {t[0] + half};\n"
                                        "  const Scalar t_full[1] = {t[0] + h};"
                                      : "";
  slots["t_half"] = stepper.takes_time ? ", t_half" : "";
  slots["t_full"] = stepper.takes_time ? ", t_full" : "";
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

void add_dopri5_slots(const Stepper& stepper, Form form, Scalar scalar, Slots& slots) {
  std::vector<std::pair<std::string, Real>> parts;
  Lines times;
  for (const TableauRow& row : dopri5_tableau()) {
    for (const auto& [stage, weight] : row.weights) {
      parts.emplace_back(fmt::format("c{}{}", row.stage, stage), fraction(weight));
    }
    if (row.stage < 7) {
      slots[fmt::format("t{}", row.stage)] =
          stepper.takes_time ? fmt::format(", t{}", row.stage) : "";
      times.push_back(fmt::format("const Scalar t{}[1] = {{t[0] + {}}};", row.stage,
                                  part_of_step(stepper, form, fraction(row.time), scalar)));
    }
  }
  slots["constants"] = lengths(stepper, form, scalar, parts, false);
  slots["times"] = stepper.takes_time ? joined(times, "  ") : "";
}

std::string dynamics_name(const Stepper& stepper) {
  return stepper.switches() ? "dynamics_in" : stepper.phases.front().dynamics;
}

/// What the dynamics need beside the state, as arguments or as parameters.
std::vector<std::string> context(const Stepper& stepper, const std::string& which,
                                 const std::string& t, bool parameters) {
  const char* const type = parameters ? "const Scalar* " : "";
  std::vector<std::string> result;
  append_if(result, stepper.switches(), (parameters ? "int " : "") + which);
  result.push_back(fmt::format("{}tau", type));
  append_if(result, stepper.takes_time, type + t);
  append_if(result, stepper.takes_anchor, fmt::format("{}anchor", type));
  append_if(result, stepper.takes_derived, parameters ? derived_parameter() : "derived");
  return result;
}

/// Where the dynamics are called: what stands behind the time.
std::string behind_time(const Stepper& stepper) {
  return std::string(stepper.takes_anchor ? ", anchor" : "") +
         (stepper.takes_derived ? ", derived" : "");
}

std::string stage_declaration(const Stepper& stepper, const std::string& head,
                              const std::vector<std::string>& own) {
  std::vector<std::string> parameters = context(stepper, "which", "t", true);
  parameters.insert(parameters.end(), own.begin(), own.end());
  return declaration(head, parameters, " noexcept {");
}

/// integrate(h, which, q, qd, tau, t, anchor, derived, q_next, qd_next, lambda, later, halfway):
/// parameters, or arguments at a state (x, v).
std::vector<std::string> integrate_list(const Stepper& stepper, bool parameters) {
  std::vector<std::string> result = {parameters ? "Scalar h" : "part"};
  const std::vector<std::string> beside =
      parameters ? context(stepper, "which", "t", true) : context(stepper, "which", "t_now", false);
  const bool which = stepper.switches();
  if (which) {
    result.push_back(beside.front());
  }
  for (const char* const name : {"q", "qd"}) {
    result.push_back(parameters ? fmt::format("const Scalar* {}", name)
                                : std::string(name == std::string("q") ? "x" : "v"));
  }
  append_if(result, stepper.compensated, parameters ? "Scalar* rest_next" : "rest_next");
  result.insert(result.end(), beside.begin() + (which ? 1 : 0), beside.end());
  for (const char* const name : {"q_next", "qd_next", "lambda", "later", "halfway"}) {
    const bool told = name[0] == 'h' ? program::tells_reactions(stepper) : stepper.rows > 0;
    append_if(result, told || name[0] == 'q',
              parameters ? fmt::format("Scalar* {}", name) : std::string(name));
  }
  return result;
}

/// Reactions in the middle of a step, of those at some parts of it: as of a polynomial through
/// them.
Lines halfway_lines(const Stepper& stepper, Scalar scalar) {
  struct Known {
    const char* lambda;
    Real part;
  };
  std::vector<Known> known = {
      {"lambda", 0}, {"halfway", Real(1) - sqrt(Real("0.5"))}, {"later", 1}};
  if (stepper.method == StepMethod::kDopri5) {
    known = {{"lambda", 0}, {"halfway", Real("0.3")}, {"fourth", Real("0.8")}, {"later", 1}};
  }
  std::vector<std::string> terms;
  for (const Known& one : known) {
    Real weight = 1;
    for (const Known& other : known) {
      weight = &one == &other ? weight
                              : Real(weight * (Real("0.5") - other.part) / (one.part - other.part));
    }
    terms.push_back(fmt::format("{} * {}[i]", literal(weight, scalar), one.lambda));
  }
  return {fmt::format("for (int i = 0; i < {}; ++i) {{", stepper.rows),
          fmt::format("  halfway[i] = {};", fmt::join(terms, " + ")), "}"};
}

/// The line that tells it, between two texts; empty where nothing is told.
std::string told(const Stepper& stepper, program::Repeated what, const std::string& before,
                 const std::string& behind) {
  return stepper.tells
             ? fmt::format("{}treedyn_again({});{}", before, static_cast<int>(what), behind)
             : "";
}

}  // namespace

std::string sdirk2_stages(const Stepper& stepper, Scalar scalar) {
  const bool single = scalar == Scalar::kFloat;
  const bool reacts = stepper.rows > 0;
  const bool tells = program::tells_reactions(stepper);
  const auto arguments = [&](const std::string& t) {
    return fmt::format("{}", fmt::join(context(stepper, "which", t, false), ", "));
  };
  std::vector<std::string> find = {"Scalar stage", "Scalar size", "const Scalar* x0",
                                   "const Scalar* v0", "Scalar* a"};
  append_if(find, reacts, "Scalar* lambda");
  find.insert(find.end(), {"Scalar (*M)[kDof]", "int* row"});
  return fill(template_text("step_stages.cpp"),
              {{"type", type_name(scalar)},
               {"jacobians", std::to_string(program::kMostJacobians)},
               {"newton_steps", std::to_string(program::kMostNewtonSteps)},
               {"tries", std::to_string(program::kMostTries)},
               {"change", single ? "1e-12f" : "1e-26"},
               {"enough", single ? "1e-10f" : "1e-22"},
               {"difference", single ? "3e-4f" : "1.5e-8"},
               {"newton_again", told(stepper, program::Repeated::kNewtonStep, "      ", "\n")},
               {"factor_again", told(stepper, program::Repeated::kJacobian, "  ", "\n")},
               {"gamma", literal(1 - sqrt(Real("0.5")), scalar)},
               {"nearer", literal(Real("0.9"), scalar)},
               {"one_half", literal(Real("0.5"), scalar)},
               {"factor_declaration",
                stage_declaration(stepper, "void factor_stage",
                                  {"Scalar stage", "const Scalar* x0", "const Scalar* v0",
                                   "const Scalar* a", "Scalar (*M)[kDof]", "int* row"})},
               {"find_declaration", stage_declaration(stepper, "int find_stage", find)},
               {"try_declaration",
                declaration("int try_step", integrate_list(stepper, true), " noexcept {")},
               {"dynamics", dynamics_name(stepper)},
               {"phase", stepper.switches() ? "which, " : ""},
               {"t", stepper.takes_time ? ", t" : ""},
               {"anchor", behind_time(stepper)},
               {"lambda", reacts ? ", lambda" : ""},
               {"later", reacts ? ", later" : ""},
               {"later_lambda", reacts ? fmt::format("  Scalar later[{}];", stepper.rows) : ""},
               {"halfway", tells    ? ", halfway"
                           : reacts ? ", later"
                                    : ""},
               {"between", tells ? joined(halfway_lines(stepper, scalar), "  ") : ""},
               {"times", stepper.takes_time ? "  const Scalar t_stage[1] = {t[0] + stage};\n"
                                              "  const Scalar t_full[1] = {t[0] + h};"
                                            : ""},
               {"context", arguments("t")},
               {"first_context", arguments("t_stage")},
               {"second_context", arguments("t_full")}});
}

namespace {

void add_sdirk2_slots(const Stepper& stepper, Form form, Scalar scalar, Slots& slots) {
  std::vector<std::string> arguments = integrate_list(stepper, false);
  if (form == Form::kStep && stepper.switches()) {
    arguments[1] = "phase[0]";
  }
  if (stepper.rows > 0) {  // of the beginning
    *std::ranges::find(arguments, "lambda") = "done > Scalar(0) ? later : lambda";
  }
  Lines first_part;
  std::string unused;
  if (program::tells_reactions(stepper)) {  // where parts were tried, behind the first of them
    arguments.back() = "done > Scalar(0) ? unused : halfway";
    unused = fmt::format("  Scalar unused[{}];", stepper.rows);
    first_part = {fmt::format("for (int i = 0; i < {} && part < h && !(done > Scalar(0)); ++i) {{",
                              stepper.rows),
                  "  halfway[i] = later[i];", "}"};
  }
  slots = {
      {"declaration", slots.at("declaration")},
      {"end", slots.at("end")},
      {"later_lambda", slots.at("later_lambda") + unused},
      {"first_part", joined(first_part, "    ")},
      {"lengths", lengths(stepper, form, scalar, {}, true)},
      {"times", stepper.takes_time ? "    const Scalar t_now[1] = {t[0] + done};" : ""},
      {"one_half", literal(Real("0.5"), scalar)},
      {"again", told(stepper, program::Repeated::kPart, "    if (n > 1) {\n      ", "\n    }\n")},
      {"try", fmt::format("try_step({})", fmt::join(arguments, ", "))}};
}

/// What stands behind the integration.
std::string integration_end(const Stepper& stepper, Form form) {
  Lines lines;
  if (form == Form::kIntegrate) {
    if (stepper.rows > 0 && stepper.method == StepMethod::kSemiImplicitEuler) {
      append(lines, {fmt::format("for (int i = 0; i < {}; ++i) {{", stepper.rows),
                     "  later[i] = lambda[i];", "}"});
    }
    lines.emplace_back("return failed;");
    return joined(lines, "  ");
  }
  append_if(lines, stepper.switches(), "phase_next[0] = phase[0];");
  lines.emplace_back("return failed | check(q_next, kDof) | check(qd_next, kDof);");
  return joined(lines, "  ");
}

std::string kept_lines(const Stepper& stepper) {
  return stepper.compensated ? "\n  for (int i = 0; i < 2 * kDof; ++i) {\n"
                               "    rest_next[i] = rest[i];\n"
                               "  }"
                             : "";
}

/// By how much joints turn beside a position without accelerations: half a turn and a little more,
/// rad.
constexpr double kPassage = 3.2;

}  // namespace

std::string integration(const Stepper& stepper, Form form, Scalar scalar) {
  const bool own = form == Form::kStep;
  const bool reacts = stepper.rows > 0;
  const auto plus = [&](const std::string& x) {
    return stepper.compensated ? fmt::format("add({}[i],", x) : x + "[i] +";
  };
  Slots slots = {
      {"declaration",
       own ? declaration(stepper.signature, " noexcept {") + kept_lines(stepper)
           : declaration(stepper.turning.empty() ? "int integrate" : "int integrate_part",
                         integrate_list(stepper, true), " noexcept {")},
      {"dynamics", dynamics_name(stepper)},
      {"phase", !stepper.switches() ? ""
                : own               ? "phase[0], "
                                    : "which, "},
      {"t", stepper.takes_time ? ", t" : ""},
      {"anchor", behind_time(stepper)},
      {"lambda", reacts ? ", lambda" : ""},
      {"end", integration_end(stepper, form)},
      {"q_plus", plus("q")},
      {"qd_plus", plus("qd")},
      {"q_rest", stepper.compensated ? ", &rest_next[i])" : ""},
      {"qd_rest", stepper.compensated ? ", &rest_next[kDof + i])" : ""}};
  if (stepper.method == StepMethod::kSemiImplicitEuler) {
    slots["lengths"] = lengths(stepper, form, scalar, {}, true);
    return fill(template_text("step_semi_implicit_euler.cpp"), slots);
  }
  slots["later_lambda"] = reacts && own ? fmt::format("  Scalar later[{}];", stepper.rows) : "";
  slots["later"] = reacts ? ", later" : "";
  const bool tells = !own && program::tells_reactions(stepper);
  slots["halfway"] = tells ? ", halfway" : slots["later"];
  switch (stepper.method) {
    case StepMethod::kRk4:
      add_rk4_slots(stepper, form, scalar, slots);
      return fill(template_text("step_rk4.cpp"), slots);
    case StepMethod::kDopri5:
      slots["fourth"] = tells ? ", fourth" : slots["later"];
      if (tells) {
        slots["later_lambda"] = fmt::format("  Scalar fourth[{}];", stepper.rows);
        slots["end"] = joined(halfway_lines(stepper, scalar), "  ") + "\n" + slots["end"];
      }
      add_dopri5_slots(stepper, form, scalar, slots);
      return fill(template_text("step_dopri5.cpp"), slots);
    default:
      add_sdirk2_slots(stepper, form, scalar, slots);
      return fill(template_text("step_sdirk2.cpp"), slots);
  }
}

std::string parts_text(const Stepper& stepper, Scalar scalar) {
  std::vector<std::string> arguments = integrate_list(stepper, false);
  std::string unused;
  if (stepper.rows > 0) {  // reactions of the beginning, and of the middle
    unused = fmt::format("  Scalar unused[{}];", stepper.rows);
    *std::ranges::find(arguments, "lambda") = "done > Scalar(0) ? unused : lambda";
  }
  if (program::tells_reactions(stepper)) {
    arguments.back() = "done + done < h ? halfway : unused";
  }
  return fill(
      template_text("step_parts.cpp"),
      {{"parts", std::to_string(stepper.parts)},
       {"again", told(stepper, program::Repeated::kPart, "    if (k > 1) {\n      ", "\n    }\n")},
       {"declaration", declaration("int integrate", integrate_list(stepper, true), " noexcept {")},
       {"joints", fmt::format("{}", fmt::join(stepper.turning, ", "))},
       {"count", std::to_string(stepper.turning.size())},
       {"turn", literal(Real(fmt::format("{:.2g}", kPassage / stepper.parts)), scalar)},
       {"far", literal(Real("0.5"), scalar)},
       {"unused", unused},
       {"times", stepper.takes_time ? "    const Scalar t_now[1] = {t[0] + done};" : ""},
       {"integrate", call_text("failed |= integrate_part", arguments, 4)}});
}

std::string step_of_parts(const Stepper& stepper, Scalar scalar) {
  std::vector<std::string> arguments = integrate_list(stepper, false);
  arguments.front() = literal(stepper.step, scalar);
  const std::map<std::string, std::string> own = {
      {"which", "phase[0]"}, {"x", "q"}, {"v", "qd"}, {"t_now", "t"}};
  for (std::string& argument : arguments) {
    const auto found = own.find(argument);
    argument = found == own.end() ? argument : found->second;
  }
  return declaration(stepper.signature, " noexcept {") + kept_lines(stepper) + "\n" +
         (stepper.rows > 0 ? fmt::format("  Scalar later[{}];\n", stepper.rows) : "") +
         call_text("  const int failed = integrate", arguments) + "\n" +
         integration_end(stepper, Form::kStep) + "\n}\n";
}

}  // namespace treedyn::emit
