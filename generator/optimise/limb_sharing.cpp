#include "optimise/limb_sharing.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "optimise/limb_partition.hpp"
#include "program/rewritten.hpp"

namespace treedyn::optimise {

namespace {

constexpr int kTrunkArray = 0;
constexpr int kRowArray = 1;
constexpr int kLimbArray = 2;

/// Writes trunk and phases of a partition.
class Writer {
 public:
  Writer(const Function& function, const Limbs& limbs, const LimbPartition& partition)
      : function_(function), from_(function.graph), partition_(partition) {
    result_.limbs = limbs;
    result_.values.resize(limbs.size());
    joint_values_.resize(limbs.size());
    exports_.resize(limbs.size());
    list_interfaces();
  }

  LimbCode write() {
    for (int stage = 0; stage <= partition_.last_stage(); ++stage) {
      for (int c = 0; c < static_cast<int>(result_.limbs.size()); ++c) {
        add_phase(c, stage);
      }
    }
    write_trunk();
    return std::move(result_);
  }

 private:
  using JointValue = std::pair<int, int>;  ///< argument of the function, place in the limb

  void list_interfaces();
  void note_operand(Ref user, Ref operand);
  void add_phase(int c, int stage);
  void write_trunk();
  Ref phase_leaf(int c, Ref k, Graph& to) const;
  Ref trunk_leaf(Ref k, Graph& to) const;
  [[nodiscard]] int element_of(int c, Ref exported) const {
    const auto& list = exports_[to_index(c)];
    const auto found = std::ranges::find(list, exported);
    TREEDYN_EXPECT(found != list.end());
    const auto place = static_cast<int>(found - list.begin());
    return static_cast<int>(joint_values_[to_index(c)].size()) + place;
  }
  [[nodiscard]] int values_of(int c) const {
    return static_cast<int>(joint_values_[to_index(c)].size() + exports_[to_index(c)].size());
  }

  const Function& function_;
  const Graph& from_;
  const LimbPartition& partition_;
  LimbCode result_;
  std::vector<Ref> trunk_values_;                      ///< ascending nodes
  std::vector<std::vector<JointValue>> joint_values_;  ///< by class
  std::vector<std::vector<Ref>> exports_;              ///< by class: nodes of its first limb
};

/// What crosses the border between `operand` and its user in the first limb or the trunk.
void Writer::note_operand(Ref user, Ref operand) {
  const LimbPlace& of_user = partition_.place(user);
  const LimbPlace& own = partition_.place(operand);
  const Node& node = from_.node(operand);
  if (of_user.is_trunk()) {
    if (partition_.is_limb_operation(operand)) {
      exports_[to_index(own.limb_class)].push_back(partition_.counterpart(operand));
    }
  } else if (of_user.limb == 0 && own.is_trunk()) {
    if (node.kind != Kind::kConstant) {
      trunk_values_.push_back(std::abs(operand));
    }
  } else if (of_user.limb == 0 && node.kind == Kind::kInput) {
    if (node.a < kFixedArrays) {
      joint_values_[to_index(own.limb_class)].emplace_back(node.a - kLimbInputs, own.position);
    }
  } else if (of_user.limb == 0 && own.stage < of_user.stage) {
    exports_[to_index(own.limb_class)].push_back(std::abs(operand));
  }
}

template <class T>
void sort_unique(std::vector<T>& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

void Writer::list_interfaces() {
  for (const Ref k : partition_.nodes()) {
    for_each_operand(from_.node(k), [&](Ref operand) { note_operand(k, operand); });
  }
  for (const Ref output : function_.outputs) {
    if (partition_.is_limb_operation(output)) {
      exports_[to_index(partition_.place(output).limb_class)].push_back(
          partition_.counterpart(output));
    }
  }
  sort_unique(trunk_values_);
  for (std::size_t c = 0; c < exports_.size(); ++c) {
    sort_unique(joint_values_[c]);
    std::ranges::for_each(exports_[c], [](Ref& k) { k = std::abs(k); });
    sort_unique(exports_[c]);
    std::ranges::stable_sort(exports_[c], {}, [&](Ref k) { return partition_.place(k).stage; });
    for (const auto& [argument, position] : joint_values_[c]) {
      result_.values[c].push_back({argument, position, -1});
    }
    for (const Ref k : exports_[c]) {
      result_.values[c].push_back({-1, 0, partition_.place(k).stage});
    }
  }
}

/// The leaf of a phase of class c for node k of the first limb or the trunk.
Ref Writer::phase_leaf(int c, Ref k, Graph& to) const {
  const LimbPlace& place = partition_.place(k);
  const Node& node = from_.node(k);
  if (node.kind == Kind::kConstant) {
    return to.constant(from_.value(k));
  }
  if (place.is_trunk()) {
    const auto found = std::ranges::lower_bound(trunk_values_, k);
    return to.input(kTrunkArray, static_cast<int>(found - trunk_values_.begin()));
  }
  if (node.kind != Kind::kInput) {
    return to.input(kLimbArray, element_of(c, k));
  }
  if (node.a >= kFixedArrays) {
    return to.input(node.a, node.b);
  }
  const auto& joints = joint_values_[to_index(c)];
  const JointValue value(node.a - kLimbInputs, place.position);
  return to.input(kLimbArray,
                  static_cast<int>(std::ranges::lower_bound(joints, value) - joints.begin()));
}

void Writer::add_phase(int c, int stage) {
  LimbPhase phase{c, stage, {}};
  Graph& to = phase.function.graph;
  std::vector<Ref> copies(from_.size(), 0);
  bool computes = false;
  const auto is_inside = [&](Ref k) {
    const LimbPlace& place = partition_.place(k);
    return place.limb_class == c && place.limb == 0 && place.stage == stage &&
           partition_.is_limb_operation(k);
  };
  for (const Ref k : partition_.nodes()) {
    if (!is_inside(k)) {
      continue;
    }
    for_each_operand(from_.node(k), [&](Ref operand) {
      if (!is_inside(operand)) {
        copies[program::node_index(operand)] = phase_leaf(c, std::abs(operand), to);
      }
    });
    const Ref copy = copy_node(from_, k, copies, to);
    copies[program::node_index(k)] = copy;
    copy_hints(from_, k, copy, to);
    computes = true;
  }
  if (!computes) {
    return;
  }
  for (int e = 0; e < values_of(c); ++e) {
    const bool now = result_.values[to_index(c)][to_index(e)].stage == stage;
    const std::size_t joints = joint_values_[to_index(c)].size();
    phase.function.outputs.push_back(
        now ? copies[program::node_index(exports_[to_index(c)][to_index(e) - joints])]
            : to.input(kLimbArray, e));
  }
  const int size = values_of(c);
  phase.function.signature.inputs = {{kTrunkValues, static_cast<int>(trunk_values_.size()), ""},
                                     {kLimbRow, 0, ""},
                                     {kLimbValues, size, ""}};
  phase.function.signature.outputs = {{kLimbValues, size, ""}};
  result_.phases.push_back(std::move(phase));
}

/// The value of a leaf in the trunk: what the limb was given, a constant, or what the limb
/// computes.
Ref Writer::trunk_leaf(Ref k, Graph& to) const {
  const LimbPlace& place = partition_.place(k);
  const Node& node = from_.node(k);
  if (partition_.is_limb_operation(k)) {
    const Ref first = partition_.counterpart(k);
    const auto limb = static_cast<int>(function_.signature.inputs.size()) + place.number;
    const Ref value = to.input(limb, element_of(place.limb_class, std::abs(first)));
    return first < 0 ? -value : value;
  }
  if (node.kind == Kind::kConstant) {
    return to.constant(from_.value(k));
  }
  if (place.is_trunk()) {
    return to.input(node.a, node.b);
  }
  const LimbClass& own = result_.limbs[to_index(place.limb_class)];
  if (node.a >= kFixedArrays) {
    return to.constant(own.columns[to_index(place.position)][to_index(place.limb)]);
  }
  const Ref input = to.input(node.a - kLimbInputs, node.b);
  return own.joints[to_index(place.limb)][to_index(place.position)].sign < 0 ? -input : input;
}

void Writer::write_trunk() {
  Function& trunk = result_.trunk;
  Graph& to = trunk.graph;
  std::vector<Ref> copies(from_.size(), 0);
  const auto of = [&](Ref a) {
    const bool copied = a == 0 || (partition_.is_operation(a) && partition_.place(a).is_trunk());
    Ref& copy = copies[program::node_index(a)];
    copy = copied ? copy : trunk_leaf(std::abs(a), to);
    return a < 0 ? -copy : copy;
  };
  for (const Ref k : partition_.nodes()) {
    if (partition_.place(k).is_trunk() && partition_.is_operation(k)) {
      for_each_operand(from_.node(k), of);
      const Ref copy = copy_node(from_, k, copies, to);
      copies[program::node_index(k)] = copy;
      copy_hints(from_, k, copy, to);
    }
  }
  std::ranges::transform(function_.outputs, std::back_inserter(trunk.outputs), of);
  std::ranges::transform(trunk_values_, std::back_inserter(trunk.outputs), of);
  trunk.signature = function_.signature;
  trunk.signature.outputs.push_back({kTrunkValues, static_cast<int>(trunk_values_.size()), ""});
  for (int c = 0; c < static_cast<int>(result_.limbs.size()); ++c) {
    for (const auto& joints : result_.limbs[to_index(c)].joints) {
      for (const auto& [argument, position] : joint_values_[to_index(c)]) {
        const LimbJoint& joint = joints[to_index(position)];
        trunk.outputs.push_back(joint.sign * to.input(argument, joint.coordinate));
      }
      const int given = static_cast<int>(joint_values_[to_index(c)].size());
      trunk.signature.inputs.push_back({kLimbValues, values_of(c), ""});
      trunk.signature.outputs.push_back({kLimbValues, given, ""});
    }
  }
}

/// Stage of every output of the trunk.
std::vector<int> output_levels(const LimbCode& code, const Function& trunk) {
  std::vector<int> level(trunk.graph.size(), 0);
  for (const Ref k : reachable(trunk.graph, trunk.outputs)) {
    const Node& node = trunk.graph.node(k);
    int& own = level[program::node_index(k)];
    own = node.kind == Kind::kInput ? code.level(node.a, node.b) : 0;
    for_each_operand(
        node, [&](Ref operand) { own = std::max(own, level[program::node_index(operand)]); });
  }
  return transformed(trunk.outputs, [&](Ref output) { return level[program::node_index(output)]; });
}

/// Numbers the columns that the phases of a class use from 0 and makes them input kRowArray.
void renumber_columns(LimbCode& code, int c) {
  LimbClass& limb_class = code.limbs[to_index(c)];
  std::set<int> used;
  for (const LimbPhase& phase : code.phases) {
    for (const Ref k : reachable(phase.function.graph, phase.function.outputs)) {
      const Node& node = phase.function.graph.node(k);
      if (phase.limb_class == c && node.kind == Kind::kInput && node.a >= kFixedArrays) {
        used.insert(node.b / limb_class.size());
      }
    }
  }
  for (LimbPhase& phase : code.phases) {
    if (phase.limb_class != c) {
      continue;
    }
    phase.function =
        with_inputs(phase.function, phase.function.outputs, [&](const Node& node, Graph& to) {
          if (node.a < kFixedArrays) {
            return to.input(node.a, node.b);
          }
          const auto place = used.find(node.b / limb_class.size());
          return to.input(kRowArray, static_cast<int>(std::distance(used.begin(), place)));
        });
    phase.function.signature.inputs[kRowArray].size = static_cast<int>(used.size());
  }
  std::vector<std::vector<Real>> columns;
  for (const int k : used) {
    columns.push_back(limb_class.columns[to_index(k)]);
  }
  limb_class.columns = std::move(columns);
}

void optimise(LimbCode& code, const Effort& effort) {
  for (LimbPhase& phase : code.phases) {
    phase.function = fold_limb_constants(optimised(phase.function, effort), code.limbs);
  }
  prune(code);
  Function trunk = optimised(code.trunk, effort);
  const std::vector<int> before = output_levels(code, code.trunk);
  const std::vector<int> after = output_levels(code, trunk);
  const bool in_time = std::equal(before.begin(), before.end(), after.begin(),
                                  [](int old_level, int level) { return level <= old_level; });
  if (in_time) {
    code.trunk = std::move(trunk);
  }
}

}  // namespace

std::shared_ptr<const LimbCode> limb_code(const Function& function, const Limbs& limbs,
                                          const std::optional<Effort>& effort) {
  const LimbPartition partition(function, limbs);
  LimbCode code = Writer(function, limbs, partition).write();
  if (code.phases.empty()) {
    return nullptr;
  }
  if (effort) {
    optimise(code, *effort);
    prune(code);
  }
  if (code.phases.empty()) {
    return nullptr;
  }
  for (std::size_t c = 0; c < code.limbs.size(); ++c) {
    renumber_columns(code, static_cast<int>(c));
  }
  return std::make_shared<const LimbCode>(std::move(code));
}

}  // namespace treedyn::optimise
