#include "block/block.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "block/print.hpp"
#include "block/rewrite.hpp"
#include "common/error.hpp"

namespace treedyn::block {
namespace {

std::string to_string(const Side& side) {
  const std::string size = side.size == 1 ? "" : fmt::format("{}", side.size);
  switch (side.set) {
    case Set::kLinks:
      return size + "N";
    case Set::kPoints:
      return size + "P";
    case Set::kRows:
      return size + "r";
    case Set::kPassive:
      return size + "p";
    case Set::kOne:
      break;
  }
  return size.empty() ? "1" : size;
}

[[noreturn]] void misfit(const char* operation, const Expression& a, const Expression& b,
                         const char* expected) {
  throw std::logic_error(fmt::format("{} of {} ({}) and {} ({}) does not conform; expected {}",
                                     operation, print(a), to_string(a.shape()), print(b),
                                     to_string(b.shape()), expected));
}

/// True for 1x1 blocks, which the size rule may turn into 3x3 blocks.
bool scalar_blocks(const Shape& shape) { return shape.rows.size == 1 && shape.cols.size == 1; }

Shape kronecker(Shape shape) {
  shape.rows.size *= 3;
  shape.cols.size *= 3;
  return shape;
}

Shape sum_shape(const Expression& a, const Expression& b) {
  if (a.shape() == b.shape()) {
    return a.shape();
  }
  if (scalar_blocks(a.shape()) && kronecker(a.shape()) == b.shape()) {
    return b.shape();
  }
  if (scalar_blocks(b.shape()) && kronecker(b.shape()) == a.shape()) {
    return a.shape();
  }
  misfit("sum", a, b, "equal shapes");
}

Shape product_shape(const Expression& a, const Expression& b) {
  Shape x = a.shape();
  Shape y = b.shape();
  if (x.cols.size != y.rows.size) {
    if (scalar_blocks(x)) {
      x = kronecker(x);
    } else if (scalar_blocks(y)) {
      y = kronecker(y);
    }
  }
  if (x.cols != y.rows) {
    misfit("product", a, b, "as many rows of the second as the first has columns");
  }
  return {.rows = x.rows, .cols = y.cols};
}

Shape skew_shape(const Expression& a) {
  Shape shape = a.shape();
  if (shape.rows.size != 3 || shape.cols.size != 1) {
    throw std::logic_error(
        fmt::format("Λ of {} ({}); expected 3-vectors", print(a), to_string(shape)));
  }
  shape.cols.size = 3;
  return shape;
}

Expression make(Kind kind, const Shape& shape, std::vector<Expression> operands) {
  return Expression({kind, shape, {}, {}, {}, std::move(operands)});
}

void append(std::vector<Expression>& list, Kind kind, const Expression& a) {
  if (a.kind() == kind) {
    list.insert(list.end(), a.operands().begin(), a.operands().end());
  } else {
    list.push_back(a);
  }
}

/// Numbers that the size rule blows up and that are a product of vectors stay one factor.
void append_factor(std::vector<Expression>& factors, const Expression& a, bool blown_up) {
  const bool of_vectors = std::ranges::any_of(
      a.operands(), [](const Expression& operand) { return !scalar_blocks(operand.shape()); });
  if (blown_up && scalar_blocks(a.shape()) && of_vectors) {
    factors.push_back(a);
  } else {
    append(factors, Kind::kProduct, a);
  }
}

Ratio lowest(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator);
  const std::int64_t n = numerator / divisor;
  const std::int64_t d = denominator / divisor;
  if (!std::in_range<int>(n) || !std::in_range<int>(d)) {
    throw TooLarge(fmt::format(
        "its numbers make the fraction {}/{}; expected numerators and denominators below 2^31", n,
        d));
  }
  return {static_cast<int>(n), static_cast<int>(d)};
}

}  // namespace

std::string to_string(const Shape& shape) {
  return to_string(shape.rows) + "×" + to_string(shape.cols);
}

Expression::Expression(Node node) : node_(std::make_shared<const Node>(std::move(node))) {}

Expression leaf(const std::string& name, Structure structure, const Shape& shape) {
  return Expression({Kind::kLeaf, shape, name, structure, {}, {}});
}

Ratio multiply(const Ratio& a, const Ratio& b) {
  return lowest(std::int64_t{a.numerator} * b.numerator,
                std::int64_t{a.denominator} * b.denominator);
}

Ratio add(const Ratio& a, const Ratio& b) {
  return lowest(
      std::int64_t{a.numerator} * b.denominator + std::int64_t{b.numerator} * a.denominator,
      std::int64_t{a.denominator} * b.denominator);
}

Expression named(const std::string& name, const Expression& expression) {
  return Expression({Kind::kNamed, expression.shape(), name, {}, {}, {expression}});
}

Expression operator+(const Expression& a, const Expression& b) {
  const Shape shape = sum_shape(a, b);
  std::vector<Expression> terms;
  append(terms, Kind::kSum, a);
  append(terms, Kind::kSum, b);
  return make(Kind::kSum, shape, std::move(terms));
}

Expression operator-(const Expression& a, const Expression& b) { return a + (-b); }

Expression operator*(const Expression& a, const Expression& b) {
  if (a.kind() == Kind::kScaled) {  // (r X) Y = r (X Y)
    return a.node().factor * (a.operands().front() * b);
  }
  const Shape shape = product_shape(a, b);
  std::vector<Expression> factors;
  const bool blown_up = a.shape().cols.size != b.shape().rows.size;
  append_factor(factors, a, blown_up);
  append_factor(factors, b, blown_up);
  return make(Kind::kProduct, shape, std::move(factors));
}

Expression operator*(int factor, const Expression& a) { return Ratio{factor, 1} * a; }

Expression operator*(const Ratio& factor, const Expression& a) {
  return a.kind() == Kind::kScaled ? multiply(factor, a.node().factor) * a.operands().front()
                                   : Expression({Kind::kScaled, a.shape(), {}, {}, factor, {a}});
}

Expression operator-(const Expression& a) { return -1 * a; }

Expression transpose(const Expression& a) {
  return make(Kind::kTranspose, {.rows = a.shape().cols, .cols = a.shape().rows}, {a});
}

Expression skew(const Expression& a) { return make(Kind::kSkew, skew_shape(a), {a}); }

Expression skew_transpose(const Expression& a) {
  return make(Kind::kSkewTranspose, skew_shape(a), {a});
}

Expression diagb(const Expression& x) {
  if (x.shape().cols != Side{}) {
    throw std::logic_error(
        fmt::format("diagb of {} ({}); expected a column", print(x), to_string(x.shape())));
  }
  const Shape shape{.rows = x.shape().rows, .cols = {x.shape().rows.set, 1}};
  return make(Kind::kDiagonal, shape, {x});
}

bool equal(const Expression& a, const Expression& b) {
  const Node& x = unnamed(a).node();
  const Node& y = unnamed(b).node();
  return &x == &y || (x.kind == y.kind && x.shape == y.shape && x.name == y.name &&
                      x.factor == y.factor && std::ranges::equal(x.operands, y.operands, equal));
}

}  // namespace treedyn::block
