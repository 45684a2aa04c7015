#include "expansion/equations_text.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "block/pattern.hpp"
#include "block/plan.hpp"
#include "block/print.hpp"
#include "common/index.hpp"
#include "equations/kinematics.hpp"
#include "equations/symbols.hpp"
#include "equations/table.hpp"
#include "expansion/expansion.hpp"
#include "expansion/polynomial.hpp"

namespace treedyn::expansion {
namespace {

using block::Expression;

// Definitions of named parts and of the whole, those that were not shown before.
class Definitions {
 public:
  std::string of(const Expression& e) {
    std::string result;
    for (const Expression& operand : e.operands()) {
      result += named(operand);
    }
    shown_.insert(definition(e));
    return result + definition(e);
  }

 private:
  static std::string definition(const Expression& e) {
    return fmt::format("  {}\n", block::print_definition(e));
  }

  std::string named(const Expression& e) {
    std::string result;
    for (const Expression& operand : e.operands()) {
      result += named(operand);
    }
    return e.kind() == block::Kind::kNamed ? result + line(e) : result;
  }

  std::string line(const Expression& e) {
    const std::string text = definition(e);
    return shown_.insert(text).second ? text : std::string();
  }

  std::set<std::string> shown_;
};

std::string links_text(const model::Tree& tree) {
  std::string result;
  for (const model::Link& link : tree.links) {
    const bool ground = link.father == model::kGround;
    const bool revolute = link.joint.turns();
    result += fmt::format("  {}  {}  {}  father {}\n", &link - tree.links.data(),
                          link.joint.identifier, revolute ? "revolute" : "prismatic",
                          ground ? "ground" : tree.links[to_index(link.father)].joint.identifier);
  }
  return result;
}

std::string pattern_text(const block::Pattern& pattern, int most_blocks) {
  std::string head = fmt::format("  blocks that D leaves: {} of {}\n", pattern.blocks(),
                                 static_cast<long long>(pattern.rows()) * pattern.cols());
  if (pattern.cols() == 1 || pattern.cols() > most_blocks || pattern.rows() > most_blocks) {
    return head;
  }
  std::string result = head + "    ";
  for (const char c : block::to_text(pattern)) {
    result += c;
    if (c == '\n') {
      result += "    ";
    }
  }
  result.erase(result.size() - 4);
  return result;
}

/// Leaves out terms below 1e-44 of the largest: what is left where numbers of 50 digits cancel.
void drop_rounding(std::vector<Polynomial>& entries) {
  GiNaC::numeric largest = 0;
  for (const Polynomial& entry : entries) {
    for (const auto& [monomial, coefficient] : entry) {
      largest = std::max(largest, GiNaC::abs(coefficient));
    }
  }
  const GiNaC::numeric least = largest * GiNaC::numeric("1e-44");
  for (Polynomial& entry : entries) {
    std::erase_if(entry, [&](const auto& term) { return GiNaC::abs(term.second) < least; });
  }
}

class Dump {
 public:
  Dump(const model::Tree& tree, std::span<const model::Point> points, const model::Vector3& gravity,
       const DumpOptions& options)
      : options_(options), index_(equations::index_of(tree, points)) {
    if (tree.size() <= options.most_links) {
      expansion_.emplace(tree, points, gravity);
    }
  }

  [[nodiscard]] std::string matrix(const Expression& e) const {
    return fmt::format("{}, {}\n", block::print_definition(e), block::to_string(e.shape())) +
           pattern_text(block::pattern(e, index_), options_.most_blocks);
  }

  std::string equation(const equations::Equation& equation) {
    const Expression& e = *equation.expression;
    std::string result = fmt::format("\n{}  {}  [{}]\n", equation.name, equation.number,
                                     block::to_string(e.shape()));
    result += definitions_.of(e);
    result += pattern_text(block::pattern(e, index_), options_.most_blocks);
    return result + entries(e);
  }

 private:
  [[nodiscard]] std::string entries(const Expression& e) const {
    if (!expansion_) {
      return {};
    }
    const Entries expanded = expansion_->expand(e);
    std::vector<Polynomial> entries;
    for (int n = 0; n < expanded.rows * expanded.cols; ++n) {
      entries.push_back(
          polynomial(expansion_->ring(), expanded.at(n / expanded.cols, n % expanded.cols)));
    }
    drop_rounding(entries);
    std::string result;
    for (int n = 0; n < expanded.rows * expanded.cols; ++n) {
      if (const Polynomial& entry = entries[to_index(n)]; !entry.empty()) {
        result += fmt::format("  [{},{}] = {}\n", n / expanded.cols, n % expanded.cols,
                              to_text(expansion_->ring(), entry, options_.most_terms));
      }
    }
    return result;
  }

  DumpOptions options_;
  Definitions definitions_;
  block::Index index_;
  std::optional<Expansion> expansion_;
};

}  // namespace

std::string dump(const model::Tree& tree, std::span<const model::Point> points,
                 const model::Vector3& gravity, const DumpOptions& options) {
  Dump dump(tree, points, gravity, options);
  std::string result = fmt::format("{}: N = {} joints, P = {} points\n{}\n", tree.identifier,
                                   tree.size(), points.size(), links_text(tree));
  result += dump.matrix(equations::D);
  for (const equations::Equation& equation : equations::table()) {
    const bool asked =
        std::ranges::find(options.functions, equation.name) != options.functions.end();
    if (options.functions.empty() || asked) {
      result += dump.equation(equation);
    }
  }
  return result;
}

}  // namespace treedyn::expansion
