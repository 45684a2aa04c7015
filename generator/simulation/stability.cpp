#include "simulation/stability.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "simulation/integrator.hpp"
#include "simulation/system.hpp"

namespace treedyn::simulation {

namespace {

using Complex = std::complex<double>;

/// Relative difference step, and the part of a contact's depth that a difference may move.
constexpr double kDifferenceOfState = 1e-6;
constexpr double kPartOfDepth = 1e-2;
/// A force may be steeper than a difference of speeds shows: the part of one that is tried, how
/// much more makes it steeper, and the part of the acceleration that may be rounding.
constexpr double kPartOfSpeed = 1e-3;
constexpr double kSteeper = 1.01;
constexpr double kSeen = 1e-6;
/// Depths that are tried, m; halvings of an interval.
constexpr double kLeastDepth = 1e-9;
constexpr double kMostDepth = 1;
constexpr int kBisections = 60;
/// Intervals of Simpson's rule for the energy of a depth.
constexpr int kSimpson = 32;
/// Eigenvalues below this part of the largest are rounding.
constexpr double kSmall = 1e-7;
constexpr double kSlow = 1e-5;  // 1/s
/// |lambda| h between which a limit is looked for, and steps in between.
constexpr double kNearest = 0.3;
constexpr double kFarthest = 30;
constexpr int kRaySteps = 100;
/// The same for semi-implicit Euler, each with eigenvalues of its own.
constexpr double kShortest = 1e-3;
constexpr int kEulerSteps = 40;
constexpr int kEulerBisections = 20;

/// Normal force of a contact at rest at a depth.
double force_at(const ContactLaw& contact, double depth) {
  const Eigen::Vector3d& normal = contact.plane().normal();
  const Eigen::Vector3d p = (contact.plane().height(Eigen::Vector3d::Zero()) + depth) * -normal;
  return normal.dot(contact.force(p, Eigen::Vector3d::Zero()));
}

double energy_at(const ContactLaw& contact, double depth) {
  double sum = 0;
  for (int k = 0; k <= kSimpson; ++k) {
    const int weight = k == 0 || k == kSimpson ? 1 : k % 2 == 1 ? 4 : 2;
    sum += weight * force_at(contact, depth * k / kSimpson);
  }
  return sum * depth / (3 * kSimpson);
}

/// The depth in [kLeastDepth, kMostDepth] at which a growing function reaches a value.
template <class Function>
double depth_of(const Function& function, double value) {
  double low = kLeastDepth;
  double high = kMostDepth;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = std::sqrt(low * high);
    (function(middle) < value ? low : high) = middle;
  }
  return high;
}

/// How deep a contact would be pressed from this state.
double closed_depth(System& system, std::size_t k, double t, const Vector& q, const Vector& qd) {
  const ContactLaw& contact = system.forces().contacts()[k];
  const Eigen::Vector3d& normal = contact.plane().normal();
  system.forces().touch(k, false);
  const Vector qdd = system.accelerate(t, q, qd).qdd;
  const Arrival arrival = system.arrival(contact.point(), normal, qd, qdd);
  const Terms& terms = system.geometry(q);
  const double height = contact.plane().height(terms.p().segment<3>(3 * contact.point()));
  system.forces().touch(k, true);
  const double fall = std::max(0.0, -arrival.acceleration);
  const double speed = std::min(0.0, arrival.speed);
  const double energy = arrival.mass * (speed * speed / 2 + fall * std::max(0.0, height));
  const double held = depth_of([&](double d) { return energy_at(contact, d); }, energy);
  const double carried =
      depth_of([&](double d) { return force_at(contact, d); }, arrival.mass * fall);
  return std::max({held, carried, -height});
}

/// Opens those that do not touch. \return the depths, of those zero
std::vector<double> keep_contacts(System& system, const Vector& q) {
  std::vector<double> depths;
  const Vector p = system.geometry(q).p();
  for (std::size_t k = 0; k < system.forces().contacts().size(); ++k) {
    const ContactLaw& contact = system.forces().contacts()[k];
    const double height = contact.plane().height(p.segment<3>(3 * contact.point()));
    system.forces().touch(k, height < 0);
    depths.push_back(std::max(0.0, -height));
  }
  return depths;
}

/// Closes every contact. \return the depths
std::vector<double> close_contacts(System& system, double t, const Vector& q, const Vector& qd) {
  std::vector<double> depths;
  for (std::size_t k = 0; k < system.forces().contacts().size(); ++k) {
    depths.push_back(closed_depth(system, k, t, q, qd));
  }
  const Vector p = system.geometry(q).p();
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const ContactLaw& contact = system.forces().contacts()[k];
    const double height = contact.plane().height(p.segment<3>(3 * contact.point()));
    system.forces().touch(k, true);
    system.forces().raise(k, height + depths[k]);
  }
  return depths;
}

/// d(qdd)/d(q, qd), N x 2N, by central differences.
Eigen::MatrixXd derivative(System& system, double t, const Vector& q, const Vector& qd,
                           double most) {
  const Eigen::Index n = q.size();
  Eigen::MatrixXd result(n, 2 * n);
  Vector y(2 * n);
  y << q, qd;
  const auto slope = [&](Eigen::Index k, double d) {
    const double x = y[k];
    y[k] = x + d;
    Vector change = system.accelerate(t, y.head(n), y.tail(n)).qdd;
    y[k] = x - d;
    change -= system.accelerate(t, y.head(n), y.tail(n)).qdd;
    y[k] = x;
    return Vector(change / (2 * d));
  };
  const double size = system.accelerate(t, q, qd).qdd.norm();
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    const double d =
        std::min(kDifferenceOfState * std::max(1.0, std::fabs(y[k])), k < n ? most : 1.0);
    result.col(k) = slope(k, d);
    if (k >= n) {
      const double near = kPartOfSpeed * d;
      const Vector steep = slope(k, near);
      if (steep.norm() > kSteeper * result.col(k).norm() && steep.norm() * near > kSeen * size) {
        result.col(k) = steep;
      }
    }
  }
  return result;
}

/// |y(1)| of y' = z y, y(0) = 1, by one step of the method: real and imaginary part as q and qd.
double growth(Integrator& integrator, Complex z) {
  const Rate rate = [&](double, const Vector& y, Vector& dy) {
    dy.resize(2);
    dy << z.real() * y[0] - z.imag() * y[1], z.imag() * y[0] + z.real() * y[1];
  };
  Vector next;
  Vector error;
  integrator.step(rate, 0, 1, Eigen::Vector2d(1, 0), next, error);
  return next.norm();
}

/// The largest r up to which r lambda/|lambda| is in the method's region of stability.
std::optional<double> along(Integrator& integrator, Complex lambda) {
  const Complex ray = lambda / std::abs(lambda);
  const double ratio = std::pow(kFarthest / kNearest, 1.0 / kRaySteps);
  const auto is_stable = [&](double size) {  // of a mode that may grow by rounding
    return growth(integrator, size * ray) <=
           (1 + kGrowth) * std::exp(std::max(0.0, size * ray.real()));
  };
  double r = kNearest;
  for (int k = 0; k < kRaySteps; ++k, r *= ratio) {
    if (!is_stable(r)) {
      double low = r / ratio;
      for (int n = 0; n < kBisections; ++n) {
        const double middle = (low + r) / 2;
        (is_stable(middle) ? low : r) = middle;
      }
      return low;
    }
  }
  return std::nullopt;
}

/// The least limit of all modes that do not grow by themselves.
std::optional<double> method_limit(Integrator& integrator, const Eigen::VectorXcd& lambdas,
                                   double size) {
  std::optional<double> limit;
  for (const Complex& lambda : lambdas) {
    if (std::abs(lambda) < std::max(kSlow, kSmall * size) || lambda.real() > kSmall * size ||
        lambda.imag() < 0 || (limit && std::abs(lambda) * *limit < kNearest)) {
      continue;
    }
    if (const std::optional<double> r = along(integrator, lambda)) {
      limit = std::min(limit.value_or(*r / std::abs(lambda)), *r / std::abs(lambda));
    }
  }
  return limit;
}

/// Semi-implicit Euler, qdd = A q + B qd: z^2 - (2 + B h + A h^2) z + (1 + B h) = 0 reaches z = -1
/// where (4/h^2 + 2 B/h + A) x = 0: the largest such 1/h.
std::optional<double> reversing_step(const Eigen::MatrixXd& f) {
  const Eigen::Index n = f.rows();
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = -f.leftCols(n) / 4;
  companion.bottomRightCorner(n, n) = -f.rightCols(n) / 2;
  const Eigen::VectorXcd all = companion.eigenvalues();
  const double size = all.cwiseAbs().maxCoeff();
  double most = 0;
  for (const Complex& mu : all) {
    if (mu.real() > std::max(kSlow, kSmall * size) && std::fabs(mu.imag()) < kSmall * size) {
      most = std::max(most, mu.real());
    }
  }
  return most > 0 ? std::optional<double>(1 / most) : std::nullopt;
}

/// How many modes a step of semi-implicit Euler amplifies.
std::ptrdiff_t amplified(const Eigen::MatrixXd& f, double h) {
  const Eigen::Index n = f.rows();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd step(2 * n, 2 * n);
  step.bottomLeftCorner(n, n) = h * f.leftCols(n);
  step.bottomRightCorner(n, n) = unit + h * f.rightCols(n);
  step.topLeftCorner(n, n) = unit + h * step.bottomLeftCorner(n, n);
  step.topRightCorner(n, n) = h * step.bottomRightCorner(n, n);
  const Eigen::VectorXcd all = step.eigenvalues();
  return std::ranges::count_if(all, [](const Complex& z) { return std::abs(z) > 1 + kGrowth; });
}

/// The least step that amplifies more modes than those that the motion does not damp. Where A and B
/// do not commute these are pairs, which leave the unit circle before one reaches -1.
std::optional<double> euler_limit(const Eigen::MatrixXd& f, const Eigen::VectorXcd& lambdas,
                                  double size) {
  const std::optional<double> reversing = reversing_step(f);
  const auto kept = std::ranges::count_if(
      lambdas, [&](const Complex& lambda) { return lambda.real() >= -kSmall * size; });
  if (kept == lambdas.size()) {
    return reversing;
  }
  const double last = std::min(reversing.value_or(kFarthest / size), kFarthest / size);
  double low = std::min(kShortest / size, last);
  const double ratio = std::pow(last / low, 1.0 / kEulerSteps);
  for (int k = 0; k < kEulerSteps; ++k, low *= ratio) {
    double high = low * ratio;
    if (amplified(f, high) > kept) {
      for (int n = 0; n < kEulerBisections; ++n) {
        const double middle = (low + high) / 2;
        (amplified(f, middle) > kept ? high : low) = middle;
      }
      return low;
    }
  }
  return reversing;
}

}  // namespace

Stability stability_at(const model::Scene& scene, System& system, double t, const Vector& q,
                       const Vector& qd, Closed closed) {
  Stability result;
  const Eigen::Index n = q.size();
  if (n > kStabilityJoints) {
    return result;
  }
  const std::vector<double> depths =
      closed == Closed::kAll ? close_contacts(system, t, q, qd) : keep_contacts(system, q);
  double most = 1;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    if (depths[k] == 0) {
      continue;
    }
    const int point = system.forces().contacts()[k].point();
    result.depths.emplace_back(scene.points[static_cast<std::size_t>(point)].name, depths[k]);
    most = std::min(most, kPartOfDepth * depths[k]);
  }
  const Eigen::MatrixXd f = derivative(system, t, q, qd, most);
  if (!f.allFinite()) {
    return result;
  }
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  M.topRightCorner(n, n).setIdentity();
  M.bottomRows(n) = f;
  Eigen::VectorXcd lambdas = M.eigenvalues();
  std::ranges::sort(lambdas,
                    [](const Complex& a, const Complex& b) { return std::abs(a) > std::abs(b); });
  result.fastest = lambdas[0];
  for (const IntegratorRow& row : integrators()) {
    const std::unique_ptr<Integrator> integrator = row.make();
    result.limits.push_back({std::string(row.name),
                             row.name == "semi-implicit-euler"
                                 ? euler_limit(f, lambdas, std::abs(result.fastest))
                                 : method_limit(*integrator, lambdas, std::abs(result.fastest))});
  }
  return result;
}

}  // namespace treedyn::simulation
