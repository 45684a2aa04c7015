// Lets Eigen compute with Real.
#pragma once

#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Core>

#include "common/real.hpp"

template <>
struct Eigen::NumTraits<treedyn::Real> : Eigen::NumTraits<treedyn::Digits> {
  using Real = treedyn::Real;
  using NonInteger = treedyn::Real;
  using Nested = treedyn::Real;
  using Literal = double;
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real dummy_precision() { return 1000 * epsilon(); }
  static Real highest() { return std::numeric_limits<Real>::max(); }
  static Real lowest() { return std::numeric_limits<Real>::lowest(); }
};
