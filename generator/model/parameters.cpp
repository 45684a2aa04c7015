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
std::string ending(InertiaPart quantity, int component) {
  switch (quantity) {
    case InertiaPart::kCom:
      return std::string("_") + kAxes[index(component)];
    case InertiaPart::kInertia:
      return std::string("_") + kEntries[index(component)];
    case InertiaPart::kMass:
      break;
  }
  return {};
}

}  // namespace

const std::array<const char*, 3>& quantity_names() {
  static const std::array<const char*, 3> names = {"mass", "com", "inertia"};
  return names;
}

std::vector<Parameter> parameters_of(const Tree& tree, int link, InertiaPart quantity) {
  constexpr std::array<int, 3> kCounts = {1, 3, 6};
  const auto kind = static_cast<std::size_t>(quantity);
  const std::string& name = tree.links[index(link)].name;
  std::vector<Parameter> result;
  for (int k = 0; k < kCounts[kind]; ++k) {
    result.push_back({link, quantity, k, name + "." + quantity_names()[kind],
                      to_identifier(name + "_" + quantity_names()[kind] + ending(quantity, k))});
  }
  return result;
}

const char* unit(const Parameter& parameter) {
  constexpr std::array<const char*, 3> kUnits = {"kg", "m", "kg m^2"};
  return kUnits[static_cast<std::size_t>(parameter.quantity)];
}

std::string meaning(const Tree& tree, const Parameter& parameter) {
  const std::string of = " of link " + tree.links[index(parameter.link)].name;
  switch (parameter.quantity) {
    case InertiaPart::kCom:
      return std::string("centre of mass ") + kAxes[index(parameter.component)] + of;
    case InertiaPart::kInertia:
      return std::string("inertia about the centre of mass ") +
             kEntries[index(parameter.component)] + of;
    case InertiaPart::kMass:
      break;
  }
  return "mass" + of;
}

Real nominal(const Tree& tree, const Parameter& parameter) {
  const Inertia& inertia = tree.links[index(parameter.link)].inertia;
  const std::size_t k = index(parameter.component);
  return parameter.quantity == InertiaPart::kCom       ? inertia.com[k]
         : parameter.quantity == InertiaPart::kInertia ? inertia.about_com[kPlaces[k]]
                                                       : inertia.mass;
}

void set(Tree& tree, const Parameter& parameter, const Real& value) {
  Inertia& inertia = tree.links[index(parameter.link)].inertia;
  const std::size_t k = index(parameter.component);
  switch (parameter.quantity) {
    case InertiaPart::kMass:
      inertia.mass = value;
      break;
    case InertiaPart::kCom:
      inertia.com[k] = value;
      break;
    case InertiaPart::kInertia:
      inertia.about_com[kPlaces[k]] = inertia.about_com[kMirrored[k]] = value;
      break;
  }
}

}  // namespace treedyn::model
