#include "formulate/stand_ins.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "common/index.hpp"
#include "common/recipe.hpp"
#include "formulate/find_limbs.hpp"
#include "formulate/geometry.hpp"
#include "formulate/origins.hpp"
#include "formulate/scene_numbers.hpp"
#include "formulate/stand_in_numbers.hpp"
#include "model/parameters.hpp"

namespace treedyn::formulate {

namespace {

/// Places of a link.
constexpr int kRow = 64;
/// Beyond the places of links and points.
constexpr int kParameterPlaces = 1 << 24;
constexpr int kOrdinaryPlaces = 3 << 23;
constexpr int kScenePlaces = 1 << 25;

/// The offset between two axes; where there are no two, its components.
Vector3 offset_of(const model::Joint& joint, const model::Joint* father, StandInNumbers& all) {
  if (father == nullptr || !joint.turns() || !father->turns()) {
    return all.vector(StandIn::kOffset, joint.offset);
  }
  return all.offset(joint.offset, father->axis, multiply(joint.rotation, joint.axis));
}

/// \param father  null: the ground
void see(model::Link& link, const model::Joint* father, StandInNumbers& all) {
  link.joint.axis = all.axis(link.joint.axis);
  link.joint.rotation = all.rotation(link.joint.rotation);
  link.joint.offset = offset_of(link.joint, father, all);
  link.inertia.mass = all.number(StandIn::kMass, link.inertia.mass);
  link.inertia.com = all.vector(StandIn::kCom, link.inertia.com);
  link.inertia.about_com = all.symmetric(link.inertia.about_com);
}

void see(model::Point& point, StandInNumbers& all) {
  if (is_fixed(point.at)) {
    point.at = all.vector(StandIn::kOffset, point.at);
  }
  point.rotation = all.rotation(point.rotation);
}

/// For every link the group of links that are alike.
std::vector<int> groups_of(const model::Tree& tree) {
  std::vector<int> groups(tree.links.size());
  int group = 0;
  for (const std::vector<int>& links : similar_links(tree)) {
    ++group;
    for (const int i : links) {
      groups[to_index(i)] = group;
    }
  }
  return groups;
}

/// Near the nominal value and nowhere special: what is zero, equal or in a ratio there is so for
/// all values.
Digits ordinary(const Digits& nominal, StandIn quantity, int parameter) {
  const Digits other = generic(quantity, kOrdinaryPlaces + parameter);
  return nominal == 0 ? Digits(other / 16) : Digits(nominal * (1 + (other - floor(other)) / 64));
}

/// A number that is made of parameters, of these; where they have no value for it, as it is.
void take(const std::vector<Real>& parameters, Real& number) {
  if (number.recipe() != 0) {
    const Real taken = evaluated(number.recipe(), parameters);
    number = isfinite(taken) ? taken : number;
  }
}

/// Of a scene all its numbers, behind those of the robot.
std::shared_ptr<const model::Scene> seen_scene(const model::Scene& scene, const Seen& seen,
                                               const std::vector<Real>& parameters,
                                               StandInNumbers& all) {
  auto result = std::make_shared<model::Scene>(scene);
  result->tree = seen.tree;
  result->points = seen.options.points;
  result->gravity = seen.options.gravity;
  all.begin(kScenePlaces, 0);
  each_number(*result, [&](std::span<Real> numbers, const SceneMeaning& meaning) {
    all.begin(all.place(), group_of(meaning.what));
    std::ranges::for_each(numbers, [&](Real& number) { take(parameters, number); });
    if (is_fixed(numbers)) {
      see(numbers, meaning.form, all);
    }
  });
  return result;
}

/// Numbers that are known at run time only are like no other number, zeros and ones as well, and
/// have ordinary values.
/// \param tree, points  as they are given
/// \return the parameters
std::vector<Real> see_parameters(const model::Tree& tree, const std::vector<model::Point>& points,
                                 Seen& seen) {
  constexpr std::array<StandIn, 7> kParts = {StandIn::kMass,   StandIn::kCom,    StandIn::kInertia,
                                             StandIn::kOffset, StandIn::kOffset, StandIn::kGravity,
                                             StandIn::kScene};
  std::vector<Real> result;
  for (const model::Parameter& parameter : seen.tree.parameters) {
    const auto index = static_cast<int>(result.size());
    const StandIn quantity = kParts[static_cast<std::size_t>(parameter.quantity)];
    const Digits stand_in = generic(quantity, kParameterPlaces + index);
    const Real nominal = model::nominal(seen.tree, seen.options.gravity, parameter);
    result.push_back(
        Real::of_parameter(index, ordinary(nominal.digits(), quantity, index), stand_in));
    model::set(seen.tree, seen.options.gravity, parameter, result.back());
  }
  for (const auto& [k, own] : model::points_with_parameters(tree, points)) {
    seen.options.points[k].at = seen.tree.points[own].at;
  }
  return result;
}

Seen see(const model::Tree& tree, const Options& options) {
  Seen seen{tree, options};
  StandInNumbers all;
  const std::vector<int> groups = groups_of(tree);
  int rows = 0;
  for (model::Link& link : seen.tree.links) {
    all.begin(kRow * rows, groups[to_index(rows)]);
    const bool is_root = link.father == model::kGround;
    see(link, is_root ? nullptr : &seen.tree.links[to_index(link.father)].joint, all);
    ++rows;
  }
  for (model::Frame& frame : seen.tree.frames) {
    all.begin(kRow * rows++, 0);
    frame.rotation = all.rotation(frame.rotation);
    frame.origin = all.vector(StandIn::kOffset, frame.origin);
  }
  for (std::vector<model::Point>* points : {&seen.tree.points, &seen.options.points}) {
    for (model::Point& point : *points) {
      all.begin(kRow * rows++, -1);
      see(point, all);
    }
  }
  all.begin(kRow * rows, 0);
  if (is_fixed(options.gravity)) {
    seen.options.gravity = all.vector(StandIn::kGravity, options.gravity);
  }
  const std::vector<Real> parameters = see_parameters(tree, options.points, seen);
  if (options.scene != nullptr) {
    const auto of_scene = [&](Real& number) {
      take(parameters, number);
    };
    std::ranges::for_each(seen.options.gravity, of_scene);
    for (model::Point& point : seen.options.points) {
      std::ranges::for_each(point.at, of_scene);
    }
    seen.scene = seen_scene(*options.scene, seen, parameters, all);
    seen.options.scene = seen.scene.get();
  }
  return seen;
}

template <class Change, class... Arrays>
void change_all(Change change, Arrays&... arrays) {
  (std::ranges::for_each(arrays, change), ...);
}

template <class Change>
void change_numbers(model::Tree& tree, Change change) {
  for (model::Link& link : tree.links) {
    change_all(change, link.joint.axis, link.joint.rotation, link.joint.offset, link.inertia.com,
               link.inertia.about_com);
    change(link.inertia.mass);
  }
  for (model::Frame& frame : tree.frames) {
    change_all(change, frame.rotation, frame.origin);
  }
  for (model::Point& point : tree.points) {
    change_all(change, point.at, point.rotation);
  }
}

/// With `change` done to all numbers that may be seen as others.
template <class Change>
Seen changed(const model::Tree& tree, const Options& options, Change change) {
  Seen result{tree, options};
  change_numbers(result.tree, change);
  for (model::Point& point : result.options.points) {
    change_all(change, point.at, point.rotation);
  }
  change_all(change, result.options.gravity);
  const auto in_scene = [&](std::span<Real> numbers, const SceneMeaning&) {
    std::ranges::for_each(numbers, change);
  };
  change(result.options.restitution);
  for (model::JointForce& own : result.options.phase_forces) {
    change(own.force);
  }
  for (model::Event& event : result.options.events) {
    each_number(event, in_scene);
  }
  if (options.scene != nullptr) {
    auto scene = std::make_shared<model::Scene>(*options.scene);
    change_numbers(scene->tree, change);
    each_number(*scene, in_scene);
    scene->points = result.options.points;
    scene->gravity = result.options.gravity;
    result.options.scene = scene.get();
    result.scene = std::move(scene);
  }
  return result;
}

}  // namespace

Seen with_stand_ins(const model::Tree& tree, const Options& options) {
  Seen seen = see(tree, options);
  note_provenance(seen);
  return seen;
}

Seen with_parameters(const model::Tree& tree, const Options& options) {
  Seen seen{tree, options};
  see_parameters(tree, options.points, seen);
  return seen;
}

Seen stand_ins_alone(const model::Tree& tree, const Options& options) {
  return changed(tree, options, [](Real& number) {
    number = number.recipe() == 0 ? Real(number.seen())
                                  : Real::of_parameter(-1, number.seen(), number.seen());
  });
}

Seen numbers_alone(const model::Tree& tree, const Options& options) {
  return changed(tree, options,
                 [](Real& number) { number = number.recipe() == 0 ? number.plain() : number; });
}

Real run_time_number(int index, const Real& nominal) {
  return Real::of_parameter(index, nominal.digits(),
                            generic(StandIn::kScene, kParameterPlaces + index));
}

model::Scene with_values(const model::Scene& scene, const std::vector<Real>& parameters) {
  Options options;
  options.scene = &scene;
  options.gravity = scene.gravity;
  options.points = scene.points;
  const auto fixed = [&](Real& number) {
    number = number.recipe() == 0 ? number.plain() : evaluated(number.recipe(), parameters);
  };
  model::Scene result = *changed(scene.tree, options, fixed).scene;
  std::size_t k = 0;
  for (const model::Parameter& parameter : scene.tree.parameters) {
    model::set(result.tree, result.gravity, parameter, parameters[k++].plain());
  }
  for (const auto& [point, own] : model::points_with_parameters(scene.tree, scene.points)) {
    result.points[point].at = result.tree.points[own].at;
  }
  result.tree.parameters.clear();
  return result;
}

}  // namespace treedyn::formulate
