// One step in time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// dy/dt of y = (q; qd).
using Rate = std::function<void(double t, const Vector& y, Vector& rate)>;

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// y(t + h) from y(t).
  /// \param[out] error  estimate of the error of `result`; empty if the method has none
  virtual void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
                    Vector& error) = 0;
  /// Order of the error estimate, by which the step is chosen; 0: fixed steps only.
  [[nodiscard]] virtual int error_order() const { return 0; }
  /// One weight b for every call of `rate` in the last step: h sum b g(call) is the integral of a
  /// function g along the step by the method's own quadrature.
  [[nodiscard]] virtual const std::vector<double>& weights() const = 0;
};

struct IntegratorRow {
  std::string_view name;
  std::string_view brief;
  std::unique_ptr<Integrator> (*make)();
};

/// Everything `--integrator` accepts.
std::span<const IntegratorRow> integrators();

/// nullptr if there is none with that name.
std::unique_ptr<Integrator> make_integrator(std::string_view name);

/// \throws InputError if there is no integrator of this name
void require_integrator(const model::Stepping& stepping);

std::unique_ptr<Integrator> make_dopri5();      ///< Boost.odeint
std::unique_ptr<Integrator> make_fehlberg78();  ///< Boost.odeint

}  // namespace treedyn::simulation
