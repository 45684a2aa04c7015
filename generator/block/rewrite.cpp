#include "block/rewrite.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace treedyn::block {
namespace {

Expression push_into_sum(const std::vector<Expression>& terms) {
  return std::accumulate(
      terms.begin() + 1, terms.end(), push_transpose(terms.front()),
      [](const Expression& sum, const Expression& term) { return sum + push_transpose(term); });
}

Expression push_into_product(const std::vector<Expression>& factors) {
  return std::accumulate(factors.rbegin() + 1, factors.rend(), push_transpose(factors.back()),
                         [](const Expression& product, const Expression& factor) {
                           return product * push_transpose(factor);
                         });
}

}  // namespace

bool is_leaf(const Expression& e, std::string_view name) {
  return e.kind() == Kind::kLeaf && e.node().name == name;
}

bool is_diagonal_leaf(const Expression& e) {
  const Structure structure = e.node().structure;
  return e.kind() == Kind::kLeaf &&
         (structure == Structure::kIdentity || structure == Structure::kRevolute ||
          structure == Structure::kDiagonal);
}

bool holds(const Expression& e, std::string_view name) {
  return is_leaf(e, name) ||
         std::ranges::any_of(e.operands(), [&](const Expression& x) { return holds(x, name); });
}

const Expression& unnamed(const Expression& e) {
  return e.kind() == Kind::kNamed ? unnamed(e.operands().front()) : e;
}

Expression product_of(std::vector<Expression>::const_iterator begin,
                      std::vector<Expression>::const_iterator end) {
  return std::accumulate(begin + 1, end, *begin,
                         [](const Expression& a, const Expression& b) { return a * b; });
}

Expression push_transpose(const Expression& e) {
  const std::vector<Expression>& x = e.operands();
  switch (e.kind()) {
    case Kind::kNamed:
      return push_transpose(x.front());
    case Kind::kTranspose:
      return x.front();
    case Kind::kScaled:
      return e.node().factor * push_transpose(x.front());
    case Kind::kSum:
      return push_into_sum(x);
    case Kind::kProduct:
      return push_into_product(x);
    default:
      return transpose(e);
  }
}

namespace {

class Replacing {
 public:
  explicit Replacing(const std::map<std::string, Expression>& others) : others_(others) {}

  Expression operator()(const Expression& e) {
    if (e.operands().empty()) {
      return e;
    }
    if (const auto found = known_.find(&e.node()); found != known_.end()) {
      return found->second;
    }
    const auto other = e.kind() == Kind::kNamed ? others_.find(e.node().name) : others_.end();
    Expression result = other == others_.end() ? of_operands(e) : other->second;
    known_.emplace(&e.node(), result);
    return result;
  }

 private:
  Expression of_operands(const Expression& e) {
    Node node = e.node();
    for (Expression& operand : node.operands) {
      operand = (*this)(operand);
    }
    return Expression(std::move(node));
  }

  const std::map<std::string, Expression>& others_;
  std::map<const Node*, Expression> known_;
};

}  // namespace

Expression replaced(const Expression& e, const std::map<std::string, Expression>& others) {
  return Replacing(others)(e);
}

bool constant_expression(const Expression& e) {
  if (e.kind() == Kind::kLeaf) {
    return is_constant(e.node().structure);
  }
  return std::ranges::all_of(e.operands(), constant_expression);
}

bool has_numbers(const Expression& e) {
  return e.shape().rows.size == 1 && e.shape().cols.size == 1;
}

bool is_of_numbers(const Expression& e) {
  return has_numbers(e) &&
         (e.kind() == Kind::kDiagonal || std::ranges::all_of(e.operands(), is_of_numbers));
}

bool blows_up(std::span<const Expression> factors, int size) {
  for (auto f = factors.rbegin(); f != factors.rend(); ++f) {
    const auto& [rows, cols] = f->shape();
    if (size == 3 && rows.size == 3 && cols.size == 1) {
      return true;
    }
    size = rows.size == cols.size ? size : rows.size;
  }
  return false;
}

Expression with_operand(const Expression& e, const Expression& x) {
  switch (e.kind()) {
    case Kind::kScaled:
      return e.node().factor * x;
    case Kind::kTranspose:
      return transpose(x);
    case Kind::kSkew:
      return skew(x);
    case Kind::kSkewTranspose:
      return skew_transpose(x);
    case Kind::kDiagonal:
      return diagb(x);
    default:
      return x;
  }
}

std::optional<Expression> without(const Expression& e, const std::set<std::string>& zeros) {
  if (e.kind() == Kind::kLeaf) {
    return zeros.contains(e.node().name) ? std::nullopt : std::optional(e);
  }
  const bool adds = e.kind() == Kind::kSum;
  std::optional<Expression> result;
  for (const Expression& operand : e.operands()) {
    const std::optional<Expression> rest = without(operand, zeros);
    if (!rest && !adds) {
      return std::nullopt;
    }
    if (rest) {
      result = !result ? *rest : adds ? *result + *rest : *result * *rest;
    }
  }
  if (!result) {
    return std::nullopt;
  }
  if (e.kind() == Kind::kNamed && equal(*result, e.operands().front())) {
    return e;
  }
  return with_operand(e, *result);
}

void flatten(const Expression& e, std::vector<Expression>& factors, Ratio& factor) {
  switch (e.kind()) {
    case Kind::kNamed:
      return flatten(e.operands().front(), factors, factor);
    case Kind::kScaled:
      factor = multiply(factor, e.node().factor);
      return flatten(e.operands().front(), factors, factor);
    case Kind::kProduct:
      for (const Expression& operand : e.operands()) {
        flatten(operand, factors, factor);
      }
      return;
    default:
      factors.push_back(e);
  }
}

}  // namespace treedyn::block
