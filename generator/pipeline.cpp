#include "pipeline.hpp"

#include <algorithm>

#include "stages/stages.hpp"

namespace treedyn {

std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn) {
  program::Programs programs = formulate_model(model, request, trace);
  const std::vector<Warning> warnings = warnings_of(programs, model, request);
  separate_parameters(model, request, programs);
  require_use_of_parameters(model, request, programs);
  check_at_states(model, request, programs);
  std::vector<emit::File> files = emit_files(model, request, std::move(programs));
  std::ranges::for_each(warnings, warn);  // an error comes alone
  return files;
}

}  // namespace treedyn
