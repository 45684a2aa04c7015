// What single numbers are seen as (formulate/stand_ins.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::formulate {

enum class StandIn : std::uint8_t { kMass, kOffset, kCom, kInertia, kAngle, kGravity, kScene };
inline constexpr std::size_t kStandIns = 7;

/// A number with 50 digits that nothing but its place decides.
Digits generic(StandIn quantity, int place);

/// What all numbers of one quantity and magnitude are seen as: the first of equal and opposite ones
/// as a positive number, so that no sign decides. Equal numbers of links that are not alike are no
/// structure, but for angles and distances of joints.
class StandInNumbers {
 public:
  /// Those of the numbers that follow; each place has one number. Groups tell equal numbers apart:
  /// links that are alike have one.
  void begin(int place, int group) {
    place_ = place;
    group_ = group;
  }
  [[nodiscard]] int place() const { return place_; }

  Real number(StandIn quantity, const Real& x);
  model::Vector3 vector(StandIn quantity, const model::Vector3& v);
  /// From a joint to the next one, of these axes: what of it is zero along their common normal, or
  /// along or across parallel ones, stays so, whatever axes its components are along. Its parts
  /// along the axes are seen as others then, instead of its components.
  model::Vector3 offset(const model::Vector3& d, const model::Vector3& father_axis,
                        const model::Vector3& axis);
  model::Matrix3 symmetric(const model::Matrix3& m);
  /// By the three angles of which most are exact and which keep its pattern.
  model::Matrix3 rotation(const model::Matrix3& r);
  /// A unit vector by longitude and latitude.
  model::Vector3 axis(const model::Vector3& v);

 private:
  struct Known {
    int group;
    Digits value;
    Digits stand_in;
  };
  Digits of_value(StandIn quantity, const Digits& value, int place);
  /// Multiples of pi/12 are seen as such, the others in their eighth of a turn.
  Digits of_angle(const Digits& angle, int place, int& changed);

  std::array<std::vector<Known>, kStandIns> known_;
  int place_ = 0;
  int group_ = 0;
};

}  // namespace treedyn::formulate
