// What the counting program and the one that reads its counts agree on.
#pragma once

#include <string>

namespace treedyn::benchmark {

/// Calls of each function; the loop around them costs about 10 instructions a call.
inline constexpr int kCountedCalls = 64;

inline std::string label_of(const std::string& robot, const std::string& function,
                            const std::string& contestant) {
  return robot + '/' + function + '/' + contestant;
}

}  // namespace treedyn::benchmark
