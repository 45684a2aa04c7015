// What every option costs and saves in the accuracy of a model's functions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "accuracy/function_errors.hpp"
#include "stages/stages.hpp"

namespace treedyn {

/// Every function of the model as asked for, then with each pass switched off, without any, with
/// other sines and cosines, and forward dynamics both ways. Equations of users too.
/// \throws UsageError if only functions of a scene were asked for
accuracy::FunctionStudy function_accuracy(const Model& model, const Request& request, int states,
                                          const Trace& trace);

/// Errors of functions that are to be written, in `request.accuracy_samples` states: JSON for the
/// manifest, by name. Functions of a scene have none.
std::map<std::string, std::string> measured_errors(const Model& model, const Request& request,
                                                   const std::vector<program::Function>& functions);

}  // namespace treedyn
