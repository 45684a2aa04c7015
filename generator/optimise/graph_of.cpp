// From sums and products of any number of operands back to binary operations.
#include <algorithm>

#include "optimise/network.hpp"

namespace treedyn::optimise {

namespace {

/// Writes a network to a graph, item by item.
class GraphWriter {
 public:
  explicit GraphWriter(const Network& network)
      : network_(network), uses_(uses(network)), image_(static_cast<std::size_t>(network.size())) {}

  Graph write(std::vector<Ref>& outputs);

 private:
  /// A product that one sum uses is written where the sum adds it: a * b + c in one place.
  void find_products_of_sums();
  void write_item(int k);
  Ref write_sum(std::span<const Ref> terms);
  Ref write_product(std::span<const Ref> factors);
  [[nodiscard]] Ref image(Ref a) const { return copy_of(image_, a); }

  const Network& network_;
  std::vector<int> uses_;
  std::vector<bool> later_;
  std::vector<Ref> image_;
  Graph graph_;
};

void GraphWriter::find_products_of_sums() {
  later_.assign(image_.size(), false);
  for (int k = 1; k < network_.size(); ++k) {
    if (network_.item(k).kind == Kind::kAdd && uses_[program::node_index(k)] > 0) {
      for (const Ref term : network_.operands(k)) {
        later_[program::node_index(term)] =
            network_.item(term).kind == Kind::kMultiply && uses_[program::node_index(term)] == 1;
      }
    }
  }
}

Ref GraphWriter::write_product(std::span<const Ref> factors) {
  const auto constant =
      std::ranges::find_if(factors, [&](Ref factor) { return network_.is_constant(factor); });
  Ref product = 0;
  for (const Ref factor : factors) {
    if (constant == factors.end() || factor != *constant) {
      product = product == 0 ? image(factor) : graph_.multiply(product, image(factor));
    }
  }
  return constant == factors.end() ? product : graph_.multiply(image(*constant), product);
}

Ref GraphWriter::write_sum(std::span<const Ref> terms) {
  std::vector<Ref> order(terms.begin(), terms.end());
  std::stable_partition(order.begin(), order.end(),
                        [&](Ref term) { return !later_[program::node_index(term)]; });
  Ref sum = 0;
  for (const Ref term : order) {
    if (later_[program::node_index(term)]) {
      image_[program::node_index(term)] = write_product(network_.operands(term));
    }
    sum = graph_.add(sum, image(term));
  }
  return sum;
}

void GraphWriter::write_item(int k) {
  const Item& item = network_.item(k);
  const auto operands = network_.operands(k);
  Ref& result = image_[program::node_index(k)];
  switch (item.kind) {
    case Kind::kConstant:
      result = graph_.constant(network_.magnitude(k));
      break;
    case Kind::kInput:
      result = graph_.input(item.first, item.size);
      break;
    case Kind::kAdd:
      result = write_sum(operands);
      break;
    case Kind::kMultiply:
      result = write_product(operands);
      break;
    case Kind::kDivide:
      result = graph_.divide(image(operands[0]), image(operands[1]));
      break;
    case Kind::kSin:
      result = graph_.sin(image(operands[0]));
      break;
    case Kind::kCos:
      result = graph_.cos(image(operands[0]));
      break;
    case Kind::kSqrt:
      result = graph_.sqrt(image(operands[0]));
      break;
  }
}

Graph GraphWriter::write(std::vector<Ref>& outputs) {
  find_products_of_sums();
  for (int k = 1; k < network_.size(); ++k) {
    if (uses_[program::node_index(k)] > 0 && !later_[program::node_index(k)]) {
      write_item(k);
    }
  }
  outputs.clear();
  for (const Ref output : network_.outputs()) {
    outputs.push_back(image(output));
  }
  return std::move(graph_);
}

}  // namespace

Graph graph_of(const Network& network, std::vector<Ref>& outputs) {
  return GraphWriter(network).write(outputs);
}

}  // namespace treedyn::optimise
