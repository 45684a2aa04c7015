#include "simulation/sign_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace treedyn::simulation {

namespace {

struct Sample {
  double s;
  double g;
};

/// The parabola through three samples at equal distances, u in [-1, 1].
struct Parabola {
  double mean, slope, bend;  ///< mean + slope u + bend u^2
  Parabola(double a, double m, double b) : mean(m), slope((b - a) / 2), bend((a + b) / 2 - m) {}
  [[nodiscard]] double at(double u) const { return mean + u * (slope + u * bend); }
  [[nodiscard]] bool has_extremum() const { return std::fabs(slope) < 2 * std::fabs(bend); }
  [[nodiscard]] double extremum() const { return -slope / (2 * bend); }
  /// Least |slope| on the piece, 0 if it changes its sign.
  [[nodiscard]] double least_slope() const {
    return std::max(0.0, std::fabs(slope) - 2 * std::fabs(bend));
  }
};

class Search {
 public:
  Search(const std::function<double(double)>& g, int start, double band)
      : g_(g), sign_(start), band_(band) {}

  SignChanges run(int pieces) {
    Sample a = sample(0);
    result_.undefined = std::isfinite(a.g) ? -1 : 0;
    for (int k = 0; k < pieces; ++k) {
      const Sample m = sample((k + 0.5) / pieces);
      const Sample b = sample((k + 1.0) / pieces);
      piece(a, m, b, 0);
      a = b;
    }
    return std::move(result_);
  }

 private:
  Sample sample(double s) {
    ++result_.evaluations;
    const double g = g_(s);
    if (std::isnan(g) && result_.undefined < 0) {
      result_.undefined = s;
    }
    return {s, g};
  }

  /// Samples in ascending order: changes of sign between them.
  void note(const Sample& next) {
    if (std::fabs(next.g) > band_ && next.g * sign_ < 0) {
      result_.places.push_back({last_, next.s});
      sign_ = -sign_;
    }
    last_ = next.s;
  }

  void piece(const Sample& a, const Sample& m, const Sample& b, int depth) {
    const Sample l = sample((a.s + m.s) / 2);
    const Sample r = sample((m.s + b.s) / 2);
    const Parabola fit(a.g, m.g, b.g);
    const double error = 4 * std::max(std::fabs(l.g - fit.at(-0.5)), std::fabs(r.g - fit.at(0.5)));
    if (depth == kSignDepth || result_.evaluations > kSignSamples || is_told(fit, error) ||
        !std::isfinite(error)) {
      for (const Sample& x : {l, m, r, b}) {
        note(x);
      }
      return;
    }
    const Sample v = fit.has_extremum() ? sample(m.s + fit.extremum() * (b.s - a.s) / 2) : m;
    if (v.g * sign_ < 0 && std::fabs(v.g) > band_ && l.g * v.g < 0 && m.g * v.g < 0 &&
        r.g * v.g < 0) {  // between samples of the other sign
      std::array<Sample, 5> all{l, m, r, v, b};
      std::ranges::sort(all, [](const Sample& x, const Sample& y) { return x.s < y.s; });
      for (const Sample& x : all) {
        note(x);
      }
      return;
    }
    piece(a, l, m, depth + 1);
    piece(m, r, b, depth + 1);
  }

  /// Whether the samples tell all signs of the piece.
  [[nodiscard]] bool is_told(const Parabola& fit, double error) const {
    double least = std::min(std::fabs(fit.at(-1)), std::fabs(fit.at(1)));
    if (fit.has_extremum()) {
      least = std::min(least, std::fabs(fit.at(fit.extremum())));
    }
    const bool same = fit.at(-1) * fit.at(1) > 0 &&
                      (!fit.has_extremum() || fit.at(fit.extremum()) * fit.at(1) > 0);
    const double size =
        std::max({std::fabs(fit.at(-1)), std::fabs(fit.mean), std::fabs(fit.at(1))});
    return (same && least > error) || fit.least_slope() > error || size + error <= band_;
  }

  const std::function<double(double)>& g_;
  int sign_;
  double band_;
  double last_ = 0;
  SignChanges result_;
};

}  // namespace

SignChanges sign_changes(const std::function<double(double)>& g, int start, int pieces,
                         double band) {
  return Search(g, start, band).run(pieces);
}

double far_side(const std::function<double(double)>& g, int side, double low, double high,
                double resolution) {
  double x1 = high;
  double f1 = side * g(high);
  double x2 = low;
  double f2 = side * g(low);
  if (f2 < 0 || !(f1 < 0)) {
    return f2 < 0 ? low : high;
  }
  double t = 0.5;
  const double fine = std::max(resolution, 4 * std::numeric_limits<double>::epsilon() *
                                               std::max(std::fabs(x1), std::fabs(x2)));
  while (std::fabs(x2 - x1) > fine) {
    const double x = x1 + t * (x2 - x1);
    const double f = side * g(x);
    if (x == x1 || x == x2) {
      break;
    }
    const bool same = (f < 0) == (f1 < 0);
    const double x3 = same ? x1 : x2;
    const double f3 = same ? f1 : f2;
    x2 = same ? x2 : x1;
    f2 = same ? f2 : f1;
    x1 = x;
    f1 = f;
    const double least = fine / 2 / std::fabs(x2 - x1);
    if (least > 0.5) {
      break;
    }
    const double xi = (x1 - x2) / (x3 - x2);
    const double phi = (f1 - f2) / (f3 - f2);
    const bool inverse = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    t = inverse ? f1 / (f2 - f1) * f3 / (f2 - f3) +
                      (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
                : 0.5;
    t = std::clamp(t, least, 1 - least);
  }
  return f1 < 0 ? x1 : x2;
}

}  // namespace treedyn::simulation
