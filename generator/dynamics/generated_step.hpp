// A scene's generated `step`, compiled for this machine and called.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "emit/unit.hpp"
#include "program/stepper.hpp"

namespace treedyn {

/// What happened within a step that tells it, Stepper::tells.
struct SteppedEvent {
  int number = 0;      ///< among all events of all phases
  long double at = 0;  ///< s from the beginning of the step
};

class GeneratedStep {
 public:
  /// Of every scalar type, unrounded.
  using Values = std::vector<long double>;

  /// Compiles the files NAME.hpp and NAME.cpp, without contraction.
  /// \param stepper  what they are of \throws InputError without a compiler
  GeneratedStep(const std::string& name, const std::vector<emit::File>& files,
                program::Stepper stepper);
  GeneratedStep(const GeneratedStep&) = delete;
  GeneratedStep& operator=(const GeneratedStep&) = delete;
  ~GeneratedStep();

  /// An argument, rounded to the scalar type by the call. \pre it is one
  Values& at(const std::string& name);
  [[nodiscard]] bool has(const std::string& name) const;
  /// Calls it; what the step gives for the next one becomes the argument. \return the status
  int call();
  [[nodiscard]] const program::Stepper& stepper() const { return stepper_; }
  /// Wall time of one call with the arguments as they are, s: the shortest of some batches.
  [[nodiscard]] double seconds();
  /// Of the last call.
  [[nodiscard]] const std::vector<SteppedEvent>& events() const { return events_; }
  /// How often the last call did what program::Repeated says.
  [[nodiscard]] const program::Repetitions& repeated() const { return repeated_; }

 private:
  struct Library;

  program::Stepper stepper_;
  std::map<std::string, Values> values_;
  std::vector<Values*> in_;                           ///< of values_, in the order of the call
  std::vector<Values*> out_;                          ///< likewise
  std::vector<std::pair<Values*, Values*>> carried_;  ///< from a result to the next call
  std::vector<SteppedEvent> events_;
  program::Repetitions repeated_ = {};
  std::unique_ptr<Library> library_;
};

/// The bits of a status by their names in the header.
std::string status_names(int status);

}  // namespace treedyn
