// The text of scene functions: straight-line stages and what stands between them.
#pragma once

#include <string>
#include <vector>

#include "emit/body.hpp"
#include "program/staged.hpp"

namespace treedyn::emit {

/// Two thresholds a pivot: rounding, and a larger share of its own diagonal entry.
bool is_measured_twice(const program::RowSolve& solve, Scalar scalar);

/// As `body`, stage by stage.
Body staged_body(const program::Staged& staged, const Vocabulary& words, const Target& target);

/// Functions of straight-line code alone, without namespace, each behind an empty line.
std::string local_functions(const std::vector<program::Staged>& functions, const Vocabulary& words,
                            const Target& target);

/// The solvers that the functions need and the functions; empty if there are none.
/// \param bodies one per function, in order
std::string staged_text(const std::vector<program::Staged>& functions,
                        const std::vector<Body>& bodies, const Vocabulary& words,
                        const Target& target);

}  // namespace treedyn::emit
