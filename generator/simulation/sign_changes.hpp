// Where a function changes its sign: all places in an interval, not the ends alone.
#pragma once

#include <functional>
#include <vector>

namespace treedyn::simulation {

/// A change of sign between two samples.
struct SignChange {
  double low;
  double high;
};

struct SignChanges {
  std::vector<SignChange> places;  ///< ascending; signs alternate
  double undefined = -1;           ///< the first sample that is not a number; -1: none
  long evaluations = 0;
};

/// Halves of halves of a piece that are looked at.
inline constexpr int kSignDepth = 12;
/// Samples after which halves are no longer looked at: a function that is noise.
inline constexpr int kSignSamples = 4000;

/// The changes of sign of g in [0, 1], double ones too.
///
/// Every piece is sampled at five points. It is done where the parabola through three of them
/// predicts the other two so well that it proves, with four times its error, that the function
/// keeps its sign or is monotone; otherwise its halves follow, and the parabola's extremum is a
/// sample as well.
/// \param start   the sign at 0, +1 or -1, whatever rounding says there
/// \param pieces  to begin with, at least 1: short against the function's own scale
/// \param band    below it a value has the sign of the sample before
SignChanges sign_changes(const std::function<double(double)>& g, int start, int pieces,
                         double band);

/// The end of [low, high] on the far side of a root, apart by `resolution`: Chandrupatla's method.
/// \pre sign(g(high)) is `side`'s opposite; \return low if so is that of g(low)
double far_side(const std::function<double(double)>& g, int side, double low, double high,
                double resolution);

}  // namespace treedyn::simulation
