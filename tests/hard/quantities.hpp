// The quantities of hard cases.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hard/run.hpp"
#include "support/cases.hpp"

namespace treedyn::hard {

using Values = std::vector<double>;

inline Values values_of(const simulation::Vector& x) { return {x.begin(), x.end()}; }

/// What a known quantity of SCHEMA.md is in the state that `run` has reached; nothing for a name
/// that is not known there. \param entry  of `expected`: body, point, event, index
std::optional<Values> known_quantity(const std::string& name, const support::Json& entry,
                                     const model::Scene& scene, Run& run);

/// A quantity that belongs to one kind of case, by runs of its own.
using Special = Values (*)(const model::Scene& scene, Source& source, const support::Json& entry);
/// nullptr if there is none with that name.
Special special_quantity(const std::string& name);

}  // namespace treedyn::hard
