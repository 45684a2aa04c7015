#include "simulation/time_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace treedyn::simulation {

namespace {

/// All numbers between two bounds.
struct Interval {
  double low;
  double high;
};

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Interval checked(double low, double high) {
  return std::isnan(low) || std::isnan(high) ? Interval{-kInfinite, kInfinite}
                                             : Interval{low, high};
}

Interval operator+(Interval a, Interval b) { return checked(a.low + b.low, a.high + b.high); }
Interval operator-(Interval a) { return {-a.high, -a.low}; }

/// 0 times infinity is 0: a bound that is not known says nothing about a zero.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Interval operator*(Interval a, Interval b) {
  const auto [low, high] = std::minmax({product(a.low, b.low), product(a.low, b.high),
                                        product(a.high, b.low), product(a.high, b.high)});
  return {low, high};
}

Interval square(Interval a) {
  const double most = std::max(std::fabs(a.low), std::fabs(a.high));
  const double least =
      a.low <= 0 && a.high >= 0 ? 0 : std::min(std::fabs(a.low), std::fabs(a.high));
  return {least * least, most * most};
}

Interval inverse(Interval a) {
  return a.low <= 0 && a.high >= 0 ? Interval{-kInfinite, kInfinite}
                                   : Interval{1 / a.high, 1 / a.low};
}

/// Whether `at + 2 pi k` is in the interval for some k.
bool meets(Interval a, double at) {
  const double turn = 2 * std::numbers::pi;
  return std::floor((a.high - at) / turn) >= std::ceil((a.low - at) / turn);
}

Interval sine(Interval a) {
  if (!(a.high - a.low < 2 * std::numbers::pi)) {
    return {-1, 1};
  }
  const auto [low, high] = std::minmax({std::sin(a.low), std::sin(a.high)});
  return {meets(a, -std::numbers::pi / 2) ? -1 : low, meets(a, std::numbers::pi / 2) ? 1 : high};
}

Interval cosine(Interval a) {
  return sine(a + Interval{std::numbers::pi / 2, std::numbers::pi / 2});
}

/// A function of time with two derivatives.
struct Jet {
  Interval x, v, a;
};

Jet operator+(const Jet& f, const Jet& g) { return {f.x + g.x, f.v + g.v, f.a + g.a}; }
Jet operator-(const Jet& f) { return {-f.x, -f.v, -f.a}; }
Jet operator-(const Jet& f, const Jet& g) { return f + -g; }

Interval twice(Interval a) { return {2 * a.low, 2 * a.high}; }

bool same(const Interval& a, const Interval& b) { return a.low == b.low && a.high == b.high; }

Jet operator*(const Jet& f, const Jet& g) {
  const bool squared = same(f.x, g.x) && same(f.v, g.v) && same(f.a, g.a);
  return {squared ? square(f.x) : f.x * g.x, f.v * g.x + f.x * g.v,
          f.a * g.x + twice(f.v * g.v) + f.x * g.a};
}

/// A function of a jet by its value and derivatives.
Jet chain(const Jet& f, Interval value, Interval first, Interval second) {
  return {value, first * f.v, second * square(f.v) + first * f.a};
}

Jet operator/(const Jet& f, const Jet& g) {
  const Interval i = inverse(g.x);
  return f * chain(g, i, -square(i), twice(square(i) * i));
}

Jet sqrt(const Jet& f) {
  const Interval root{std::sqrt(std::max(0.0, f.x.low)), std::sqrt(std::max(0.0, f.x.high))};
  const Interval i = inverse(twice(root));
  return chain(f, root, i, -(i * inverse(twice(f.x))));
}

Jet sin(const Jet& f) {
  const Interval s = sine(f.x);
  return chain(f, s, cosine(f.x), -s);
}

Jet cos(const Jet& f) {
  const Interval c = cosine(f.x);
  return chain(f, c, -sine(f.x), -c);
}

Jet constant(double x) { return {{x, x}, {0, 0}, {0, 0}}; }

Interval only(double x) { return {x, x}; }

/// Variables along a step.
class Along {
 public:
  Along(const Changing& changing, const Motion& motion, double step)
      : motion_(motion), step_(step), plane_(changing.plane) {
    const auto points = static_cast<int>(motion.x.size()) - motion.joints;
    first_ = changing.point < 0 || points == 0 ? -1 : motion.joints + 3 * changing.point;
  }

  Jet operator()(const model::Variable& variable) const {
    switch (variable.quantity) {
      case model::Quantity::kTime:
        return {{motion_.t, motion_.t + step_}, {1, 1}, {0, 0}};
      case model::Quantity::kPosition:
        return place(variable.index);
      case model::Quantity::kVelocity:
        return speed(variable.index);
      default:
        break;
    }
    if (first_ < 0) {
      return constant(0);
    }
    switch (variable.quantity) {
      case model::Quantity::kPointPosition:
        return place(first_ + variable.index);
      case model::Quantity::kPointVelocity:
        return speed(first_ + variable.index);
      case model::Quantity::kDepth:
        return constant(-plane_.height(Eigen::Vector3d::Zero())) - along_normal(&Along::place);
      case model::Quantity::kNormalSpeed:
        return along_normal(&Along::speed);
      default:
        return constant(0);
    }
  }

 private:
  [[nodiscard]] Jet place(int k) const {
    const Jet v = speed(k);
    return {only(motion_.x[k]) + v.x * Interval{0, step_}, v.x, v.v};
  }
  [[nodiscard]] Jet speed(int k) const {
    const Interval a{motion_.least[k], motion_.most[k]};
    return {only(motion_.v[k]) + a * Interval{0, step_}, a, only(motion_.rate[k])};
  }
  [[nodiscard]] Jet along_normal(Jet (Along::*of)(int) const) const {
    const Eigen::Vector3d& normal = plane_.normal();
    return constant(normal[0]) * (this->*of)(first_) +
           constant(normal[1]) * (this->*of)(first_ + 1) +
           constant(normal[2]) * (this->*of)(first_ + 2);
  }

  const Motion& motion_;
  double step_;
  const PlaneValues& plane_;
  int first_;  ///< coordinate of the point; -1: none
};

}  // namespace

Motion going_on(double t, const Vector& x, const Vector& v, const Vector& a) {
  Vector all = Vector::Zero(x.size());
  all.head(a.size()) = a;
  return {t, static_cast<int>(a.size()), x, v, all, all, Vector::Zero(x.size())};
}

Motion gone(double h, const Motion& begin, const Vector& middle, const Vector& end) {
  const Vector first = (middle - begin.v) * (2 / h);
  const Vector second = (end - middle) * (2 / h);
  const Vector more = (second - first) / 2;
  const Vector start = first - more;
  const Vector last = second + more;
  return {begin.t,       begin.joints, begin.x, begin.v, start.cwiseMin(last), start.cwiseMax(last),
          more * (4 / h)};
}

double resolved_step(Changing& changing, const Motion& motion, double longest) {
  double step = longest;
  for (int k = 0; k < kScaleHalvings; ++k) {
    const Jet jet = changing.value.evaluate<Jet>([](double x) { return constant(x); },
                                                 Along(changing, motion, step));
    const double bend = std::max(std::fabs(jet.a.low), std::fabs(jet.a.high)) * step * step;
    const double size = std::max(std::fabs(jet.x.low), std::fabs(jet.x.high));
    const double range = jet.x.high - jet.x.low;
    const bool is_flat = bend <= kBend * range + kFlat * size || range <= kNothing * changing.most;
    if (std::isfinite(range) && is_flat) {
      changing.most = std::max(changing.most, size);
      return step;
    }
    step /= 2;
  }
  return longest;
}

std::vector<Changing> changing_expressions(const model::Scene& scene) {
  std::vector<Changing> result;
  const auto add = [&](const model::Expression& value, int point = -1,
                       const model::Plane& plane = {}) {
    if (!value.is_constant()) {
      result.push_back({value, point, PlaneValues(plane)});
    }
  };
  for (const model::JointLaw& law : scene.joint_laws) {
    add(law.force);
  }
  for (const model::PointLaw& law : scene.point_laws) {
    for (const model::Expression& value : law.value) {
      add(value, law.point);
    }
  }
  for (const model::GroundContact& contact : scene.contacts) {
    if (contact.law) {
      add(*contact.law, contact.point, contact.plane);
    }
  }
  for (const model::Constraint& constraint : scene.constraints) {
    for (const model::Expression& value : constraint.accelerations) {
      add(value);
    }
    for (const model::Expression& value : constraint.curve.acceleration) {
      add(value);
    }
  }
  return result;
}

}  // namespace treedyn::simulation
