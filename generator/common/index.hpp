// Numbers of links, joints and rows as positions in containers.
#pragma once

#include <cstddef>

namespace treedyn {

/// `i`, which is not negative, as a position in a container.
constexpr std::size_t to_index(int i) { return static_cast<std::size_t>(i); }

}  // namespace treedyn
