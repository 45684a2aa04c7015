// The terms by straight-line programs.
#pragma once

#include "program/tape.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// A scene's own program, interpreted.
class TapeDynamics final : public Dynamics {
 public:
  /// \param terms     of q, qd: the arrays of Terms in its order, those that are needed
  /// \param geometry  of q: p, C, R, H, those that are needed
  TapeDynamics(const program::Function& terms, const program::Function& geometry);

  void evaluate(const Vector& q, const Vector& qd, Terms& terms) override;
  void evaluate_geometry(const Vector& q, Terms& terms) override;
  [[nodiscard]] std::optional<long> operations() const override {
    return static_cast<long>(terms_.instructions());
  }

 private:
  program::Tape terms_;
  program::Tape geometry_;
  std::vector<double> buffer_;
};

}  // namespace treedyn::simulation
