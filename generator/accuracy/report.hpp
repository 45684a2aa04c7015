// A study as text, CSV, JSON and a page.
#pragma once

#include <string>
#include <vector>

#include "accuracy/study.hpp"

namespace treedyn::accuracy {

/// For a terminal: the floors, the orders, and for each core the Pareto front with what the next
/// decade costs.
std::string report_text(const Study& study, const std::vector<const Core*>& on);

/// One row a setting: errors, operations, cycles on every core. Quoted as in RFC 4180.
std::string report_csv(const Study& study);

/// All of it, errors of every initial state included.
std::string report_json(const Study& study);

/// One page that needs no network: the diagrams and the table.
std::string report_page(const Study& study, const std::vector<const Core*>& on);

/// The setting as lines for `generate --settings`.
std::string settings_text(const Study& study, const Setting& setting);

/// The cheapest setting for a target on a core with its evidence, or what is reachable.
std::string choice_text(const Study& study, const Core& core, double target);

}  // namespace treedyn::accuracy
