// Random tree descriptions for property tests.
#pragma once

#include <nlohmann/json.hpp>

namespace treedyn::random {

/// A tree description (INTERFACE.md 4) with 1 to `largest` links: any numbering, several roots,
/// revolute, prismatic and fixed joints, arbitrary axes and rotations, massless links inside
/// chains, points on any link. To be called inside a rapidcheck property.
nlohmann::json description(int largest);

}  // namespace treedyn::random
