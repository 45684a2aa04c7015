// Line charts on logarithmic axes.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace treedyn::benchmark {

struct Line {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< positive, x ascending
};

struct Panel {
  std::string title;
  std::vector<Line> lines;
};

/// SVG: the panels side by side, two a row, with the same lines in the same colours; x is called
/// `x_name` and grows by powers of 2, y by powers of 10.
std::string line_chart(const std::string& x_name, const std::vector<Panel>& panels);

}  // namespace treedyn::benchmark
