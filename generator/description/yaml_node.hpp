// YAML (and JSON) text as a tree of scalars, sequences and mappings with places.
#pragma once

#include <string>
#include <vector>

#include "description/raw_tree.hpp"

namespace treedyn::description {

enum class NodeKind { kScalar, kSequence, kMapping };

struct Node {
  NodeKind kind = NodeKind::kScalar;
  Text key;                 ///< of an entry of a mapping
  std::string text;         ///< of a scalar
  bool empty = false;       ///< a plain scalar that YAML reads as null
  std::vector<Node> items;  ///< of a sequence or mapping, in file order
  Place where;
};

/// The entry of a mapping; null if there is none.
const Node* find(const Node& mapping, std::string_view key);

/// Reads one YAML document; keys of a mapping are scalars and different.
///
/// Anchors, aliases and tags are refused; nesting and the number of values are bounded. Linear (n
/// log n in the keys of one mapping).
/// \param what  is expected of a file that is empty
/// \throws InputError
Node parse_yaml_node(const std::string& text, const std::string& file,
                     const std::string& what = "a tree description");

}  // namespace treedyn::description
