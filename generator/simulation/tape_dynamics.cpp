#include "simulation/tape_dynamics.hpp"

#include <algorithm>
#include <array>

namespace treedyn::simulation {

namespace {

std::span<const double> span_of(const Vector& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

}  // namespace

TapeDynamics::TapeDynamics(const program::Function& terms, const program::Function& geometry)
    : terms_(terms), geometry_(geometry), buffer_(geometry.outputs.size()) {}

void TapeDynamics::evaluate(const Vector& q, const Vector& qd, Terms& terms) {
  const std::array<std::span<const double>, 2> inputs{span_of(q), span_of(qd)};
  terms_.evaluate(inputs, terms.values());
}

void TapeDynamics::evaluate_geometry(const Vector& q, Terms& terms) {
  if (buffer_.empty()) {
    return;
  }
  const std::array<std::span<const double>, 1> inputs{span_of(q)};
  geometry_.evaluate(inputs, buffer_);
  auto copy = [&, from = std::size_t{0}](std::size_t array, bool needed) mutable {
    const std::size_t size = terms.offset(array + 1) - terms.offset(array);
    if (needed) {
      std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(from), size,
                  terms.values().begin() + static_cast<std::ptrdiff_t>(terms.offset(array)));
      from += size;
    }
  };
  copy(2, terms.needs().points);
  copy(3, terms.needs().points);
  copy(5, terms.needs().rotations);
  copy(6, terms.needs().rotations);
}

}  // namespace treedyn::simulation
