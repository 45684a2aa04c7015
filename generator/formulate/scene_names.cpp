#include "formulate/scene_names.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "formulate/scene_phases.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

/// x, y, z, or the components of a direction.
std::string direction_text(const model::Vector3& d) {
  for (std::size_t n = 0; n < 3; ++n) {
    if (d[n] == 1 && d[(n + 1) % 3] == 0 && d[(n + 2) % 3] == 0) {
      return std::string(1, "xyz"[n]);
    }
  }
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", d[0].convert_to<double>(),
                     d[1].convert_to<double>(), d[2].convert_to<double>());
}

/// The name, or the first of name_2, name_3, .. that is not taken; it is taken then.
std::string counted(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int k = 2; !taken.insert(result).second; ++k) {
    result = fmt::format("{}_{}", name, k);
  }
  return result;
}

/// That of the point; further ones of a point are counted, beside points that are called so.
std::vector<std::string> names_of_contacts(const model::Scene& scene) {
  std::vector<std::string> names;
  std::vector<std::size_t> further;
  std::set<std::string> taken;
  for (const model::GroundContact& contact : scene.contacts) {
    const auto point = static_cast<std::size_t>(contact.point);
    names.push_back(to_identifier(scene.points[point].identifier));
    if (!taken.insert(names.back()).second) {
      further.push_back(names.size() - 1);
    }
  }
  for (const std::size_t contact : further) {
    names[contact] = counted(names[contact], taken);
  }
  return names;
}

}  // namespace

std::vector<ImpactName> impacts_of(const model::Scene& scene) {
  std::vector<ImpactName> result;
  const auto add = [&](const ImpactName& impact) {
    const auto same = [&](const ImpactName& other) {
      return other.same_as(impact);
    };
    if (!impact.constraints.empty() && std::ranges::none_of(result, same)) {
      result.push_back(impact);
    }
  };
  for (const model::Phase& phase : scene.phases) {
    for (const model::Event& event : phase.until) {
      if (!event.impact) {
        continue;
      }
      const std::string name = fmt::format("impact_{}", to_identifier(phase.name));
      add(impact_with(*event.impact, event.impact->restitution, name));
      if (event.impact->rest_below > 0) {
        add(impact_with(*event.impact, 0, name + "_at_rest"));
      }
    }
  }
  if (result.size() == 1) {
    result.front().name = "impact";
  }
  const bool one = result.size() == 1;
  for (const model::Phase& phase : scene.phases) {
    for (const model::Event& event : phase.until) {
      if (rests_unasked(scene, event)) {
        add(impact_with(
            *event.impact, 0,
            one ? "impact_at_rest" : fmt::format("impact_{}_at_rest", to_identifier(phase.name))));
      }
    }
  }
  std::set<std::string> taken;
  for (ImpactName& impact : result) {
    impact.name = counted(impact.name, taken);
  }
  return result;
}

std::vector<std::string> row_names(const model::Scene& scene, const std::vector<int>& active) {
  std::vector<std::string> names;
  for (const int c : active) {
    const model::Constraint& constraint = scene.constraints[static_cast<std::size_t>(c)];
    const bool turning = constraint.kind == model::ConstraintKind::kOrientation;
    if (constraint.kind == model::ConstraintKind::kJoint) {
      names.push_back(
          fmt::format("{}: {} of the joint", constraint.name,
                      scene.tree.moved_by(constraint.joint).joint.turns() ? "moment" : "force"));
    }
    for (const model::Vector3& d : constraint.directions) {
      names.push_back(fmt::format("{}: {} {}", constraint.name,
                                  turning ? "moment about" : "force along", direction_text(d)));
    }
  }
  return names;
}

std::vector<std::string> anchor_names(const model::Scene& scene) {
  std::vector<std::string> names;
  for (int c = 0; c < static_cast<int>(scene.constraints.size()); ++c) {
    const int size = anchor_size(scene, c);
    if (size == 0) {
      continue;
    }
    const model::Constraint& constraint = scene.constraints[static_cast<std::size_t>(c)];
    const auto point = static_cast<std::size_t>(constraint.point);
    const int first = anchor_offset(scene, c);
    const std::string place =
        size == 1 ? fmt::format("anchor {}: position of the joint", first)
                  : fmt::format("anchor {} to {}: {} of {}", first, first + size - 1,
                                size == 3 ? "position" : "rotation", scene.points[point].name);
    names.push_back(fmt::format("{} when {} began to act", place, constraint.name));
  }
  return names;
}

std::string contact_name(const model::Scene& scene, std::size_t contact, const std::string& stem) {
  return scene.contacts.size() == 1
             ? stem
             : fmt::format("{}_{}", stem, names_of_contacts(scene).at(contact));
}

std::string phase_name(const model::Scene& scene, std::size_t phase, const std::string& function) {
  return scene.phases.size() == 1
             ? function
             : fmt::format("{}_{}", function, to_identifier(scene.phases[phase].name));
}

}  // namespace treedyn::formulate
