// Rounding errors of formulations: what each pass costs in accuracy.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "formulate/formulate.hpp"
#include "model/tree.hpp"

namespace treedyn::benchmark {

/// Where a state lies.
enum class Region {
  kUsual,     ///< angles in [-pi, pi], a fifth of them small (1e-1 .. 1e-6)
  kSingular,  ///< every joint near a multiple of pi/2 (stretched arms), or a base near 90 degrees
              ///< pitch
  kLarge,     ///< angles up to 100 rad
};
inline constexpr std::array<const char*, 3> kRegions{"usual", "singular", "large"};

/// The largest error of a function by region.
struct Errors {
  /// |x - y| of an entry relative to its natural scale, the sum of the magnitudes of the terms of
  /// its equation (Engine::scales): a few unit roundoffs of it cannot be avoided, also where y is
  /// nearly zero (B near right angles).
  std::array<double, kRegions.size()> scaled{};
  /// max|x - y| relative to max|y| and to what relative changes of the inputs by 1 make of y, to
  /// first order. Rounding of the inputs, and of sums of angles, costs 1 unit roundoff of it, also
  /// where y is steep (forward dynamics near a singular position, large angles).
  std::array<double, kRegions.size()> conditioned{};
};

/// What is asked of a robot.
struct Subject {
  std::string name;
  model::Tree tree;
  std::size_t states = 0;  ///< in each region
  int effort = 0;          ///< of the search
};

/// One way to formulate a function.
struct Formulation {
  std::string name;  ///< "all passes", "without sums, search", "no pass"
  std::vector<formulate::Pass> without;
  std::size_t with = 0;  ///< number of the formulation that has the pass that this one lacks
  formulate::ForwardDynamics forward_dynamics = formulate::ForwardDynamics::kCheapest;
};

/// All passes; all but `sums`, which rounds where the others do not; all but that and one more;
/// none.
std::vector<Formulation> formulations_by_pass();
/// Forward dynamics by the factor of A and by articulated bodies.
std::vector<Formulation> formulations_of_forward_dynamics();

struct Accuracy {
  std::string robot;
  std::string function;
  Formulation formulation;
  int operations = 0;
  Errors in_double{};
  Errors in_float{};
};

/// Errors of one function against 50 digits, one row a formulation; deterministic.
///
/// The operations of a formulation are executed one by one in double and in float, as the generated
/// text executes them without contraction to fused multiply-adds. The reference is the last
/// formulation executed with 50 digits; every 50th state it is compared with the block equations.
/// \throws std::runtime_error if those differ
std::vector<Accuracy> accuracy(const Subject& subject, const std::string& function,
                               const std::vector<Formulation>& formulations);

/// How many times larger the errors of `a` are than those of `b`, entry by entry; 1 where `a` is
/// within `floor`.
Errors factors(const Errors& a, const Errors& b, double floor);

}  // namespace treedyn::benchmark
