#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

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

}  // namespace treedyn::simulation
