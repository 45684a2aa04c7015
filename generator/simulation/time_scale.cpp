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

Jet over(const model::Expression& expression, const State& state, double step) {
  return expression.evaluate<Jet>([](double x) { return constant(x); },
                                  [&](const model::Variable& variable) {
                                    return variable.quantity == model::Quantity::kTime
                                               ? Jet{{state.t, state.t + step}, {1, 1}, {0, 0}}
                                               : constant(value_in(state, variable));
                                  });
}

}  // namespace

double resolved_step(const model::Expression& expression, const State& state, double longest) {
  double step = longest;
  for (int k = 0; k < kScaleHalvings; ++k) {
    const Jet jet = over(expression, state, step);
    const double bend = std::max(std::fabs(jet.a.low), std::fabs(jet.a.high)) * step * step;
    const double size = std::max(std::fabs(jet.x.low), std::fabs(jet.x.high));
    if (bend <= kBend * (jet.x.high - jet.x.low) + kFlat * size) {
      return step;
    }
    step /= 2;
  }
  return longest;
}

std::vector<model::Expression> timed_expressions(const model::Scene& scene) {
  std::vector<model::Expression> result;
  const auto add = [&](const model::Expression& expression) {
    if (expression.uses(model::Quantity::kTime)) {
      result.push_back(expression);
    }
  };
  for (const model::JointLaw& law : scene.joint_laws) {
    add(law.force);
  }
  for (const model::PointLaw& law : scene.point_laws) {
    std::ranges::for_each(law.value, add);
  }
  for (const model::Constraint& constraint : scene.constraints) {
    std::for_each(constraint.accelerations.begin(), constraint.accelerations.end(), add);
    std::for_each(constraint.curve.acceleration.begin(), constraint.curve.acceleration.end(), add);
  }
  return result;
}

}  // namespace treedyn::simulation
