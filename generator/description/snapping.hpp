// Rotations and axes with exact entries: snapping, INTERFACE.md 2, and orthonormalisation.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"
#include "description/raw_tree.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {

/// What snapping did and what it nearly did.
struct SnapLog {
  std::vector<model::Snap> snaps;
  /// Values farther than the tolerance, but not farther than 1e-4; angles that are multiples of
  /// pi/12 but for what two or three decimals leave: 1.57, 0.785.
  std::vector<Warning> misses;
};

/// Makes exact what is within a tolerance of an exact value: angles at multiples of pi/12, entries
/// at the sines and cosines of these. What is exact but for the rounding of 50 digits is always
/// made exact.
///
/// An entry snaps only if it keeps its exact value when the rotation or axis is normalised: so
/// never one of a rotation by a general angle that happens to pass by 1/2.
class Snapper {
 public:
  /// \param tolerance rad; 0: off
  Snapper(const RawTree& raw, Real tolerance) : raw_(raw), tolerance_(std::move(tolerance)) {}

  /// Rz(yaw) Ry(pitch) Rx(roll). `written` are the three texts; `what` names them: "joint 'elbow':
  /// rpy".
  Matrix3 from_rpy(const Vector3& rpy, const Numbers& written, const std::string& what);
  /// The rotation next to a matrix. \throws InputError if an entry is farther than 1e-9 from it.
  Matrix3 from_matrix(const Matrix3& matrix, const Numbers& written, const std::string& what);
  /// A product of rotations: that of a joint behind fixed ones, which stands at `where`.
  Matrix3 composed(const Matrix3& product, const Place& where, const std::string& what);
  /// The unit vector along `axis`. \throws InputError if it has no length.
  Vector3 unit_axis(const Vector3& axis, const Numbers& written, const std::string& what);

  [[nodiscard]] const SnapLog& log() const { return log_; }

 private:
  struct SinCos {
    Real sin;
    Real cos;
  };
  SinCos sin_cos(const Real& angle, const Text& written, const std::string& what);
  template <std::size_t size, typename Project>
  std::array<Real, size> snap_entries(const std::array<Real, size>& given, const Numbers& written,
                                      const std::string& what, const Project& project);
  void record(const Real& given, const Real& exact, const std::string& exact_text,
              const Text& written, const std::string& what, bool few_digits = false);

  const RawTree& raw_;
  Real tolerance_;
  SnapLog log_;
};

}  // namespace treedyn::description
