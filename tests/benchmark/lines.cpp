#include "benchmark/lines.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace treedyn::benchmark {

namespace {

constexpr const char* kColours[] = {"#1b5e9b", "#d95f02", "#2f8f5b", "#7b4fa3",
                                    "#5aa2d8", "#f0a35e", "#86c99f", "#bfa3d9"};
constexpr double kWidth = 420;
constexpr double kHeight = 300;
constexpr double kLeft = 60;
constexpr double kTop = 26;
constexpr double kBottom = 34;

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     text);
}

std::string rule(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>\n", x1,
      y1, x2, y2);
}

/// Powers of a base that hold all values: exponents.
struct Range {
  int first = 0;
  int last = 1;
};

Range range_of(const Panel& panel, double base, double std::pair<double, double>::*member) {
  double least = HUGE_VAL;
  double largest = 0;
  for (const Line& line : panel.lines) {
    for (const auto& point : line.points) {
      least = std::min(least, point.*member);
      largest = std::max(largest, point.*member);
    }
  }
  const double scale = 1 / std::log(base);
  const auto first = static_cast<int>(std::floor(std::log(least) * scale + 1e-9));
  const auto last = static_cast<int>(std::ceil(std::log(largest) * scale - 1e-9));
  return {first, std::max(last, first + 1)};
}

class Drawing {
 public:
  Drawing(const Panel& panel, const std::string& x_name)
      : panel_(panel),
        x_name_(x_name),
        x_(range_of(panel, 2, &std::pair<double, double>::first)),
        y_(range_of(panel, 10, &std::pair<double, double>::second)) {}

  [[nodiscard]] std::string text() const {
    std::string text =
        fmt::format("<text x=\"{}\" y=\"16\" font-size=\"13\" font-weight=\"bold\">{}</text>\n",
                    kLeft, panel_.title);
    for (int k = x_.first; k <= x_.last; ++k) {
      const double x = place_x(std::exp2(k));
      text += rule(x, kTop, x, kHeight - kBottom);
      text += text_at(x, kHeight - kBottom + 14, "middle", fmt::format("{}", std::exp2(k)));
    }
    for (int k = y_.first; k <= y_.last; ++k) {
      const double y = place_y(std::pow(10, k));
      text += rule(kLeft, y, kWidth - 10, y);
      text += text_at(kLeft - 5, y + 3, "end", fmt::format("{:g}", std::pow(10, k)));
    }
    text += text_at((kLeft + kWidth) / 2, kHeight - 6, "middle", x_name_);
    for (std::size_t k = 0; k < panel_.lines.size(); ++k) {
      text += line(panel_.lines[k], kColours[k % std::size(kColours)]);
    }
    return text;
  }

 private:
  [[nodiscard]] double place_x(double value) const {
    return kLeft + (std::log2(value) - x_.first) / (x_.last - x_.first) * (kWidth - 10 - kLeft);
  }
  [[nodiscard]] double place_y(double value) const {
    const double share = (std::log10(value) - y_.first) / (y_.last - y_.first);
    return kHeight - kBottom - share * (kHeight - kBottom - kTop);
  }
  [[nodiscard]] std::string line(const Line& line, const char* colour) const {
    std::string points;
    std::string marks;
    for (const auto& [x, y] : line.points) {
      points += fmt::format("{:.1f},{:.1f} ", place_x(x), place_y(y));
      marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n",
                           place_x(x), place_y(y), colour);
    }
    return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>\n{}", points, colour,
                       marks);
  }

  const Panel& panel_;
  const std::string& x_name_;
  Range x_;
  Range y_;
};

}  // namespace

std::string line_chart(const std::string& x_name, const std::vector<Panel>& panels) {
  constexpr double kLegend = 40;
  std::string body;
  const std::vector<Line>& lines = panels.front().lines;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double x = 12 + 270.0 * static_cast<double>(k % 3);
    const double y = 8 + 16.0 * static_cast<double>(k / 3);
    body += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/>\n", x, y,
                        kColours[k % std::size(kColours)]);
    body += text_at(x + 15, y + 9, "start", lines[k].name);
  }
  for (std::size_t k = 0; k < panels.size(); ++k) {
    body += fmt::format(
        "<g transform=\"translate({},{})\">\n{}</g>\n", kWidth * static_cast<double>(k % 2),
        kLegend + kHeight * static_cast<double>(k / 2), Drawing(panels[k], x_name).text());
  }
  const double rows = std::ceil(static_cast<double>(panels.size()) / 2);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"10\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
      2 * kWidth, kLegend + rows * kHeight, body);
}

}  // namespace treedyn::benchmark
