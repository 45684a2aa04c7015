// The values of single links in their cheapest forms: pattern -> replacement (F2 to F8).
#pragma once

#include <optional>
#include <vector>

#include "derive/value.hpp"

namespace treedyn::derive {

/// Replaces, operands before their users, what one of the patterns fits; `roots` follow.
Values with_forms(const Values& values, std::vector<int>& roots);

/// Ω = Λ(α) + Λ(ω)² with ω = D w: the numbers of its operands.
struct Turning {
  int Omega = -1;
  int alpha = -1;
  int omega = -1;
};
/// The turnings among `needed` whose joints turn about z: w = y z and α = D (x z + ω_f×w) for
/// numbers x, y. Then Ω z = Ω_f z: a joint changes Ω only across its own axis.
std::vector<Turning> turnings_about_axes(const Values& values, const std::vector<int>& needed);

/// Takes what turns with its link out of the rates of h^c and I^c, so that only speeds between
/// links travel; `roots` follow. Other values stay as they are.
Values with_relative_speeds(const Values& values, std::vector<int>& roots);

/// The number `root` without the sums over subtrees that it is linear in; nothing if there are
/// none.
std::optional<int> transposed(Values& values, int root);

}  // namespace treedyn::derive
