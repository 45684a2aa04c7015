// R11 on a derivation: the time derivative of every value, in frames that turn with the links.
#pragma once

#include <optional>

#include "derive/derive.hpp"

namespace treedyn::derive {

/// The rate along q̇ of what is derived, its own values beside their rates. Nothing if places of
/// joints are asked for, or if it is made of others than constants of links, sums over subtrees and
/// products.
std::optional<Derivation> rate(const Derivation& derivation);

}  // namespace treedyn::derive
