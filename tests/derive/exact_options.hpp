// How programs are formulated whose constants are compared as exact fractions.
#pragma once

#include <string>

#include "formulate/formulate.hpp"

namespace treedyn::support {

/// A point on every link and on the ground, gravity in a general direction.
inline formulate::Options exact_options(const model::Tree& tree, int effort) {
  formulate::Options options;
  for (int link = model::kGround; link < tree.size(); ++link) {
    model::Point point;
    point.link = link;
    point.identifier = "p" + std::to_string(options.points.size());
    point.at = {Real("0.25"), Real("-0.5"), Real("0.75")};
    options.points.push_back(point);
  }
  options.gravity = {Real(1), Real(2), Real("-9.81")};
  options.effort = effort;
  options.without = {formulate::Pass::kNormals};  // whose frames have other angles than quarters
  return options;
}

}  // namespace treedyn::support
