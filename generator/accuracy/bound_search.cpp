#include "accuracy/bound_search.hpp"

#include <algorithm>
#include <map>
#include <queue>

namespace treedyn::accuracy {

namespace {

/// A part of the box for one value.
struct Piece {
  double part = 0;  ///< bound / scale
  double bound = 0;
  std::size_t value = 0;
  Box box;
  bool operator<(const Piece& other) const {
    return part != other.part ? part < other.part : value > other.value;
  }
};

/// A value that is an output, or several.
struct Value {
  OutputError error;
  std::set<int> inputs;
  std::size_t output;  ///< the first
  double scale;        ///< the least
  double bound = 0;
};

class Search {
 public:
  Search(const program::Function& function, const Arithmetic& how, const Over& over) : over_(over) {
    std::map<program::Ref, std::size_t> known;
    for (std::size_t k = 0; k < function.outputs.size(); ++k) {
      const program::Ref output = std::abs(function.outputs[k]);
      const auto [place, is_new] = known.emplace(output, values_.size());
      value_of_.push_back(output == 0 ? kNone : place->second);
      if (output == 0) {
        known.erase(place);
      } else if (is_new) {
        values_.push_back({OutputError(function, output, how), {}, k, over.scales[k]});
        values_.back().inputs = values_.back().error.inputs();
      } else {
        Value& value = values_[place->second];
        value.scale = std::min(value.scale, over.scales[k]);
      }
    }
  }

  BoundsOver run() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      push(k, over_.box);
    }
    for (int cut = 0; cut < over_.cuts && !pieces_.empty() && halve(); ++cut) {
    }
    BoundsOver result;
    if (!pieces_.empty()) {
      Value& worst = values_[pieces_.top().value];
      result.largest = pieces_.top().part;
      result.output = worst.output;
      worst.error(pieces_.top().box);
      result.obstacle = worst.error.obstacle();
    }
    for (; !pieces_.empty(); pieces_.pop()) {
      double& bound = values_[pieces_.top().value].bound;
      bound = std::max(bound, pieces_.top().bound);
    }
    for (const std::size_t value : value_of_) {
      result.outputs.push_back(value == kNone ? 0 : values_[value].bound);
    }
    return result;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void push(std::size_t of, Box box) {
    Value& value = values_[of];
    Piece piece{0, value.error(box), of, std::move(box)};
    piece.part = piece.bound == 0 ? 0 : piece.bound / value.scale;
    pieces_.push(std::move(piece));
  }

  /// The worst piece along its widest element, as parts of the whole box; false: it is a point.
  bool halve() {
    const Piece worst = pieces_.top();
    std::size_t widest = kNone;
    double most = 0;
    for (const int k : values_[worst.value].inputs) {
      const auto i = static_cast<std::size_t>(k);
      const double width =
          over_.box[i].width() > 0 ? worst.box[i].width() / over_.box[i].width() : 0;
      if (width > most) {
        most = width;
        widest = i;
      }
    }
    if (widest == kNone) {
      return false;
    }
    pieces_.pop();
    Box left = worst.box;
    Box right = worst.box;
    left[widest].high = right[widest].low = worst.box[widest].middle();
    push(worst.value, std::move(left));
    push(worst.value, std::move(right));
    return true;
  }

  const Over& over_;
  std::vector<Value> values_;
  std::vector<std::size_t> value_of_;  ///< of every output
  std::priority_queue<Piece> pieces_;
};

}  // namespace

BoundsOver bounds_over(const program::Function& function, const Arithmetic& how, const Over& over) {
  return Search(function, how, over).run();
}

}  // namespace treedyn::accuracy
