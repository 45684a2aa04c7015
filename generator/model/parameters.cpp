#include "model/parameters.hpp"

#include <algorithm>
#include <array>

#include "common/identifier.hpp"
#include "common/index.hpp"

namespace treedyn::model {

namespace {

/// Of these entries the places in a row-major matrix, and in its transpose.
constexpr std::array<std::size_t, 6> kPlaces = {0, 1, 2, 4, 5, 8};
constexpr std::array<std::size_t, 6> kMirrored = {0, 3, 6, 4, 7, 8};

/// A row for each ParameterKind, in their order.
struct Kind {
  const char* name;
  int count;
  const char* unit;
  const char* meaning;
};
constexpr std::array<Kind, 7> kKinds = {{
    {"mass", 1, "kg", "mass"},
    {"com", 3, "m", "centre of mass"},
    {"inertia", 6, "kg m^2", "inertia about the centre of mass"},
    {"offset", 3, "m", "joint offset"},
    {"at", 3, "m", "place"},
    {"gravity", 3, "m/s^2", "gravity"},
    {"", 1, "", "parameter"},
}};
/// Those that a model declares.
constexpr std::size_t kOfModels = kKinds.size() - 1;

const Kind& kind(ParameterKind quantity) { return kKinds[static_cast<std::size_t>(quantity)]; }

/// "", "x", "xx"
std::string component_name(ParameterKind quantity, int component) {
  const int count = kind(quantity).count;
  return count == 1 ? "" : count == 3 ? kAxes[to_index(component)] : kEntries[to_index(component)];
}

/// Both with something in between, or the one that there is.
std::string joined(std::string first, char between, const std::string& second) {
  if (!first.empty() && !second.empty()) {
    first += between;
  }
  return first += second;
}

/// What it belongs to, as the file writes it.
std::string owner(const Tree& tree, const Parameter& parameter) {
  return parameter.quantity >= ParameterKind::kGravity ? ""
         : parameter.quantity == ParameterKind::kPoint ? tree.points[to_index(parameter.link)].name
                                                       : tree.links[to_index(parameter.link)].name;
}

/// Where it stands.
template <class SomeTree, class SomeGravity>
auto& place(SomeTree& tree, SomeGravity& gravity, const Parameter& parameter) {
  const std::size_t k = to_index(parameter.component);
  if (parameter.quantity == ParameterKind::kGravity) {
    return gravity[k];
  }
  if (parameter.quantity == ParameterKind::kPoint) {
    return tree.points[to_index(parameter.link)].at[k];
  }
  auto& link = tree.links[to_index(parameter.link)];
  return parameter.quantity == ParameterKind::kOffset    ? link.joint.offset[k]
         : parameter.quantity == ParameterKind::kCom     ? link.inertia.com[k]
         : parameter.quantity == ParameterKind::kInertia ? link.inertia.about_com[kPlaces[k]]
                                                         : link.inertia.mass;
}

}  // namespace

std::optional<Declared> find_quantity(std::string_view name) {
  const std::size_t dot = name.find('.');
  const auto* const end = kKinds.begin() + kOfModels;
  const auto* const row = std::ranges::find(kKinds.begin(), end, name.substr(0, dot), &Kind::name);
  if (row == end) {
    return std::nullopt;
  }
  const auto quantity = static_cast<ParameterKind>(row - kKinds.begin());
  if (dot == std::string_view::npos) {
    return Declared{quantity, std::nullopt};
  }
  for (int k = 0; k < row->count; ++k) {
    if (row->count > 1 && name.substr(dot + 1) == component_name(quantity, k)) {
      return Declared{quantity, k};
    }
  }
  return std::nullopt;
}

std::vector<Parameter> parameters_of(const Tree& tree, int link, const Declared& declared) {
  const Kind& of = kind(declared.quantity);
  std::vector<Parameter> result;
  for (int k = 0; k < of.count; ++k) {
    if (k != declared.component.value_or(k)) {
      continue;
    }
    Parameter parameter{link, declared.quantity, k, {}, {}, 0};
    const std::string component = component_name(declared.quantity, k);
    const std::string name = owner(tree, parameter);
    parameter.declared =
        joined(joined(name, '.', of.name), '.', declared.component ? component : "");
    parameter.identifier = to_identifier(joined(joined(name, '_', of.name), '_', component));
    result.push_back(std::move(parameter));
  }
  return result;
}

const char* unit(const Parameter& parameter) { return kind(parameter.quantity).unit; }

namespace {

/// A number of a link to which other links are fixed.
bool carries_others(const Tree& tree, const Parameter& parameter) {
  const bool of_body = parameter.quantity == ParameterKind::kMass ||
                       parameter.quantity == ParameterKind::kCom ||
                       parameter.quantity == ParameterKind::kInertia;
  return of_body && std::ranges::any_of(tree.frames, [&](const Frame& frame) {
           return frame.link == parameter.link &&
                  frame.name != tree.links[to_index(parameter.link)].name;
         });
}

}  // namespace

std::string meaning(const Tree& tree, const Parameter& parameter) {
  const std::string component = component_name(parameter.quantity, parameter.component);
  const std::string what = joined(kind(parameter.quantity).meaning, ' ', component);
  switch (parameter.quantity) {
    case ParameterKind::kGravity:
      return what + ", base frame";
    case ParameterKind::kPoint:
      return what + " of point " + owner(tree, parameter) + ", frame of link " +
             link_name(tree, parameter);
    case ParameterKind::kScene:
      return what + " " + parameter.declared + " of the scene";
    default:
      return what + " of link " + owner(tree, parameter) +
             (carries_others(tree, parameter) ? " with all that is fixed to it" : "");
  }
}

std::string link_name(const Tree& tree, const Parameter& parameter) {
  if (parameter.quantity != ParameterKind::kPoint) {
    return owner(tree, parameter);
  }
  const int link = tree.points[to_index(parameter.link)].link;
  return link == kGround ? "" : tree.links[to_index(link)].name;
}

Real nominal(const Tree& tree, const Vector3& gravity, const Parameter& parameter) {
  return parameter.quantity == ParameterKind::kScene ? parameter.of_scene
                                                     : place(tree, gravity, parameter);
}

void set(Tree& tree, Vector3& gravity, const Parameter& parameter, const Real& value) {
  if (parameter.quantity == ParameterKind::kScene) {
    return;
  }
  place(tree, gravity, parameter) = value;
  if (parameter.quantity == ParameterKind::kInertia) {
    tree.links[to_index(parameter.link)]
        .inertia.about_com[kMirrored[to_index(parameter.component)]] = value;
  }
}

std::vector<std::pair<std::size_t, std::size_t>> points_with_parameters(
    const Tree& tree, const std::vector<Point>& points) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto is_of = [&](const Parameter& parameter) {
      if (parameter.quantity != ParameterKind::kPoint) {
        return false;
      }
      const Point& own = tree.points[to_index(parameter.link)];
      return own.name == points[k].name && own.link == points[k].link && own.at == points[k].at;
    };
    const auto found = std::ranges::find_if(tree.parameters, is_of);
    if (found != tree.parameters.end()) {
      result.emplace_back(k, to_index(found->link));
    }
  }
  return result;
}

bool of_scene_alone(const Tree& tree) {
  return std::ranges::all_of(tree.parameters, [](const Parameter& parameter) {
    return parameter.quantity == ParameterKind::kScene;
  });
}

bool has_lengths(const Tree& tree) {
  return std::ranges::any_of(tree.parameters, [](const Parameter& parameter) {
    return parameter.quantity == ParameterKind::kOffset ||
           parameter.quantity == ParameterKind::kPoint;
  });
}

}  // namespace treedyn::model
