// Vectors and 3x3 matrices of Real, as much of them as the checks of a model need.
#pragma once

#include "model/tree.hpp"

namespace treedyn::description {

using model::Matrix3;
using model::Vector3;

Matrix3 identity();
Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(const Real& s, const Vector3& a);
Matrix3 operator+(const Matrix3& a, const Matrix3& b);
Vector3 operator*(const Matrix3& a, const Vector3& x);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& a);
Real dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Real norm(const Vector3& a);
Real determinant(const Matrix3& a);
/// Largest |a_kl - b_kl|.
Real distance(const Matrix3& a, const Matrix3& b);
/// Inertia of the point mass m at `d` about the origin: m (d.d E - d d^T), that is -m Lambda(d)^2.
Matrix3 point_inertia(const Real& m, const Vector3& d);
/// The eigenvalues of a symmetric matrix, ascending; Jacobi rotations, 50 digits.
Vector3 eigenvalues(const Matrix3& a);

}  // namespace treedyn::description
