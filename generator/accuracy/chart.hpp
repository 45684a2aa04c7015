// Diagrams on logarithmic axes as SVG.
#pragma once

#include <string>

#include "accuracy/study.hpp"

namespace treedyn::accuracy {

/// Error over the step: is float enough, which step? Horizontal lines are the floors of the
/// scalars and of events that steps take at their end, vertical ones stability limits, marks at the
/// upper edge motions that failed.
std::string step_chart(const Study& study);

/// Error over cycles for a second of motion on a core, with the Pareto front: which setting?
std::string work_chart(const Study& study, const Core& core);

}  // namespace treedyn::accuracy
