#include "benchmark/growing.hpp"

#include <vector>

#include <fmt/format.h>

namespace treedyn::benchmark {

std::string growing_robot(bool chain, int size) {
  static const char* const kAxes[] = {"[0, 0, 1]", "[0, 1, 0]", "[1, 0, 0]"};
  std::string text = "name: robot\nlinks:\n";
  std::vector<std::size_t> depth;
  for (int i = 0; i < size; ++i) {
    const int father = chain ? i - 1 : (i - 1) / 2;
    depth.push_back(i == 0 ? 0 : depth[static_cast<std::size_t>(father)] + 1);
    const std::string offset =
        i == 0 ? "[0, 0, 0]" : fmt::format("[{}, 0, 0.3]", i % 2 == 0 ? "0.1" : "0");
    text += fmt::format(
        "  - name: link{}\n    father: {}\n"
        "    joint: {{name: joint{}, type: revolute, axis: {}, offset: {}}}\n"
        "    mass: {}\n    com: [0.02, -0.01, 0.15]\n    inertia: [0.02, 0, 0, 0.03, 0, 0.01]\n",
        i, i == 0 ? std::string("ground") : fmt::format("link{}", father), i,
        kAxes[depth.back() % 3], offset, 1 + 0.01 * i);
  }
  return text;
}

}  // namespace treedyn::benchmark
