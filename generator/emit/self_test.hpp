// Known answers in the generated files, and the function that compares with them (`--self-test`).
#pragma once

#include <string>

#include "emit/unit.hpp"

namespace treedyn::emit {

inline constexpr const char* kSelfTest = "self_test";

/// Comment and prototype, with the numbers that the function gives to outputs.
std::string self_test_declaration(const Unit& unit);

/// States, answers and the function.
std::string self_test_text(const Unit& unit);

}  // namespace treedyn::emit
