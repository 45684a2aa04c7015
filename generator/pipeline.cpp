#include "pipeline.hpp"

#include "stages/in_scalar.hpp"

namespace treedyn {

std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn) {
  program::Programs programs = formulate_model(model, request, trace);
  for (const Warning& warning : warnings_of(programs, request)) {
    warn(warning);
  }
  separate_parameters(model, request, programs);
  require_use_of_parameters(model, request, programs);
  check_at_states(model, request, programs);
  return emit_files(model, request, std::move(programs));
}

}  // namespace treedyn
