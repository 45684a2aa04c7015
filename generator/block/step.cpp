#include "block/step.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/sorted.hpp"

namespace treedyn::block {
namespace {

using Rows = std::vector<std::vector<int>>;

Rows rows_of(const Pattern& pattern) {
  Rows rows(to_index(pattern.rows()));
  pattern.visit([&](int i, int j, int) { rows[to_index(i)].push_back(j); });
  return rows;
}

// "Lines" are the rows for a left factor D and the columns for a right factor: the line that a sum
// adds to, and the line that it adds.
struct Edge {
  int to = 0;
  int from = 0;
};

/// The links with fathers in the order of the sum: from the roots down, or (subtree) from the
/// leaves up.
std::vector<Edge> edges(const PathSum& sum, const Index& index) {
  std::vector<Edge> result;
  for (int i = 0; i < index.links(); ++i) {
    const int f = index.father[to_index(i)];
    if (f >= 0) {
      result.push_back(sum.subtree ? Edge{f, i} : Edge{i, f});
    }
  }
  if (sum.subtree) {
    std::ranges::reverse(result);
  }
  return result;
}

Rows path_sum_lines(const PathSum& sum, const Rows& x, const Index& index) {
  Rows lines = sum.strict ? Rows(x.size()) : x;
  for (const Edge& edge : edges(sum, index)) {
    std::vector<int>& line = lines[to_index(edge.to)];
    line = united(line, lines[to_index(edge.from)]);
    if (sum.strict) {
      line = united(line, x[to_index(edge.from)]);
    }
  }
  return lines;
}

void path_sum_terms(const PathSum& sum, Step& result, const Step& x, const Index& index) {
  const bool columns = sum.on_right;
  // line `from` of the operand (or of the result itself) to line `to` of the result
  const auto add = [&](int to, int from, bool from_result) {
    const Pattern& source = from_result ? result.pattern : x.pattern;
    for (int other = 0; other < (columns ? source.rows() : source.cols()); ++other) {
      const int left = columns ? source.find(other, from) : source.find(from, other);
      if (left >= 0) {
        result.terms.push_back(
            {columns ? result.pattern.find(other, to) : result.pattern.find(to, other), left,
             from_result ? 1 : 0});
      }
    }
  };
  for (int i = 0; i < index.links() && !sum.strict; ++i) {
    add(i, i, false);
  }
  for (const Edge& edge : edges(sum, index)) {
    add(edge.to, edge.from, true);
    if (sum.strict) {
      add(edge.to, edge.from, false);
    }
  }
}

Step made(Operation operation, int height, int width, Pattern pattern) {
  Step result;
  result.operation = operation;
  result.height = height;
  result.width = width;
  result.pattern = std::move(pattern);
  return result;
}

Step same_blocks(const Step& a, Operation operation) {
  Step result = made(operation, a.height, a.width, a.pattern);
  for (int block = 0; block < a.pattern.blocks(); ++block) {
    result.terms.push_back({block, block, 0});
  }
  return result;
}

/// \throws TooLarge beyond 31 bits
int narrowed(std::int64_t x) {
  if (!std::in_range<int>(x)) {
    throw TooLarge(
        fmt::format("multiplies constant matrices to the number {}; expected less than 2^31", x));
  }
  return static_cast<int>(x);
}

std::int64_t folded_term(const Step& step, const Term& term,
                         const std::vector<const Step*>& operands) {
  const auto constant = [&](std::size_t operand, int place) {
    return std::int64_t{operands[operand]->constants[to_index(place)]};
  };
  switch (step.operation) {
    case Operation::kSum: {
      const Ratio& factor = step.factors[to_index(term.right)];
      TREEDYN_EXPECT(factor.denominator == 1);
      return factor.numerator * constant(to_index(term.right), term.left);
    }
    case Operation::kProduct:
      return constant(0, term.left) * constant(1, term.right);
    default:
      return constant(0, term.left);
  }
}

}  // namespace

Step constant_step(Pattern pattern, std::vector<int> values) {
  Step result = made(Operation::kConstant, 1, 1, std::move(pattern));
  result.constants = std::move(values);
  return result;
}

Step sum_step(const std::vector<const Step*>& operands, std::vector<Ratio> factors) {
  Step result;
  result.operation = Operation::kSum;
  result.pattern = operands.front()->pattern;
  for (const Step* operand : operands) {
    result.pattern = unite(result.pattern, operand->pattern);
    result.height = std::max(result.height, operand->height);  // size rule
    result.width = std::max(result.width, operand->width);
  }
  for (std::size_t k = 0; k < operands.size(); ++k) {
    operands[k]->pattern.visit([&](int i, int j, int block) {
      result.terms.push_back({result.pattern.find(i, j), block, static_cast<int>(k)});
    });
  }
  result.factors = std::move(factors);
  return result;
}

Step product_step(const Step& a, const Step& b) {
  TREEDYN_EXPECT(a.pattern.cols() == b.pattern.rows());
  Step result = made(Operation::kProduct, a.block_size() == 1 ? b.height : a.height,
                     b.block_size() == 1 ? a.width : b.width, product(a.pattern, b.pattern));
  a.pattern.visit([&](int i, int k, int left) {
    b.pattern.visit_row(k, [&](int j, int right) {
      result.terms.push_back({result.pattern.find(i, j), left, right});
    });
  });
  return result;
}

Step path_sum_step(const PathSum& sum, const Step& x, const Index& index) {
  const Pattern lines_of_x = sum.on_right ? transpose(x.pattern) : x.pattern;
  const Pattern lines(lines_of_x.cols(), path_sum_lines(sum, rows_of(lines_of_x), index));
  Step result =
      made(Operation::kPathSum, x.height, x.width, sum.on_right ? transpose(lines) : lines);
  path_sum_terms(sum, result, x, index);
  return result;
}

Step transpose_step(const Step& a) {
  Step result = made(Operation::kTranspose, a.width, a.height, transpose(a.pattern));
  a.pattern.visit([&](int i, int j, int block) {
    result.terms.push_back({result.pattern.find(j, i), block, 0});
  });
  return result;
}

Step skew_step(const Step& a, Operation operation) {
  Step result = same_blocks(a, operation);
  result.width = 3;
  return result;
}

Step diagonal_step(const Step& a) {
  Step result = same_blocks(a, Operation::kDiagonal);
  Rows rows = rows_of(a.pattern);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].empty()) {
      rows[i] = {static_cast<int>(i)};
    }
  }
  result.pattern = Pattern(a.pattern.rows(), rows);
  return result;
}

Step folded(const Step& step, const std::vector<const Step*>& operands) {
  std::vector<std::int64_t> values(to_index(step.pattern.blocks()), 0);
  for (const Term& term : step.terms) {
    values[to_index(term.target)] += folded_term(step, term, operands);
  }
  Rows rows(to_index(step.pattern.rows()));
  std::vector<int> kept;
  step.pattern.visit([&](int i, int j, int block) {
    if (values[to_index(block)] != 0) {
      rows[to_index(i)].push_back(j);
      kept.push_back(narrowed(values[to_index(block)]));
    }
  });
  return constant_step(Pattern(step.pattern.cols(), rows), std::move(kept));
}

}  // namespace treedyn::block
