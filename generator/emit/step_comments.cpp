#include "emit/step_comments.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace treedyn::emit {

using program::node_index;
using program::Ref;

namespace {

/// Fewer statements for one body get no comment.
constexpr std::size_t kShortestRun = 3;
constexpr std::size_t kMostGoals = 3;
constexpr int kNoBody = -1;

/// What symbols of hints are called (EQUATIONS.md 1.1, 7).
constexpr std::array<std::array<const char*, 2>, 12> kWords = {
    {{"omega", "angular velocity omega"},
     {"alpha", "angular acceleration alpha"},
     {"a", "acceleration a"},
     {"F", "force F"},
     {"M", "moment M"},
     {"h", "first moment h"},
     {"I", "inertia I"},
     {"E", "second moments E"},
     {"s", "way s to the joint"},
     {"u", "joint force u"},
     {"inverse_pivot", "1/pivot"},
     {"inverse_cosine", "1/cosine"}}};

std::string word_of(const std::string& symbol) {
  const auto* const found = std::ranges::find_if(
      kWords, [&](const auto& row) { return std::string_view(row[0]) == symbol; });
  return found == kWords.end() ? symbol : (*found)[1];
}

/// Links of statements and what they lead to.
class Steps {
 public:
  Steps(const program::Function& function, const Statements& statements, const Vocabulary& words)
      : function_(function),
        graph_(function.graph),
        statements_(statements),
        words_(words),
        goals_(function.graph.size()) {
    find_goals();
  }

  [[nodiscard]] std::map<std::size_t, std::string> comments() const;

 private:
  [[nodiscard]] int body_of(const Statement& statement) const;
  [[nodiscard]] bool begins_run(std::size_t at) const;
  void find_goals();
  [[nodiscard]] std::string text(std::size_t begin, std::size_t end) const;

  const program::Function& function_;
  const program::Graph& graph_;
  const Statements& statements_;
  const Vocabulary& words_;
  std::vector<std::string> goals_;  ///< by node: a symbol, an output array; empty: not known
};

/// The body that a statement computes something for; none if it stores a result that exists.
int Steps::body_of(const Statement& statement) const {
  const bool computes = statement.copy_of < 0 && statement.angles.empty() &&
                        statements_.is_operation(statement.value) &&
                        (statement.output < 0 || !statements_.is_local(statement.value));
  return computes ? graph_.hint(statement.value).body : kNoBody;
}

/// A value without a name and without a place among the results is part of the first user of its
/// own body that leads to something.
void Steps::find_goals() {
  const auto at = [this](Ref a) -> std::string& {
    return goals_[node_index(a)];
  };
  std::vector<bool> is_fixed(goals_.size());
  for (std::size_t k = function_.outputs.size(); k-- > 0;) {
    if (function_.outputs[k] != 0) {
      is_fixed[node_index(function_.outputs[k])] = true;
      at(function_.outputs[k]) =
          function_.signature.outputs[statements_.output_array(static_cast<int>(k))].name;
    }
  }
  const std::vector<Ref> nodes = program::reachable(graph_, function_.outputs);
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    for (const Ref k : {-*node, *node}) {
      const char* const symbol = graph_.hint(k).symbol;
      if (symbol != nullptr) {
        is_fixed[static_cast<std::size_t>(*node)] = true;
        at(k) = symbol;
      }
    }
    program::for_each_operand(graph_.node(*node), [&](Ref operand) {
      const auto value = node_index(operand);
      const bool in_body = graph_.hint(std::abs(operand)).body == graph_.hint(*node).body;
      if (!is_fixed[value] && in_body && !at(*node).empty()) {
        goals_[value] = at(*node);
      }
    });
  }
}

bool Steps::begins_run(std::size_t at) const {
  const int body = body_of(statements_.all()[at]);
  std::size_t run = 0;
  for (; at < statements_.all().size() && run < kShortestRun; ++at) {
    const int next = body_of(statements_.all()[at]);
    if (next != kNoBody && next != body) {
      return false;
    }
    run += next == body ? 1 : 0;
  }
  return true;
}

std::string Steps::text(std::size_t begin, std::size_t end) const {
  const int body = body_of(statements_.all()[begin]);
  std::vector<std::string> goals;
  for (std::size_t at = begin; at < end && goals.size() < kMostGoals; ++at) {
    const Statement& statement = statements_.all()[at];
    if (body_of(statement) != body || statements_.is_trigonometric(statement.value)) {
      continue;
    }
    const std::string& goal = goals_[node_index(statement.value)];
    append_if(goals, !goal.empty() && std::ranges::find(goals, word_of(goal)) == goals.end(),
              word_of(goal));
  }
  std::string comment = fmt::format("// {}", words_.body_comments[static_cast<std::size_t>(body)]);
  if (goals.empty()) {
    return comment;
  }
  const std::string& equation = function_.signature.equation;
  const std::string what =
      fmt::format(": {}{}{}", fmt::join(goals, ", "), equation.empty() ? "" : " of ", equation);
  const bool fits = kIndentation + comment.size() + what.size() <= kColumns;
  return fits ? comment + what : comment;
}

std::map<std::size_t, std::string> Steps::comments() const {
  const std::vector<Statement>& all = statements_.all();
  std::vector<std::size_t> begins;
  int current = kNoBody;
  for (std::size_t at = 0; at < all.size(); ++at) {
    if (at > 0 && (all[at].part != all[at - 1].part ||
                   statements_.level_of(at) != statements_.level_of(at - 1))) {
      current = kNoBody;
    }
    const int body = body_of(all[at]);
    if (body != kNoBody && body != current && begins_run(at)) {
      begins.push_back(at);
      current = body;
    }
  }
  std::map<std::size_t, std::string> result;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : all.size();
    result.emplace(begins[k], text(begins[k], end));
  }
  return result;
}

}  // namespace

std::map<std::size_t, std::string> step_comments(const program::Function& function,
                                                 const Statements& statements,
                                                 const Vocabulary& words) {
  return Steps(function, statements, words).comments();
}

}  // namespace treedyn::emit
