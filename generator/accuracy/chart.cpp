#include "accuracy/chart.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "accuracy/picture_places.hpp"

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

/// The size of a name, about.
double width_of(const std::string& name) { return 5.8 * static_cast<double>(name.size()); }
constexpr double kLine = 11;

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
    Places places = marks();
    const std::string levels = floors(places);  // first: names of limits have more room
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n<text x=\"{2}\" y=\"18\" "
        "font-size=\"13\">{3}</text>\n{4}{5}{6}{7}{8}</svg>\n",
        kWidth, kHeight, kLeft, escaped(title), grid(axis), front_line(front), series(), levels,
        limit_lines(limits, places));
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
    const int decades = static_cast<int>(x_.high - x_.low);
    for (int number = 0; number <= decades; ++number) {
      const double k = x_.low + number;
      const double x = px(std::pow(10, k));
      text += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\">1e{4}</text>\n",
          x, kTop, kHeight - kBottom, kHeight - kBottom + 16, k);
    }
    const double every = std::max(1.0, std::ceil((y_.high - y_.low) / 10));
    const int lines = static_cast<int>((y_.high - y_.low) / every);
    for (int number = 0; number <= lines; ++number) {
      const double k = y_.low + number * every;
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

  /// What names had better not cover.
  [[nodiscard]] Places marks() const {
    constexpr double kHalf = 4;
    Places result;
    for (const Outcome& outcome : study_.outcomes) {
      if (!outcome.failed()) {
        const double x = px(abscissa_(outcome));
        const double y = py(outcome.error(study_.error));
        result.take({x - kHalf, y - kHalf, x + kHalf, y + kHalf});
      }
    }
    return result;
  }

  /// Horizontal lines, each with its name right above or below it.
  [[nodiscard]] std::string floors(Places& places) const {
    std::vector<std::pair<double, std::string>> levels;
    const auto add = [&](const std::string& name, const std::optional<Floor>& floor) {
      if (floor) {
        levels.emplace_back(py(floor->error), fmt::format("{}: {:.1e}", name, floor->error));
      }
    };
    for (const State state : kStates) {
      const std::optional<Floor> floor = floor_of(study_, state);
      add(fmt::format("floor of {}", name_of(state)),
          floor && floor->is_reached ? floor : std::nullopt);
    }
    add("floor of events at the end of a step", event_floor(study_));
    std::ranges::sort(levels);
    std::string text;
    for (const auto& [y, name] : levels) {
      places.take({kLeft, y - 1, kWidth - kRight, y + 1});
      text +=
          fmt::format("<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#555\" stroke-dasharray=\"2 3\"/>\n",
                      kLeft, y, kWidth - kRight);
    }
    for (const auto& [y, name] : levels) {
      text += level_name(name, y, places);
    }
    return text;
  }

  [[nodiscard]] static std::string level_name(const std::string& name, double y, Places& places) {
    std::vector<Rectangle> boxes;
    double right = kWidth - kRight - 4;
    do {
      for (const double top : {y - 1.5 - kLine, y + 1.5}) {
        boxes.push_back({right - width_of(name), top, right, top + kLine});
      }
      right -= kLine;
    } while (right > kLeft + width_of(name));
    const Rectangle& box = boxes[places.take_best(boxes)];
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" fill=\"#555\" stroke=\"white\" "
        "stroke-width=\"2\" paint-order=\"stroke\">{}</text>\n",
        box.right, box.bottom - 1.5, name);
  }

  /// Vertical lines at the steps beyond which methods are unstable, where they are in the picture,
  /// with names along them.
  [[nodiscard]] std::string limit_lines(const std::vector<StepLimit>& limits,
                                        Places& places) const {
    std::vector<StepLimit> shown;
    for (const StepLimit& limit : limits) {
      const double decades = std::log10(limit.step);
      if (decades >= x_.low && decades <= x_.high) {
        shown.push_back(limit);
        places.take({px(limit.step) - 1, kTop, px(limit.step) + 1, kHeight - kBottom});
      }
    }
    std::string text;
    for (const StepLimit& limit : shown) {
      const double x = px(limit.step);
      const std::string name =
          fmt::format("{} is stable up to {:.2g} s", limit.integrator, limit.step);
      std::vector<Rectangle> boxes;
      for (const double left : {x - 2 - kLine, x + 2}) {
        double foot = kHeight - kBottom - 4;
        do {
          boxes.push_back({left, foot - width_of(name), left + kLine, foot});
          foot -= 4;
        } while (foot - width_of(name) > kTop);
      }
      const Rectangle& box = boxes[places.take_best(boxes)];
      text += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#a33\" stroke-dasharray=\"6 3\"/><text "
          "transform=\"translate({3:.1f} {4:.1f}) rotate(-90)\" fill=\"#a33\" stroke=\"white\" "
          "stroke-width=\"2\" paint-order=\"stroke\">{5}</text>\n",
          x, kTop, kHeight - kBottom, box.right - 2, box.bottom, name);
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
    Places crosses;
    double line = kTop + 6;
    for (std::size_t k = 0; k < methods.size(); ++k) {
      for (const State state : kStates) {
        const std::string one =
            one_series(methods[k], state, kColours[k % std::size(kColours)], crosses);
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

  /// A cross for a motion that failed, beside those that are there.
  [[nodiscard]] static std::string cross(double x, const std::string& what, const char* colour,
                                         Places& crosses) {
    constexpr double kApart = 5;
    std::vector<Rectangle> boxes;
    for (int k = 0; k < 24; ++k) {
      const double at = x + kApart * (k % 2 == 0 ? -k / 2 : (k + 1) / 2);
      boxes.push_back({at - kApart / 2, 0, at + kApart / 2, 1});
    }
    const Rectangle& box = boxes[crosses.take_best(boxes)];
    return fmt::format(
        "<path d=\"M{:.1f} {}l8 8m0 -8l-8 8\" stroke=\"{}\" stroke-width=\"2\"><title>{}: "
        "failed</title></path>\n",
        (box.left + box.right) / 2 - 4, kTop - 12, colour, escaped(what));
  }

  [[nodiscard]] std::string one_series(const std::string& name, State state, const char* colour,
                                       Places& crosses) const {
    std::string path;
    std::string marks;
    for (const Outcome& outcome : study_.outcomes) {
      if (method_of(outcome.setting) != name || outcome.setting.state != state) {
        continue;
      }
      const double x = px(abscissa_(outcome));
      if (outcome.failed()) {
        marks += cross(x, text_of(outcome.setting), colour, crosses);
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
