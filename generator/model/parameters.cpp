#include "model/parameters.hpp"

#include "common/identifier.hpp"

namespace treedyn::model {

namespace {

constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
constexpr std::array<const char*, 6> kEntries = {"xx", "xy", "xz", "yy", "yz", "zz"};
/// Of these entries the places in a row-major matrix, and in its transpose.
constexpr std::array<std::size_t, 6> kPlaces = {0, 1, 2, 4, 5, 8};
constexpr std::array<std::size_t, 6> kMirrored = {0, 3, 6, 4, 7, 8};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// "", "_x", "_xx"
std::string ending(ParameterKind quantity, int component) {
  switch (quantity) {
    case ParameterKind::kCom:
    case ParameterKind::kGravity:
      return std::string("_") + kAxes[index(component)];
    case ParameterKind::kInertia:
      return std::string("_") + kEntries[index(component)];
    case ParameterKind::kMass:
      break;
  }
  return {};
}

}  // namespace

const std::array<const char*, 3>& quantity_names() {
  static const std::array<const char*, 3> names = {"mass", "com", "inertia"};
  return names;
}

std::vector<Parameter> parameters_of(const Tree& tree, int link, ParameterKind quantity) {
  constexpr std::array<int, 4> kCounts = {1, 3, 6, 3};
  const auto kind = static_cast<std::size_t>(quantity);
  const bool of_link = quantity != ParameterKind::kGravity;
  const std::string name = of_link ? tree.links[index(link)].name : "";
  const std::string declared = of_link ? name + "." + quantity_names()[kind] : "gravity";
  const std::string stem = of_link ? name + "_" + quantity_names()[kind] : declared;
  std::vector<Parameter> result;
  for (int k = 0; k < kCounts[kind]; ++k) {
    result.push_back({link, quantity, k, declared, to_identifier(stem + ending(quantity, k))});
  }
  return result;
}

const char* unit(const Parameter& parameter) {
  constexpr std::array<const char*, 4> kUnits = {"kg", "m", "kg m^2", "m/s^2"};
  return kUnits[static_cast<std::size_t>(parameter.quantity)];
}

std::string meaning(const Tree& tree, const Parameter& parameter) {
  const std::string of =
      parameter.link == kGround ? "" : " of link " + tree.links[index(parameter.link)].name;
  switch (parameter.quantity) {
    case ParameterKind::kCom:
      return std::string("centre of mass ") + kAxes[index(parameter.component)] + of;
    case ParameterKind::kInertia:
      return std::string("inertia about the centre of mass ") +
             kEntries[index(parameter.component)] + of;
    case ParameterKind::kGravity:
      return std::string("gravity ") + kAxes[index(parameter.component)] + ", base frame";
    case ParameterKind::kMass:
      break;
  }
  return "mass" + of;
}

Real nominal(const Tree& tree, const Vector3& gravity, const Parameter& parameter) {
  const std::size_t k = index(parameter.component);
  if (parameter.quantity == ParameterKind::kGravity) {
    return gravity[k];
  }
  const Inertia& inertia = tree.links[index(parameter.link)].inertia;
  return parameter.quantity == ParameterKind::kCom       ? inertia.com[k]
         : parameter.quantity == ParameterKind::kInertia ? inertia.about_com[kPlaces[k]]
                                                         : inertia.mass;
}

void set(Tree& tree, Vector3& gravity, const Parameter& parameter, const Real& value) {
  const std::size_t k = index(parameter.component);
  if (parameter.quantity == ParameterKind::kGravity) {
    gravity[k] = value;
    return;
  }
  Inertia& inertia = tree.links[index(parameter.link)].inertia;
  if (parameter.quantity == ParameterKind::kMass) {
    inertia.mass = value;
  } else if (parameter.quantity == ParameterKind::kCom) {
    inertia.com[k] = value;
  } else {
    inertia.about_com[kPlaces[k]] = inertia.about_com[kMirrored[k]] = value;
  }
}

}  // namespace treedyn::model
