#include "limits.hpp"

#include <numeric>

#include <fmt/format.h>

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
    result.push_back(
        1 + (link.father == model::kGround ? 0 : result[static_cast<std::size_t>(link.father)]));
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
    of_points += point.link == model::kGround ? 0 : depth[static_cast<std::size_t>(point.link)];
  }
  require(where, "the paths from the points to the ground have", of_points, "joints in all",
          kMostPointJoints);
}

}  // namespace treedyn
