#include "emit/stepper.hpp"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/template_file.hpp"

namespace treedyn::emit {

using program::StepMethod;
using program::Stepper;

namespace {

/// Times of the later stages; nothing if nothing depends on time.
std::string times(const Stepper& stepper) {
  return stepper.takes_time ? "  const Scalar t_half[1] = {t[0] + half};\n"
                              "  const Scalar t_full[1] = {t[0] + h};"
                            : "";
}

void add_rk4_slots(const Stepper& stepper, Scalar scalar,
                   std::map<std::string, std::string>& slots) {
  const bool reacts = stepper.rows > 0;
  slots["half"] = literal(stepper.step / 2, scalar);
  slots["sixth"] = literal(stepper.step / 6, scalar);
  slots["times"] = times(stepper);
  slots["t_half"] = stepper.takes_time ? ", t_half" : "";
  slots["t_full"] = stepper.takes_time ? ", t_full" : "";
  slots["later_lambda"] = reacts ? fmt::format("  Scalar later[{}];", stepper.rows) : "";
  slots["later"] = reacts ? ", later" : "";
}

}  // namespace

std::string stepper_text(const Stepper& stepper, Scalar scalar) {
  const program::Signature& signature = stepper.signature;
  const std::vector<bool> all(signature.inputs.size() + signature.outputs.size(), true);
  std::map<std::string, std::string> slots = {
      {"declaration",
       declaration("void " + signature.name, parameters(signature, all), " noexcept {")},
      {"type", type_name(scalar)},
      {"step", literal(stepper.step, scalar)},
      {"dynamics", stepper.dynamics},
      {"t", stepper.takes_time ? ", t" : ""},
      {"anchor", stepper.takes_anchor ? ", anchor" : ""},
      {"lambda", stepper.rows > 0 ? ", lambda" : ""}};
  if (stepper.method == StepMethod::kSemiImplicitEuler) {
    return fill(template_text("step_semi_implicit_euler.cpp"), slots);
  }
  add_rk4_slots(stepper, scalar, slots);
  return fill(template_text("step_rk4.cpp"), slots);
}

}  // namespace treedyn::emit
