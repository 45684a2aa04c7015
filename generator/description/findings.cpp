#include "description/findings.hpp"

namespace treedyn::description {

namespace {

void append(std::vector<Warning>& all, const std::vector<Warning>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void vet_tree(Vetted& vetted) {
  append(vetted.findings, vetted.tree.warnings);
  append(vetted.findings, joints_without_inertia(vetted.tree));
}

}  // namespace treedyn::description
