// What `treedyn vet` says.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"
#include "pipeline.hpp"

namespace treedyn {

struct Finding {
  Location where;
  std::string message;
  bool is_error = false;  ///< the model cannot be read
};

/// Everything that looks wrong in the model; its first mistake if it cannot be read.
std::vector<Finding> vet(const Request& request);

/// \param format "text", "gcc" (file:line:column: warning: message) or "json"
std::string findings_text(const std::vector<Finding>& findings, const std::string& format);

}  // namespace treedyn
