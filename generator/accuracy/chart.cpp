#include "accuracy/chart.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

namespace treedyn::accuracy {

namespace {

constexpr double kWidth = 760;
constexpr double kHeight = 430;
constexpr double kLeft = 70;
constexpr double kRight = 260;  ///< for the names of the series
constexpr double kTop = 46;
constexpr double kBottom = 50;
constexpr const char* kColours[] = {"#1b5e9b", "#d95f02", "#2f8f5b", "#7a5195", "#8c6d1f"};

/// A range of whole decades.
struct Decades {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (std::isfinite(value) && value > 0) {
      low = std::min(low, std::floor(std::log10(value)));
      high = std::max(high, std::ceil(std::log10(value)));
    }
  }
  void widen() {
    if (low > high) {
      low = -1;
      high = 0;
    }
    high = std::max(high, low + 1);
  }
  /// 0 at the lower end, 1 at the upper.
  [[nodiscard]] double place(double value) const {
    return std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
  }
};

const char* dashes(State state) {
  switch (state) {
    case State::kFloat:
      return " stroke-dasharray=\"4 2\"";
    case State::kCompensated:
      return " stroke-dasharray=\"1 2\"";
    case State::kDouble:
      break;
  }
  return "";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

using Abscissa = std::function<double(const Outcome&)>;

class Chart {
 public:
  Chart(const Study& study, Abscissa abscissa) : study_(study), abscissa_(std::move(abscissa)) {
    for (const Outcome& outcome : study.outcomes) {
      x_.include(abscissa_(outcome));
      if (!outcome.failed()) {
        y_.include(outcome.error(study.error));
        y_.include(outcome.least(study.error));
      }
    }
    x_.widen();
    y_.widen();
  }

  [[nodiscard]] std::string text(const std::string& title, const std::string& axis,
                                 const std::vector<std::size_t>& front,
                                 const std::vector<StepLimit>& limits = {}) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n<text x=\"{2}\" y=\"18\" "
        "font-size=\"13\">{3}</text>\n{4}{5}{6}{7}{8}</svg>\n",
        kWidth, kHeight, kLeft, escaped(title), grid(axis), front_line(front), series(), floors(),
        limit_lines(limits));
  }

 private:
  [[nodiscard]] double px(double x) const {
    return kLeft + (kWidth - kLeft - kRight) * x_.place(x);
  }
  [[nodiscard]] double py(double y) const {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * y_.place(y);
  }

  [[nodiscard]] std::string grid(const std::string& axis) const {
    std::string text;
    for (double k = x_.low; k <= x_.high; ++k) {
      const double x = px(std::pow(10, k));
      text += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\">1e{4}</text>\n",
          x, kTop, kHeight - kBottom, kHeight - kBottom + 16, k);
    }
    const double every = std::max(1.0, std::ceil((y_.high - y_.low) / 10));
    for (double k = y_.low; k <= y_.high; k += every) {
      const double y = py(std::pow(10, k));
      text += fmt::format(
          "<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\">1e{5}</text>\n",
          kLeft, y, kWidth - kRight, kLeft - 6, y + 4, k);
    }
    return text +
           fmt::format(
               "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n<text x=\"14\" y=\"{}\" "
               "transform=\"rotate(-90 14 {})\" text-anchor=\"middle\">largest {}</text>\n",
               (kLeft + kWidth - kRight) / 2, kHeight - 12, escaped(axis), kHeight / 2, kHeight / 2,
               row_of(study_.error).text);
  }

  [[nodiscard]] std::string floors() const {
    std::string text;
    for (const State state : kStates) {
      if (const std::optional<Floor> floor = floor_of(study_, state); floor && floor->is_reached) {
        const double below = state == State::kCompensated ? 11 : -3;  // near that of float
        text += level(fmt::format("floor of {}", name_of(state)), floor->error, below);
      }
    }
    if (const std::optional<Floor> floor = event_floor(study_)) {
      text += level("floor of events at the end of a step", floor->error, -3);
    }
    return text;
  }

  /// A horizontal line with its name, `below` the line.
  [[nodiscard]] std::string level(const std::string& name, double error, double below) const {
    const double y = py(error);
    return fmt::format(
        "<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#555\" stroke-dasharray=\"2 3\"/><text x=\"{3}\" "
        "y=\"{4:.1f}\" text-anchor=\"end\" fill=\"#555\" stroke=\"white\" "
        "stroke-width=\"2\" paint-order=\"stroke\">{5}: {6:.1e}</text>\n",
        kLeft, y, kWidth - kRight, kWidth - kRight - 4, y + below, name, error);
  }

  /// Vertical lines at the steps beyond which methods are unstable, where they are in the picture,
  /// with names along them.
  [[nodiscard]] std::string limit_lines(const std::vector<StepLimit>& limits) const {
    constexpr double kFoot = 60;  // above the names of the floors of double
    std::string text;
    for (const StepLimit& limit : limits) {
      const double decades = std::log10(limit.step);
      if (decades < x_.low || decades > x_.high) {
        continue;
      }
      const double x = px(limit.step);
      text += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#a33\" stroke-dasharray=\"6 3\"/><text "
          "transform=\"translate({3:.1f} {4}) rotate(-90)\" fill=\"#a33\" stroke=\"white\" "
          "stroke-width=\"2\" paint-order=\"stroke\">{5} is stable up to {6:.2g} s</text>\n",
          x, kTop, kHeight - kBottom, x - 3, kHeight - kBottom - kFoot, limit.integrator,
          limit.step);
    }
    return text;
  }

  [[nodiscard]] std::string front_line(const std::vector<std::size_t>& front) const {
    std::string path;
    for (const std::size_t k : front) {
      const Outcome& outcome = study_.outcomes[k];
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px(abscissa_(outcome)),
                          py(outcome.error(study_.error)));
    }
    return path.empty() ? path
                        : fmt::format(
                              "<path d=\"{}\" fill=\"none\" stroke=\"#bbb\" "
                              "stroke-width=\"6\" stroke-linejoin=\"round\"/>\n",
                              path);
  }

  /// A line for each scalar and method, a bar for the band at each step.
  [[nodiscard]] std::string series() const {
    std::vector<std::string> methods;
    for (const Outcome& outcome : study_.outcomes) {
      const std::string name = method_of(outcome.setting);
      if (std::find(methods.begin(), methods.end(), name) == methods.end()) {
        methods.push_back(name);
      }
    }
    std::string text;
    double line = kTop + 6;
    for (std::size_t k = 0; k < methods.size(); ++k) {
      for (const State state : kStates) {
        const std::string one = one_series(methods[k], state, kColours[k % std::size(kColours)]);
        if (!one.empty()) {
          text += one + legend(methods[k], state, kColours[k % std::size(kColours)], line);
          line += 17;
        }
      }
    }
    return text;
  }

  [[nodiscard]] static std::string legend(const std::string& name, State state, const char* colour,
                                          double y) {
    return fmt::format(
        "<path d=\"M{0} {1}h18\" stroke=\"{2}\" stroke-width=\"2\"{3}/><text x=\"{4}\" "
        "y=\"{5}\">{6} {7}</text>\n",
        kWidth - kRight + 8, y, colour, dashes(state), kWidth - kRight + 30, y + 4, name_of(state),
        escaped(name));
  }

  [[nodiscard]] std::string one_series(const std::string& name, State state,
                                       const char* colour) const {
    std::string path;
    std::string marks;
    for (const Outcome& outcome : study_.outcomes) {
      if (method_of(outcome.setting) != name || outcome.setting.state != state) {
        continue;
      }
      const double x = px(abscissa_(outcome));
      if (outcome.failed()) {
        marks += fmt::format(
            "<path d=\"M{:.1f} {}l8 8m0 -8l-8 8\" stroke=\"{}\" stroke-width=\"2\"><title>{}: "
            "failed</title></path>\n",
            x - 4, kTop - 12, colour, escaped(text_of(outcome.setting)));
        continue;
      }
      const double error = outcome.error(study_.error);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, py(error));
      marks += fmt::format(
          "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\" opacity=\"0.4\" "
          "stroke-width=\"3\"/><circle cx=\"{0:.1f}\" cy=\"{2:.1f}\" r=\"3\" "
          "fill=\"{3}\"><title>{4}: {5:.2e}</title></circle>\n",
          x, py(std::max(outcome.least(study_.error), 1e-300)), py(error), colour,
          escaped(text_of(outcome.setting)), error);
    }
    if (path.empty()) {
      return marks;
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n{}",
                       path, colour, dashes(state), marks);
  }

  const Study& study_;
  Abscissa abscissa_;
  Decades x_;
  Decades y_;
};

}  // namespace

std::string step_chart(const Study& study) {
  const Chart chart(study, [](const Outcome& outcome) { return outcome.setting.step; });
  return chart.text(fmt::format("{}: is float enough, which step?", study.scene), "step, s", {},
                    study.stability);
}

std::string work_chart(const Study& study, const Core& core) {
  const Chart chart(study, [&](const Outcome& outcome) { return outcome.cycles_per_second(core); });
  return chart.text(fmt::format("{}: which setting on {}?", study.scene, core.brief),
                    "cycles for a second of motion (table); the grey line is the Pareto front",
                    pareto(study, core));
}

}  // namespace treedyn::accuracy
