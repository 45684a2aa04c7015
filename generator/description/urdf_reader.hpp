// URDF files as written.
#pragma once

#include <string>

#include "description/raw_tree.hpp"

namespace treedyn::description {

/// Links, joints and their inertias; other elements (visual, transmission, gazebo, sensor) are
/// ignored.
///
/// \throws InputError for malformed XML, a document type declaration, and missing or repeated
/// elements.
RawTree read_urdf(const std::string& text, const std::string& file);

}  // namespace treedyn::description
