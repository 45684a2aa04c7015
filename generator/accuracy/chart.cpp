#include "accuracy/chart.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "accuracy/picture_places.hpp"
#include "emit/template_file.hpp"

namespace treedyn::accuracy {

namespace {

constexpr double kWidth = 760;  ///< more where a name needs it
constexpr double kPlot = 334;   ///< height of the plot
constexpr double kLeft = 70;
constexpr double kTop = 46;     ///< without rows above the plot
constexpr double kBottom = 50;  ///< for numbers and name of the axis
constexpr double kRow = 13;     ///< of names above and beside the plot
constexpr double kEntry = 17;   ///< of the legend

/// How the curves of a method look.
struct Look {
  const char* colour;
  const char* mark;  ///< a path around its point
};

/// Neighbours differ in both, 32 methods in one of them.
Look look(std::size_t method) {
  constexpr const char* kColours[] = {"#1b5e9b", "#d95f02", "#2f8f5b", "#7a5195",
                                      "#8c6d1f", "#c51b7d", "#333333", "#0097a7"};
  constexpr const char* kMarks[] = {"m-3 0a3 3 0 1 0 6 0a3 3 0 1 0 -6 0", "m-3 -3h6v6h-6z",
                                    "m0 -4l4 7h-8z", "m0 -4l4 4l-4 4l-4 -4z"};
  const std::size_t round = method / std::size(kColours);
  return {kColours[method % std::size(kColours)], kMarks[(method + round) % std::size(kMarks)]};
}

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
  [[nodiscard]] bool is_empty() const { return low > high; }
  void widen() {
    if (is_empty()) {
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

/// The size of a name, at most.
double width_of(const std::string& name) { return 6.2 * static_cast<double>(name.size()); }

using Abscissa = std::function<double(const Outcome&)>;

class Chart {
 public:
  Chart(const Study& study, Abscissa abscissa, const std::vector<StepLimit>& limits = {})
      : study_(study), abscissa_(std::move(abscissa)) {
    for (const Outcome& outcome : study.outcomes) {
      x_.include(abscissa_(outcome));
      if (!outcome.failed()) {
        y_.include(outcome.error(study.error));
        y_.include(outcome.least(study.error));
        zeros_ += outcome.error(study.error) > 0 ? 0 : 1;
      }
      if (std::ranges::find(methods_, method_of(outcome.setting)) == methods_.end()) {
        methods_.push_back(method_of(outcome.setting));
      }
    }
    is_empty_ = y_.is_empty();
    x_.widen();
    y_.widen();
    find_levels();
    for (const StepLimit& limit : limits) {
      const double decades = std::log10(limit.step);
      if (decades >= x_.low && decades <= x_.high) {
        limits_.push_back(limit);
      }
    }
    std::ranges::sort(limits_, {}, &StepLimit::step);
    top_ = kTop + kRow * static_cast<double>(limits_.size() + (zeros_ > 0 ? 1 : 0));
    bottom_ = top_ + kPlot;
  }

  [[nodiscard]] std::string text(const std::string& title, const std::string& axis,
                                 const std::vector<std::size_t>& front) const {
    constexpr double kOfTitle = 7.4;  // a letter
    double width = std::max(kWidth, kLeft + kOfTitle * static_cast<double>(title.size()));
    double foot = 0;
    const std::string names = legend(width, foot);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1}\" "
        "viewBox=\"0 0 {0:.0f} {1}\" font-family=\"sans-serif\" font-size=\"11\">\n<rect "
        "width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{2}\" y=\"18\" "
        "font-size=\"13\">{3}</text>\n{4}{5}{6}{7}{8}{9}{10}</svg>\n",
        width, foot, kLeft, emit::html_text(title), note(), grid(axis), front_line(front),
        limit_lines(), series(), floors(), names);
  }

 private:
  [[nodiscard]] double px(double x) const { return kLeft + (right_ - kLeft) * x_.place(x); }
  [[nodiscard]] double py(double y) const { return bottom_ - kPlot * y_.place(y); }

  /// The floors, the highest first, and the room for their names beside the plot.
  void find_levels() {
    const auto add = [&](const std::string& name, const std::optional<Floor>& floor) {
      if (floor && floor->error > 0) {
        levels_.emplace_back(floor->error, fmt::format("{}: {:.1e}", name, floor->error));
      }
    };
    for (const State state : kStates) {
      const std::optional<Floor> floor = floor_of(study_, state);
      add(fmt::format("floor of {}", name_of(state)),
          floor && floor->is_reached ? floor : std::nullopt);
    }
    add("floor of events at the end of a step", event_floor(study_));
    std::ranges::sort(levels_, std::greater());
    double widest = 0;
    for (const auto& [error, name] : levels_) {
      widest = std::max(widest, width_of(name));
    }
    right_ = kWidth - 20 - widest;
  }

  /// Errors that have no place on the axis.
  [[nodiscard]] std::string note() const {
    const std::string text =
        is_empty_
            ? "all errors are exactly 0: there is no place for them on a logarithmic axis"
            : fmt::format("not drawn: {} of exactly 0, for which a logarithmic axis has no place",
                          zeros_ == 1 ? "an error" : fmt::format("{} errors", zeros_));
    return zeros_ == 0
               ? ""
               : fmt::format("<text x=\"{}\" y=\"35\" fill=\"#555\">{}</text>\n", kLeft, text);
  }

  [[nodiscard]] std::string grid(const std::string& axis) const {
    std::string text;
    const int decades = static_cast<int>(x_.high - x_.low);
    for (int number = 0; number <= decades; ++number) {
      const double k = x_.low + number;
      text += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\">1e{4}</text>\n",
          px(std::pow(10, k)), top_, bottom_, bottom_ + 16, k);
    }
    const double every = std::max(1.0, std::ceil((y_.high - y_.low) / 10));
    const int lines = static_cast<int>((y_.high - y_.low) / every);
    for (int number = 0; number <= lines; ++number) {
      const double k = y_.low + number * every;
      const double y = py(std::pow(10, k));
      text += fmt::format("<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/>", kLeft, y, right_);
      text += is_empty_
                  ? ""
                  : fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">1e{}</text>\n",
                                kLeft - 6, y + 4, k);
    }
    return text +
           fmt::format(
               "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n<text x=\"14\" y=\"{}\" "
               "transform=\"rotate(-90 14 {})\" text-anchor=\"middle\">largest {}</text>\n",
               (kLeft + right_) / 2, bottom_ + 38, emit::html_text(axis), top_ + kPlot / 2,
               top_ + kPlot / 2, row_of(study_.error).text);
  }

  /// Horizontal lines, each with its name at its right end, below the name of the one above.
  [[nodiscard]] std::string floors() const {
    std::string text;
    double above = 0;
    for (const auto& [error, name] : levels_) {
      const double y = py(error);
      above = std::max(y, above + kRow);
      text += fmt::format(
          "<path d=\"M{0} {1:.1f}H{2}L{3} {4:.1f}\" fill=\"none\" stroke=\"#555\" "
          "stroke-dasharray=\"2 3\"/><text x=\"{5}\" y=\"{6:.1f}\" fill=\"#555\">{7}</text>\n",
          kLeft, y, right_, right_ + 10, above, right_ + 13, above + 4, name);
    }
    return text;
  }

  /// Vertical lines at the steps beyond which methods are unstable, where they are in the picture,
  /// with names above the plot: that of the longest step on top, so that no line crosses one that
  /// ends at its line.
  [[nodiscard]] std::string limit_lines() const {
    constexpr double kGap = 4;
    std::string text;
    std::string names;
    double row = top_ - 18;
    for (const StepLimit& limit : limits_) {
      const double x = px(limit.step);
      const std::string name =
          fmt::format("{} is stable up to {:.2g} s", limit.integrator, limit.step);
      const bool fits = x - kGap - width_of(name) > 0;
      text += fmt::format("<path d=\"M{:.1f} {}V{}\" stroke=\"#a33\" stroke-dasharray=\"6 3\"/>\n",
                          x, row - 9, bottom_);
      names += fmt::format(
          "<text x=\"{:.1f}\" y=\"{}\"{} fill=\"#a33\" stroke=\"white\" stroke-width=\"3\" "
          "paint-order=\"stroke\">{}</text>\n",
          fits ? x - kGap : x + kGap, row, fits ? " text-anchor=\"end\"" : "", name);
      row -= kRow;
    }
    return text + names;
  }

  [[nodiscard]] std::string front_line(const std::vector<std::size_t>& front) const {
    std::string path;
    for (const std::size_t k : front) {
      const Outcome& outcome = study_.outcomes[k];
      const double error = outcome.error(study_.error);
      path += error > 0 ? fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L",
                                      px(abscissa_(outcome)), py(error))
                        : "";
    }
    return path.empty() ? path
                        : fmt::format(
                              "<path d=\"{}\" fill=\"none\" stroke=\"#bbb\" stroke-width=\"6\" "
                              "stroke-linejoin=\"round\"/>\n",
                              path);
  }

  /// A line for each scalar and method, a bar for the band at each step.
  [[nodiscard]] std::string series() const {
    std::string text;
    Places crosses;
    for (std::size_t k = 0; k < methods_.size(); ++k) {
      for (const State state : kStates) {
        text += one_series(k, state, crosses);
      }
    }
    return text;
  }

  /// Below the plot: the lines of scalars, and in columns the colours and marks of methods.
  /// \param[in,out] width  of the picture, at least what a name needs
  /// \param[out]    foot   the lower edge
  [[nodiscard]] std::string legend(double& width, double& foot) const {
    constexpr double kLine = 26;
    constexpr double kApart = 16;
    std::string text;
    double x = kLeft;
    double y = bottom_ + 62;
    const auto add = [&](const std::string& name, const std::string& line) {
      text += fmt::format("<path d=\"M{0} {1}h20\" {2}<text x=\"{3}\" y=\"{4}\">{5}</text>\n", x, y,
                          line, x + kLine, y + 4, emit::html_text(name));
    };
    for (const State state : kStates) {
      if (std::ranges::any_of(study_.outcomes, [&](const Outcome& outcome) {
            return outcome.setting.state == state;
          })) {
        add(name_of(state), fmt::format("stroke=\"#333\" stroke-width=\"2\"{}/>", dashes(state)));
        x += kLine + width_of(name_of(state)) + kApart;
      }
    }
    double column = 0;
    for (const std::string& name : methods_) {
      column = std::max(column, kLine + width_of(name) + kApart);
    }
    width = std::max(width, kLeft + column);
    const auto columns = static_cast<std::size_t>((width - kLeft) / std::max(column, 1.0));
    for (std::size_t k = 0; k < methods_.size(); ++k) {
      x = kLeft + column * static_cast<double>(k % columns);
      y += k % columns == 0 ? kEntry : 0;
      add(methods_[k],
          fmt::format("stroke=\"{0}\" stroke-width=\"2\"/><path d=\"M{1} {2}{3}\" fill=\"{0}\"/>",
                      look(k).colour, x + 10, y, look(k).mark));
    }
    foot = y + kEntry;
    return text;
  }

  /// A cross for a motion that failed, beside those that are there.
  [[nodiscard]] std::string cross(double x, const std::string& what, const char* colour,
                                  Places& crosses) const {
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
        (box.left + box.right) / 2 - 4, top_ - 12, colour, emit::html_text(what));
  }

  [[nodiscard]] std::string one_series(std::size_t method, State state, Places& crosses) const {
    const auto [colour, mark] = look(method);
    std::string path;
    std::string marks;
    for (const Outcome& outcome : study_.outcomes) {
      if (method_of(outcome.setting) != methods_[method] || outcome.setting.state != state) {
        continue;
      }
      const double x = px(abscissa_(outcome));
      if (outcome.failed()) {
        marks += cross(x, text_of(outcome.setting), colour, crosses);
        continue;
      }
      const double error = outcome.error(study_.error);
      if (!(error > 0)) {
        continue;
      }
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, py(error));
      marks += fmt::format(
          "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\" opacity=\"0.4\" "
          "stroke-width=\"3\"/><path d=\"M{0:.1f} {2:.1f}{4}\" fill=\"{3}\"><title>{5}: "
          "{6:.2e}</title></path>\n",
          x, py(std::max(outcome.least(study_.error), 1e-300)), py(error), colour, mark,
          emit::html_text(text_of(outcome.setting)), error);
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
  bool is_empty_ = false;  ///< nothing has a place on the axis of errors
  int zeros_ = 0;          ///< errors of exactly 0
  std::vector<std::string> methods_;
  std::vector<std::pair<double, std::string>> levels_;  ///< errors and names of floors
  std::vector<StepLimit> limits_;                       ///< in the picture, by rising step
  double right_ = 0, top_ = 0, bottom_ = 0;             ///< of the plot
};

}  // namespace

std::string step_chart(const Study& study) {
  const Chart chart(
      study, [](const Outcome& outcome) { return outcome.setting.step; }, study.stability);
  return chart.text(fmt::format("{}: is float enough, which step?", study.scene), "step, s", {});
}

std::string work_chart(const Study& study, const Core& core) {
  const Chart chart(study, [&](const Outcome& outcome) { return outcome.cycles_per_second(core); });
  return chart.text(fmt::format("{}: which setting on {}?", study.scene, core.brief),
                    "cycles for a second of motion (table); the grey line is the Pareto front",
                    pareto(study, core));
}

}  // namespace treedyn::accuracy
