// What the errors of `treedyn accuracy` are measured against, and how.
#pragma once

#include <map>
#include <vector>

#include "accuracy/study.hpp"
#include "cli/motions.hpp"

namespace treedyn {

/// Steps of one run at most.
inline constexpr double kMostSteps = 400'000;

/// What is there to measure, and how far settings are off.
class Comparison {
 public:
  /// \pre `subject` outlives it
  Comparison(const Subject& subject, std::vector<model::Point> points);

  /// What settings are compared with from now on.
  void set_reference(std::vector<Motion> exact);
  /// All errors of motions from the starts.
  std::map<accuracy::Error, std::vector<double>> errors(const std::vector<Motion>& motions);
  /// \param sized  cores of which the outcome has the sizes \param timed  it has the wall time
  accuracy::Outcome outcome(const accuracy::Setting& setting, StepWriter& writer,
                            const std::vector<const accuracy::Core*>& sized, bool timed);

 private:
  const Subject& subject_;
  std::vector<model::Point> points_;
  Energies energies_;
  bool slides_ = false;   ///< in the reference rows in m act
  bool turns_ = false;    ///< in rad
  bool happens_ = false;  ///< there are events
  std::vector<Motion> exact_;
  std::vector<GeneratedStep::Values> exact_energies_, exact_places_;
};

/// The generated steps of order five and four in the longest scalar of the host: the first becomes
/// the reference.
std::vector<Motion> reference(const Subject& subject, Comparison& comparison, StepWriter& writer,
                              accuracy::Study& study);

/// `simulate`, as precisely as its steps get through.
void check(const Subject& subject, const std::vector<Motion>& exact, accuracy::Study& study);

}  // namespace treedyn
