#include "description/vet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

bool is_zero(const model::Matrix3& tensor) {
  return std::all_of(tensor.begin(), tensor.end(), [](const Real& x) { return x == 0; });
}

void add_point_masses(const model::Tree& tree, std::vector<Warning>& findings) {
  for (const model::Link& link : tree.links) {
    if (link.inertia.mass != 0 && is_zero(link.inertia.about_com)) {
      findings.push_back(
          {link.where, fmt::format("link '{}' has a mass but no inertia about its centre "
                                   "of mass",
                                   shown(link.name))});
    }
    if (link.inertia.mass == 0 && !is_zero(link.inertia.about_com)) {
      findings.push_back(
          {link.where, fmt::format("link '{}' has an inertia but no mass", shown(link.name))});
    }
  }
}

void append(std::vector<Warning>& all, const std::vector<Warning>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void vet_tree(Vetted& vetted) {
  append(vetted.findings, vetted.tree.warnings);
  add_point_masses(vetted.tree, vetted.findings);
  append(vetted.findings, joints_without_inertia(vetted.tree));
}

}  // namespace treedyn::description
