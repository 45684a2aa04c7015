#include "request/limits.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/index.hpp"
#include "description/vectors.hpp"

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

}  // namespace

void require_size(const model::Tree& tree, const std::vector<model::Point>& points,
                  const Location& where) {
  require(where, "the model has", tree.size(), "joints that move", kMostJoints);
  const std::vector<int> depth = model::depths(tree);
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
  double most = -1;
  Location place;
  std::string text;
  const auto consider = [&](const Real& size, const Location& where, const std::string& of,
                            const char* unit) {
    const double number = abs(size).convert_to<double>();
    const double decades = std::abs(std::log10(number));
    if (number > 0 && decades > most) {
      most = decades;
      place = where;
      text = fmt::format("{} {:.6g}{}", of, number, unit);
    }
  };
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const model::Link& link = tree.links[i];
    const model::Inertia& inertia = link.inertia;
    const std::string name = fmt::format("link '{}': ", shown(link.name));
    const std::string joint = fmt::format("joint '{}': ", shown(link.joint.name));
    const model::Matrix3& I = inertia.about_com;
    consider(inertia.mass, link.where, name + "mass", " kg");
    consider(description::norm(inertia.com), link.where, name + "centre of mass at", " m");
    consider(I[0] + I[4] + I[8], link.where, name + "inertia of trace", " kg m^2");
    consider(description::norm(link.joint.offset), link.joint.where, joint + "origin at", " m");
    consider(tree.drives[i].multiplier, link.joint.where, joint + "multiplier", "");
  }
  throw InputError(place, fmt::format("{}: {}", text, what));
}

}  // namespace treedyn
