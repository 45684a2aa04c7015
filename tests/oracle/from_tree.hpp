// A checked model as the plain structs of the oracle.
#pragma once

#include <string>
#include <vector>

#include "model/tree.hpp"
#include "oracle/functions.hpp"

namespace treedyn::oracle {

template <class T, std::size_t N>
std::array<T, N> converted(const std::array<Real, N>& values) {
  std::array<T, N> result{};
  for (std::size_t k = 0; k < N; ++k) {
    result[k] = static_cast<T>(values[k]);
  }
  return result;
}

/// \pre `tree.drives` are identities: every joint is a coordinate.
template <class T>
Robot<T> from_tree(const model::Tree& tree) {
  Robot<T> result;
  for (const model::Link& link : tree.links) {
    const model::Joint& joint = link.joint;
    result.push_back({link.father, joint.type == model::JointType::kRevolute,
                      converted<T>(joint.axis), converted<T>(joint.offset),
                      converted<T>(joint.rotation), static_cast<T>(link.inertia.mass),
                      converted<T>(link.inertia.com), converted<T>(link.inertia.about_com)});
  }
  return result;
}

template <class T>
Problem<T> problem_of(const model::Tree& tree, const std::vector<model::Point>& points,
                      const model::Vector3& gravity) {
  Problem<T> result{from_tree<T>(tree), converted<T>(gravity), {}};
  for (const model::Point& point : points) {
    result.points.push_back({point.link, converted<T>(point.at), converted<T>(point.rotation)});
  }
  return result;
}

/// max|x|
inline Real largest(const std::vector<Real>& values) {
  Real result = 0;
  for (const Real& value : values) {
    result = std::max(result, Real(abs(value)));
  }
  return result;
}

}  // namespace treedyn::oracle
