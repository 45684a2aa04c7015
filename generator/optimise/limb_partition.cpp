#include "optimise/limb_partition.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

namespace treedyn::optimise {

using residue::Key;

namespace {

constexpr int kMostJoints = 1 << 12;  ///< of a limb, for its keys

/// Equal for numbers of 35 equal digits: tilts of 1e-17 are no zeros.
Key key_of_digits(const Digits& x) {
  const auto leading = static_cast<double>(x);
  const Key key = residue::key_of(leading);
  if (leading == 0) {
    return key;
  }
  const Digits rest = ldexp(Digits((x - Digits(leading)) / x), 116);  // below 2^63
  const auto further = static_cast<std::int64_t>(round(rest));
  return further == 0 ? key
                      : residue::sum(key, residue::key_of(static_cast<int>(further >> 32),
                                                          static_cast<int>(further)));
}

/// Equal for numbers that are equal as they are and as they are seen.
Key key_of_number(const Real& x) {
  const Key seen = key_of_digits(x.seen());
  return x.seen() == x.digits()
             ? seen
             : residue::sum(seen, residue::odd(key_of_digits(x.digits()), Kind::kConstant));
}

}  // namespace

LimbPartition::LimbPartition(const Function& function, const Limbs& limbs)
    : graph_(function.graph),
      limbs_(limbs),
      nodes_(reachable(function.graph, function.outputs)),
      places_(graph_.size()),
      keys_(graph_.size(), 0),
      of_trunk_(graph_.size(), false) {
  place_leaves();
  do {
    place_operations();
  } while (give_to_trunk());
  while (raise_stages()) {
  }
}

void LimbPartition::place_leaves() {
  std::map<int, LimbPlace> of_coordinate;
  std::vector<int> first_number;
  int number = 0;
  for (std::size_t c = 0; c < limbs_.size(); ++c) {
    first_number.push_back(number);
    for (int limb = 0; limb < limbs_[c].size(); ++limb, ++number) {
      const auto& joints = limbs_[c].joints[static_cast<std::size_t>(limb)];
      for (std::size_t p = 0; p < joints.size(); ++p) {
        of_coordinate[joints[p].coordinate] = {static_cast<int>(c), limb, number,
                                               static_cast<int>(p), 0};
      }
    }
  }
  for (const Ref k : nodes_) {
    const Node& node = graph_.node(k);
    LimbPlace& place = places_[program::node_index(k)];
    if (node.kind == Kind::kConstant) {
      keys_[program::node_index(k)] = key_of_number(graph_.value(k));
    } else if (node.kind == Kind::kInput && node.a >= kFixedArrays) {
      const int c = node.a - kFixedArrays;
      const int size = limbs_[static_cast<std::size_t>(c)].size();
      place = {c, node.b % size, first_number[static_cast<std::size_t>(c)] + node.b % size,
               node.b / size, 0};
      keys_[program::node_index(k)] = residue::key_of(node.a, place.position);
    } else if (node.kind == Kind::kInput && node.a >= kLimbInputs) {
      place = of_coordinate.at(node.b);
      keys_[program::node_index(k)] =
          residue::key_of(node.a, place.limb_class * kMostJoints + place.position);
    } else {
      keys_[program::node_index(k)] = residue::key_of(-1, k);  // the trunk's: known by its number
    }
  }
}

Key LimbPartition::key(Ref a) const {
  const Key positive = keys_[program::node_index(a)];
  return a < 0 ? residue::negative(positive) : positive;
}

Key LimbPartition::operation_key(const Node& node) const {
  switch (node.kind) {
    case Kind::kAdd:
      return residue::sum(key(node.a), key(node.b));
    case Kind::kMultiply:
      return residue::product(key(node.a), key(node.b));
    case Kind::kDivide:
      return residue::product(key(node.a), residue::inverse(key(node.b)));
    case Kind::kSin:
      return residue::odd(key(node.a), node.kind);
    case Kind::kCos:
      return residue::even(key(node.a), node.kind);
    case Kind::kSqrt:
      return residue::image(key(node.a), node.kind);
    case Kind::kConstant:
    case Kind::kInput:
      break;
  }
  return 0;
}

void LimbPartition::place_operation(Ref k) {
  LimbPlace place;
  bool several = of_trunk_[program::node_index(k)];
  for_each_operand(graph_.node(k), [&](Ref operand) {
    const LimbPlace& own = this->place(operand);
    if (!own.is_trunk()) {
      several |= !place.is_trunk() && place.number != own.number;
      place = own;
    }
  });
  if (several) {
    place = {};
  }
  place.position = 0;
  place.stage = 0;
  places_[program::node_index(k)] = place;
  keys_[program::node_index(k)] =
      place.is_trunk() ? residue::key_of(-1, k) : operation_key(graph_.node(k));
}

void LimbPartition::place_operations() {
  for (const Ref k : nodes_) {
    if (is_operation(k)) {
      place_operation(k);
    }
  }
}

LimbPartition::Name LimbPartition::name(Ref k) const {
  const Key positive = keys_[program::node_index(k)];
  return {place(k).limb_class, std::min(positive, residue::negative(positive))};
}

/// Operations that some limb of their class does not have; true if there were any.
bool LimbPartition::give_to_trunk() {
  std::map<Name, std::set<int>> owners;
  first_.clear();
  for (const Ref k : nodes_) {
    if (is_limb_operation(k)) {
      owners[name(k)].insert(place(k).limb);
      if (place(k).limb == 0) {
        first_.try_emplace(name(k), k);
      }
    }
  }
  bool changed = false;
  for (const Ref k : nodes_) {
    if (is_limb_operation(k)) {
      const auto limbs = static_cast<std::size_t>(place(k).limb_class);
      const bool everywhere = static_cast<int>(owners[name(k)].size()) == limbs_[limbs].size();
      of_trunk_[program::node_index(k)] = !everywhere;
      changed |= !everywhere;
    }
  }
  return changed;
}

/// The trunk waits for the limbs whose values it needs, the limbs of a class for each other's
/// trunk values; true if a stage grew.
bool LimbPartition::raise_stages() {
  bool raised = false;
  std::map<Name, int> of_class;
  for (const Ref k : nodes_) {
    if (!is_operation(k)) {
      continue;
    }
    LimbPlace& own = places_[program::node_index(k)];
    int stage = own.stage;
    for_each_operand(graph_.node(k), [&](Ref operand) {
      if (is_operation(operand)) {
        const bool from_limb = own.is_trunk() && !place(operand).is_trunk();
        stage = std::max(stage, place(operand).stage + (from_limb ? 1 : 0));
      }
    });
    if (!own.is_trunk()) {
      int& common = of_class[name(k)];
      common = std::max(common, stage);
    }
    raised |= stage > own.stage;
    own.stage = stage;
    last_stage_ = std::max(last_stage_, stage);
  }
  for (const Ref k : nodes_) {
    if (is_limb_operation(k)) {
      raised |= of_class[name(k)] > place(k).stage;
      places_[program::node_index(k)].stage = of_class[name(k)];
    }
  }
  return raised;
}

Ref LimbPartition::counterpart(Ref a) const {
  const Ref first = first_.at(name(a));
  return key(a) == key(first) ? first : -first;
}

}  // namespace treedyn::optimise
