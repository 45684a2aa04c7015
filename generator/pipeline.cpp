#include "pipeline.hpp"

#include <fmt/format.h>

#include "stages/in_scalar.hpp"

namespace treedyn {

namespace {

/// Functions without some pass, because it would have amplified rounding.
void warn_of_rounding(const Request& request, const program::Programs& programs, const Warn& warn) {
  const Location where{request.scene.value_or(request.model), 0, 0};
  const auto check = [&](const std::string& name, const program::Rounding& rounding) {
    if (rounding.refused > 0) {
      warn({where, fmt::format("function '{}' is generated without {}: rounding errors would grow "
                               "{:.2g} times by it",
                               name, fmt::join(rounding.left_out, ", "), rounding.refused)});
    }
  };
  for (const program::Function& function : programs.functions) {
    check(function.signature.name, function.rounding);
  }
  for (const program::Staged& staged : programs.staged) {
    check(staged.signature.name, staged.function.rounding);
  }
}

}  // namespace

std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn) {
  program::Programs programs = formulate_model(model, request, trace);
  warn_of_rounding(request, programs, warn);
  const Location where{request.scene.value_or(request.model), 0, 0};
  for (const Warning& warning : float_warnings(programs, request.target.scalar, where)) {
    warn(warning);
  }
  separate_parameters(model, request, programs);
  check_at_states(model, request, programs);
  return emit_files(model, request, std::move(programs));
}

}  // namespace treedyn
