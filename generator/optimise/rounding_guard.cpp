#include "optimise/rounding_guard.hpp"

namespace treedyn::optimise {

namespace {

/// Of every output, by all passes together.
constexpr double kMostOverReference = 2;

/// Values in double: where they cancel, their error bounds count and not what is left.
std::vector<Rounded<double>> rounded_items(const Network& network, int point) {
  using Number = Rounded<double>;
  std::vector<Number> items(static_cast<std::size_t>(network.size()));
  const auto of = [&](Ref a) {
    const Number& item = items[program::node_index(a)];
    return a < 0 ? -item : item;
  };
  const auto elementary = [](Kind kind, const Number& a) {
    return Number::function(kind, a, sample_function(kind, a.value));
  };
  for (int k = 1; k < network.size(); ++k) {
    const Item& item = network.item(k);
    Number& result = items[static_cast<std::size_t>(k)];
    if (item.kind == Kind::kConstant) {
      result = Number(static_cast<double>(network.magnitude(k).seen()));
    } else if (item.kind == Kind::kInput) {
      result = Number(sample_input(item.first, item.size, point));
    } else {
      result = operation<Number>(network, k, of, elementary);
    }
  }
  return items;
}

}  // namespace

std::vector<ErrorBounds> output_errors(const Network& network) {
  const std::array points = {rounded_items(network, 1), rounded_items(network, 2)};
  std::vector<ErrorBounds> bounds;
  for (const Ref output : network.outputs()) {
    const auto k = program::node_index(output);
    bounds.push_back({points[0][k].error, points[1][k].error});
  }
  return bounds;
}

bool RoundingGuard::accepts(const Network& network) const {
  const std::vector<ErrorBounds> bounds = output_errors(network);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    if (!within(bounds[k], reference_[k], kMostOverReference)) {
      return false;
    }
  }
  return true;
}

}  // namespace treedyn::optimise
