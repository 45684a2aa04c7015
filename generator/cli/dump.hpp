// What leaves a stage, as text.
#pragma once

#include <string>
#include <vector>

#include "request/read_model.hpp"

namespace treedyn {

/// The block equations of the model's functions with the zero blocks of D.
std::string equations_text(const Model& model, const Request& request);

/// How the code of a function comes about, line by line. \throws UsageError for a function that is
/// no block equation.
std::string derivation_text(const Model& model, const Request& request, const std::string& name);

/// The stages whose results `dump` shows.
const std::vector<std::string>& stages();
/// What leaves a stage, as text. \pre `stage` is one of `stages()`.
std::string dump(const Request& request, const std::string& stage);

}  // namespace treedyn
