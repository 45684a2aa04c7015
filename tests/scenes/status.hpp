// The bits that functions of scenes return, as namespace status of their headers numbers them.
#pragma once

namespace treedyn::support {

enum Status {
  kRankLost = 1,
  kRowGivenUp = 2,
  kNoConvergence = 4,
  kEventMissed = 8,
  kNotANumber = 16,
  kGuardUndefined = 32,
  kEventLate = 64,
  kTurnedFar = 128,
};

}  // namespace treedyn::support
