#include "simulation/dynamics.hpp"

#include <algorithm>

#include "model/force_laws.hpp"

namespace treedyn::simulation {

Needs needs_of(const model::Scene& scene) {
  const bool holds = std::ranges::any_of(scene.constraints, [](const model::Constraint& c) {
    return c.kind == model::ConstraintKind::kOrientation;
  });
  return {!scene.points.empty(), model::has_moments(scene) || holds};
}

Terms::Terms(int dof, int points, Needs needs) : dof_(dof), points_(points), needs_(needs) {
  const auto n = static_cast<std::size_t>(dof);
  const std::size_t p = needs.points ? static_cast<std::size_t>(points) : 0;
  const std::size_t r = needs.rotations ? static_cast<std::size_t>(points) : 0;
  std::size_t end = 0;
  for (const std::size_t size : {n * n, n, 3 * p, 3 * p * n, 3 * p, 9 * r, 3 * r * n, 3 * r}) {
    offsets_.push_back(end);
    end += size;
  }
  values_.assign(end, 0);
}

void Terms::set_geometry(std::span<const double> values) {
  auto from = values.begin();
  for (const std::size_t array : {2U, 3U, 5U, 6U}) {
    const auto size = static_cast<std::ptrdiff_t>(offsets_[array + 1] - offsets_[array]);
    std::copy_n(from, size, values_.begin() + static_cast<std::ptrdiff_t>(offsets_[array]));
    from += size;
  }
}

}  // namespace treedyn::simulation
