// `treedyn check --numeric`: do old and new functions give the same values?
#pragma once

#include <string>
#include <vector>

#include "emit/unit.hpp"
#include "pipeline.hpp"

namespace treedyn {

/// Compiles the files in `folder` and the new ones with the C++ compiler ($CXX, c++, g++ or
/// clang++) and returns, one line a function, the largest distance of their values at 20 fixed
/// states.
std::string numeric_report(const Model& model, const Request& request,
                           const std::vector<emit::File>& files, const std::string& folder);

}  // namespace treedyn
