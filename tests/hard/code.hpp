// The generated functions of a scene, compiled for this machine.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "formulate/scene_steps.hpp"
#include "hard/motion.hpp"
#include "support/compiled.hpp"

namespace treedyn::hard {

using Numbers = std::vector<double>;
/// Arrays of a call, by the names of the header.
using Arrays = std::map<std::string, Numbers>;

class Code {
 public:
  /// The whole way from the scene to text in `scalar`, search left out, proof included.
  /// \param functions  of the scene; empty: all that it needs
  Code(const model::Scene& scene, const std::string& scalar,
       const std::vector<std::string>& functions);

  /// \param inputs  at least those of the function
  [[nodiscard]] Arrays call(const std::string& function, const Arrays& inputs) const;
  [[nodiscard]] bool has(const std::string& function) const {
    return compiled_->manifest().has(function);
  }
  /// Additions, multiplications and divisions of one call, as the manifest states them.
  [[nodiscard]] long operations(const std::string& function) const;
  /// The phases of `step`, in the order of its numbers.
  [[nodiscard]] const std::vector<formulate::PhaseState>& states() const { return states_; }

 private:
  std::vector<formulate::PhaseState> states_;
  std::unique_ptr<support::CompiledModel> compiled_;
};

/// Where every constraint begins to act, in the order of `anchor`. \param q  of now
Numbers anchors_at(const model::Scene& scene, const Vector& q, double t);

}  // namespace treedyn::hard
