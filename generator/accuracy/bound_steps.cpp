#include "accuracy/bound_steps.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace treedyn::accuracy {

namespace {

using program::Graph;
using program::Kind;
using program::Node;
using program::node_index;
using program::Ref;

/// The value of the literal.
Real literal_value(const Real& value, emit::Scalar scalar) {
  return scalar == emit::Scalar::kFloat ? Real(value.convert_to<float>())
                                        : Real(value.convert_to<double>());
}

bool is_power_of_two(const Real& value) {
  int exponent = 0;
  return std::frexp(static_cast<double>(value), &exponent) == 0.5;
}

bool is_wave(const BoundStep& step) { return step.kind == Kind::kSin || step.kind == Kind::kCos; }

class Steps {
 public:
  Steps(const program::Function& function, emit::Scalar scalar)
      : graph_(function.graph), scalar_(scalar), numbers_(function.graph.size(), -1) {
    for (const program::Array& array : function.signature.inputs) {
      first_.push_back(elements_);
      elements_ += array.size;
    }
  }

  std::vector<BoundStep> of(Ref output) {
    const std::vector<Ref> outputs = {output};
    for (const Ref k : program::reachable(graph_, outputs)) {
      numbers_[static_cast<std::size_t>(k)] = static_cast<int>(steps_.size());
      steps_.push_back(made(k));
    }
    pair_products();
    return std::move(steps_);
  }

 private:
  [[nodiscard]] const BoundStep& step(int k) const { return steps_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] int number(Ref a) const { return numbers_[node_index(a)]; }

  [[nodiscard]] BoundStep made(Ref k) const {
    const Node& node = graph_.node(k);
    BoundStep result;
    result.kind = node.kind;
    if (node.kind == Kind::kConstant) {
      const Real value = graph_.value(k).plain();
      const auto near = static_cast<double>(value);
      result.constant = outwards(near, near);
      const auto off = static_cast<double>(abs(literal_value(value, scalar_) - value));
      result.literal = off == 0 ? 0 : above(off);
    } else if (node.kind == Kind::kInput) {
      result.a = first_[static_cast<std::size_t>(node.a)] + node.b;
    } else {
      result.a = number(node.a);
      result.minus_a = node.a < 0;
      result.b = node.b == 0 ? -1 : number(node.b);
      result.minus_b = node.b < 0;
      result.exact = node.kind == Kind::kMultiply && (is_exact(node.a) || is_exact(node.b));
      note_angle(result);
    }
    return result;
  }

  [[nodiscard]] bool is_exact(Ref a) const {
    return graph_.is_constant(a) &&
           is_power_of_two(literal_value(graph_.value(a).plain(), scalar_));
  }

  void note_angle(BoundStep& of) const {
    if (of.b < 0) {
      return;
    }
    const BoundStep& a = step(of.a);
    const BoundStep& b = step(of.b);
    if (of.kind == Kind::kMultiply && is_wave(a) != is_wave(b)) {
      const BoundStep& wave = is_wave(a) ? a : b;
      of.angle = wave.a;
      of.sine = wave.kind == Kind::kSin;
      of.other = is_wave(a) ? of.b : of.a;
    } else if (of.kind == Kind::kAdd) {
      of.turn = a.angle >= 0 && a.angle == b.angle && a.sine != b.sine;
    }
  }

  /// The order of the products decides which of several make a pair.
  void pair_products() {
    std::map<std::pair<int, int>, std::array<std::vector<int>, 2>> products;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const BoundStep& of = steps_[k];
      if (of.angle >= 0) {
        products[{of.other, of.angle}][of.sine ? 1 : 0].push_back(static_cast<int>(k));
      }
    }
    for (const auto& [key, of] : products) {
      for (std::size_t k = 0; k < std::min(of[0].size(), of[1].size()); ++k) {
        steps_[static_cast<std::size_t>(key.first)].pairs.emplace_back(of[0][k], of[1][k]);
        steps_[static_cast<std::size_t>(of[0][k])].paired = true;
        steps_[static_cast<std::size_t>(of[1][k])].paired = true;
      }
    }
  }

  const Graph& graph_;
  emit::Scalar scalar_;
  std::vector<int> numbers_;  ///< of the graph's nodes: steps
  std::vector<int> first_;    ///< of every array: its first element among all
  int elements_ = 0;
  std::vector<BoundStep> steps_;
};

}  // namespace

std::vector<BoundStep> bound_steps(const program::Function& function, Ref output,
                                   emit::Scalar scalar) {
  return Steps(function, scalar).of(output);
}

}  // namespace treedyn::accuracy
