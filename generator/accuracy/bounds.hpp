// Bounds of rounding errors that hold in every state of a range.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "accuracy/bound_steps.hpp"

namespace treedyn::accuracy {

/// A range of states: one interval for every element of the arguments, array after array.
using Box = std::vector<Interval>;

/// How far one output of a function, computed in some arithmetic, may be from its exact value.
///
/// An operation of the code leaves op(a, b) + e with |e| <= half a unit in the last place of the
/// largest op(a, b), and the smallest normal number more (smaller ones may be flushed to zero); a
/// constant is off by what its literal is, a sine or cosine by the error that headers state
/// (`libm`: 1 ulp of 1). Nothing is dropped: the output is a function y(e) of all these e, and by
/// the mean value theorem y(e) - y(0) = sum of e_k dy/de_k(t e) for some t in [0, 1]. One backward
/// sweep encloses the derivatives, with ranges of values that contain whatever any e brings about.
/// Fused operations round less and stay within.
///
/// What intervals forget of sines and cosines, |c x + s y|^2 <= x^2 + y^2, is used where the code
/// has such a sum, and where a derivative is one.
class OutputError {
 public:
  OutputError(const program::Function& function, program::Ref output, const Arithmetic& how);

  /// In every state of the box; infinite if there is none, see `obstacle`. O(operations)
  double operator()(const Box& box);

  /// Why the last bound is infinite: "a divisor may be zero"; "" if it is not.
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

  /// The elements of the box that the output depends on.
  [[nodiscard]] std::set<int> inputs() const;
  /// Those of them that anything but a sine or cosine takes.
  [[nodiscard]] std::set<int> inputs_as_they_are() const;

 private:
  [[nodiscard]] const Interval& value(int k) const { return values_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Interval a(const BoundStep& of) const {
    return of.minus_a ? -value(of.a) : value(of.a);
  }
  [[nodiscard]] Interval b(const BoundStep& of) const {
    return of.minus_b ? -value(of.b) : value(of.b);
  }
  [[nodiscard]] Interval exact(const BoundStep& of, const Box& box) const;
  [[nodiscard]] Interval sum(const BoundStep& of) const;
  [[nodiscard]] Interval wave(const BoundStep& of) const;
  [[nodiscard]] Interval turned(double x, double y) const;
  [[nodiscard]] double noise(const BoundStep& of, const Interval& exact) const;
  [[nodiscard]] Interval passed(int product) const;
  void note_obstacle(const BoundStep& of, const Interval& exact);
  void forward(const Box& box);
  void backward(std::size_t k);

  struct Limits {
    double unit, least, largest;  ///< roundoff, smallest normal and largest number
    double sine_error, sine_range;
  };
  static Limits limits_of(const Arithmetic& how);

  Limits limits_;
  std::vector<BoundStep> steps_;
  std::vector<Interval> values_, slopes_;
  std::vector<double> noises_;
  std::string obstacle_;
};

}  // namespace treedyn::accuracy
