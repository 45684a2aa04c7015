#include "request/limits.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/index.hpp"

namespace treedyn {

namespace {

constexpr long kMostJoints = 1000;
constexpr long kMostPathJoints = 20'000;  // a chain of 199 joints has 19900
constexpr long kMostPoints = 5000;
constexpr long kMostPointJoints = 20'000;

void require(const Location& where, const char* what, long count, const char* of, long most) {
  if (count > most) {
    throw InputError(where, fmt::format("{} {} {}, which are too many; expected at most {}", what,
                                        count, of, most));
  }
}

/// By link, the joints between it and the ground.
std::vector<long> path_lengths(const model::Tree& tree) {
  std::vector<long> result;
  for (const model::Link& link : tree.links) {
    result.push_back(1 + (link.father == model::kGround ? 0 : result[to_index(link.father)]));
  }
  return result;
}

}  // namespace

void require_size(const model::Tree& tree, const std::vector<model::Point>& points,
                  const Location& where) {
  require(where, "the model has", tree.size(), "joints that move", kMostJoints);
  const std::vector<long> depth = path_lengths(tree);
  require(where, "the paths from the links of the model to the ground have",
          std::accumulate(depth.begin(), depth.end(), 0L), "joints in all", kMostPathJoints);
  require(where, "the model has", static_cast<long>(points.size()), "points", kMostPoints);
  long of_points = 0;
  for (const model::Point& point : points) {
    of_points += point.link == model::kGround ? 0 : depth[to_index(point.link)];
  }
  require(where, "the paths from the points to the ground have", of_points, "joints in all",
          kMostPointJoints);
}

void refuse_decades(const model::Tree& tree, const std::string& what) {
  const auto distance = [](const model::Link& link) {
    const model::Vector3& com = link.inertia.com;
    return sqrt(com[0] * com[0] + com[1] * com[1] + com[2] * com[2]);
  };
  const model::Link& heaviest =
      *std::ranges::max_element(tree.links, {}, [&](const model::Link& link) {
        const model::Matrix3& I = link.inertia.about_com;
        return link.inertia.mass * distance(link) * distance(link) + I[0] + I[4] + I[8];
      });
  throw InputError(heaviest.where,
                   fmt::format("link '{}', {:.6g} kg, centre of mass {:.6g} m from its joint: {}",
                               shown(heaviest.name), heaviest.inertia.mass.convert_to<double>(),
                               distance(heaviest).convert_to<double>(), what));
}

}  // namespace treedyn
