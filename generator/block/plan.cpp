#include "block/plan.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "block/association.hpp"
#include "block/rewrite.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"

namespace treedyn::block {
namespace {

/// Matrices in one product: their order is found in cubic time and quadratic memory.
constexpr std::size_t kMostFactors = 200;

int count(const Index& index, Set set) {
  switch (set) {
    case Set::kLinks:
      return index.links();
    case Set::kPoints:
      return index.points();
    case Set::kRows:
      return index.rows();
    case Set::kOne:
    case Set::kPassive:  // of numbers alone
      break;
  }
  return 1;
}

Pattern leaf_pattern(const Expression& e, const Index& index) {
  const int rows = count(index, e.shape().rows.set);
  const int cols = count(index, e.shape().cols.set);
  std::vector<std::vector<int>> columns;  // rows of the transpose
  switch (e.node().structure) {
    case Structure::kIdentity:
    case Structure::kDiagonal:
      return diagonal(rows);
    case Structure::kReachability:
    case Structure::kAlongPaths:
      return reachability(index);
    case Structure::kFather:
      for (const int father : index.father) {
        columns.push_back(father < 0 ? std::vector<int>{} : std::vector<int>{father});
      }
      return {rows, columns};
    case Structure::kOnes:
    case Structure::kFull:
      return full(rows, cols);
    case Structure::kRowPoints:
      return transpose(Pattern(rows, index.row_points));
    case Structure::kCarrier:
      for (const int carrier : index.carrier) {
        columns.push_back(carrier < 0 ? std::vector<int>{} : std::vector<int>{carrier});
      }
      return transpose(Pattern(rows, columns));
    case Structure::kRevolute:
      for (int i = 0; i < rows; ++i) {
        columns.push_back(index.revolute[to_index(i)] ? std::vector<int>{i} : std::vector<int>{});
      }
      return {rows, columns};
  }
  return {};
}

}  // namespace

Plan::Plan(Index index) : index_(std::move(index)) {
  const Pattern d = reachability(index_);
  const int n = index_.links();
  identity_ = constant(constant_step(diagonal(n), std::vector<int>(to_index(n), 1)));
  const int d_step = constant(constant_step(d, std::vector<int>(to_index(d.blocks()), 1)));
  const int dt_step = constant(transpose_step(step(d_step)));
  const int strict = add_sum({{d_step, {}}, {identity_, {-1, 1}}});
  const int strict_t = add_sum({{dt_step, {}}, {identity_, {-1, 1}}});
  path_sums_ = {{d_step, {false, false, false}}, {dt_step, {true, false, false}}};
  path_sums_[strict] = {false, true, false};
  path_sums_[strict_t] = {true, true, false};
  path_sums_.erase(identity_);  // D = E if every link is a root
}

int Plan::leaf(const std::string& name) const {
  const auto found = leaves_.find(name);
  return found == leaves_.end() ? -1 : found->second;
}

std::vector<int> Plan::needed(const std::vector<int>& results) const {
  std::vector<bool> wanted(steps_.size(), false);
  for (const int result : results) {
    wanted[to_index(result)] = true;
  }
  std::vector<int> list;
  for (int i = static_cast<int>(steps_.size()) - 1; i >= 0; --i) {
    const Step& s = step(i);
    if (!wanted[to_index(i)] || s.operands.empty()) {
      continue;
    }
    list.push_back(i);
    for (const int operand : s.operands) {
      wanted[to_index(operand)] = true;
    }
  }
  std::ranges::reverse(list);
  return list;
}

std::vector<const Step*> Plan::operands(const std::vector<int>& ids) const {
  return transformed(ids, [&](int id) { return &step(id); });
}

bool Plan::is_constant(const std::vector<int>& ids) const {
  return std::ranges::all_of(ids,
                             [this](int id) { return step(id).operation == Operation::kConstant; });
}

int Plan::append(Step step) {
  step.offset = storage_;
  storage_ += step.numbers();
  steps_.push_back(std::move(step));
  return static_cast<int>(steps_.size()) - 1;
}

int Plan::constant(Step step) {
  if (step.operation != Operation::kConstant) {  // a transposed constant, see the constructor
    step = constant_step(step.pattern, std::vector<int>(to_index(step.pattern.blocks()), 1));
  }
  const auto key = std::make_pair(step.pattern, step.constants);
  const auto found = constants_.find(key);
  if (found != constants_.end()) {
    return found->second;
  }
  const int id = append(std::move(step));
  constants_.emplace(key, id);
  return id;
}

/// The step of that key: constants are folded, the rest is remembered.
template <class Make>
int Plan::once(const Key& key, const std::vector<int>& ids, Make make) {
  if (const auto found = known_.find(key); found != known_.end()) {
    return found->second;
  }
  Step step = make();
  step.operands = ids;
  const bool integers = std::ranges::all_of(
      step.factors, [](const Ratio& factor) { return factor.denominator == 1; });
  if (is_constant(ids) && step.block_size() == 1 && integers) {
    return constant(folded(step, operands(ids)));
  }
  return known_[key] = append(std::move(step));
}

int Plan::add(const Expression& e) {
  switch (e.kind()) {
    case Kind::kLeaf:
      return add_leaf(e);
    case Kind::kNamed:
      return add(e.operands().front());
    case Kind::kSum:
      return add_terms(e);
    case Kind::kScaled:
      return add_sum({{add(e.operands().front()), e.node().factor}});
    case Kind::kProduct:
      return add_product(e);
    default:
      return add_unary(e);
  }
}

int Plan::add_terms(const Expression& sum) {
  std::vector<Scaled> terms;
  for (const Expression& term : sum.operands()) {
    const bool scaled = term.kind() == Kind::kScaled;
    terms.push_back(
        {add(scaled ? term.operands().front() : term), scaled ? term.node().factor : Ratio{}});
  }
  return add_sum(terms);
}

int Plan::add_leaf(const Expression& e) {
  const Node& node = e.node();
  const Pattern blocks = leaf_pattern(e, index_);
  if (treedyn::block::is_constant(node.structure)) {
    return constant(constant_step(blocks, std::vector<int>(to_index(blocks.blocks()), 1)));
  }
  const auto found = leaves_.find(node.name);
  if (found != leaves_.end()) {
    return found->second;
  }
  Step step;
  step.operation = Operation::kLeaf;
  step.name = node.name;
  step.pattern = blocks;
  step.height = node.shape.rows.size;
  step.width = node.shape.cols.size;
  return leaves_[node.name] = append(std::move(step));
}

int Plan::add_sum(const std::vector<Scaled>& terms) {
  std::vector<Scaled> kept;
  for (const Scaled& term : terms) {
    if (step(term.step).pattern.blocks() > 0) {
      kept.push_back(term);
    }
  }
  if (kept.empty()) {
    return terms.front().step;
  }
  if (kept.size() == 1 && kept.front().factor == Ratio{}) {
    return kept.front().step;
  }
  Key key{static_cast<int>(Operation::kSum)};
  std::vector<int> ids;
  std::vector<Ratio> factors;
  for (const Scaled& term : kept) {
    key.insert(key.end(), {term.step, term.factor.numerator, term.factor.denominator});
    ids.push_back(term.step);
    factors.push_back(term.factor);
  }
  return once(key, ids, [&] { return sum_step(operands(ids), std::move(factors)); });
}

int Plan::add_unary(const Expression& e) {
  const int operand = add(e.operands().front());
  return once({-1 - static_cast<int>(e.kind()), operand}, {operand}, [&] {
    const Step& x = step(operand);
    return e.kind() == Kind::kTranspose       ? transpose_step(x)
           : e.kind() == Kind::kSkew          ? skew_step(x, Operation::kSkew)
           : e.kind() == Kind::kSkewTranspose ? skew_step(x, Operation::kSkewTranspose)
                                              : diagonal_step(x);
  });
}

int Plan::add_product(const Expression& e) {
  std::vector<Expression> factors;
  Ratio factor;
  flatten(e, factors, factor);
  int result = -1;
  const std::span<const Expression> before(factors.begin(), factors.end() - 1);
  if (e.shape().cols == Side{} && !blows_up(before, factors.back().shape().rows.size)) {
    result = add(factors.back());
    for (std::size_t k = factors.size() - 1; k-- > 0;) {
      result = apply(factors[k], result);
    }
  } else {
    const std::vector<int> ids = transformed(factors, [&](const Expression& f) { return add(f); });
    result = chain(ids);
  }
  return add_sum({{result, factor}});
}

/// e times a column: (X + Y) v = X v + Y v, (X Y) v = X (Y v), so that only columns are computed;
/// but what the size rule blows up is numbers first.
int Plan::apply(const Expression& e, int column) {
  const std::vector<Expression>& x = e.operands();
  const int size = step(column).height;
  const bool of_vectors = size == 3 && has_numbers(e) && !is_of_numbers(e);
  if (of_vectors || (e.kind() == Kind::kProduct && blows_up(x, size))) {
    return multiply(add(e), column);
  }
  switch (e.kind()) {
    case Kind::kNamed:
      return apply(x.front(), column);
    case Kind::kScaled:
      return add_sum({{apply(x.front(), column), e.node().factor}});
    case Kind::kProduct:
      for (std::size_t k = x.size(); k-- > 0;) {
        column = apply(x[k], column);
      }
      return column;
    case Kind::kSum:
      return constant_expression(e) ? multiply(add(e), column) : apply_terms(e, column);
    case Kind::kTranspose: {
      const Expression pushed = push_transpose(x.front());
      return pushed.kind() == Kind::kTranspose ? multiply(add(pushed), column)
                                               : apply(pushed, column);
    }
    default:
      return multiply(add(e), column);
  }
}

int Plan::apply_terms(const Expression& sum, int column) {
  const std::vector<Scaled> terms = transformed(sum.operands(), [&](const Expression& term) {
    return Scaled{apply(term, column), {}};
  });
  return add_sum(terms);
}

const PathSum* Plan::as_path_sum(int step) const {
  const auto found = path_sums_.find(step);
  return found == path_sums_.end() ? nullptr : &found->second;
}

int Plan::multiply(int a, int b) {
  if (a == identity_ || b == identity_) {
    return a == identity_ ? b : a;
  }
  if (const PathSum* sum = as_path_sum(a); sum != nullptr && !is_constant({b})) {
    return path_sum(*sum, a, b);
  }
  if (const PathSum* sum = as_path_sum(b); sum != nullptr && !is_constant({a})) {
    return path_sum({!sum->subtree, sum->strict, true}, b, a);  // x D sums over descendants
  }
  return once({static_cast<int>(Operation::kProduct), a, b}, {a, b},
              [&] { return product_step(step(a), step(b)); });
}

int Plan::path_sum(const PathSum& sum, int matrix, int x) {
  return once({static_cast<int>(Operation::kPathSum), matrix, x, sum.on_right ? 1 : 0}, {x},
              [&] { return path_sum_step(sum, step(x), index_); });
}

int Plan::chain(const std::vector<int>& factors) {
  if (factors.size() > kMostFactors) {
    throw TooLarge(fmt::format("multiplies {} matrices in one product; expected at most {}",
                               factors.size(), kMostFactors));
  }
  std::vector<Factor> matrices;
  matrices.reserve(factors.size());
  for (const int f : factors) {
    const Step& s = step(f);
    matrices.push_back({s.pattern, s.height, s.width, as_path_sum(f) != nullptr});
  }
  const std::vector<Split> order = associate(matrices);
  std::vector<int> values = factors;
  for (const Split& split : order) {  // innermost products first
    values[to_index(split.left)] =
        multiply(values[to_index(split.left)], values[to_index(split.right)]);
  }
  return values.front();
}

Pattern pattern(const Expression& expression, const Index& index) {
  Plan plan(index);
  return plan.step(plan.add(expression)).pattern;
}

}  // namespace treedyn::block
