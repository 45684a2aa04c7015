// Which nodes of a graph belong to one limb, and which are the same in all limbs of a class.
#pragma once

#include <map>

#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// Where a node belongs.
struct LimbPlace {
  int limb_class = -1;  ///< -1: the trunk
  int limb = 0;         ///< in its class
  int number = 0;       ///< of the limb, counted over all classes
  int position = 0;     ///< of a leaf: place of its joint in the limb, or column
  int stage = 0;        ///< of an operation

  [[nodiscard]] bool is_trunk() const { return limb_class < 0; }
};

/// An operation belongs to a limb if it needs leaves of that limb alone, values of the trunk and
/// constants, and all limbs of the class have an operation of the same value, up to the sign.
/// Everything else is the trunk's. Values are compared by keys: wrong with a probability of 1e-12.
class LimbPartition {
 public:
  LimbPartition(const Function& function, const Limbs& limbs);

  /// What the outputs need, ascending.
  [[nodiscard]] const std::vector<Ref>& nodes() const { return nodes_; }
  [[nodiscard]] const LimbPlace& place(Ref a) const { return places_[program::node_index(a)]; }
  [[nodiscard]] bool is_operation(Ref a) const { return graph_.is_operation(a); }
  [[nodiscard]] bool is_limb_operation(Ref a) const {
    return is_operation(a) && !place(a).is_trunk();
  }
  /// The operation of the same value in the first limb, negative if its value is the opposite.
  /// \pre is_limb_operation(a)
  [[nodiscard]] Ref counterpart(Ref a) const;
  [[nodiscard]] int last_stage() const { return last_stage_; }

 private:
  using Name = std::pair<int, residue::Key>;  ///< class, key without sign

  void place_leaves();
  void place_operations();
  void place_operation(Ref k);
  bool give_to_trunk();
  bool raise_stages();
  [[nodiscard]] residue::Key key(Ref a) const;
  [[nodiscard]] residue::Key operation_key(const Node& node) const;
  [[nodiscard]] Name name(Ref k) const;

  const Graph& graph_;
  const Limbs& limbs_;
  std::vector<Ref> nodes_;
  std::vector<LimbPlace> places_;   // by node
  std::vector<residue::Key> keys_;  // by node
  std::vector<bool> of_trunk_;      // by node: nothing is like it in another limb
  std::map<Name, Ref> first_;       // operations of the first limbs
  int last_stage_ = 0;
};

}  // namespace treedyn::optimise
