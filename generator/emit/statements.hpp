// What one generated function states: its statements in order, in parts, and the words for their
// values.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/layout.hpp"
#include "emit/literal.hpp"
#include "emit/names.hpp"
#include "program/schedule.hpp"

namespace treedyn::emit {

inline constexpr int kIndentation = 2;

/// An angle, its sine and its cosine.
struct Angle {
  program::Ref angle = 0;
  program::Ref sine = 0;
  program::Ref cosine = 0;
};

/// One statement: `const Scalar x = ...;` (output < 0) or `A[output] = ...;`, of the sine and the
/// cosine of an angle together `const auto [s, c] = ...;`, or those of several angles.
struct Statement {
  program::Ref value = 0;          ///< of both the sine; of several angles the first that is needed
  program::Ref partner = 0;        ///< the cosine; 0: one value is stated
  std::vector<Angle> angles = {};  ///< of several together; empty: none
  int output = -1;
  int copy_of = -1;  ///< another output with the same value up to its sign
  std::size_t part = 0;
};

/// The statements of a function.
/// \invariant every value that a statement names is an input, a constant or stated before it.
class Statements {
 public:
  /// \param level  stage of an input element (array, element), see program::Staged; empty: all 0
  Statements(const program::Function& function, const Vocabulary& words, const Target& target,
             const std::function<int(int, int)>& level);

  [[nodiscard]] const std::vector<Statement>& all() const { return statements_; }
  /// Zeros that stand in a function of their own, not among `all`; none unless the target asks.
  [[nodiscard]] const std::vector<Statement>& zeros() const { return zeros_; }
  [[nodiscard]] const program::Schedule& schedule() const { return schedule_; }
  /// The stage of a statement.
  [[nodiscard]] int level_of(std::size_t statement) const {
    return level_[program::node_index(statements_[statement].value)];
  }
  [[nodiscard]] bool is_operation(program::Ref a) const;
  [[nodiscard]] bool is_trigonometric(program::Ref a) const;
  /// True if the value has a name of its own: some operation uses it, or it is one of a pair.
  [[nodiscard]] bool is_local(program::Ref a) const { return is_local_[program::node_index(a)]; }
  /// True if a part behind its own needs the value.
  [[nodiscard]] bool is_shared(program::Ref a) const { return slot_[program::node_index(a)] >= 0; }
  /// True if the value is shared and another part than `part` states it.
  [[nodiscard]] bool is_elsewhere(program::Ref a, std::size_t part) const {
    return is_shared(a) && part_of_[program::node_index(a)] != part;
  }
  /// The element of the workspace that holds a shared value.
  [[nodiscard]] int slot(program::Ref a) const { return slot_[program::node_index(a)]; }
  /// Elements of the workspace.
  [[nodiscard]] int slots() const { return slots_; }
  /// The values that a statement gives names to.
  static void visit_definitions(const Statement& statement,
                                const std::function<void(program::Ref)>& visit);
  /// The name of a local array.
  [[nodiscard]] std::string array_name(const std::string& stem) const;
  /// What the right side of a statement names: locals, inputs and constants.
  void visit_atoms(const Statement& statement,
                   const std::function<void(program::Ref)>& visit) const;

  /// The array that holds an output element.
  [[nodiscard]] std::size_t output_array(int output) const;
  /// "A[12]".
  [[nodiscard]] std::string element(int output) const;
  [[nodiscard]] const std::string& name(program::Ref local) const { return names_.at(local); }
  /// A local, an input or a constant.
  [[nodiscard]] std::string atom(program::Ref value) const;

 private:
  void find_levels(const std::function<int(int, int)>& level);
  void find_uses();
  void find_pairs();
  void make_schedule();
  void list_statements();
  void list_definition(program::Ref value, std::vector<bool>& stated);
  void list_angle(program::Ref value, std::vector<bool>& stated);
  void list_stores(program::Ref value);
  void list_constants(int level);
  void spread_zeros();
  [[nodiscard]] bool stays(int output, program::Ref value) const;
  void divide();
  [[nodiscard]] std::size_t best_cut(const std::vector<int>& crossing, std::size_t begin) const;
  [[nodiscard]] std::vector<int> crossing_counts() const;
  [[nodiscard]] std::vector<std::size_t> last_parts() const;
  void assign_slots();
  [[nodiscard]] std::string input(const program::Node& node) const;
  [[nodiscard]] int available(program::Ref value) const;

  const program::Function& function_;
  const program::Graph& graph_;
  const Vocabulary& words_;
  Target target_;
  std::vector<program::Ref> operations_;
  LocalNames names_;
  program::Schedule schedule_;
  std::vector<int> level_;  // by node
  int last_level_ = 0;
  std::vector<bool> is_local_;
  std::vector<program::Ref> partner_;         // by node: the other one of sine and cosine, 0: none
  std::vector<std::vector<int>> outputs_of_;  // by node
  std::vector<Statement> statements_;
  std::vector<Statement> zeros_;
  std::vector<std::size_t> part_of_;  // by node, where its local is defined
  std::vector<int> slot_;             // by node; -1: not shared
  int slots_ = 0;
};

}  // namespace treedyn::emit
