// The robots of tests/data/golden as plain structs.
#pragma once

#include <algorithm>

#include "oracle/recursive.hpp"
#include "support/cases.hpp"

namespace treedyn::oracle {

template <std::size_t N>
std::array<double, N> numbers(const support::Json& list) {
  return list.get<std::array<double, N>>();
}

/// A case with its links sorted so that fathers come first; `link[i]` is the link of body i.
struct GoldenRobot {
  Robot<double> robot;
  std::vector<std::size_t> link;

  /// One row (or number) a link, in the order of the robot.
  [[nodiscard]] std::vector<double> rows(const support::Json& list) const {
    std::vector<double> result;
    for (const std::size_t i : link) {
      const std::vector<double> row = support::flat(list.at(i));
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  }
};

inline GoldenRobot golden_robot(const support::Json& data) {
  const auto father = data.at("father").get<std::vector<int>>();
  GoldenRobot result;
  std::vector<int> place(father.size(), -1);
  while (result.link.size() < father.size()) {
    for (std::size_t i = 0; i < father.size(); ++i) {
      const int f = father[i] == 0 ? -1 : place[static_cast<std::size_t>(father[i] - 1)];
      if (place[i] >= 0 || (father[i] != 0 && f < 0)) {
        continue;
      }
      place[i] = static_cast<int>(result.link.size());
      result.link.push_back(i);
      result.robot.push_back(
          {f, data.at("sigma").at(i) == 1, numbers<3>(data.at("joint_axis").at(i)),
           numbers<3>(data.at("joint_offset").at(i)), numbers<9>(data.at("joint_R0").at(i)),
           data.at("mass").at(i), numbers<3>(data.at("com").at(i)),
           numbers<9>(data.at("inertia").at(i))});
    }
  }
  return result;
}

}  // namespace treedyn::oracle
