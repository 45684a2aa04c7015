#include "random/random_description.hpp"

#include <rapidcheck.h>

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace treedyn::random {

namespace {

using Json = nlohmann::json;

/// A decimal with one digit, from -limit/10 to limit/10.
double tenth(int limit) { return *rc::gen::inRange(-limit, limit + 1) / 10.0; }

Json axis() {
  std::array<int, 3> result{};
  while (result == std::array<int, 3>{}) {
    for (int& x : result) {
      x = *rc::gen::inRange(-2, 3);
    }
  }
  return result;
}

Json vector() { return {tenth(9), tenth(9), tenth(9)}; }

/// Right angles as often as general ones.
Json rpy() {
  Json result = Json::array();
  for (int k = 0; k < 3; ++k) {
    const int quarters = *rc::gen::inRange(-2, 3);
    if (*rc::gen::arbitrary<bool>()) {
      result.push_back(fmt::format("{}*pi/2", quarters));
    } else {
      result.push_back(tenth(30));
    }
  }
  return {{"rpy", result}};
}

/// E tr(S) - S of a positive definite S = L L^T + 0.1 E: positive definite, within the triangle
/// inequality.
Json inertia() {
  const double a = tenth(9);
  const double b = tenth(9);
  const double c = tenth(9);
  const std::array<double, 3> s{a * a + 0.1, b * b + 0.1, c * c + 0.1};
  return {s[1] + s[2], -a * b, -a * c, s[0] + s[2], -b * c, s[0] + s[1]};
}

Json joint(std::size_t index) {
  const int kind = *rc::gen::inRange(0, index == 0 ? 7 : 8);  // at least one joint
  const char* type = kind < 4 ? "revolute" : kind < 7 ? "prismatic" : "fixed";
  Json result{{"name", fmt::format("j{}", index)},
              {"type", type},
              {"offset", vector()},
              {"rotation", rpy()}};
  if (kind < 7) {
    result["axis"] = axis();
  }
  return result;
}

}  // namespace

nlohmann::json description(int largest) {
  const int count = *rc::gen::inRange(1, largest + 1);
  std::vector<int> fathers;
  std::vector<bool> leaf(static_cast<std::size_t>(count), true);
  for (int i = 0; i < count; ++i) {
    fathers.push_back(*rc::gen::inRange(-1, i));
    if (fathers.back() >= 0) {
      leaf[static_cast<std::size_t>(fathers.back())] = false;
    }
  }
  std::vector<Json> links;
  std::vector<Json> points;
  for (std::size_t i = 0; i < fathers.size(); ++i) {
    const std::string name = fmt::format("link{}", i);
    Json link{{"name", name},
              {"father", fathers[i] < 0 ? "ground" : fmt::format("link{}", fathers[i])},
              {"joint", joint(i)}};
    if (leaf[i] || *rc::gen::inRange(0, 4) > 0) {
      link["mass"] = *rc::gen::inRange(1, 50) / 10.0;
      link["com"] = vector();
      link["inertia"] = inertia();
    }
    links.push_back(link);
    points.push_back({{"name", fmt::format("p{}", i)}, {"link", name}, {"at", vector()}});
  }
  for (std::size_t i = links.size(); i > 1; --i) {  // any numbering
    std::swap(links[i - 1], links[*rc::gen::inRange<std::size_t>(0, i)]);
  }
  return {{"name", "random"}, {"links", links}, {"points", points}};
}

}  // namespace treedyn::random
