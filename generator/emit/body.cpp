#include "emit/body.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "common/error.hpp"
#include "emit/expression.hpp"
#include "program/schedule.hpp"

namespace treedyn::emit {

using program::Kind;
using program::Ref;

namespace {

constexpr int kColumns = 100;
constexpr int kIndentation = 2;
/// A function with more statements is split: gcc needs more than linear time for one huge block.
/// Below that, one block is up to 30 % faster than parts (measured: hyq, simple_humanoid).
constexpr std::size_t kLargestFunction = 1500;
constexpr std::size_t kSmallestPart = 200;
constexpr std::size_t kLargestPart = 400;
/// Fewer statements for one body get no comment.
constexpr int kShortestRun = 3;

std::size_t index(Ref a) { return static_cast<std::size_t>(std::abs(a)); }

/// One statement: `const Scalar x = ...;` (output < 0) or `A[output] = ...;`.
struct Statement {
  Ref value = 0;
  int output = -1;
  int copy_of = -1;  ///< another output with the same value up to its sign
  std::size_t part = 0;
};

class Writer {
 public:
  Writer(const program::Function& function, const Vocabulary& words, const Target& target,
         const std::function<int(int, int)>& level)
      : function_(function),
        graph_(function.graph),
        words_(words),
        target_(target),
        operations_(program::operations_in_order(graph_, function.outputs)),
        names_(function, words, operations_) {
    find_levels(level);
  }

  Body write();

 private:
  void find_levels(const std::function<int(int, int)>& level);
  void sink();
  void find_uses();
  void make_schedule();
  void list_statements();
  void list_stores(Ref value);
  void list_constants(int level);
  bool stays(int output, Ref value) const;
  void divide();
  std::size_t best_cut(const std::vector<int>& crossing, std::size_t begin) const;
  std::vector<int> crossing_counts() const;
  void find_shared();

  std::string element(int output) const;
  std::string atom(Ref value, std::size_t part) const;
  std::string input(const program::Node& node) const;
  std::string text(const Statement& statement) const;
  std::string broadcast(Ref value) const;
  std::string right_side(const Statement& statement) const;
  int body_of(const Statement& statement) const;
  void note_body(std::size_t at, Part& part, int& current) const;
  void note_arrays(const Statement& statement, Part& part) const;
  std::size_t output_array(int output) const;
  bool is_operation(Ref a) const {
    return a != 0 && graph_.node(a).kind != Kind::kConstant && graph_.node(a).kind != Kind::kInput;
  }
  int level_of(std::size_t statement) const { return level_[index(statements_[statement].value)]; }
  bool is_local(Ref a) const { return used_by_operation_[index(a)]; }
  bool is_large() const { return operations_.size() + function_.outputs.size() > kLargestFunction; }
  int available(Ref value) const;
  void visit_atoms(const Statement& statement, const std::function<void(Ref)>& visit) const;

  const program::Function& function_;
  const program::Graph& graph_;
  const Vocabulary& words_;
  Target target_;
  std::vector<Ref> operations_;
  LocalNames names_;
  program::Schedule schedule_;
  std::vector<int> level_;  // by node
  int last_level_ = 0;
  std::vector<bool> used_by_operation_;
  std::vector<std::vector<int>> outputs_of_;  // by node
  std::vector<Statement> statements_;
  std::vector<std::size_t> part_of_;  // by node, where its local is defined
  std::vector<bool> shared_;          // by node, needed by a later part
};

void Writer::find_levels(const std::function<int(int, int)>& level) {
  level_.assign(graph_.size(), 0);
  for (const Ref k : program::reachable(graph_, function_.outputs)) {
    const program::Node& node = graph_.node(k);
    int& own = level_[index(k)];
    if (node.kind == Kind::kInput && level) {
      own = level(node.a, node.b);
    }
    program::for_each_operand(node,
                              [&](Ref operand) { own = std::max(own, level_[index(operand)]); });
    last_level_ = std::max(last_level_, own);
  }
}

void Writer::find_uses() {
  used_by_operation_.assign(graph_.size(), false);
  outputs_of_.resize(graph_.size());
  for (const Ref k : operations_) {
    program::for_each_operand(graph_.node(k),
                              [&](Ref operand) { used_by_operation_[index(operand)] = true; });
  }
  for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
    outputs_of_[index(function_.outputs[output])].push_back(static_cast<int>(output));
  }
}

/// Room for the expression of a value: `const Scalar name = ...;`, or `A[12] = -(...);`.
int Writer::available(Ref value) const {
  const int left =
      is_local(value)
          ? static_cast<int>(std::string_view("const Scalar ").size()) + names_.width(value)
          : static_cast<int>(element(outputs_of_[index(value)].front()).size()) + 3;
  return kColumns - kIndentation - left - static_cast<int>(std::string_view(" = ;").size());
}

void Writer::make_schedule() {
  program::Measure measure;
  measure.available = [this](Ref value) {
    return available(value);
  };
  measure.atom = [this](Ref value) {
    return is_operation(value) ? names_.width(value) + (is_large() ? 2 : 0)
                               : static_cast<int>(atom(value, 0).size());
  };
  schedule_ = program::schedule(graph_, function_.outputs, operations_, measure);
}

void Writer::list_statements() {
  for (int level = 0; level <= last_level_; ++level) {
    for (const Ref value : schedule_.statements) {
      if (level_[index(value)] != level) {
        continue;
      }
      if (is_local(value)) {
        names_.assign(value);
        statements_.push_back({.value = value});
      }
      list_stores(value);
    }
    list_constants(level);
  }
}

void Writer::list_stores(Ref value) {
  int first = -1;
  for (const int output : outputs_of_[index(value)]) {
    statements_.push_back({.value = function_.outputs[static_cast<std::size_t>(output)],
                           .output = output,
                           .copy_of = first});
    first = first < 0 ? output : first;
  }
}

/// True if the output is the same element of the array of the same name: nothing is to be done.
bool Writer::stays(int output, Ref value) const {
  return value > 0 && graph_.node(value).kind == Kind::kInput &&
         input(graph_.node(value)) == element(output);
}

/// Outputs that are constants or inputs of this level; zeros last.
void Writer::list_constants(int level) {
  for (const bool zeros : {false, true}) {
    for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
      const Ref value = function_.outputs[output];
      if (!is_operation(value) && (value == 0) == zeros && level_[index(value)] == level &&
          !stays(static_cast<int>(output), value)) {
        statements_.push_back({.value = value, .output = static_cast<int>(output)});
      }
    }
  }
}

/// What the right side of a statement names: locals, inputs and constants.
void Writer::visit_atoms(const Statement& statement, const std::function<void(Ref)>& visit) const {
  if (statement.value == 0 || statement.copy_of >= 0) {
    return;
  }
  if (!is_operation(statement.value) || (statement.output >= 0 && is_local(statement.value))) {
    visit(std::abs(statement.value));
  } else {
    for_each_atom(graph_, schedule_, statement.value, visit);
  }
}

/// For every place between two statements the number of locals that are needed on both sides.
std::vector<int> Writer::crossing_counts() const {
  std::vector<std::size_t> defined(graph_.size(), 0);
  std::vector<std::size_t> last(graph_.size(), 0);
  for (std::size_t at = 0; at < statements_.size(); ++at) {
    if (statements_[at].output < 0) {
      defined[index(statements_[at].value)] = at;
    }
    visit_atoms(statements_[at], [&](Ref value) { last[index(value)] = at; });
  }
  std::vector<int> change(statements_.size() + 1, 0);
  for (const Statement& statement : statements_) {
    const std::size_t k = index(statement.value);
    if (statement.output < 0) {
      ++change[defined[k] + 1];
      --change[std::min(last[k] + 1, statements_.size())];
    }
  }
  for (std::size_t at = 1; at < change.size(); ++at) {
    change[at] += change[at - 1];
  }
  return change;
}

/// The place for the end of the part that starts at `begin`: few values cross it.
std::size_t Writer::best_cut(const std::vector<int>& crossing, std::size_t begin) const {
  const std::size_t middle = begin + (kSmallestPart + kLargestPart) / 2;
  std::size_t best = middle;
  for (std::size_t at = begin + kSmallestPart; at <= begin + kLargestPart; ++at) {
    const bool splits_pair = statements_[at].output < 0 && statements_[at - 1].output < 0 &&
                             graph_.node(statements_[at].value).kind >= Kind::kSin &&
                             graph_.node(statements_[at - 1].value).kind >= Kind::kSin;
    if (!splits_pair && crossing[at] < crossing[best]) {
      best = at;
    }
  }
  return best;
}

void Writer::divide() {
  if (statements_.size() <= kLargestFunction) {
    return;
  }
  const std::vector<int> crossing = crossing_counts();
  std::size_t part = 0;
  std::size_t end = best_cut(crossing, 0);
  for (std::size_t at = 0; at < statements_.size(); ++at) {
    if (at == end || (at > 0 && level_of(at) != level_of(at - 1))) {
      ++part;
      end = at + kLargestPart < statements_.size() ? best_cut(crossing, at) : statements_.size();
    }
    statements_[at].part = part;
  }
}

void Writer::find_shared() {
  part_of_.assign(graph_.size(), 0);
  shared_.assign(graph_.size(), false);
  for (const Statement& statement : statements_) {
    if (statement.output < 0) {
      part_of_[index(statement.value)] = statement.part;
    }
  }
  for (const Statement& statement : statements_) {
    visit_atoms(statement, [&](Ref value) {
      if (is_operation(value) && part_of_[index(value)] != statement.part) {
        shared_[index(value)] = true;
      }
    });
  }
}

std::size_t Writer::output_array(int output) const {
  std::size_t array = 0;
  for (int end = function_.signature.outputs[0].size; output >= end;
       end += function_.signature.outputs[array].size) {
    ++array;
  }
  return array;
}

std::string Writer::element(int output) const {
  int place = output;
  const std::size_t array = output_array(output);
  for (std::size_t k = 0; k < array; ++k) {
    place -= function_.signature.outputs[k].size;
  }
  return fmt::format("{}[{}]", function_.signature.outputs[array].name, place);
}

std::string Writer::input(const program::Node& node) const {
  return fmt::format("{}[{}]", function_.signature.inputs[static_cast<std::size_t>(node.a)].name,
                     node.b);
}

std::string Writer::atom(Ref value, std::size_t part) const {
  const program::Node& node = graph_.node(value);
  if (node.kind == Kind::kConstant) {
    return literal(graph_.value(value), target_.scalar);
  }
  if (node.kind == Kind::kInput) {
    return input(node);
  }
  const bool elsewhere = shared_[index(value)] && part_of_[index(value)] != part;
  return elsewhere ? "w." + names_.at(value) : names_.at(value);
}

/// A constant in every lane.
std::string Writer::broadcast(Ref value) const {
  return value == 0 ? "Scalar{}"
                    : fmt::format("Scalar{{}} {} {}", value < 0 ? '-' : '+',
                                  literal(graph_.value(std::abs(value)), target_.scalar));
}

std::string Writer::right_side(const Statement& statement) const {
  const Ref value = statement.value;
  if (target_.lanes > 1 && (value == 0 || graph_.node(value).kind == Kind::kConstant)) {
    return broadcast(value);
  }
  if (value == 0) {
    return literal(0, target_.scalar);
  }
  if (statement.copy_of >= 0) {
    const Ref original = function_.outputs[static_cast<std::size_t>(statement.copy_of)];
    return fmt::format("{}{}", original == value ? "" : "-", element(statement.copy_of));
  }
  if (!is_operation(value) || (statement.output >= 0 && is_local(value))) {
    return fmt::format("{}{}", value < 0 ? "-" : "", atom(std::abs(value), statement.part));
  }
  return expression(
      graph_, schedule_, [&](Ref used) { return atom(used, statement.part); }, value);
}

std::string Writer::text(const Statement& statement) const {
  const std::string left = statement.output < 0
                               ? fmt::format("const Scalar {}", names_.at(statement.value))
                               : element(statement.output);
  std::string line = fmt::format("{} = {};", left, right_side(statement));
  TREEDYN_EXPECT(line.size() + kIndentation <= kColumns);
  return line;
}

/// The body that a statement computes something for, -1 if it stores a result that exists.
int Writer::body_of(const Statement& statement) const {
  const bool computes = statement.copy_of < 0 && is_operation(statement.value) &&
                        (statement.output < 0 || !is_local(statement.value));
  return computes ? graph_.hint(statement.value).body : -1;
}

/// A comment line where at least three statements in a row begin to compute for another body.
void Writer::note_body(std::size_t at, Part& part, int& current) const {
  const int body = body_of(statements_[at]);
  if (body < 0 || body == current) {
    return;
  }
  int run = 0;
  for (; at < statements_.size() && run < kShortestRun; ++at) {
    const int next = body_of(statements_[at]);
    if (next >= 0 && next != body) {
      return;
    }
    run += next == body ? 1 : 0;
  }
  part.lines.push_back(fmt::format("// {}", words_.body_comments[static_cast<std::size_t>(body)]));
  current = body;
}

void Writer::note_arrays(const Statement& statement, Part& part) const {
  const std::size_t inputs = function_.signature.inputs.size();
  if (statement.output >= 0) {
    part.uses[inputs + output_array(statement.output)] = true;
  }
  if (statement.copy_of >= 0) {
    part.uses[inputs + output_array(statement.copy_of)] = true;
  }
  visit_atoms(statement, [&](Ref value) {
    part.uses_workspace |= shared_[index(value)] && part_of_[index(value)] != statement.part;
    if (graph_.node(value).kind == Kind::kInput) {
      part.uses[static_cast<std::size_t>(graph_.node(value).a)] = true;
    }
  });
}

Body Writer::write() {
  shared_.assign(graph_.size(), false);
  find_uses();
  make_schedule();
  list_statements();
  divide();
  find_shared();

  Body result;
  int current = -1;
  for (std::size_t at = 0; at < statements_.size(); ++at) {
    const Statement& statement = statements_[at];
    if (result.parts.size() <= statement.part) {
      result.parts.push_back({{},
                              level_of(at),
                              std::vector<bool>(function_.signature.inputs.size() +
                                                function_.signature.outputs.size())});
      current = -1;
    }
    Part& part = result.parts.back();
    while (static_cast<int>(result.stages.size()) < level_of(at)) {
      result.stages.push_back(part.lines.size());
      current = -1;
    }
    note_body(at, part, current);
    note_arrays(statement, part);
    part.lines.push_back(text(statement));
    ++result.statements;
    if (statement.output < 0 && shared_[index(statement.value)]) {
      const std::string& name = names_.at(statement.value);
      result.workspace.push_back(name);
      part.uses_workspace = true;
      part.lines.push_back(fmt::format("w.{} = {};", name, name));
      ++result.statements;
    }
  }
  result.structural_zeros =
      static_cast<int>(std::count(function_.outputs.begin(), function_.outputs.end(), Ref{0}));
  return result;
}

}  // namespace

Body body(const program::Function& function, const Vocabulary& words, const Target& target,
          const std::function<int(int, int)>& level) {
  return Writer(function, words, target, level).write();
}

}  // namespace treedyn::emit
