#include "emit/body.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/index.hpp"
#include "emit/layout.hpp"
#include "emit/operation_text.hpp"
#include "emit/sincos.hpp"
#include "emit/statements.hpp"
#include "emit/step_comments.hpp"

namespace treedyn::emit {

using program::Kind;
using program::node_index;
using program::Ref;

namespace {

/// The text of the statements.
class Writer {
 public:
  Writer(const program::Function& function, const Vocabulary& words, const Target& target,
         const std::function<int(int, int)>& level)
      : function_(function),
        graph_(function.graph),
        words_(words),
        target_(target),
        statements_(function, words, target, level),
        workspace_(statements_.array_name("w")),
        loaded_in_(function.graph.size(), 0) {}

  Body write();

 private:
  [[nodiscard]] std::string text(const Statement& statement) const;
  [[nodiscard]] std::string pair(const Statement& statement) const;
  void state_angles(const Statement& statement, Part& part, Body& body) const;
  [[nodiscard]] std::string broadcast(Ref value) const;
  [[nodiscard]] bool is_of_scalars(const Statement& statement) const;
  [[nodiscard]] std::string right_side(const Statement& statement) const;
  void note_arrays(const Statement& statement, Part& part) const;
  void load(const Statement& statement, Part& part, Body& body);
  void share(Ref value, Part& part, Body& body) const;

  const program::Function& function_;
  const program::Graph& graph_;
  const Vocabulary& words_;
  Target target_;
  Statements statements_;
  std::string workspace_;
  std::vector<std::size_t> loaded_in_;  ///< by node: the last part that took it from the workspace
};

/// A constant in every lane.
std::string Writer::broadcast(Ref value) const {
  return value == 0
             ? target_.number + "{}"
             : fmt::format("{}{{}} {} {}", target_.number, value < 0 ? '-' : '+',
                           number_text(words_, graph_.value(std::abs(value)), target_.scalar));
}

/// True if what becomes a vector is made of arguments that are none alone.
bool Writer::is_of_scalars(const Statement& statement) const {
  bool result = target_.lanes > 1 && statement.copy_of < 0 && statement.value != 0 &&
                graph_.node(statement.value).kind != Kind::kConstant;
  statements_.visit_atoms(statement, [&](Ref value) {
    const program::Node& node = graph_.node(value);
    const bool is_input = node.kind == Kind::kInput;
    const std::string& number = is_input ? function_.signature.inputs[to_index(node.a)].number : "";
    result = result && (is_input ? number.empty() && target_.number != "Scalar"
                                 : node.kind == Kind::kConstant);
  });
  return result;
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
    const Ref original = function_.outputs[to_index(statement.copy_of)];
    return fmt::format("{}{}", original == value ? "" : "-",
                       statements_.element(statement.copy_of));
  }
  if (!statements_.is_operation(value) || (statement.output >= 0 && statements_.is_local(value))) {
    return fmt::format("{}{}", value < 0 ? "-" : "", statements_.atom(std::abs(value)));
  }
  return expression(
      graph_, statements_.schedule(), [&](Ref used) { return statements_.atom(used); }, value);
}

/// Both in one call. What C++17 binds, C++11 refers to; copies would take stack where numbers are
/// in software.
std::string Writer::pair(const Statement& statement) const {
  const std::string& sine = statements_.name(statement.value);
  const std::string both = statements_.array_name("p_" + sine);
  const std::string call = fmt::format("{}({});", kSineCosine,
                                       statements_.atom(std::abs(graph_.node(statement.value).a)));
  const std::string left = fmt::format("const auto {} =", both);
  const bool fits = kIndentation + left.size() + 1 + call.size() <= kColumns;
  return fmt::format(
      "{0}{1}{2}\n{3:{4}}const {8}& {5} = {6}.sine;\n{3:{4}}const {8}& {7} = {6}.cosine;", left,
      fits ? " " : kNextLine, call, "", kIndentation, sine, both,
      statements_.name(statement.partner), target_.number);
}

/// The arrays hold whole vectors; a call for each of the longest. One angle needs none.
void Writer::state_angles(const Statement& statement, Part& part, Body& body) const {
  if (statement.angles.size() == 1) {
    const Angle& angle = statement.angles.front();
    part.lines.push_back(pair({.value = angle.sine, .partner = angle.cosine}));
    return;
  }
  const std::size_t number = ++body.angle_statements;
  const std::string suffix = number == 1 ? "" : fmt::format("_{}", number);
  const std::vector<std::string> arrays = {statements_.array_name("sines" + suffix),
                                           statements_.array_name("cosines" + suffix)};
  const std::size_t count = statement.angles.size();
  const std::size_t most = most_angles(target_.scalar);
  for (const std::string& array : arrays) {
    part.lines.push_back(fmt::format("Scalar {}[{}];", array, (count + most - 1) / most * most));
  }
  for (std::size_t begin = 0; begin < count; begin += most) {
    std::vector<std::string> arguments;
    for (const std::string& array : arrays) {
      arguments.push_back(begin == 0 ? array : fmt::format("{} + {}", array, begin));
    }
    for (std::size_t k = begin; k < std::min(begin + most, count); ++k) {
      arguments.push_back(statements_.atom(statement.angles[k].angle));
    }
    part.lines.push_back(call_text(kSinesCosines, arguments));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const Angle& angle = statement.angles[k];
    for (const auto& [value, array] :
         {std::pair(angle.sine, arrays[0]), std::pair(angle.cosine, arrays[1])}) {
      part.lines.push_back(
          fmt::format("const Scalar {} = {}[{}];", statements_.name(value), array, k));
      ++body.statements;
    }
  }
}

std::string Writer::text(const Statement& statement) const {
  if (statement.partner != 0) {
    return pair(statement);
  }
  const std::string left = statement.output < 0 ? fmt::format("const {} {}", target_.number,
                                                              statements_.name(statement.value))
                                                : statements_.element(statement.output);
  std::string right = right_side(statement) + ';';
  if (is_of_scalars(statement)) {  // a sum with zero would lose a negative zero
    const std::string zero = fmt::format("- {}{{}};", target_.number);
    const bool fits = kContinuation + right.size() + zero.size() <= kColumns;
    right.back() = ' ';
    right += fits ? zero : "\n" + std::string(kContinuation, ' ') + zero;
  }
  const bool fits = kIndentation + left.size() + 3 + right.size() <= kColumns;
  TREEDYN_EXPECT(fits || kContinuation + right.size() <= kColumns);
  return fmt::format("{} ={}{}", left, fits ? " " : kNextLine, right);
}

void Writer::note_arrays(const Statement& statement, Part& part) const {
  const std::size_t inputs = function_.signature.inputs.size();
  if (statement.output >= 0) {
    part.uses[inputs + statements_.output_array(statement.output)] = true;
  }
  if (statement.copy_of >= 0) {
    part.uses[inputs + statements_.output_array(statement.copy_of)] = true;
  }
  statements_.visit_atoms(statement, [&](Ref value) {
    if (graph_.node(value).kind == Kind::kInput) {
      part.uses[to_index(graph_.node(value).a)] = true;
    }
  });
}

/// What the statement needs of other parts, where its own part has not loaded it yet.
void Writer::load(const Statement& statement, Part& part, Body& body) {
  statements_.visit_atoms(statement, [&](Ref value) {
    std::size_t& loaded = loaded_in_[node_index(value)];
    if (statements_.is_elsewhere(value, statement.part) && loaded != statement.part) {
      loaded = statement.part;
      part.uses_workspace = true;
      part.lines.push_back(fmt::format("const {} {} = {}[{}];", target_.number,
                                       statements_.name(value), workspace_,
                                       statements_.slot(value)));
      ++body.statements;
    }
  });
}

/// Keeps a value that other parts need.
void Writer::share(Ref value, Part& part, Body& body) const {
  if (statements_.is_shared(value)) {
    part.uses_workspace = true;
    part.lines.push_back(
        fmt::format("{}[{}] = {};", workspace_, statements_.slot(value), statements_.name(value)));
    ++body.statements;
  }
}

Body Writer::write() {
  Body result;
  result.workspace = statements_.slots();
  result.number = target_.number;
  result.workspace_name = workspace_;
  const std::map<std::size_t, std::string> comments = step_comments(function_, statements_, words_);
  for (std::size_t at = 0; at < statements_.all().size(); ++at) {
    const Statement& statement = statements_.all()[at];
    if (result.parts.size() <= statement.part) {
      result.parts.push_back({{},
                              statements_.level_of(at),
                              std::vector<bool>(function_.signature.inputs.size() +
                                                function_.signature.outputs.size())});
    }
    Part& part = result.parts.back();
    while (static_cast<int>(result.stages.size()) < statements_.level_of(at)) {
      result.stages.push_back(part.lines.size());
    }
    if (const auto comment = comments.find(at); comment != comments.end()) {
      part.lines.push_back(comment->second);
    }
    note_arrays(statement, part);
    load(statement, part, result);
    if (statement.angles.empty()) {
      part.lines.push_back(text(statement));
    } else {
      state_angles(statement, part, result);
    }
    ++result.statements;
    Statements::visit_definitions(statement, [&](Ref value) { share(value, part, result); });
  }
  const std::size_t arrays = function_.signature.inputs.size() + function_.signature.outputs.size();
  result.zeros.uses.resize(arrays);
  if (result.parts.empty() && !statements_.zeros().empty()) {
    result.parts.push_back({{}, 0, std::vector<bool>(arrays)});
  }
  for (const Statement& zero : statements_.zeros()) {
    note_arrays(zero, result.zeros);
    result.zeros.lines.push_back(text(zero));
    ++result.statements;
  }
  result.structural_zeros = static_cast<int>(std::ranges::count(function_.outputs, Ref{0}));
  return result;
}

}  // namespace

Body body(const program::Function& function, const Vocabulary& words, const Target& target,
          const std::function<int(int, int)>& level) {
  return Writer(function, words, target, level).write();
}

}  // namespace treedyn::emit
