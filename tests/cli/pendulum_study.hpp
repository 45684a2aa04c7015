// What the tests of accuracy studies share.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace treedyn {

inline const std::string kPendulum = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
inline constexpr double kGravity = 9.81;

/// Those of a line of a table, which may end as on Windows.
inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line.substr(0, line.find('\r')));
  for (std::string field; std::getline(in, field, ',');) {
    result.push_back(field);
  }
  return result;
}

}  // namespace treedyn
