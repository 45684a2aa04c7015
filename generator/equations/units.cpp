#include "equations/units.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "block/rewrite.hpp"

namespace treedyn::equations {
namespace {

using block::Expression;
using block::Kind;
using block::Structure;

constexpr Unit kNumber{};

struct UnitName {
  Unit unit;
  const char* text = "";
};
constexpr UnitName kNames[] = {
    {{1, 1, -2}, "N"}, {{1, 2, -2}, "N m"}, {{1, 2, -3}, "W"}, {{1, 0, -2}, "N/m"}};

struct LeafRow {
  const char* name = "";
  Unit revolute;   ///< of the blocks in rows of revolute joints, or of all
  Unit prismatic;  ///< of those in rows of prismatic joints
};
constexpr LeafRow kLeaves[] = {
    {"m^d", {.kg = 1}, {.kg = 1}},
    {"J_c^d", {.kg = 1, .m = 2}, {.kg = 1, .m = 2}},
    {"s^d", {.m = 1}, {.m = 1}},
    {"l^d", {.m = 1}, {.m = 1}},
    {"c^d", {.m = 1}, {.m = 1}},
    {"t^d", {.m = 1}, {.m = 1}},
    {"q̇", {.s = -1}, {.m = 1, .s = -1}},
    {"q̇^d", {.s = -1}, {.m = 1, .s = -1}},
    {"q̈", {.s = -2}, {.m = 1, .s = -2}},
    {"τ", {.kg = 1, .m = 2, .s = -2}, {.kg = 1, .m = 1, .s = -2}},
    {"f_b", {.kg = 1, .m = 1, .s = -2}, {}},
    {"n_b", {.kg = 1, .m = 2, .s = -2}, {}},
    {"g", {.m = 1, .s = -2}, {.m = 1, .s = -2}},
};

std::string power(const char* name, int exponent) {
  return exponent == 1 ? name : fmt::format("{}^{}", name, exponent);
}

/// Of kilogram, metre and second.
std::string text_of(const Unit& unit) {
  for (const UnitName& row : kNames) {
    if (row.unit.kg == unit.kg && row.unit.m == unit.m && row.unit.s == unit.s) {
      return row.text;
    }
  }
  std::vector<std::string> above;
  std::vector<std::string> below;
  for (const auto& [name, exponent] :
       {std::pair("kg", unit.kg), std::pair("m", unit.m), std::pair("s", unit.s)}) {
    if (exponent != 0) {
      (exponent > 0 ? above : below).push_back(power(name, std::abs(exponent)));
    }
  }
  std::string top = above.empty() ? "1" : fmt::format("{}", fmt::join(above, " "));
  if (below.empty()) {
    return top;
  }
  return below.size() == 1 ? fmt::format("{}/{}", top, below.front())
                           : fmt::format("{}/({})", top, fmt::join(below, " "));
}

std::optional<Unit> sum(const std::optional<Unit>& a, const std::optional<Unit>& b) {
  if (!a || !b) {
    return a ? a : b;
  }
  if (*a == *b || b->any) {
    return a;
  }
  if (a->any) {
    return b;
  }
  const auto is_known = [](const Unit& unit) {
    return unit.inputs == kNumber.inputs;
  };
  if (a->inputs != b->inputs) {  // some units of the inputs fit
    return is_known(*a) ? a : is_known(*b) ? b : Unit{.any = true};
  }
  throw UnitError(fmt::format("adds {} to {}{}; expected terms of one unit", text_of(*b),
                              text_of(*a), is_known(*a) ? "" : ", times the same inputs"));
}

Units sum(const Units& a, const Units& b) {
  Units result;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      result[i][j] = sum(a[i][j], b[i][j]);
    }
  }
  return result;
}

std::optional<Unit> product(const std::optional<Unit>& a, const std::optional<Unit>& b) {
  return a && b ? std::optional(*a * *b) : std::nullopt;
}

/// Rows of one kind, columns of the other, and what both kinds of the middle add up to.
Units product(const Units& a, const Units& b) {
  Units result;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t k = 0; k < 2; ++k) {
        result[i][j] = sum(result[i][j], product(a[i][k], b[k][j]));
      }
    }
  }
  return result;
}

/// Of a zero, like dot(m_d): it fits every sum.
Units any(Units a) {
  for (auto& row : a) {
    for (std::optional<Unit>& unit : row) {
      unit = unit ? std::optional(Unit{.any = true}) : unit;
    }
  }
  return a;
}

Units transposed(Units a) {
  std::swap(a[0][1], a[1][0]);
  return a;
}

/// A column on the diagonal: nothing but zeros between the kinds.
Units diagonal(const Units& a) {
  Units result;
  result[0][0] = a[0][0];
  result[1][1] = a[1][0];
  return result;
}

}  // namespace

Unit operator*(const Unit& a, const Unit& b) {
  if (a.any || b.any) {
    return {.any = true};
  }
  Unit result{.kg = a.kg + b.kg, .m = a.m + b.m, .s = a.s + b.s};
  for (std::size_t k = 0; k < result.inputs.size(); ++k) {
    result.inputs[k] = static_cast<std::int8_t>(a.inputs[k] + b.inputs[k]);
  }
  return result;
}

Unit unit_of_input(std::size_t k, std::size_t kind) {
  Unit result;
  const std::size_t place = 2 * k + kind;
  result.any = place >= result.inputs.size();
  if (!result.any) {
    result.inputs[place] = 1;
  }
  return result;
}

std::string to_string(const Unit& unit) {
  return unit.any || unit.inputs != kNumber.inputs ? "" : text_of(unit);
}

std::string to_string(const Units& units) {
  std::vector<std::string> texts;
  for (const auto& row : units) {
    for (const auto& unit : row) {
      const std::string text = unit ? to_string(*unit) : "";
      if (!text.empty() && std::ranges::find(texts, text) == texts.end()) {
        texts.push_back(text);
      }
    }
  }
  return fmt::format("{}", fmt::join(texts, "|"));
}

/// The same unit everywhere.
Units UnitReader::uniform(const Expression& e, const Unit& unit) const {
  Units result;
  const bool by_rows = e.shape().rows.set == block::Set::kLinks;
  const bool by_cols = e.shape().cols.set == block::Set::kLinks;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const bool row = by_rows ? kinds_.has(static_cast<int>(i)) : i == 0;
      const bool col = by_cols ? kinds_.has(static_cast<int>(j)) : j == 0;
      if (row && col) {
        result[i][j] = unit;
      }
    }
  }
  return result;
}

Units UnitReader::of_leaf(const Expression& e) const {
  const block::Node& node = e.node();
  if (const auto found = leaves_.find(node.name); found != leaves_.end()) {
    return found->second;
  }
  Units result = uniform(e, kNumber);
  for (const LeafRow& row : kLeaves) {
    if (node.name == row.name) {
      for (std::size_t j = 0; j < 2; ++j) {
        result[0][j] = result[0][j] ? std::optional(row.revolute) : std::nullopt;
        result[1][j] = result[1][j] ? std::optional(row.prismatic) : std::nullopt;
      }
    }
  }
  const bool square = e.shape().rows.set == e.shape().cols.set;
  const bool diagonal = node.structure == Structure::kDiagonal ||
                        node.structure == Structure::kIdentity ||
                        node.structure == Structure::kRevolute;
  if (square && diagonal) {
    result[0][1] = result[1][0] = std::nullopt;
  }
  if (node.structure == Structure::kRevolute) {
    result[1][1] = std::nullopt;
  }
  return result;
}

/// E - σ has rows of prismatic joints only.
Units UnitReader::of_sum(const Expression& e) {
  const std::vector<Expression>& terms = e.operands();
  const bool slides =
      terms.size() == 2 && is_leaf(terms[0], "E") && terms[1].kind() == Kind::kScaled &&
      terms[1].node().factor == block::Ratio{-1, 1} && is_leaf(terms[1].operands().front(), "σ");
  if (slides) {
    Units result = of(terms[0]);
    result[0][0] = std::nullopt;
    return result;
  }
  Units result = of(terms.front());
  for (std::size_t k = 1; k < terms.size(); ++k) {
    result = sum(result, of(terms[k]));
  }
  return result;
}

Units UnitReader::of(const Expression& e) {
  if (const auto found = known_.find(&e.node()); found != known_.end()) {
    return found->second.second;
  }
  Units result;
  switch (e.kind()) {
    case Kind::kLeaf:
      result = of_leaf(e);
      break;
    case Kind::kSum:
      result = of_sum(e);
      break;
    case Kind::kProduct:
      result = of(e.operands().front());
      for (std::size_t k = 1; k < e.operands().size(); ++k) {
        result = product(result, of(e.operands()[k]));
      }
      break;
    case Kind::kTranspose:
      result = transposed(of(e.operands().front()));
      break;
    case Kind::kScaled:
      result = of(e.operands().front());
      if (e.node().factor.numerator == 0) {
        result = any(result);
      }
      break;
    case Kind::kDiagonal:
      result = diagonal(of(e.operands().front()));
      break;
    default:
      result = of(e.operands().front());
  }
  known_.emplace(&e.node(), std::pair(e, result));
  return result;
}

}  // namespace treedyn::equations
