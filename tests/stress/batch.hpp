// Many robots in one translation unit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stress/reference.hpp"

namespace treedyn::stress {

/// The generated code of some robots, compiled once. \pre names are identifiers, each once
class Batch {
 public:
  Batch(const std::vector<Robot>& robots, const std::string& scalar);

  /// The first output of a function of a robot in its state.
  [[nodiscard]] std::vector<double> call(const Robot& robot, const std::string& function) const;

 private:
  std::shared_ptr<void> library_;
};

}  // namespace treedyn::stress
