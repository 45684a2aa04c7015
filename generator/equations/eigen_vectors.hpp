// 3-vectors and 3x3 matrices of any scalar type.
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace treedyn::equations {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3, Eigen::RowMajor>;

template <class Scalar, class Number, class Convert>
Vector3<Scalar> vector3(const std::array<Number, 3>& a, const Convert& convert) {
  return {convert(a[0]), convert(a[1]), convert(a[2])};
}

template <class Scalar, class Number, class Convert>
Matrix3<Scalar> matrix3(const std::array<Number, 9>& a, const Convert& convert) {
  Matrix3<Scalar> result;
  for (std::size_t n = 0; n < a.size(); ++n) {
    result.data()[n] = convert(a[n]);
  }
  return result;
}

}  // namespace treedyn::equations
