#include <cmath>

#include <fmt/format.h>

#include "benchmark/report.hpp"
#include "benchmark/series.hpp"

namespace treedyn::benchmark {

namespace {

constexpr const char* kColours[] = {"#1b5e9b", "#5aa2d8", "#b9b9b9",
                                    "#d95f02", "#7a5195", "#2f8f5b"};
constexpr int kBar = 9;          ///< height, px
constexpr int kGap = 8;          ///< between functions
constexpr int kLabels = 190;     ///< width of the names of the functions
constexpr int kDecade = 70;      ///< width of a factor of 10
constexpr int kPanel = 520;      ///< width of a robot
constexpr int kTitle = 34;       ///< height of its name
constexpr double kLeast = 0.05;  ///< at the left end of the bars

double place(double ratio) {
  return kLabels + kDecade * std::log10(std::max(ratio, kLeast) / kLeast);
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     text);
}

class Chart {
 public:
  explicit Chart(const std::vector<Cell>& cells)
      : cells_(cells),
        contestants_(values(cells, &Cell::contestant)),
        functions_(values(cells, &Cell::function)) {}

  [[nodiscard]] std::string text() const {
    const std::vector<std::string> robots = values(cells_, &Cell::robot);
    const auto rows = static_cast<int>((robots.size() + 1) / 2);
    std::string body = legend();
    for (std::size_t k = 0; k < robots.size(); ++k) {
      const auto column = static_cast<int>(k % 2);
      const auto row = static_cast<int>(k / 2);
      body += fmt::format("<g transform=\"translate({},{})\">\n{}</g>\n", column * kPanel,
                          40 + row * panel_height(), panel(robots[k]));
    }
    const int width = kPanel * static_cast<int>(std::min<std::size_t>(2, robots.size()));
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"10\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
        width, 40 + rows * panel_height(), body);
  }

 private:
  [[nodiscard]] int group_height() const {
    return kBar * static_cast<int>(contestants_.size()) + kGap;
  }
  [[nodiscard]] int panel_height() const {
    return kTitle + group_height() * static_cast<int>(functions_.size()) + 14;
  }

  [[nodiscard]] std::string legend() const {
    std::string text;
    double x = 10;
    for (std::size_t k = 0; k < contestants_.size(); ++k) {
      text += fmt::format("<rect x=\"{:.1f}\" y=\"8\" width=\"10\" height=\"10\" fill=\"{}\"/>\n",
                          x, kColours[k % std::size(kColours)]);
      text += text_at(x + 14, 17, "start", contestants_[k]);
      x += 30 + 6 * static_cast<double>(contestants_[k].size());
    }
    return text + text_at(10, 32, "start",
                          fmt::format("least time of a call relative to {}, logarithmic, less is "
                                      "better",
                                      contestants_.front()));
  }

  [[nodiscard]] std::string panel(const std::string& robot) const {
    std::string text = fmt::format(
        "<text x=\"10\" y=\"14\" font-size=\"13\" font-weight=\"bold\">{}</text>\n", robot);
    const int bottom = panel_height() - 14;
    for (const double tick : {0.1, 1.0, 10.0, 100.0, 1000.0}) {
      text += fmt::format(
          "<line x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\" "
          "stroke=\"#cccccc\"/>\n",
          place(tick), kTitle - 6, bottom);
      text += text_at(place(tick), kTitle - 9, "middle", fmt::format("{:g}", tick));
    }
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      text += group(robot, functions_[k], kTitle + group_height() * static_cast<int>(k));
    }
    return text;
  }

  [[nodiscard]] std::string group(const std::string& robot, const std::string& function,
                                  int top) const {
    const Cell* first = find(cells_, robot, function, contestants_.front());
    if (first == nullptr) {
      return {};
    }
    std::string text = text_at(kLabels - 6, top + group_height() / 2, "end", function);
    for (std::size_t k = 0; k < contestants_.size(); ++k) {
      const Cell* cell = find(cells_, robot, function, contestants_[k]);
      if (cell == nullptr) {
        continue;
      }
      const double ratio = cell->least / first->least;
      const int y = top + kBar * static_cast<int>(k);
      text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
                          kLabels, y, place(ratio) - kLabels, kBar - 1,
                          kColours[k % std::size(kColours)]);
      text += text_at(place(ratio) + 3, y + kBar - 1, "start",
                      fmt::format("{:.{}f}", ratio,
                                  ratio < 1    ? 2
                                  : ratio < 10 ? 1
                                               : 0));
    }
    return text;
  }

  const std::vector<Cell>& cells_;
  std::vector<std::string> contestants_;
  std::vector<std::string> functions_;
};

}  // namespace

std::string svg(const std::vector<Cell>& cells) { return Chart(cells).text(); }

}  // namespace treedyn::benchmark
