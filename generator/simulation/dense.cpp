#include "simulation/dense.hpp"

namespace treedyn::simulation {

void Dense::set(double h, const Vector& y, const Vector& qdd, const Vector& next) {
  const Eigen::Index n = y.size() / 2;
  q_.setZero(n, 6);
  v_.setZero(n, 4);
  q_.col(0) = y.head(n);
  q_.col(1) = h * y.tail(n);
  q_.col(2) = 3 * (next.head(n) - y.head(n)) - h * (2 * y.tail(n) + next.tail(n));
  q_.col(3) = -2 * (next.head(n) - y.head(n)) + h * (y.tail(n) + next.tail(n));
  v_.col(0) = y.tail(n);
  v_.col(1) = h * qdd;
  v_.col(2) = next.tail(n) - y.tail(n) - h * qdd;
}

void Dense::set(double h, const Vector& y, const Vector& qdd, const Vector& next,
                const Vector& qdd_next) {
  const Eigen::Index n = y.size() / 2;
  q_.setZero(n, 6);
  v_.setZero(n, 4);
  q_.col(0) = y.head(n);
  q_.col(1) = h * y.tail(n);
  q_.col(2) = h * h / 2 * qdd;
  const Vector d = next.head(n) - q_.col(0) - q_.col(1) - q_.col(2);
  const Vector v = h * (next.tail(n) - y.tail(n) - h * qdd);
  const Vector a = h * h * (qdd_next - qdd);
  q_.col(3) = 10 * d - 4 * v + a / 2;
  q_.col(4) = -15 * d + 7 * v - a;
  q_.col(5) = 6 * d - 3 * v + a / 2;
  v_.col(0) = y.tail(n);
  v_.col(1) = h * qdd;
  v_.col(2) = 3 * (next.tail(n) - y.tail(n)) - h * (2 * qdd + qdd_next);
  v_.col(3) = -2 * (next.tail(n) - y.tail(n)) + h * (qdd + qdd_next);
}

const Vector& Dense::at(double s) {
  const Eigen::Index n = q_.rows();
  y_.setZero(2 * n);
  for (Eigen::Index k = q_.cols() - 1; k >= 0; --k) {  // Horner's rule
    y_.head(n) = y_.head(n) * s + q_.col(k);
  }
  for (Eigen::Index k = v_.cols() - 1; k >= 0; --k) {
    y_.tail(n) = y_.tail(n) * s + v_.col(k);
  }
  return y_;
}

}  // namespace treedyn::simulation
