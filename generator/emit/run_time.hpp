// What generated files say of numbers that are known at run time only.
#pragma once

#include <string>
#include <vector>

#include "emit/unit.hpp"

namespace treedyn::emit {

/// Types of the header, and the arguments of these types.
inline constexpr const char* kParameters = "Parameters";
inline constexpr const char* kDerivedParameters = "DerivedParameters";
inline constexpr const char* kNominal = "kNominalParameters";
inline constexpr const char* kUpdate = "update_parameters";

/// The fields of the parameters, short enough for statements.
std::vector<std::string> field_names(const model::Tree& tree);

/// The argument of `update_parameters`, and that of the other functions, its size left open.
program::Array parameters_array(const model::Tree& tree);
program::Array derived_array();
/// The fields of the latter.
std::vector<std::string> derived_names(const std::vector<Real>& numbers, const model::Tree& tree);

/// Both structs and the nominal values; nothing without parameters.
std::string parameter_types(const Unit& unit);

/// `,\n  "parameters": [...]` of the manifest; nothing without parameters.
std::string parameters_json(const model::Tree& tree, const model::Vector3& gravity);

}  // namespace treedyn::emit
