// The entries of a mapping whose keys are known.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/yaml_node.hpp"

namespace treedyn::description {

using Keys = std::vector<std::string_view>;

/// A mapping, and how messages call it. Every member throws InputError with the place of the entry
/// and what was expected. The text and the node outlive the object.
class Fields {
 public:
  /// \param what     how messages call the mapping: "constraint 'foot'"
  /// \param ignored  further keys, which are comments
  Fields(const std::string& file, const Node& node, std::string what, const Keys& keys,
         const Keys& ignored = {});

  [[noreturn]] void fail(const Place& where, const std::string& message) const;
  /// nullptr if the key is missing.
  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] const Node& get(std::string_view key) const;
  [[nodiscard]] const Place& where() const { return node_.where; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& what() const { return what_; }

  [[nodiscard]] Text scalar(const Node& node) const;
  [[nodiscard]] Text text(std::string_view key) const { return scalar(get(key)); }
  [[nodiscard]] std::optional<Text> optional_text(std::string_view key) const;
  [[nodiscard]] std::optional<Numbers> numbers(std::string_view key) const;
  [[nodiscard]] Numbers numbers(const Node& node) const;
  [[nodiscard]] const std::vector<Node>& sequence(const Node& node) const;
  /// The entries of a list; none if the key is missing.
  [[nodiscard]] const std::vector<Node>& list(std::string_view key) const;

 private:
  const std::string& file_;
  const Node& node_;
  std::string what_;
};

/// "'key'" of an entry of a mapping, "entry" of one of a list.
std::string described(const Node& node);

/// "kind 'name'" if the mapping has a name, else "kind 3".
std::string called(std::string_view kind, const Node& node, std::size_t index);

/// The entries of `parameters:`, name and value.
const std::vector<Node>& parameters(const std::string& file, const Node& node);

}  // namespace treedyn::description
