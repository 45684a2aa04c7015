// Names of the functions of a scene and of their rows.
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"

namespace treedyn::formulate {

/// An impact that some event of the scene has.
struct ImpactName {
  std::vector<int> constraints;
  std::vector<int> held;  ///< of them those that are led through it
  Real restitution = 0;   ///< of the others
  std::string name = {};

  [[nodiscard]] bool same_as(const ImpactName& other) const {
    return constraints == other.constraints && held == other.held &&
           restitution == other.restitution;
  }
};

/// That of an event with this restitution, its own or none.
inline ImpactName impact_with(const model::Impact& impact, const Real& restitution,
                              const std::string& name = "") {
  return {impact.constraints, impact.held, restitution, name};
}

/// Every impact once; where a slow rebound comes to rest also the one without rebound. One impact
/// is called impact, several are called after the phases that they end.
std::vector<ImpactName> impacts_of(const model::Scene& scene);

/// "foot: force along z" for every row of the constraints.
std::vector<std::string> row_names(const model::Scene& scene, const std::vector<int>& active);

/// "anchor 0 to 2: position of foot when left_stance began to act" for every anchor of the scene.
std::vector<std::string> anchor_names(const model::Scene& scene);

/// Of a function of one contact: the point's identifier follows unless there is one contact.
std::string contact_name(const model::Scene& scene, std::size_t contact, const std::string& stem);

/// Of a function in a phase: with several phases the phase's identifier follows.
std::string phase_name(const model::Scene& scene, std::size_t phase, const std::string& function);

}  // namespace treedyn::formulate
