#include "emit/statements.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "common/index.hpp"
#include "emit/operation_text.hpp"

namespace treedyn::emit {

using program::Kind;
using program::node_index;
using program::Ref;

namespace {

/// A function with more statements is split: gcc needs more than linear time for one huge block.
/// Below that, one block is up to 30 % faster than parts (measured: hyq, simple_humanoid).
constexpr std::size_t kLargestFunction = 1500;
constexpr std::size_t kSmallestPart = 200;
constexpr std::size_t kLargestPart = 400;
/// Zeros from which a function of their own pays.
constexpr std::ptrdiff_t kManyZeros = 16;

}  // namespace

Statements::Statements(const program::Function& function, const Vocabulary& words,
                       const Target& target, const std::function<int(int, int)>& level)
    : function_(function),
      graph_(function.graph),
      words_(words),
      target_(target),
      operations_(program::operations_in_order(graph_, function.outputs, target.order())),
      names_(function, words, operations_),
      slot_(graph_.size(), -1) {
  find_levels(level);
  find_uses();
  if (!target.takes_libm()) {
    find_pairs();
  }
  make_schedule();
  list_statements();
  if (target.lanes > 1 && last_level_ == 0) {
    spread_zeros();
  }
  divide();
  assign_slots();
}

bool Statements::is_trigonometric(Ref a) const {
  return graph_.node(a).kind == Kind::kSin || graph_.node(a).kind == Kind::kCos;
}

bool Statements::is_operation(Ref a) const {
  return a != 0 && graph_.node(a).kind != Kind::kConstant && graph_.node(a).kind != Kind::kInput;
}

void Statements::find_levels(const std::function<int(int, int)>& level) {
  level_.assign(graph_.size(), 0);
  for (const Ref k : program::reachable(graph_, function_.outputs)) {
    const program::Node& node = graph_.node(k);
    int& own = level_[node_index(k)];
    if (node.kind == Kind::kInput && level) {
      own = level(node.a, node.b);
    }
    program::for_each_operand(
        node, [&](Ref operand) { own = std::max(own, level_[node_index(operand)]); });
    last_level_ = std::max(last_level_, own);
  }
}

void Statements::find_uses() {
  is_local_.assign(graph_.size(), false);
  partner_.assign(graph_.size(), 0);
  outputs_of_.resize(graph_.size());
  for (const Ref k : operations_) {
    program::for_each_operand(graph_.node(k),
                              [&](Ref operand) { is_local_[node_index(operand)] = true; });
  }
  for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
    outputs_of_[node_index(function_.outputs[output])].push_back(static_cast<int>(output));
  }
}

/// The sine and the cosine of every angle of which both are needed.
void Statements::find_pairs() {
  std::vector<Ref> first(graph_.size(), 0);
  for (const Ref k : operations_) {
    if (!is_trigonometric(k)) {
      continue;
    }
    Ref& other = first[node_index(graph_.node(k).a)];
    if (other != 0) {
      partner_[node_index(k)] = other;
      partner_[node_index(other)] = k;
      is_local_[node_index(k)] = is_local_[node_index(other)] = true;
    }
    other = k;
  }
}

/// Room for the expression of a value: `const Scalar name = ...;`, or `A[12] = -(...);`.
int Statements::available(Ref value) const {
  const int left =
      is_local(value)
          ? static_cast<int>(("const " + target_.number + " ").size()) + names_.width(value)
          : static_cast<int>(element(outputs_of_[node_index(value)].front()).size()) + 3;
  return static_cast<int>(kColumns) - kIndentation - left -
         static_cast<int>(std::string_view(" = ;").size());
}

void Statements::make_schedule() {
  program::Measure measure;
  measure.available = [this](Ref value) {
    return available(value);
  };
  measure.atom = [this](Ref value) {
    if (graph_.node(value).kind == Kind::kConstant) {
      return number_width(words_, graph_.value(value), target_.scalar);
    }
    return is_operation(value) ? names_.width(value) : static_cast<int>(atom(value).size());
  };
  measure.own_line = static_cast<int>(kColumns - kContinuation - std::string_view("-();").size());
  schedule_ = program::schedule(graph_, function_.outputs, operations_, measure);
}

void Statements::list_statements() {
  std::vector<bool> stated(graph_.size(), false);
  for (int level = 0; level <= last_level_; ++level) {
    std::vector<Ref> waiting;  // to be stored behind all that are computed together
    const auto store = [&] {
      std::ranges::for_each(waiting, [&](Ref value) { list_stores(value); });
      waiting.clear();
    };
    for (const Ref value : schedule_.statements) {
      if (level_[node_index(value)] != level) {
        continue;
      }
      const bool together = target_.takes_vectors() && partner_[node_index(value)] != 0;
      if (together) {
        list_angle(value, stated);
      } else {
        store();
        list_definition(value, stated);
      }
      waiting.push_back(value);
    }
    store();
    list_constants(level);
  }
}

/// Sine and cosine of one angle. Joins the statement before it if that is one of angles, of this
/// level and not of the sine or cosine whose sine and cosine these are.
void Statements::list_angle(Ref value, std::vector<bool>& stated) {
  if (stated[node_index(value)]) {
    return;
  }
  const program::Node& node = graph_.node(value);
  const Ref partner = partner_[node_index(value)];
  const bool is_sine = node.kind == Kind::kSin;
  stated[node_index(partner)] = true;
  names_.assign(value);
  names_.assign(partner);
  const auto gives = [&](const Angle& angle) {
    return angle.sine == node.a || angle.cosine == node.a;
  };
  if (statements_.empty() || statements_.back().angles.empty() ||
      level_of(statements_.size() - 1) != level_[node_index(value)] ||
      std::ranges::any_of(statements_.back().angles, gives)) {
    statements_.push_back({.value = value});
  }
  statements_.back().angles.push_back(
      {node.a, is_sine ? value : partner, is_sine ? partner : value});
}

/// Of sine and cosine of one angle the first brings both.
void Statements::list_definition(Ref value, std::vector<bool>& stated) {
  const Ref partner = partner_[node_index(value)];
  if (!is_local(value) || stated[node_index(value)]) {
    return;
  }
  names_.assign(value);
  if (partner == 0) {
    statements_.push_back({.value = value});
    return;
  }
  names_.assign(partner);
  stated[node_index(partner)] = true;
  const bool is_sine = graph_.node(value).kind == Kind::kSin;
  statements_.push_back({.value = is_sine ? value : partner, .partner = is_sine ? partner : value});
}

void Statements::list_stores(Ref value) {
  int first = -1;
  for (const int output : outputs_of_[node_index(value)]) {
    statements_.push_back(
        {.value = function_.outputs[to_index(output)], .output = output, .copy_of = first});
    first = first < 0 ? output : first;
  }
}

/// True if the output is the same element of the array of the same name: nothing is to be done.
bool Statements::stays(int output, Ref value) const {
  return value > 0 && graph_.node(value).kind == Kind::kInput &&
         input(graph_.node(value)) == element(output);
}

/// Outputs that are constants or inputs of this level; zeros last.
void Statements::list_constants(int level) {
  const bool apart =
      target_.zeros_apart && std::ranges::count(function_.outputs, Ref{0}) >= kManyZeros;
  for (const bool zeros : {false, true}) {
    std::vector<Statement>& list = zeros && apart ? zeros_ : statements_;
    for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
      const Ref value = function_.outputs[output];
      if (!is_operation(value) && (value == 0) == zeros && level_[node_index(value)] == level &&
          !stays(static_cast<int>(output), value)) {
        list.push_back({.value = value, .output = static_cast<int>(output)});
      }
    }
  }
}

/// Several states at once: a processor stores zeros while it computes sines, if there are some
/// behind each pair; it does not wait for all of them in a row.
void Statements::spread_zeros() {
  const auto is_zero = [](const Statement& statement) {
    return statement.output >= 0 && statement.value == 0;
  };
  const auto is_pair = [](const Statement& statement) {
    return statement.partner != 0;
  };
  const auto pairs = std::ranges::count_if(statements_, is_pair);
  if (pairs == 0 || std::ranges::count_if(statements_, is_zero) < kManyZeros) {
    return;
  }
  const auto middle =
      std::stable_partition(statements_.begin(), statements_.end(), std::not_fn(is_zero));
  const std::vector<Statement> zeros(middle, statements_.end());
  std::vector<Statement> spread;
  std::ptrdiff_t before = 0;
  std::ptrdiff_t placed = 0;
  for (auto at = statements_.begin(); at != middle; ++at) {
    spread.push_back(*at);
    before += is_pair(*at) ? 1 : 0;
    const std::ptrdiff_t end = std::ssize(zeros) * before / pairs;
    spread.insert(spread.end(), zeros.begin() + placed, zeros.begin() + end);
    placed = end;
  }
  statements_ = std::move(spread);
}

void Statements::visit_definitions(const Statement& statement,
                                   const std::function<void(Ref)>& visit) {
  if (statement.output >= 0) {
    return;
  }
  for (const Angle& angle : statement.angles) {
    visit(angle.sine);
    visit(angle.cosine);
  }
  if (statement.angles.empty()) {
    visit(statement.value);
  }
  if (statement.partner != 0) {
    visit(statement.partner);
  }
}

void Statements::visit_atoms(const Statement& statement,
                             const std::function<void(Ref)>& visit) const {
  if (statement.value == 0 || statement.copy_of >= 0) {
    return;
  }
  if (!statement.angles.empty()) {
    std::ranges::for_each(statement.angles, [&](const Angle& angle) { visit(angle.angle); });
    return;
  }
  if (!is_operation(statement.value) || (statement.output >= 0 && is_local(statement.value))) {
    visit(std::abs(statement.value));
  } else {
    for_each_atom(graph_, schedule_, statement.value, visit);
  }
}

/// For every place between two statements the number of locals that are needed on both sides.
std::vector<int> Statements::crossing_counts() const {
  std::vector<std::size_t> defined(graph_.size(), 0);
  std::vector<std::size_t> last(graph_.size(), 0);
  for (std::size_t at = 0; at < statements_.size(); ++at) {
    visit_definitions(statements_[at], [&](Ref value) { defined[node_index(value)] = at; });
    visit_atoms(statements_[at], [&](Ref value) { last[node_index(value)] = at; });
  }
  std::vector<int> change(statements_.size() + 1, 0);
  for (const Statement& statement : statements_) {
    visit_definitions(statement, [&](Ref value) {
      const std::size_t k = node_index(value);
      ++change[defined[k] + 1];
      --change[std::min(last[k] + 1, statements_.size())];
    });
  }
  for (std::size_t at = 1; at < change.size(); ++at) {
    change[at] += change[at - 1];
  }
  return change;
}

/// The place for the end of the part that starts at `begin`: few values cross it.
std::size_t Statements::best_cut(const std::vector<int>& crossing, std::size_t begin) const {
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

void Statements::divide() {
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

/// The last part that names a value, by node.
std::vector<std::size_t> Statements::last_parts() const {
  std::vector<std::size_t> last(graph_.size(), 0);
  for (const Statement& statement : statements_) {
    visit_atoms(statement, [&](Ref value) { last[node_index(value)] = statement.part; });
  }
  return last;
}

/// An element of the workspace for every value that another part needs. It serves again behind the
/// last part that needs it.
void Statements::assign_slots() {
  part_of_.assign(graph_.size(), 0);
  const std::vector<std::size_t> last = last_parts();
  const std::size_t parts = statements_.empty() ? 1 : statements_.back().part + 1;
  std::vector<std::vector<int>> freed(parts);  // by the part that needs them last
  std::set<int> free;
  std::size_t part = 0;
  for (const Statement& statement : statements_) {
    for (; part < statement.part; ++part) {
      free.insert(freed[part].begin(), freed[part].end());
    }
    visit_definitions(statement, [&](Ref value) {
      const std::size_t k = node_index(value);
      part_of_[k] = part;
      if (last[k] <= part) {
        return;
      }
      if (free.empty()) {
        free.insert(slots_++);
      }
      slot_[k] = *free.begin();
      free.erase(free.begin());
      freed[last[k]].push_back(slot_[k]);
    });
  }
}

std::size_t Statements::output_array(int output) const {
  std::size_t array = 0;
  for (int end = function_.signature.outputs[0].size; output >= end;
       end += function_.signature.outputs[array].size) {
    ++array;
  }
  return array;
}

std::string Statements::array_name(const std::string& stem) const {
  std::string name = stem;
  while (has(function_.signature.arrays(), name)) {
    name += '_';
  }
  return name;
}

std::string Statements::element(int output) const {
  int place = output;
  const std::size_t array = output_array(output);
  for (std::size_t k = 0; k < array; ++k) {
    place -= function_.signature.outputs[k].size;
  }
  return element_text(function_.signature.outputs[array], place);
}

std::string Statements::input(const program::Node& node) const {
  return element_text(function_.signature.inputs[to_index(node.a)], node.b);
}

std::string Statements::atom(Ref value) const {
  const program::Node& node = graph_.node(value);
  if (node.kind == Kind::kConstant) {
    return number_text(words_, graph_.value(value), target_.scalar);
  }
  if (node.kind == Kind::kInput) {
    return input(node);
  }
  return names_.at(value);
}

}  // namespace treedyn::emit
