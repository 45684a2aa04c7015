#include "simulation/tape_dynamics.hpp"

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
  terms.set_geometry(buffer_);
}

}  // namespace treedyn::simulation
