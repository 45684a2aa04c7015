// Places of a picture in which names and marks do not cover each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace treedyn::accuracy {

/// A rectangle of a picture; y grows downwards.
struct Rectangle {
  double left, top, right, bottom;

  /// The area in both.
  [[nodiscard]] double common(const Rectangle& other) const {
    return std::max(0.0, std::min(right, other.right) - std::max(left, other.left)) *
           std::max(0.0, std::min(bottom, other.bottom) - std::max(top, other.top));
  }
};

/// Where marks and names stand.
class Places {
 public:
  void take(const Rectangle& box) { taken_.push_back(box); }
  /// Takes the box that covers the least; the first of several.
  std::size_t take_best(const std::vector<Rectangle>& boxes) {
    const auto covered = [&](const Rectangle& box) {
      double sum = 0;
      for (const Rectangle& other : taken_) {
        sum += box.common(other);
      }
      return sum;
    };
    const auto best = std::ranges::min_element(boxes, {}, covered);
    const auto at = static_cast<std::size_t>(best - boxes.begin());
    take(*best);
    return at;
  }

 private:
  std::vector<Rectangle> taken_;
};

}  // namespace treedyn::accuracy
