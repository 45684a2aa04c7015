// Models and scenes as trees that can be changed and written again.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "description/yaml_node.hpp"

namespace treedyn::fuzz {

/// Of a YAML or a URDF file. Elements of XML are mappings, their attributes entries with a key that
/// begins with '@'. \throws InputError
description::Node read_nodes(const std::string& text, bool is_xml);
/// The same as text: YAML in flow style, or XML.
std::string written(const description::Node& root, bool is_xml);

/// Changes the structure: entries are dropped, repeated, exchanged, moved, wrapped; numbers become
/// extreme, names hostile, references those of others.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}
  void change(description::Node& root);
  std::size_t below(std::size_t limit) { return random_() % (limit == 0 ? 1 : limit); }

 private:
  std::mt19937 random_;
};

}  // namespace treedyn::fuzz
